#include "hls/loop_recorder.hpp"

#include <cstring>

#include "dataflow/base/input_error.hpp"

namespace dataflow::untimed {

namespace {
constexpr std::uint64_t most_idle_iterations = std::uint64_t{1} << 26U;  ///< seconds
}

void IdleIterations::count(std::string const& process, LoopMark const& loop) {
    if (++count_ > most_idle_iterations)
        throw InputError("process " + process + " has begun more than " + std::to_string(most_idle_iterations) +
                         " iterations of its loop " + loop.name +
                         " without an access to a stream, expected a function that returns");
}

std::size_t LoopRecorder::number_of(LoopMark const& loop) {
    for (std::size_t i = 0; i < loops_.size(); ++i) {
        if (std::strcmp(loops_[i].name, loop.name) != 0)
            continue;
        if (loops_[i].ii != loop.ii || loops_[i].depth != loop.depth || loops_[i].is_pipelined != loop.is_pipelined)
            throw InputError("process " + process_ + " has two loops of the name " + loop.name +
                             " that differ, expected another name for one of them");
        return i;
    }
    loops_.push_back(loop);
    return loops_.size() - 1;
}

std::size_t LoopRecorder::group_of(Accesses const& accesses) {
    auto const [at, is_new] = group_numbers_.try_emplace(accesses, groups_.size());
    if (is_new)
        groups_.push_back(accesses);
    return at->second;
}

void LoopRecorder::leave() {
    condition_.clear();
    if (is_in_loop_)
        events_.push_back({Event::What::leave});
    is_in_loop_ = false;
}

void LoopRecorder::attempt(Access const& access) {
    idle_.ends();
    attempts_.insert(access);
    bool const is_open = !open_.empty() && !open_.back().is_around;
    if (!is_open && !is_in_loop_)
        return;
    attempts_in_.insert({is_open ? open_.back().loop : loop_, access});
    if (is_open && !access.writes)
        look_behind();
    (is_open ? open_.back().attempts : condition_).push_back(access);
}

/// The iteration at hand reads, or asks.
void LoopRecorder::look_behind() {
    for (Access const& before : open_.back().attempts)
        before_reads_.insert({open_.back().loop, before});
}

void LoopRecorder::access(Access access) {
    idle_.ends();
    if (!open_.empty() && !open_.back().is_around) {
        if (!access.writes)
            look_behind();
        open_.back().accesses.push_back(access);
        return;
    }
    leave();
    events_.push_back({Event::What::access, group_of({access})});
}

void LoopRecorder::put_around(Open& outer) {
    if (outer.is_around)
        return;
    LoopMark const& loop = loops_[outer.loop];
    if (loop.is_pipelined)
        throw InputError("process " + process_ + " has a marked loop in its pipelined loop " + loop.name +
                         ", which a tool would unroll, expected a mark of one of the two only");
    if (loop.is_block())
        throw InputError("process " + process_ + " has a marked loop in its block of states " + loop.name +
                         ", expected a block without one, { FASTER_STATES(" + loop.name + ", STATES); }");
    outer.is_around = true;
    around_.insert(loop.name);
    for (Access const& one : std::exchange(outer.accesses, {}))
        access(one);
}

void LoopRecorder::begin(LoopMark const& loop) {
    idle_.count(process_, loop);
    if (!open_.empty())
        put_around(open_.back());
    open_.push_back({number_of(loop), {}, std::exchange(condition_, {})});
}

void LoopRecorder::end() {
    Open const ended = std::move(open_.back());
    open_.pop_back();
    if (ended.is_around) {
        leave();
        return;
    }
    if (is_in_loop_ && loop_ != ended.loop)
        leave();
    if (!is_in_loop_)
        events_.push_back({Event::What::enter, ended.loop});
    is_in_loop_ = true;
    loop_ = ended.loop;
    std::size_t const group = group_of(ended.accesses);
    if (events_.back().what == Event::What::iterate && events_.back().number == group)
        ++events_.back().count;
    else
        events_.push_back({Event::What::iterate, group});
}

/// Iterations of loops around others in which those have none are no different: what they access is outside loops.
Events LoopRecorder::as_parts(Events const& events) {
    Events parts;
    bool is_around = false;
    for (Event const& event : events) {
        if (event.what == Event::What::enter)
            is_around = around_.count(loops_[event.number].name) != 0;
        if (!is_around) {
            parts.push_back(event);
            continue;
        }
        if (event.what == Event::What::iterate)
            for (std::uint64_t i = 0; i < event.count; ++i)
                for (Access const& one : Accesses(groups_[event.number]))
                    parts.push_back({Event::What::access, group_of({one})});
        is_around = event.what != Event::What::leave;
    }
    return parts;
}

Events LoopRecorder::take() {
    idle_.ends();
    leave();
    Events events = std::exchange(events_, {});
    if (!around_.empty())
        events = as_parts(events);
    return events;
}

}  // namespace dataflow::untimed
