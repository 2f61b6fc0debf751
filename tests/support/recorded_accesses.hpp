#pragma once
#include <functional>
#include <vector>

#include "dataflow/tools/recording/event_merge.hpp"
#include "dataflow/tools/recording/memory_ports.hpp"
#include "dataflow/tools/recording/recorded_core.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::testing {

/// An event of a recorded core, the fields of the token that it reads, if it does, and the accesses to block RAM that
/// it stands for.
using AccessVisit = std::function<void(recording::CoreEvent const& event, recording::TokenValues const& read,
                                       std::vector<recording::PortAccess> const& accesses)>;

/// Visits core after core, the earliest event first.
void for_each_access(std::vector<recording::RecordedCore> const& cores, AccessVisit const& visit);

}  // namespace faster::testing
