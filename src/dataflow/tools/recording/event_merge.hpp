#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "dataflow/tools/recording/event_spool.hpp"

namespace dataflow::recording {

/// The events of one process as things that happen in a single cycle each, in order: iterations one by one, the end of
/// a stall after its begin. Fields stay behind the write they belong to.
class EventStream {
  public:
    explicit EventStream(EventSpool& spool) : spool_(&spool) { has_next_ = spool.get(next_); }

    /// False at the end.
    bool get(Event& event);

  private:
    bool split_front(Event& event);

    EventSpool* spool_;
    Event next_;
    bool has_next_ = false;
    Event iterating_;  ///< iterations still to come; count 0: none
    Event resume_;
    bool resumes_ = false;
};

/// An event, and whose it is. A write has all fields of its token.
struct CoreEvent {
    std::size_t core = 0;
    std::size_t process = 0;  ///< of none: 0
    Event event;
    TokenValues const* fields = nullptr;  ///< of a write; valid during the call
};

/// Visits the events of all processes of several cores, the earliest first; of one cycle, by core and process.
void for_each_event(std::vector<std::pair<std::size_t, Spools*>> const& cores,
                    std::function<void(CoreEvent const&)> const& visit);

}  // namespace dataflow::recording
