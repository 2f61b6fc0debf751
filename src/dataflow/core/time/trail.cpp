#include "dataflow/core/time/trail.hpp"

#include <algorithm>

namespace dataflow::timing {

using Kind = TrailEvent::Kind;

void Trail::stalled(unsigned process, unsigned port, Region region, Cycles step, Cycles until) {
    TrailEvent event;
    event.time = until;
    event.count = static_cast<std::uint32_t>(step);
    event.process = static_cast<std::uint16_t>(process);
    event.port = static_cast<std::uint16_t>(port);
    event.region = region;
    events_.push_back(event);
}

void Trail::marked(unsigned process, Region region, Cycles from) {
    TrailEvent event;
    event.time = from;
    event.kind = Kind::marked;
    event.process = static_cast<std::uint16_t>(process);
    event.region = region;
    events_.push_back(event);
}

void Trail::flown(unsigned process, unsigned port, Cycles flight, bool was_frozen, Cycles cycle) {
    TrailEvent event;
    event.time = cycle;
    event.count = static_cast<std::uint32_t>(flight);
    event.distance = was_frozen ? 1 : 0;
    event.kind = Kind::flown;
    event.process = static_cast<std::uint16_t>(process);
    event.port = static_cast<std::uint16_t>(port);
    events_.push_back(event);
}

/// The stalls may be far apart in the trail, between those of others: they are put down once more, side by side.
void Trail::repeated(std::uint64_t since, ProcessMask mask, std::uint64_t count, Cycles cycles) {
    std::size_t const end = events_.size();
    for (auto i = static_cast<std::size_t>(since - forgotten_); i < end; ++i) {
        TrailEvent const event = events_[i];
        if (event.kind == Kind::stalled && ((mask >> event.process) & 1U) != 0)
            append(event, cycles);
    }
    if (count == 1 || events_.size() == end)
        return;
    TrailEvent again;
    again.time = cycles;
    again.kind = Kind::repeated;
    again.count = static_cast<std::uint32_t>(count - 1);
    again.distance = static_cast<std::uint32_t>(events_.size() - end);
    events_.push_back(again);
}

void Trail::followed(Transition transition, Cycles end, bool goes_on) {
    transitions_.push_back(transition);
    if (goes_on) {
        ++events_.back().count;
        events_.back().time = end;
        return;
    }
    TrailEvent event;
    event.time = end;
    event.kind = Kind::followed;
    event.count = 1;
    events_.push_back(event);
}

void Trail::append(TrailEvent event, Cycles later) {
    if (event.kind != Kind::repeated)
        event.time += later;
    events_.push_back(event);
}

std::vector<TrailEvent> Trail::take(Cycles origin) {
    std::vector<TrailEvent> taken;
    forgotten_ += events_.size();
    taken.swap(events_);
    for (TrailEvent& event : taken)
        if (event.kind != Kind::repeated)
            event.time -= origin;
    return taken;
}

void Trail::forget(std::size_t events, std::size_t transitions, Junction junction) {
    forgotten_ += events;
    events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(events));
    transitions_.erase(transitions_.begin(), transitions_.begin() + static_cast<std::ptrdiff_t>(transitions));
    junction_ = std::move(junction);
    accept_length();
}

}  // namespace dataflow::timing
