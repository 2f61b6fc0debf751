#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "kernel/recording/event_stream.hpp"

namespace faster::recording {

/// An event, and whose it is. A write has all fields of its token.
struct CoreEvent {
    std::size_t core = 0;
    std::size_t process = 0;
    Event event;
    TokenValues const* fields = nullptr;  ///< of a write; valid during the call
};

/// Visits the events of all processes of several cores, the earliest first; of one cycle, by core and process.
void for_each_event(std::vector<std::pair<std::size_t, Spools*>> const& cores,
                    std::function<void(CoreEvent const&)> const& visit);

}  // namespace faster::recording
