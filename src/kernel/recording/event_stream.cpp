#include "kernel/recording/event_stream.hpp"

namespace faster::recording {

using Kind = Event::Kind;

bool EventStream::get(Event& event) {
    if (split_front(event))
        return true;
    if (!has_next_)
        return false;
    event = next_;
    has_next_ = spool_->get(next_);
    if (event.kind == Kind::iterate) {
        iterating_ = event;
        --iterating_.count;
        ++iterating_.value;
        iterating_.cycle += iterating_.stride;
        event.count = 1;
    } else if (event.kind == Kind::stall) {
        resumes_ = true;
        resume_ = event;
        resume_.kind = Kind::resume;
        resume_.cycle = static_cast<Cycles>(event.value);
    }
    return true;
}

/// What is left of an event told before, if it comes before the next one.
bool EventStream::split_front(Event& event) {
    if (resumes_) {
        resumes_ = false;
        event = resume_;
        return true;
    }
    if (iterating_.count == 0)
        return false;
    if (has_next_ && next_.cycle <= iterating_.cycle && next_.kind == Kind::leave) {
        iterating_.count = 0;  // the last interval of a loop shorter than it is cut off
        return false;
    }
    if (has_next_ && next_.cycle < iterating_.cycle)
        return false;
    event = iterating_;
    event.count = 1;
    --iterating_.count;
    ++iterating_.value;
    iterating_.cycle += iterating_.stride;
    return true;
}

}  // namespace faster::recording
