#include "timing/transition_bench.hpp"

#include <algorithm>

#include "timing/core_timing.hpp"

namespace faster::timing {

namespace {
std::unique_ptr<CoreTiming> bench_core(CoreTiming const& core, bool leaves_trails) {
    std::unique_ptr<CoreTiming> bench = core.blank_copy();
    if (leaves_trails)
        bench->leave_trail(Trail::any_length);
    return bench;
}
}  // namespace

TransitionBench::TransitionBench(CoreTiming const& core, Lead const& lead, bool leaves_trails)
    : core_(bench_core(core, leaves_trails)),
      group_(*core_, lead),
      state_(group_),
      counters_(state_.counters()),
      growth_(counters_.size() + 1),
      leaves_trails_(leaves_trails) {}

TransitionBench::~TransitionBench() = default;

void TransitionBench::start_from(Words const& from) {
    time_ += time_apart;
    if (time_ > last_time) {
        state_.forget_times();
        time_ = first_time;
    }
    state_.load(from, time_);
}

void TransitionBench::forget_growth() {
    for (std::uint64_t* counter : counters_)
        *counter = 0;
}

/// The counters count on from zero.
void TransitionBench::take_growth(std::vector<Transition::Growth>& growth) {
    Transition::Growth* end = growth_.data();
    std::uint32_t number = 0;
    for (std::uint64_t* const counter : counters_) {
        std::uint64_t const amount = *counter;
        *counter = 0;
        *end = {number++, amount};
        end += amount != 0 ? 1 : 0;
    }
    growth.assign(growth_.data(), end);
}

void TransitionBench::describe_peaks(std::vector<Transition::Peak>& peaks) const {
    for (std::uint32_t f = 0; f < group_.fifos().size(); ++f)
        if (state_.peak(f) > 0)
            peaks.push_back({f, static_cast<std::uint32_t>(state_.peak(f))});
}

std::vector<RelativeState::Waiting> TransitionBench::park(Words const& from) {
    start_from(from);
    std::vector<RelativeState::Waiting> waitings;
    for (unsigned m = 1; m < group_.members().size(); ++m)
        waitings.push_back(state_.park(m));
    take_growth(parking_growth_);
    state_.save(words_, RelativeState::all_logs);
    return waitings;
}

/// What has been left since the last call.
std::vector<TrailEvent> TransitionBench::take_trail() {
    return leaves_trails_ ? core_->take_trail(time_) : std::vector<TrailEvent>();
}

bool TransitionBench::work_out(Words const& from, Phrase const& phrase, Transition& transition) {
    start_from(from);
    std::size_t const members = group_.members().size();
    for (unsigned m = 0; m < members; ++m) {
        times_before_[m] = group_.members()[m].process->local_time();
        entries_before_[m] = state_.entries(m);
        ports_before_[m] = state_.parked_at(m);
        transition.iterations[m] = state_.iterations(m);
    }
    Phrase::write(phrase.codes(), phrase.size(), group_, [&](unsigned member, std::uint8_t next_ports, bool frozen) {
        transition.froze |= frozen ? 1U << member : 0U;
        state_.outlooks()[member] = {next_ports, frozen};
    });
    core_->resolve_processes(processes_of(phrase));
    if (!group_.driver().finished()) {
        take_trail();  // it came to nothing
        forget_growth();
        return false;
    }
    for (unsigned m = 0; m < members; ++m) {
        bool const entered = state_.entries(m) != entries_before_[m];
        transition.entered |= entered ? 1U << m : 0U;
        transition.iterations[m] = state_.iterations(m) - (entered ? 0 : transition.iterations[m]);
    }
    transition.cycles = group_.driver().local_time() - time_;
    describe(phrase, transition);
    transition.trail = take_trail();
    return true;
}

/// The driver and those that a phrase gives something to do.
std::uint32_t TransitionBench::processes_of(Phrase const& phrase) const {
    std::uint32_t processes = 0;
    for (unsigned m = 0; m < group_.members().size(); ++m)
        if (m == 0 || ((phrase.active() >> m) & 1U) != 0)
            processes |= 1U << group_.members()[m].process->index();
    return processes;
}

void TransitionBench::describe(Phrase const& phrase, Transition& transition) {
    describe_rooms(transition);
    describe_stands(phrase, transition);
    state_.save(words_, RelativeState::all_logs);
    state_.count_tokens();
    take_growth(transition.growth);
    describe_peaks(transition.peaks);
}

void TransitionBench::describe_stands(Phrase const& phrase, Transition& transition) {
    Cycles const end = group_.driver().local_time();
    auto const since_end = [end](Cycles cycle) { return static_cast<std::int64_t>(cycle - end); };
    for (unsigned m = 1; m < group_.members().size(); ++m) {
        bool const active = ((phrase.active() >> m) & 1U) != 0;
        if (state_.outlooks()[m].frozen && !active)
            continue;
        RelativeState::Waiting const waiting = state_.park(m);
        bool const waits_anew = waiting.waits && waiting.port != ports_before_[m];
        if (active || waits_anew || waiting.since != times_before_[m])
            transition.stands.push_back(
                {m, since_end(waiting.since), since_end(waiting.arrival), waiting.port, active});
    }
}

/// All a frozen writer needs to know later, which its state does not say.
void TransitionBench::describe_rooms(Transition& transition) {
    Cycles const end = group_.driver().local_time();
    for (unsigned f = 0; f < group_.fifos().size(); ++f) {
        Group::Inner const& inner = group_.fifos()[f];
        if (!state_.outlooks()[inner.writer].frozen)
            continue;
        bool const froze = ((transition.froze >> inner.writer) & 1U) != 0;
        std::vector<Cycles> const times = state_.room_times(f);
        std::size_t const fresh = froze ? times.size() : std::min(times.size(), RelativeState::loaded_reads(inner));
        Transition::Room room{f, froze, {}};
        for (std::size_t i = times.size() - fresh; i < times.size(); ++i)
            room.from.push_back(static_cast<std::int64_t>(times[i] - end));
        if (froze || fresh > 0)
            transition.rooms.push_back(std::move(room));
    }
}

}  // namespace faster::timing
