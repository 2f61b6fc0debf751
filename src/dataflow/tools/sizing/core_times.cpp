#include "dataflow/tools/sizing/core_times.hpp"

#include <algorithm>
#include <numeric>

#include "dataflow/base/core_share.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/core/machine/core_ends.hpp"
#include "dataflow/run/replay/collect.hpp"
#include "dataflow/tools/sizing/cut_members.hpp"
#include "dataflow/tools/sizing/writes_in_a_cycle.hpp"

namespace dataflow::sizing {

namespace {

/// At most as much room everywhere, and at least as much latency.
bool is_no_faster(Choice const& one, Choice const& other) {
    for (std::size_t i = 0; i < one.size(); ++i)
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

/// The first FIFO's port at which a process reads; none if it reads none.
std::optional<unsigned> first_read_port(timing::ProcessTiming const& process) {
    for (unsigned port = 0; port < process.port_count(); ++port)
        if (!process.writes(port) && !process.fifo(port).is_stream())
            return port;
    return std::nullopt;
}

Cycles stalls_of(timing::ProcessTiming const& process) {
    return process.empty_stall_cycles() + process.full_stall_cycles();
}

/// Leaves a core once nobody needs it any more, and knows that it did.
class GivenUp {
  public:
    explicit GivenUp(CoreTimes::IsObsolete is_obsolete) : is_obsolete_(std::move(is_obsolete)) {}
    replay::Leaves or_if(replay::Leaves const& leaves) {
        return [this, leaves](timing::CoreTiming const& core) {
            is_given_up_ = is_obsolete_ && is_obsolete_();
            return is_given_up_ || (leaves && leaves(core));
        };
    }
    explicit operator bool() const { return is_given_up_; }

  private:
    CoreTimes::IsObsolete is_obsolete_;
    bool is_given_up_ = false;
};

/// No FIFO changes it.
Cycles load_of(replay::RecordedRun const& run, Machine const& machine) {
    return run.memory ? replay::load_cycles(machine, run.memory->loaded) : 0;
}

}  // namespace

CoreTimes::CoreTimes(replay::RecordedRun const& run, Machine const& machine, BeforeRetiming before_retiming)
    : CoreTimes(std::make_shared<replay::ScriptedRun const>(run), machine, load_of(run, machine),
                writes_in_a_cycle(run), std::move(before_retiming)) {}

CoreTimes::CoreTimes(Run run, Machine machine, Cycles load, std::vector<std::uint64_t> writes,
                     BeforeRetiming before_retiming)
    : run_(std::move(run)),
      machine_(std::move(machine)),
      load_(load),
      writes_(std::move(writes)),
      before_retiming_(std::move(before_retiming)),
      freezing_(freezing_fifos(machine_)),
      are_together_(shares_memory(machine_)),
      relaxed_(freezing_.empty() && !are_together_
                   ? nullptr
                   : new CoreTimes(run_, sizing::relaxed(machine_), load_, writes_, before_retiming_)),
      cores_(cores_with_samples(machine_.cores, run_->run().tape.samples())),
      tokens_(machine_.fifos.size()),
      work_(cores_) {}

/// A FIFO was full behind a pipeline that freezes then, if it does.
bool CoreTimes::has_frozen(Choice const& choice, Known const& known) const {
    return std::any_of(freezing_.begin(), freezing_.end(),
                       [&](std::size_t fifo) { return choice[fifo].capacity() < known.room[fifo]; });
}

/// The relaxed machine does the same as long as nothing would freeze, and no memory is shared.
std::optional<CoreTimes::Known> CoreTimes::known(std::size_t core, Choice const& choice) const {
    std::optional<Known> relaxed = is_monotone() || are_together_ ? std::nullopt : relaxed_->known(core, choice);
    if (relaxed && !relaxed->is_left_early && !has_frozen(choice, *relaxed))
        return relaxed;
    std::lock_guard<std::mutex> const lock(mutex_);
    auto const known = known_.find({core, choice});
    if (known != known_.end() && !known->second.is_left_early)
        return known->second;
    for (auto other = known_.lower_bound({core, Choice{}}); other != known_.end() && other->first.first == core;
         ++other)
        if (!other->second.is_left_early && is_same(choice, other->first, other->second))
            return other->second;
    return known == known_.end() ? std::nullopt : std::optional(known->second);
}

bool CoreTimes::is_done(std::size_t core, Choice const& choice) const {
    std::optional<Known> const there = known(core, choice);
    return there && !there->is_left_early;
}

Cycles CoreTimes::least_cycles(std::size_t core, Choice const& choice) const {
    std::optional<Known> const there = known(core, choice);
    return there ? there->end : 0;
}

std::uint64_t CoreTimes::needed_room(Choice const& choice, std::size_t fifo) const {
    std::uint64_t room = 1;
    for (std::size_t core = 0; core < cores_; ++core)
        room = std::max(room, known(core, choice)->room[fifo]);
    return std::min(room, choice[fifo].capacity());
}

bool CoreTimes::was_full(Choice const& choice, std::size_t fifo) const {
    for (std::size_t core = 0; core < cores_; ++core)
        if (known(core, choice)->room[fifo] > choice[fifo].capacity())
            return true;
    return false;
}

/// Enough room for what happened there, and at most its latency.
bool CoreTimes::is_as_fast(Choice const& choice, CoreChoice const& place, Known const& known) {
    for (std::size_t i = 0; i < choice.size(); ++i)
        if (choice[i].capacity() < std::min(known.room[i], place.second[i].capacity()) ||
            choice[i].read_latency() > place.second[i].read_latency())
            return false;
    return true;
}

/// Whether two choices make no difference: latencies are equal, and room is too, or more than is needed. Where a run
/// got stuck, what was full is not all counted.
bool CoreTimes::is_same(Choice const& choice, CoreChoice const& place, Known const& known) {
    if (known.is_left_early || known.end == Cut::deadlock)
        return choice == place.second;
    for (std::size_t i = 0; i < choice.size(); ++i) {
        FifoChoice const& there = place.second[i];
        bool const is_never_full = std::min(choice[i].capacity(), there.capacity()) >= known.room[i];
        if (choice[i].read_latency() != there.read_latency() ||
            (choice[i].capacity() != there.capacity() && !is_never_full))
            return false;
    }
    return true;
}

Cycles CoreTimes::end_of(timing::CoreTiming& core, std::size_t number) const {
    if (!core.blocked().empty())
        return Cut::deadlock;
    auto const is_left = [&](timing::FifoTiming const& fifo) {
        return fifo.writes() != fifo.reads() && !machine_.fifos[core.number_of(fifo)].may_keep_tokens;
    };
    std::size_t const samples = share_of(number, machine_.cores, run_->run().tape.samples()).count;
    if (results_of(core).size() != samples || std::any_of(core.fifos().begin(), core.fifos().end(), is_left))
        throw InputError("what the recorded processes write is not what they read, expected the file of a run");
    std::optional<RunEnd> const end = run_end(machine_, core);
    return load_ + (end ? end->cycle + 1 : 0);
}

CoreTimes::Known CoreTimes::outcome(std::size_t number, timing::CoreTiming& core) {
    Known known{end_of(core, number), false, {}};
    if (known.end != Cut::deadlock && is_monotone())
        note_work(number, core, results_of(core).back() + 1);
    for (std::size_t i = 0; i < machine_.fifos.size(); ++i) {
        timing::FifoTiming const& fifo = core.fifos()[i];
        // Tokens enter beside what was there at the end of the cycle before: what leaves in theirs still has its place.
        known.room.push_back(fifo.final_max_occupancy() + writes_[i]);
        if (known.end != Cut::deadlock)
            tokens_[i] = std::max(tokens_[i], fifo.writes());
    }
    return known;
}

/// Room that one core needs makes the others what they are, where cores are together.
void CoreTimes::enter(std::vector<std::size_t> const& cores, Choice const& choice, replay::Cores const& timings) {
    std::lock_guard<std::mutex> const lock(mutex_);
    std::vector<Known> outcomes;
    for (std::size_t i = 0; i < cores.size(); ++i)
        outcomes.push_back(outcome(cores[i], *timings[i]));
    std::vector<std::uint64_t> room(machine_.fifos.size());
    for (std::size_t i = 0; i < room.size(); ++i)
        for (Known const& one : outcomes)
            room[i] = std::max(room[i], one.room[i]);
    for (std::size_t i = 0; i < cores.size(); ++i) {
        if (are_together_)
            outcomes[i].room = room;
        known_[{cores[i], choice}] = std::move(outcomes[i]);
    }
    retimed_ += cores.size();
}

replay::Cores CoreTimes::retimed(std::vector<std::size_t> const& cores, Choice const& choice,
                                 replay::CoreOptions const& options) const {
    if (before_retiming_)
        before_retiming_();
    return retime_cores(*run_, with_choice(machine_, choice), cores, options);
}

void CoreTimes::work_out(std::vector<std::size_t> const& cores, Choice const& choice) {
    if (!cores.empty())
        enter(cores, choice, retimed(cores, choice, {}));
}

std::vector<Cycles> const& CoreTimes::results_of(timing::CoreTiming const& core) const {
    return core.processes()[machine_.ends].stamps();
}

/// Null if the process that ends samples reads nothing.
timing::ProcessTiming const* CoreTimes::writer_of_results(timing::CoreTiming const& core) const {
    timing::ProcessTiming const& collector = core.processes()[machine_.ends];
    std::optional<unsigned> const port = first_read_port(collector);
    return port ? &core.processes()[static_cast<std::size_t>(core.other_end(collector, *port))] : nullptr;
}

/// What the writer of the results does is the same with all FIFOs; only its waiting is not. It takes at least what the
/// collector waits for it up to the last result: its last token comes no sooner. Both may wait otherwise, and the
/// collector go on after the last result: that is left out. Not of a lead group, whose waiting nobody knows on the way.
void CoreTimes::note_work(std::size_t number, timing::CoreTiming const& core, Cycles end) {
    timing::ProcessTiming const* const writer = writer_of_results(core);
    if (work_[number] || writer == nullptr || writer->flushes() || run_->lead().has(writer->index()))
        return;
    timing::ProcessTiming const& collector = core.processes()[machine_.ends];
    Cycles const waited = collector.fifo(*first_read_port(collector)).empty_stall_cycles();
    Cycles const behind_end = collector.local_time() - std::min(collector.local_time(), end);
    Cycles const left_out =
        stalls_of(*writer) + writer->memory_stall_cycles() + writer->awaited_setup_cycles() + behind_end;
    work_[number] = waited - std::min(waited, left_out);
}

/// What a core works at least, on the relaxed machine if times are not monotone.
std::optional<Cycles> CoreTimes::work_of(std::size_t core) const {
    if (!is_monotone())
        return relaxed_->work_of(core);
    std::lock_guard<std::mutex> const lock(mutex_);
    return work_[core];
}

/// It has waited too long for its work still to be done in time. Cores that are together go to their ends.
replay::Leaves CoreTimes::as_soon_as_exceeds(std::size_t core, Cycles bound) const {
    std::optional<Cycles> const work = work_of(core);
    if (!work || are_together_)
        return nullptr;
    return [=](timing::CoreTiming const& timing) {
        return !results_of(timing).empty() && load_ + *work + stalls_of(*writer_of_results(timing)) > bound;
    };
}

void CoreTimes::work_out_whether_exceeds(std::size_t core, Choice const& choice, Cycles bound,
                                         IsObsolete const& is_obsolete) {
    GivenUp given_up{is_obsolete};
    replay::CoreOptions options;
    options.leaves = given_up.or_if(as_soon_as_exceeds(core, bound));
    std::vector<std::size_t> const cores = with(core);
    auto const timings = retimed(cores, choice, options);
    if (!given_up && (are_together_ || !enter_as_left({core, choice}, *timings.front(), bound)))
        enter(cores, choice, timings);
}

std::vector<std::size_t> CoreTimes::with(std::size_t core) const {
    std::vector<std::size_t> cores{core};
    if (are_together_) {
        cores.resize(cores_);
        std::iota(cores.begin(), cores.end(), std::size_t{0});
    }
    return cores;
}

/// False if it has not been left before its end.
bool CoreTimes::enter_as_left(CoreChoice const& place, timing::CoreTiming const& core, Cycles bound) {
    replay::Leaves const exceeds = as_soon_as_exceeds(place.first, bound);
    std::size_t const done = results_of(core).size();
    std::size_t const samples = share_of(place.first, machine_.cores, run_->run().tape.samples()).count;
    if (done == samples || !exceeds || !exceeds(core))
        return false;
    Cycles const least = load_ + *work_of(place.first) + stalls_of(*writer_of_results(core));
    std::lock_guard<std::mutex> const lock(mutex_);
    ++retimed_;
    Known& known = known_[place];
    if (known.end < least)
        known = {least, true, {}};
    return true;
}

bool CoreTimes::is_told_by(CoreChoice const& place, Known const& known, Choice const& choice, bool exceeds) const {
    if (!is_monotone())
        return is_same(choice, place, known);
    return exceeds ? is_no_faster(choice, place.second) : is_as_fast(choice, place, known);
}

std::optional<bool> CoreTimes::known_to_exceed(std::size_t core, Choice const& choice, Cycles bound) const {
    if (!is_monotone() && relaxed_->known_to_exceed(core, choice, bound).value_or(false))
        return true;
    if (!is_monotone() && is_done(core, choice))
        return known(core, choice)->end > bound;
    std::lock_guard<std::mutex> const lock(mutex_);
    for (auto known = known_.lower_bound({core, Choice{}}); known != known_.end() && known->first.first == core;
         ++known) {
        bool const exceeds = known->second.end > bound;
        if (!exceeds && known->second.is_left_early)
            continue;
        if (is_told_by(known->first, known->second, choice, exceeds))
            return exceeds;
    }
    return std::nullopt;
}

bool CoreTimes::exceeds(std::size_t core, Choice const& choice, Cycles bound) {
    return exceeds(core, choice, bound, nullptr).value();
}

std::optional<bool> CoreTimes::exceeds(std::size_t core, Choice const& choice, Cycles bound,
                                       IsObsolete const& is_obsolete) {
    if (std::optional<bool> const known = known_to_exceed(core, choice, bound))
        return known;
    work_out_whether_exceeds(core, choice, bound, is_obsolete);
    return known_to_exceed(core, choice, bound);
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
        on_threads(open.size(), jobs, [&](std::size_t i) { work_out_whether_exceeds(open[i], choice, bound); });
        for (std::size_t const worked_out : open)
            if (known_to_exceed(worked_out, choice, bound).value())
                return worked_out;
        if (is_decided)
            return core - 1;
    }
    return cores_;
}

Cycles CoreTimes::cycles(std::size_t core, Choice const& choice) {
    if (!is_done(core, choice))
        work_out(with(core), choice);
    return known(core, choice)->end;
}

Cycles CoreTimes::total_cycles(Choice const& choice, unsigned jobs) {
    std::vector<std::vector<std::size_t>> shares(are_together_ ? 1 : std::max(1U, jobs));
    std::size_t next = 0;
    for (std::size_t core = 0; core < cores_; ++core)
        if (!is_done(core, choice))
            shares[next++ % shares.size()].push_back(core);
    on_threads(shares.size(), jobs, [&](std::size_t i) { work_out(shares[i], choice); });
    Cycles total = 0;
    for (std::size_t core = 0; core < cores_; ++core)
        total = std::max(total, cycles(core, choice));
    return total;
}

Cut CoreTimes::explain(std::size_t core, Choice const& choice) { return suspects(core, choice, Cut::deadlock).value(); }

replay::Cores CoreTimes::with_trails(std::size_t core, Choice const& choice, replay::Leaves const& leaves) const {
    replay::CoreOptions options;
    options.leave_trails = true;
    options.leaves = leaves;
    return retimed(with(core), choice, options);
}

Cut CoreTimes::first_suspects(std::size_t core, Choice const& choice, std::size_t samples) const {
    replay::Cores const timings = with_trails(
        core, choice, [=](timing::CoreTiming const& so_far) { return results_of(so_far).size() >= samples; });
    timing::CoreTiming const& timing = *timings[are_together_ ? core : 0];
    if (results_of(timing).empty())
        return {};
    return {members_of_path(timing, {machine_.ends, results_of(timing).back()}), results_of(timing).back() + 1};
}

std::optional<Cut> CoreTimes::suspects(std::size_t core, Choice const& choice, Cycles bound,
                                       IsObsolete const& is_obsolete) {
    GivenUp given_up{is_obsolete};
    replay::Cores const timings = with_trails(core, choice, given_up.or_if(as_soon_as_exceeds(core, bound)));
    if (given_up)
        return std::nullopt;
    timing::CoreTiming& timing = *timings[are_together_ ? core : 0];
    bool const is_left = !are_together_ && enter_as_left({core, choice}, timing, bound);
    if (!is_left)
        enter(with(core), choice, timings);
    Cycles const cycles = is_left ? least_cycles(core, choice) : end_of(timing, core);
    Members const members = cycles == Cut::deadlock ? members_of_deadlock(timing)
                            : is_left ? members_of_path(timing, {machine_.ends, results_of(timing).back()})
                                      : members_of_path(timing, run_end(machine_, timing).value_or(RunEnd()));
    return Cut{members, cycles};
}

}  // namespace dataflow::sizing
