#include "dataflow/tools/recording/event_merge.hpp"

#include <algorithm>
#include <memory>

namespace dataflow::recording {

namespace {

/// The next event of one process, with what follows it in the same breath.
struct Source {
    std::size_t core;
    std::size_t process;
    EventStream stream;
    Event event;
    bool has_event = false;

    Source(std::size_t core_number, std::size_t process_number, EventSpool& spool)
        : core(core_number), process(process_number), stream(spool) {
        has_event = stream.get(event);
    }
};

/// Takes the next event out of a source, with all fields of a token.
void take(Source& source, CoreEvent& event, TokenValues& fields) {
    event = {source.core, source.process, source.event, nullptr};
    source.has_event = source.stream.get(source.event);
    if (event.event.kind != Event::Kind::write)
        return;
    fields.assign(1, event.event.value);
    while (source.has_event && source.event.kind == Event::Kind::field) {
        fields.push_back(source.event.value);
        source.has_event = source.stream.get(source.event);
    }
    event.fields = &fields;
}

}  // namespace

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

/// Cycle by cycle: many events share one, so that looking for the next cycle is done once for all of them.
void for_each_event(std::vector<std::pair<std::size_t, Spools*>> const& cores,
                    std::function<void(CoreEvent const&)> const& visit) {
    std::vector<std::unique_ptr<Source>> sources;
    for (auto const& [core, spools] : cores)
        spools->each([&, core = core](std::size_t process, EventSpool& spool) {
            sources.push_back(std::make_unique<Source>(core, process, spool));
        });
    TokenValues fields{};
    CoreEvent event;
    for (;;) {
        Cycles cycle = ~Cycles{0};
        for (auto const& source : sources)
            if (source->has_event)
                cycle = std::min(cycle, source->event.cycle);
        if (cycle == ~Cycles{0})
            return;
        for (auto const& source : sources)
            while (source->has_event && source->event.cycle <= cycle) {
                take(*source, event, fields);
                visit(event);
            }
    }
}

}  // namespace dataflow::recording
