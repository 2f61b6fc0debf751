#include "dataflow/core/memory/memory_system.hpp"

#include <algorithm>
#include <utility>

#include "dataflow/core/time/core_timing.hpp"

namespace dataflow::timing {

MemorySystem::MemorySystem(ExternalMemory const& shape, std::vector<MasterShape> masters)
    : shape_(shape),
      shapes_(std::move(masters)),
      controllers_free_ps_(1),
      ports_free_(shape.ports),
      port_beats_(shape.ports) {}

void MemorySystem::add_core(CoreTiming& core, bool has_work, Resume resume) {
    if (resume == nullptr)
        resume = [&core](ProcessMask woken) { core.resume(woken); };
    cores_.push_back({&core, std::move(resume), 0, MemoryMaster::never});
    if (has_work)
        working_.push_back(&core);
    MemoryMaster::HandedOut& handed_out = handed_out_.emplace_back();
    std::size_t const number = cores_.size() - 1;
    for (std::size_t i = 0; i < shapes_.size(); ++i)
        masters_.push_back({MemoryMaster(shape_, core.stream(i), shapes_[i].prefetch, handed_out),
                            {number, shapes_[i].process},
                            number % shape_.ports,
                            shapes_[i].hands_out ? &handed_out : nullptr});
    if (!shape_.is_shared) {
        controllers_free_ps_.resize(masters_.size());
        ports_free_.resize(masters_.size());
    }
}

void MemorySystem::note_request(std::size_t master) {
    Joint& joint = masters_[master];
    std::optional<Cycles> const ask = joint.master.next_ask();
    if (!ask || joint.is_waiting)
        return;
    joint.is_waiting = true;
    requests_.emplace(*ask, master);
}

bool MemorySystem::follow_master(std::size_t master) {
    bool const delivered = masters_[master].master.follow(masters_[master].handing_out);
    note_request(master);
    return delivered;
}

std::vector<MemorySystem::Target> MemorySystem::follow() {
    std::vector<Target> targets;
    for (std::size_t master = 0; master < masters_.size(); ++master)
        if (follow_master(master))
            targets.push_back(masters_[master].target);
    return targets;
}

std::optional<Cycles> MemorySystem::next_ask() const {
    return requests_.empty() ? std::nullopt : std::optional<Cycles>(requests_.top().first);
}

MemorySystem::Target MemorySystem::serve_next() { return masters_[serve().master].target; }

/// The controller's and the port's rules.
MemorySystem::Served MemorySystem::serve() {
    auto const [ask, number] = requests_.top();
    requests_.pop();
    Joint& joint = masters_[number];
    joint.is_waiting = false;
    MemoryMaster& master = joint.master;
    MemoryBurst const& burst = master.next_burst();
    Picoseconds const arrival = Picoseconds{ask + shape_.request_cycles} * shape_.period_ps;
    Picoseconds& controller_free_ps = controllers_free_ps_[shape_.is_shared ? 0 : number];
    Picoseconds const begin = std::max(arrival, controller_free_ps);
    controller_free_ps = begin + burst.granules * shape_.granule_ps;
    controller_.granules += burst.granules;
    note_queue(arrival, begin);
    controller_.history.arrived(ask + shape_.request_cycles, burst.beats, begins_ps_.size());
    auto cycle = static_cast<Cycles>((begin + shape_.latency_ps + shape_.period_ps - 1) / shape_.period_ps);
    if (!master.stream().is_write()) {
        Cycles& port_free = ports_free_[shape_.is_shared ? joint.port : number];
        cycle = std::max(cycle, port_free);
        port_free = cycle + burst.beats;
        port_beats_[joint.port] += burst.beats;
    }
    if (served_call_)
        served_call_({ask, ask + shape_.request_cycles, begin, controller_free_ps, cycle, burst.beats, joint.port,
                      master.stream().is_write()});
    Served const served{number, master.served(cycle)};
    note_request(number);
    return served;
}

void MemorySystem::note_queue(Picoseconds arrival, Picoseconds begin) {
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
void MemorySystem::settle(std::size_t core, ProcessMask woken) {
    do {
        cores_[core].resume(woken);
        woken = 0;
        for (std::size_t master = core * shapes_.size(); master < (core + 1) * shapes_.size(); ++master)
            if (follow_master(master))
                woken |= bit_of(masters_[master].target.process);
    } while (woken != 0);
}

/// What comes of what was served is not before the process goes on that waits for it. Returns from when on it may.
Cycles MemorySystem::wake(Served const& served) {
    if (served.first_readable == MemoryMaster::never)
        return MemoryMaster::never;
    Target const target = masters_[served.master].target;
    Core& core = cores_[target.core];
    Cycles const own = core.timing->process(target.process).not_before();
    core.woken |= bit_of(target.process);
    core.goes_on_from = std::min(core.goes_on_from, std::max(own, served.first_readable));
    return core.goes_on_from;
}

void MemorySystem::let_go(std::size_t core) {
    cores_[core].goes_on_from = MemoryMaster::never;
    settle(core, std::exchange(cores_[core].woken, 0));
}

/// Serves as long as nobody can ask for anything before, and lets a core go on when it might: by then it has much to do
/// at once.
void MemorySystem::go_on(bool at_the_end) {
    for (std::size_t core = 0; core < cores_.size(); ++core) {
        cores_[core].timing->resolve(false);
        settle(core, 0);
    }
    auto const first_to_go_on = [this] {
        auto const is_before = [](Core const& one, Core const& other) { return one.goes_on_from < other.goes_on_from; };
        return std::min_element(cores_.begin(), cores_.end(), is_before);
    };
    for (;;) {
        Cycles const unknown = at_the_end ? MemoryMaster::never : unknown_from();
        Cycles before = std::min(unknown, first_to_go_on()->goes_on_from);
        while (!requests_.empty() && requests_.top().first < before)
            before = std::min(before, wake(serve()));
        auto const core = first_to_go_on();
        if (core->woken == 0)
            return;
        let_go(static_cast<std::size_t>(core - cores_.begin()));
    }
}

}  // namespace dataflow::timing
