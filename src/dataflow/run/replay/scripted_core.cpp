#include "dataflow/run/replay/scripted_core.hpp"

#include <utility>

#include "dataflow/base/each_bit.hpp"
#include "dataflow/run/replay/plain_reader.hpp"

namespace dataflow::replay {

namespace {
/// Members of a group that are told by scripts: the driver, and who answers it.
std::uint32_t scripted_members(timing::Group const& group) { return 1U | group.readers(); }

bool is_scripted(timing::Group const& group, std::size_t process) {
    bool scripted = false;
    for_each_bit(scripted_members(group),
                 [&](unsigned m) { scripted = scripted || group.members()[m].process->index() == process; });
    return scripted;
}
}  // namespace

ScriptedCore::ScriptedCore(ScriptSource const& source, timing::Lead const& lead, CoreShare share,
                           timing::PhraseCore& core, Leaves leaves)
    : source_(source), share_(share), core_(core), group_(core, lead), leaves_(std::move(leaves)) {
    core.be_told_in_form(!source.form().empty());
    for (std::size_t i = 0; i < core.processes().size(); ++i)
        for (std::size_t k = 0; k < share.count && !is_scripted(group_, i); ++k)
            append_sample(source[share.first + k].before[i], core.process(i).log());
}

void ScriptedCore::go_on(timing::ProcessMask woken) {
    if (!is_following_)
        core_.resume(woken);
    else if (still_waits(woken))
        return note_who_is_done();
    while (!is_left_ && (is_following_ || fed_ < share_.count)) {
        if (!is_following_ && awaits_driver())
            return note_who_is_done();
        if (!is_following_)
            take_up_next();
        if (!follow())
            return;
        end_sample();
    }
}

/// The driver, which has yet to do what made it stop.
bool ScriptedCore::still_waits(timing::ProcessMask woken) {
    core_.resolve_processes(woken);
    return !group_.driver().finished();
}

/// With a sample's worth of operations, as scripts do not pay, or end early: no more of them at a time.
bool ScriptedCore::awaits_driver() const {
    constexpr std::size_t most_left = 4096;  // operations behind a script
    timing::ProcessTiming const& driver = group_.driver();
    bool const is_far_behind = !core_.follows_script() || driver.log().pending() > most_left;
    return fed_ > 0 && is_far_behind && !driver.finished();
}

/// False: it waits for the memory.
bool ScriptedCore::follow() {
    core_.walk_through();
    if (!script_.done())
        note_who_is_done();
    return script_.done();
}

void ScriptedCore::take_up_next() {
    for_each_bit(scripted_members(group_), [this](unsigned m) {
        unsigned const process = group_.members()[m].process->index();
        append_sample(sample().before[process], core_.process(process).log());
    });
    script_ = sample().script_in(source_.book());
    core_.take_up(script_);
    is_following_ = true;
}

void ScriptedCore::end_sample() {
    sample().tell_rest(core_);
    core_.resolve(false);
    is_following_ = false;
    if (++fed_ == share_.count || !core_.follows_script())
        core_.resume(0);  // to the end of what is logged
    is_left_ = leaves_(core_);
}

/// With what the script has for him, and has something to do behind it.
void ScriptedCore::note_who_is_done() {
    std::uint32_t idle = 0;
    for_each_bit(group_.readers(), [&](unsigned m) {
        std::size_t const process = group_.members()[m].process->index();
        idle |= core_.processes()[process].log().exhausted() && has_more(process) ? 1U << m : 0U;
    });
    for (auto const* phrase = script_.next; phrase != script_.end && idle != 0; ++phrase)
        idle &= ~source_.book()[*phrase].active;
    has_more_to_say_ = has_more_to_say_ || idle != 0;
}

/// Behind the script at hand.
bool ScriptedCore::has_more(std::size_t process) const {
    bool const ends = is_following_ && !sample().after[process].empty();
    std::size_t const next = fed_ + (is_following_ ? 1 : 0);
    return ends || (next < share_.count && !source_[share_.first + next].before[process].empty());
}

}  // namespace dataflow::replay
