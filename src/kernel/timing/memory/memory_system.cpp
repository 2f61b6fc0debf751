#include "kernel/timing/memory/memory_system.hpp"

#include <algorithm>

#include "kernel/timing/core_timing.hpp"

namespace faster::timing {

MemorySystem::MemorySystem(ExternalMemory const& shape, std::vector<MasterShape> masters)
    : shape_(shape),
      shapes_(std::move(masters)),
      controllers_free_ps_(1),
      ports_free_(shape.ports),
      port_figures_(shape.ports) {}

void MemorySystem::add_core(CoreTiming& core, bool has_work) {
    cores_.push_back(&core);
    if (has_work)
        working_.push_back(&core);
    MemoryMaster::HandedOut& handed_out = handed_out_.emplace_back();
    for (MasterShape const& master : shapes_)
        masters_.emplace_back(shape_, core.stream(master.stream), master.prefetch, handed_out);
    is_waiting_.resize(masters_.size());
    if (!shape_.is_shared) {
        controllers_free_ps_.resize(masters_.size());
        ports_free_.resize(masters_.size());
    }
}

void MemorySystem::note_request(std::size_t master) {
    std::optional<Cycles> const ask = masters_[master].next_ask();
    if (!ask || is_waiting_[master])
        return;
    is_waiting_[master] = true;
    requests_.emplace(*ask, master);
}

bool MemorySystem::follow_master(std::size_t master) {
    bool const hands_out = shapes_[master % shapes_.size()].hands_out;
    bool const delivered = masters_[master].follow(hands_out ? &handed_out_[master / shapes_.size()] : nullptr);
    note_request(master);
    return delivered;
}

std::vector<MemorySystem::Target> MemorySystem::follow() {
    std::vector<Target> targets;
    for (std::size_t master = 0; master < masters_.size(); ++master)
        if (follow_master(master))
            targets.push_back(target_of(master));
    return targets;
}

std::optional<Cycles> MemorySystem::next_ask() const {
    return requests_.empty() ? std::nullopt : std::optional<Cycles>(requests_.top().first);
}

MemorySystem::Target MemorySystem::serve_next() { return target_of(serve().master); }

/// The controller's and the port's rules.
MemorySystem::Served MemorySystem::serve() {
    auto const [ask, number] = requests_.top();
    requests_.pop();
    is_waiting_[number] = false;
    MemoryMaster& master = masters_[number];
    MemoryBurst const& burst = master.next_burst();
    std::uint64_t const arrival = (ask + shape_.request_cycles) * shape_.period_ps;
    std::uint64_t& controller_free_ps = controllers_free_ps_[shape_.is_shared ? 0 : number];
    std::uint64_t const begin = std::max(arrival, controller_free_ps);
    controller_free_ps = begin + burst.granules * shape_.granule_ps;
    controller_.granules += burst.granules;
    note_queue(arrival, begin);
    controller_.history.arrived(ask + shape_.request_cycles, burst.granules, begins_ps_.size());
    Cycles cycle = (begin + shape_.latency_ps + shape_.period_ps - 1) / shape_.period_ps;
    std::size_t const port = number / shapes_.size() % shape_.ports;
    if (!master.stream().is_write()) {
        Cycles& port_free = ports_free_[shape_.is_shared ? port : number];
        cycle = std::max(cycle, port_free);
        port_free = cycle + burst.beats;
        port_figures_[port].beats += burst.beats;
    }
    if (served_call_)
        served_call_({ask, ask + shape_.request_cycles, begin, controller_free_ps, cycle, burst.beats, port,
                      master.stream().is_write()});
    Served const served{number, master.served(cycle)};
    note_request(number);
    return served;
}

void MemorySystem::note_queue(std::uint64_t arrival, std::uint64_t begin) {
    while (!begins_ps_.empty() && begins_ps_.front() <= arrival)
        begins_ps_.pop_front();
    if (begin > arrival)
        begins_ps_.push_back(begin);
    controller_.largest_queue = std::max<std::uint64_t>(controller_.largest_queue, begins_ps_.size());
}

/// What no process has said yet, it does in this cycle at the earliest.
Cycles MemorySystem::unknown_from() const {
    Cycles from = MemoryMaster::never;
    for (CoreTiming const* core : working_)
        from = std::min(from, core->unknown_from());
    return from;
}

/// As far as a core gets with what the memory has delivered.
void MemorySystem::settle(std::size_t core, bool is_resolved) {
    if (!is_resolved)
        cores_[core]->resolve(false);
    ProcessMask woken = 0;
    do {
        cores_[core]->resume(woken);
        woken = 0;
        for (std::size_t master = core * shapes_.size(); master < (core + 1) * shapes_.size(); ++master)
            if (follow_master(master))
                woken |= ProcessMask{1} << target_of(master).process;
    } while (woken != 0);
}

void MemorySystem::go_on(bool at_the_end) {
    for (std::size_t core = 0; core < cores_.size(); ++core)
        settle(core, false);
    std::vector<ProcessMask> woken(cores_.size());
    for (bool has_served = true; has_served;) {
        has_served = false;
        Cycles before = at_the_end ? MemoryMaster::never : unknown_from();
        for (; !requests_.empty() && requests_.top().first < before; has_served = true) {
            Served const served = serve();
            if (served.first_readable == MemoryMaster::never)
                continue;
            // What comes of it is not before its process goes on.
            Target const target = target_of(served.master);
            Cycles const own = cores_[target.core]->process(target.process).not_before();
            before = std::min(before, std::max(own, served.first_readable));
            woken[target.core] |= ProcessMask{1} << target.process;
        }
        for (std::size_t core = 0; core < cores_.size(); ++core) {
            if (woken[core] == 0)
                continue;
            cores_[core]->resume(woken[core]);
            woken[core] = 0;
            settle(core, true);
        }
    }
}

}  // namespace faster::timing
