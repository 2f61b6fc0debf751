#pragma once
#include "dataflow/run/replay/core_variant.hpp"
#include "dataflow/run/replay/retime.hpp"

namespace dataflow::replay {

/// A non-blocking access might find something else than in the recorded run, so only another run can tell.
class OutcomeDiffers : public NotRetimable {
  public:
    using NotRetimable::NotRetimable;
};

/// What a process does behind a non-blocking access depends on what that found. `are_over`: the cores have done all
/// that they can. Throws OutcomeDiffers if one of their processes would have found something else than was recorded,
/// and names the access.
void require_outcomes(Cores const& cores, bool are_over);

}  // namespace dataflow::replay
