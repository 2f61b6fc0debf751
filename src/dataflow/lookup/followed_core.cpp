#include "dataflow/lookup/followed_core.hpp"

#include <algorithm>

namespace dataflow::timing {

std::unique_ptr<PhraseCore> make_core() { return std::make_unique<FollowedCore>(); }
std::shared_ptr<Answers> make_answers() { return std::make_shared<Automaton>(); }

void FollowedCore::let_follow(Lead const& lead, std::shared_ptr<Answers> const& answers) {
    PhraseCore::let_follow(lead, answers);
    if (!lead.followers.empty())
        automaton_ = std::static_pointer_cast<Automaton>(answers);
}

void FollowedCore::complete_counters() {
    if (automaton_ != nullptr && group() != nullptr)
        automaton_->settle(*group(), session_);
}

void FollowedCore::note_trail(Trail& trail) {
    if (automaton_ == nullptr)
        return;
    automaton_->leave_trails();
    trail.set_passages(automaton_.get());
}

void FollowedCore::note_connected() {
    if (!keeps_logs())
        for (ProcessTiming& process : own_processes())
            if (std::unique_ptr<LoopsInSteps> loops = LoopsInSteps::of(process, lead().has(process.index())))
                in_steps_.push_back(std::move(loops));
    PhraseCore::note_connected();
    if (group() != nullptr)
        for (std::unique_ptr<LoopsInSteps> const& loops : in_steps_)
            is_group_in_steps_ = is_group_in_steps_ || group()->has(loops->process());
}

PhraseCore::Form FollowedCore::form() {
    connect();
    Form form;
    if (!is_group_in_steps_)
        return form;
    for (std::unique_ptr<LoopsInSteps> const& loops : in_steps_)
        loops->add_form(form);
    return form;
}

PhraseCore::Formed FollowedCore::put_in_form(std::size_t process, std::vector<Operation>& operations) {
    connect();
    for (std::unique_ptr<LoopsInSteps> const& loops : in_steps_)
        if (loops->process().index() == process)
            return loops->rewrite(operations) ? Formed::anew : Formed::impossible;
    return Formed::as_before;
}

void FollowedCore::be_told_in_form(bool is_in_form) {
    if (is_in_form == is_told_in_steps_)
        return;
    connect();
    look_at_logs();
    is_told_in_steps_ = is_in_form;
    for (std::unique_ptr<LoopsInSteps> const& loops : in_steps_)
        loops->pass_over();
}

void FollowedCore::look_at_logs() {
    if (is_told_in_steps_)
        return;
    for (std::unique_ptr<LoopsInSteps> const& loops : in_steps_)
        loops->rewrite();
}

bool FollowedCore::is_followed() {
    return automaton_ != nullptr && automaton_->fits(*this, lead(), *group(), is_group_in_steps_);
}

void FollowedCore::resume(ProcessMask processes) {
    connect();
    look_at_logs();
    if (!is_followed()) {
        resolve_processes(processes);
    } else {
        go_on(true);
        shorten_trail();
    }
}

void FollowedCore::go_on(bool to_the_end) {
    if (!is_followed()) {
        PhraseCore::go_on(to_the_end);
    } else if (group_has_started()) {
        for (;;) {
            settle(all_processes(), bit_of(lead().driver));
            Automaton::Progress const progress = automaton_->follow(*group(), session_);
            if (progress.later && !to_the_end)
                break;
            if (!let_driver_go() && !progress.moved && !keep_more())
                break;
        }
    }
}

void FollowedCore::take_up(Script& script) {
    PhraseCore::take_up(script);
    walk_ = {group(), &session_, &script, nullptr, nullptr, nullptr, 0};
    follows_ = (!is_group_in_steps_ || is_told_in_steps_) && is_followed();
}

bool FollowedCore::set_out() {
    look_at_logs();
    while (!script()->done()) {
        if (follows_ && group_has_started()) {
            settle(all_processes(), bit_of(lead().driver));
            if (Automaton::is_where_script_goes_on(*group()) && automaton_->set_out(walk_))
                return true;
            if (let_driver_go())
                continue;
        }
        if (follows_ && awaits_memory())
            return false;
        write_next_phrase();
    }
    return false;
}

/// The driver waits for somebody who may wait for the memory.
bool FollowedCore::awaits_memory() const { return !streams().empty() && !group()->driver().finished(); }

void FollowedCore::let_walk() { automaton_->go_on(std::vector<Automaton::Walk*>{&walk_}); }

void FollowedCore::arrive() {
    bool const moved = automaton_->arrive(walk_);
    if (!let_driver_go() && !moved && !script()->done())
        write_next_phrase();
}

void FollowedCore::write_next_phrase() {
    // A driver with operations left waits for somebody, and will wait however many more there are.
    follows_ = follows_ && group()->driver().finished();
    write_next(*group(), *script());
}

/// What a process waited before its first access is no stall, and no state of the automaton tells it: until all of the
/// group have begun, the driver goes step by step.
bool FollowedCore::group_has_started() {
    auto const has_begun = [](Group::Member const& member) { return member.process->has_accessed(); };
    while (!started_) {
        settle(all_processes(), bit_of(lead().driver));
        started_ = std::all_of(group()->members().begin(), group()->members().end(), has_begun);
        ProcessTiming& driver = process(lead().driver);
        if (started_ || driver.front() != ProcessTiming::Status::ready)
            break;
        driver.commit_front();
    }
    return started_;
}

/// Up to the next sample at most; false: it could not move.
bool FollowedCore::let_driver_go() {
    ProcessTiming& driver = process(lead().driver);
    std::size_t const before = driver.log().pending();
    return driver.advance(true) != 0 || driver.log().pending() != before;
}

std::size_t Automaton::go_on(std::vector<PhraseCore*> const& cores) {
    std::vector<Walk*> walks;
    walks.reserve(cores.size());
    for (PhraseCore* const core : cores)
        walks.push_back(&static_cast<FollowedCore&>(*core).walk());
    return go_on(walks);
}

}  // namespace dataflow::timing
