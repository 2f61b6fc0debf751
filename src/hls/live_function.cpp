#include "hls/live_function.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "dataflow/base/input_error.hpp"

namespace dataflow {

namespace {
constexpr std::size_t most_questions = 1000;  ///< in an iteration; more are a loop that never ends
}

using untimed::Attempt;
using untimed::LoopMark;
using untimed::StreamBase;

void LiveFunction::run() {
    untimed::ProcessCall const& process = core_.design().processes()[process_];
    idle_.ends();
    go_on();
    try {
        process.call();
    } catch (sc_core::sc_unwind_exception const&) {
        throw;
    } catch (...) {
        untimed::observer = nullptr;
        std::rethrow_exception(untimed::thrown_by_process(process.name));
    }
    leave_loop();
    untimed::observer = nullptr;
}

/// Meanwhile other functions may have run.
void LiveFunction::go_on() { untimed::observer = this; }

/// Outside loops it has a state of its own.
void LiveFunction::end_access() {
    if (where_ == Where::outside)
        clock_.advance(1);
    go_on();
}

/// It only says where others end: the description does not have it.
bool LiveFunction::is_around(LoopMark const& loop) const {
    return core_.recorder(process_).around().count(loop.name) != 0;
}

void LiveFunction::leave_loop() {
    if (std::exchange(is_open_, false))
        clock_.close_iteration();
    if (loop_ != nullptr)
        clock_.close_loop();
    loop_ = nullptr;
    where_ = Where::outside;
    leaves_ = false;
}

void LiveFunction::come_to_access() {
    if (where_ == Where::between || where_ == Where::condition)
        leave_loop();
}

void LiveFunction::begin_access(untimed::Access const& access, bool is_attempt) {
    idle_.ends();
    if (described_[is_attempt].emplace(loop_, access).second)
        core_.require_described(process_, loop_ != nullptr ? loop_->name : nullptr, access, is_attempt);
}

void LiveFunction::open_iteration() {
    if (std::exchange(is_open_, true))
        clock_.close_iteration();
    clock_.open_iteration(iterations_++);
    asked_.clear();
}

void LiveFunction::begins_iteration(LoopMark const& loop) {
    idle_.count(core_.machine().processes[process_].name, loop);
    if (is_around(loop)) {
        come_to_access();
        return go_on();
    }
    bool const is_same = loop_ != nullptr && !leaves_ && std::strcmp(loop_->name, loop.name) == 0;
    if (!is_same) {
        core_.require_described(process_, loop);
        leave_loop();
        clock_.open_loop(clock_.loop(loop.name), {loop.file, loop.line});
        loop_ = &loop;
        iterations_ = 0;
    }
    if (!is_same || where_ != Where::condition)
        open_iteration();
    where_ = Where::iteration;
    go_on();
}

void LiveFunction::ends_iteration(LoopMark const& loop) noexcept {
    if (where_ == Where::iteration && loop_ != nullptr && std::strcmp(loop_->name, loop.name) == 0)
        where_ = Where::between;
    else
        leaves_ = true;
}

void LiveFunction::reads(StreamBase& stream) {
    come_to_access();
    begin_access({stream.number(), false}, false);
    core_.stream_fifo(stream.number()).read();
    end_access();
}

void LiveFunction::wrote(StreamBase& stream) {
    come_to_access();
    begin_access({stream.number(), true}, false);
    core_.stream_fifo(stream.number()).write(stream.shown_last());
    end_access();
}

bool LiveFunction::attempts(StreamBase const& stream, Attempt const& attempt) {
    if (attempt.only_asks)
        come_to_question({stream.number(), attempt.writes});
    else
        come_to_access();
    begin_access({stream.number(), attempt.writes}, true);
    bool const is_found = find(core_.stream_fifo(stream.number()), attempt);
    end_access();
    return is_found;
}

void LiveFunction::come_to_question(untimed::Access const& access) {
    bool const is_asked_again =
        where_ == Where::condition && std::find(asked_.begin(), asked_.end(), access) != asked_.end();
    if ((where_ == Where::between && !leaves_) || is_asked_again) {
        open_iteration();
        where_ = Where::condition;
    }
    if (where_ == Where::between)
        leave_loop();
    if (where_ == Where::outside)
        return;
    asked_.push_back(access);
    if (asked_.size() > most_questions)
        throw InputError("process " + core_.machine().processes[process_].name + " asks streams more than " +
                         std::to_string(most_questions) + " times in an iteration of its loop " + loop_->name +
                         ", expected a mark in the loop that asks");
}

bool LiveFunction::find(ClockedFifo<std::int64_t>& fifo, Attempt const& attempt) const {
    std::int64_t token = 0;
    if (attempt.only_asks)
        return attempt.writes ? !fifo.full() : !fifo.empty();
    return attempt.writes ? fifo.write_nb(attempt.shown) : fifo.read_nb(token);
}

}  // namespace dataflow
