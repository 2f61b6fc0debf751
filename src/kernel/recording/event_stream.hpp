#pragma once
#include <vector>

#include "kernel/recording/event_spool.hpp"

namespace faster::recording {

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

}  // namespace faster::recording
