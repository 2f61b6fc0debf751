#include "recording/event_merge.hpp"

#include <memory>
#include <tuple>

namespace faster::recording {

namespace {

/// The next event of one process, with what follows it in the same breath.
struct Source {
    std::size_t core;
    std::size_t module;
    EventStream stream;
    Event event;
    bool has_event = false;

    Source(std::size_t core_number, std::size_t module_number, EventSpool& spool)
        : core(core_number), module(module_number), stream(spool) {
        has_event = stream.get(event);
    }
};

struct Later {
    bool operator()(Source const* a, Source const* b) const {
        return std::tie(a->event.cycle, a->core, a->module) > std::tie(b->event.cycle, b->core, b->module);
    }
};

}  // namespace

void for_each_event(std::vector<std::pair<std::size_t, Spools*>> const& cores,
                    std::function<void(CoreEvent const&)> const& visit) {
    std::vector<std::unique_ptr<Source>> sources;
    std::priority_queue<Source*, std::vector<Source*>, Later> queue;
    for (auto const& [core, spools] : cores)
        for (std::size_t module = 0; module < module_count; ++module) {
            sources.push_back(std::make_unique<Source>(core, module, (*spools)[module]));
            if (sources.back()->has_event)
                queue.push(sources.back().get());
        }
    std::vector<std::int64_t> fields;
    while (!queue.empty()) {
        Source& source = *queue.top();
        queue.pop();
        CoreEvent event{source.core, source.module, source.event, nullptr};
        source.has_event = source.stream.get(source.event);
        if (event.event.kind == Event::Kind::write) {
            fields.assign(1, event.event.value);
            for (; source.has_event && source.event.kind == Event::Kind::field;
                 source.has_event = source.stream.get(source.event))
                fields.push_back(source.event.value);
            event.fields = &fields;
        }
        visit(event);
        if (source.has_event)
            queue.push(&source);
    }
}

}  // namespace faster::recording
