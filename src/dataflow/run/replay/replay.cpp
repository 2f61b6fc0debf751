#include "dataflow/run/replay/replay.hpp"

#include <algorithm>
#include <utility>

#include "dataflow/run/replay/plain_reader.hpp"

namespace dataflow::replay {

namespace {

/// The first follower that writes what the driver reads of it.
std::size_t supplier_of(timing::CoreTiming const& core, timing::Lead const& lead) {
    for (timing::Lead::Follower const& follower : lead.followers) {
        timing::ProcessTiming const& process = core.processes()[follower.process];
        for (unsigned port = 0; port < process.port_count(); ++port)
            if (process.writes(port) && core.number_of(process.fifo(port)) == follower.anchor)
                return follower.process;
    }
    return core.processes().size();
}

}  // namespace

Replay::Replay(ScriptSource const& source, Plain plain, CoreShare share, timing::PhraseCore& core,
               timing::Lead const& lead, Leaves leaves)
    : source_(source),
      plain_(std::move(plain)),
      share_(share),
      core_(core),
      leaves_(std::move(leaves)),
      has_followers_(!lead.followers.empty()),
      supplier_(supplier_of(core, lead)),
      is_stuck_(core.processes().size(), false) {}

bool Replay::go_on() {
    if (is_walking_)
        core_.arrive();
    for (; fed_ < share_.count && !is_over_; ++fed_) {
        is_walking_ = is_walking_ || begin_script(share_.first + fed_);
        is_walking_ = is_walking_ && core_.set_out();
        if (is_walking_)
            return true;
        end_sample(share_.first + fed_);
        if (leaves_ && leaves_(core_))
            break;
    }
    tell_end(core_);
    core_.resolve();
    return false;
}

bool Replay::is_stuck() const { return std::find(is_stuck_.begin(), is_stuck_.end(), true) != is_stuck_.end(); }

/// False if there is nothing to be followed.
bool Replay::begin_script(std::size_t sample) {
    times_before_ = all_times();
    is_scripted_ = sample < source_.size() && !is_stuck();
    core_.be_told_in_form(is_scripted_ && !source_.form().empty());
    if (is_scripted_)
        take_up(source_[sample], sample);
    return is_scripted_ && has_followers_;
}

void Replay::end_sample(std::size_t sample) {
    is_scripted_ ? source_[sample].tell_rest(core_) : feed_plain(sample);
    core_.resolve(false);
    if (all_times() == times_before_ || backlog() > usual_backlog)
        find_stuck();
}

void Replay::feed_plain(std::size_t sample) {
    SampleOperations const operations = plain_(sample);
    for (std::size_t i = 0; i < operations.size(); ++i)
        if (!is_stuck_[i] && !(i == supplier_ && sample < supplied_))
            append_sample(operations[i], core_.process(i).log());
}

void Replay::take_up(ScriptedSample const& scripted, std::size_t sample) {
    for (std::size_t i = 0; i < scripted.before.size(); ++i)
        if (i != supplier_)
            append_sample(scripted.before[i], core_.process(i).log());
    if (!has_followers_)
        return;
    supply(sample + 2);
    script_ = scripted.script_in(source_.book());
    core_.take_up(script_);
}

/// The supplier is a sample ahead, so that what it goes on with after the one at hand is known.
void Replay::supply(std::size_t end) {
    if (supplier_ == core_.processes().size())
        return;
    std::size_t const last = std::min({end, share_.first + share_.count, source_.size()});
    for (supplied_ = std::max(supplied_, share_.first); supplied_ < last; ++supplied_)
        append_sample(source_[supplied_].before[supplier_], core_.process(supplier_).log());
}

std::size_t Replay::backlog() {
    std::size_t operations = 0;
    for (std::size_t i = 0; i < is_stuck_.size(); ++i)
        operations += is_stuck_[i] ? 0 : core_.process(i).log().pending();
    return operations;
}

/// Together they tell whether anybody has moved.
Cycles Replay::all_times() const {
    Cycles sum = 0;
    for (timing::ProcessTiming const& process : core_.processes())
        sum += process.local_time();
    return sum;
}

/// Processes that wait for each other round in a circle, and those that wait for them, do so for ever: what comes after
/// that would only fill the memory. The supplier, which may be ahead, never has much of it. Who waits for somebody that
/// only waits to be told more may go on with that: a loop that rewinds lets tokens of a call out in the next one.
void Replay::find_stuck() {
    core_.resolve();
    std::vector<std::optional<std::size_t>> const awaited = awaited_processes();
    std::vector<bool> waits(awaited.size());
    for (std::size_t i = 0; i < awaited.size(); ++i)
        waits[i] = awaited[i].has_value();
    for (std::size_t i = 0; i < awaited.size();) {
        bool const may_go_on = waits[i] && !waits[*awaited[i]];
        waits[i] = waits[i] && !may_go_on;
        i = may_go_on ? 0 : i + 1;
    }
    is_over_ = std::find(waits.begin(), waits.end(), false) == waits.end();
    is_stuck_ = std::move(waits);
    if (supplier_ < is_stuck_.size())
        is_stuck_[supplier_] = false;
}

/// By process: for whom it waits, if it does; for itself if nobody is there.
std::vector<std::optional<std::size_t>> Replay::awaited_processes() {
    std::vector<std::optional<std::size_t>> awaited;
    for (unsigned i = 0; i < is_stuck_.size(); ++i) {
        using Status = timing::ProcessTiming::Status;
        timing::ProcessTiming& process = core_.process(i);
        Status const status = process.front();
        if (status == Status::ready || process.finished()) {
            awaited.emplace_back();
            continue;
        }
        unsigned const port = status == Status::blocked ? process.blocking_port() : process.flushing_port();
        int const other = core_.other_end(process, port);
        awaited.emplace_back(other < 0 ? i : static_cast<std::size_t>(other));
    }
    return awaited;
}

}  // namespace dataflow::replay
