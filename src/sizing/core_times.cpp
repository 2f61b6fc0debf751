#include "sizing/core_times.hpp"

#include <algorithm>

#include "common/input_error.hpp"
#include "common/on_threads.hpp"
#include "config/core_share.hpp"
#include "retiming/retime.hpp"
#include "timing/path_sweep.hpp"

namespace faster::sizing {

namespace {

/// At most as much room everywhere, and at least as much latency.
bool is_no_faster(Choice const& one, Choice const& other) {
    for (std::size_t i = 0; i < fifo_count; ++i)
        if (one[i].capacity() > other[i].capacity() || one[i].read_latency() < other[i].read_latency())
            return false;
    return true;
}

std::size_t cores_with_samples(std::size_t cores, std::size_t samples) {
    std::size_t used = 0;
    while (used < cores && share_of(used, cores, samples).count > 0)
        ++used;
    return used;
}

constexpr auto collector = static_cast<unsigned>(ModuleId::result_collector);

std::vector<Cycles> const& results_of(timing::CoreTiming const& core) { return core.processes()[collector].stamps(); }

/// How often a path turns at a port of a process, wherever in its program.
std::uint64_t turns_at(timing::ProcessTiming const& process, unsigned port, timing::PathSums const& path) {
    auto const loops = static_cast<unsigned>(process.loops().size());
    std::uint64_t turns = 0;
    for (unsigned number = 0; number < timing::Region::count(loops); ++number)
        turns += path.turns(process.index(), timing::Region::numbered(number), port);
    return turns;
}

using Members = std::array<Cut::Member, fifo_count>;

Members members_of_path(timing::CoreTiming const& core) {
    timing::PathSums const path = critical_path(core, collector, results_of(core).back());
    Members members{};
    for (timing::ProcessTiming const& process : core.processes())
        for (unsigned port = 0; port < process.port_count(); ++port) {
            timing::FifoTiming const& fifo = process.fifo(port);
            if (turns_at(process, port, path) == 0)
                continue;
            Cut::Member& member = members[core.number_of(fifo)];
            if (process.writes(port))
                member.capacity = fifo.shape().capacity;
            else
                member.is_slow = fifo.shape().read_latency > 1;
        }
    return members;
}

/// The processes that wait for each other in a circle; others may only wait for these.
std::vector<timing::Wait> circle_of(std::vector<timing::Wait> const& waits) {
    std::vector<timing::Wait> chain;
    for (std::string next = waits.front().process;;) {
        auto const waits_there = [&next](timing::Wait const& wait) { return wait.process == next; };
        auto const seen = std::find_if(chain.begin(), chain.end(), waits_there);
        if (seen != chain.end())
            return {seen, chain.end()};
        auto const wait = std::find_if(waits.begin(), waits.end(), waits_there);
        if (wait == waits.end())
            return waits;
        chain.push_back(*wait);
        next = wait->other;
    }
}

/// Everything else could have all the room it wants: what is full would be as full.
Members members_of_deadlock(timing::CoreTiming& core) {
    Members members{};
    for (timing::Wait const& wait : circle_of(core.waits()))
        for (std::size_t i = 0; i < fifo_count; ++i)
            if (wait.to_write && wait.fifo == fifo_names[i])
                members[i].capacity = wait.capacity;
    return members;
}

}  // namespace

CoreTimes::CoreTimes(retiming::RecordedRun const& run, AcceleratorConfig config)
    : run_(run, config.flow),
      config_(std::move(config)),
      cores_(cores_with_samples(config_.raster_cores, run.tape.samples())) {}

bool CoreTimes::is_known(std::size_t core, Choice const& choice) const {
    std::lock_guard<std::mutex> const lock(mutex_);
    return known_.count({core, choice}) > 0;
}

Cycles CoreTimes::end_of(timing::CoreTiming& core, std::size_t number) const {
    if (!core.waits().empty())
        return Cut::deadlock;
    auto const is_left = [](timing::FifoTiming const& fifo) { return fifo.writes() != fifo.reads(); };
    std::size_t const samples = share_of(number, config_.raster_cores, run_.run().tape.samples()).count;
    if (results_of(core).size() != samples || std::any_of(core.fifos().begin(), core.fifos().end(), is_left))
        throw InputError("what the recorded processes write is not what they read, expected the file of a run");
    return results_of(core).back() + 1;
}

void CoreTimes::enter(Place const& place, timing::CoreTiming& core) {
    Cycles const end = end_of(core, place.first);
    std::lock_guard<std::mutex> const lock(mutex_);
    ++retimed_;
    known_.emplace(place, end);
    if (end != Cut::deadlock)
        for (std::size_t i = 0; i < fifo_count; ++i)
            tokens_[i] = std::max(tokens_[i], core.fifos()[i].writes());
}

void CoreTimes::work_out(std::vector<std::size_t> const& cores, Choice const& choice) {
    auto const timings = retime_cores(run_, with_choice(config_, choice), cores);
    for (std::size_t i = 0; i < cores.size(); ++i)
        enter({cores[i], choice}, *timings[i]);
}

std::optional<bool> CoreTimes::known_to_exceed(std::size_t core, Choice const& choice, Cycles bound) const {
    std::lock_guard<std::mutex> const lock(mutex_);
    for (auto known = known_.lower_bound({core, Choice{}}); known != known_.end() && known->first.first == core;
         ++known) {
        auto const& [place, cycles] = *known;
        if (cycles > bound ? is_no_faster(choice, place.second) : is_no_faster(place.second, choice))
            return cycles > bound;
    }
    return std::nullopt;
}

bool CoreTimes::exceeds(std::size_t core, Choice const& choice, Cycles bound) {
    std::optional<bool> const known = known_to_exceed(core, choice, bound);
    return known ? *known : cycles(core, choice) > bound;
}

std::size_t CoreTimes::first_to_exceed(Choice const& choice, Cycles bound, unsigned jobs) {
    for (std::size_t core = 0; core < cores_;) {
        std::vector<std::size_t> open;
        bool is_decided = false;
        for (; core < cores_ && open.size() < std::max(1U, jobs) && !is_decided; ++core) {
            std::optional<bool> const known = known_to_exceed(core, choice, bound);
            is_decided = known.value_or(false);
            if (!known)
                open.push_back(core);
        }
        on_threads(open.size(), jobs, [&](std::size_t i) { work_out({open[i]}, choice); });
        for (std::size_t const worked_out : open)
            if (cycles(worked_out, choice) > bound)
                return worked_out;
        if (is_decided)
            return core - 1;
    }
    return cores_;
}

Cycles CoreTimes::cycles(std::size_t core, Choice const& choice) {
    if (!is_known(core, choice))
        work_out({core}, choice);
    std::lock_guard<std::mutex> const lock(mutex_);
    return known_.at({core, choice});
}

Cycles CoreTimes::total_cycles(Choice const& choice, unsigned jobs) {
    std::vector<std::vector<std::size_t>> shares(std::max(1U, jobs));
    std::size_t next = 0;
    for (std::size_t core = 0; core < cores_; ++core)
        if (!is_known(core, choice))
            shares[next++ % shares.size()].push_back(core);
    on_threads(shares.size(), jobs, [&](std::size_t i) { work_out(shares[i], choice); });
    Cycles total = 0;
    for (std::size_t core = 0; core < cores_; ++core)
        total = std::max(total, cycles(core, choice));
    return total;
}

Cut CoreTimes::explain(std::size_t core, Choice const& choice) {
    auto const timings = retime_cores(run_, with_choice(config_, choice), {core}, true);
    timing::CoreTiming& timing = *timings.front();
    enter({core, choice}, timing);
    Cut cut;
    cut.total_cycles = end_of(timing, core);
    Members const members = cut.total_cycles == Cut::deadlock ? members_of_deadlock(timing) : members_of_path(timing);
    for (std::size_t i = 0; i < fifo_count; ++i)
        if (members[i].capacity > 0 || members[i].is_slow) {
            cut.members.push_back(members[i]);
            cut.members.back().fifo = static_cast<FifoId>(i);
        }
    return cut;
}

}  // namespace faster::sizing
