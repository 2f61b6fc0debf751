#include <algorithm>

#include "channels/dataflow_core.hpp"
#include "channels/fifo_channel.hpp"
#include "channels/process_clock.hpp"
#include "dataflow/base/input_error.hpp"

namespace dataflow {

// Which accesses a step, or an iteration of a loop, may make.

namespace {
[[noreturn]] void refuse_end(std::string const& module, std::string const& fifo, bool writes) {
    throw InputError("module " + module + (writes ? " writes " : " reads ") + fifo +
                     ", which its describe() does not say, expected " + (writes ? "writes_to" : "reads_from") + "(\"" +
                     fifo + "\")");
}
}  // namespace

void ProcessClock::require_calling(FifoChannel const& fifo, bool writes) const {
    std::optional<std::size_t> const running = dataflow_core_.running_process(timing_.index());
    if (running && *running != timing_.index())
        refuse_end(dataflow_core_.machine().processes[*running].name, fifo.basename(), writes);
}

void ProcessClock::require_end(FifoChannel const& fifo, timing::Ports port, bool writes) const {
    if (port.is_empty() || port.first() >= fifos_.size() || fifos_[port.first()] != &fifo ||
        timing_.writes(port.first()) != writes)
        refuse_end(timing_.name(), fifo.basename(), writes);
}

/// What is read when an iteration begins keeps the module from everything else that the iteration does. Once that is
/// found right, it need not be looked at again.
void ProcessClock::require_first_stage(timing::Ports port) {
    unsigned const number = port.first();
    if (last_attempt_ && reached_ + step_of(number) == *last_attempt_)
        return;
    timing_.require_first(pipelined_, number);
    note_first_reads(pipelined_, port);
    SoundAccesses& sound = sound_by_loop_[pipelined_];
    sound.first_reads |= sound.accesses & port.number();
    sound_ = sound;
}

/// A body that is called with tokens is ahead of time.
void ProcessClock::refuse_in_tokens_body(std::string const& what) const {
    throw InputError("module " + timing_.name() + " accesses " + what +
                     " in a body that is called with tokens, expected it among tokens_of(), or a body that " +
                     "accesses all its ports itself");
}

void ProcessClock::refuse_wait(Cycles cycles) const {
    throw InputError("module " + timing_.name() + " lets " + std::to_string(cycles) + " cycles pass, expected up to " +
                     std::to_string(longest_wait));
}

void ProcessClock::refuse_number(unsigned loop) const {
    throw InputError("module " + timing_.name() + " begins its loop number " + std::to_string(loop) +
                     ", expected one of its " + std::to_string(timing_.loops().size()) +
                     ", as clock_.loop(NAME) tells it");
}

void ProcessClock::refuse_inside(char const* what) const {
    throw InputError("module " + timing_.name() + " " + what +
                     " inside of a step or an iteration of a loop, expected it before or behind that");
}

void ProcessClock::refuse_later(unsigned port) const {
    throw InputError("module " + timing_.name() + " accesses " + fifos_[port]->timing().name() +
                     " in what is done later in an iteration, expected clock_.access() of its port in the body, and " +
                     "no more than put() later");
}

void ProcessClock::refuse_outside(char const* what) const {
    throw InputError("module " + timing_.name() + " " + what + " outside of any loop, expected enter_loop() before it");
}

void ProcessClock::access_closely(timing::Ports port) {
    if (is_in_tokens_body_)
        refuse_in_tokens_body(fifos_[port.first()]->timing().name());
    if (!is_pipelining_)
        timing_.note_site(port.first(), site_);
    else if (!collecting_)
        refuse_later(port.first());
    if (!collecting_) {
        site_ = SourceSite();
        step(port);
        return;
    }
    require_once(port);
    collected_ = collected_ | port;
    if (last_attempt_)
        tell_behind_attempt(port);
}

/// An iteration, or a step, does one thing at a port at most. Which ports a loop accesses decides when it does so.
void ProcessClock::require_once(timing::Ports port) const {
    unsigned const number = port.first();
    if (uses_memory()) {
        if (is_memory(number))
            return;
        bool const takes = stream_ != nullptr && !stream_->writes && collected_.has(timing_.stream_port());
        if (!is_pipelining_ && takes && !timing_.writes(number))
            refuse_both(fifos_[number]->timing().name());
    }
    if (collected_.has(number) || attempted_.has(number))
        refuse_second(number);
    if (is_pipelining_)
        require_named(pipelined_, number);
}

void ProcessClock::require_access(unsigned loop, timing::Ports others, timing::Ports port) const {
    if (others.has(port.first()))
        refuse_second(port.first());
    require_named(loop, port.first());
}

void ProcessClock::refuse_second(unsigned port) const {
    throw InputError("module " + timing_.name() + (timing_.writes(port) ? " writes " : " reads ") +
                     fifos_[port]->timing().name() + " twice in a step or an iteration of a loop, expected once");
}

void ProcessClock::require_named(unsigned loop, unsigned port) const {
    timing::LoopShape const& shape = timing_.loops()[loop];
    bool const writes = timing_.writes(port);
    if (is_named_by(shape, port))
        return;
    throw InputError("loop " + timing_.name() + "." + shape.name + (writes ? " writes " : " reads ") +
                     fifos_[port]->timing().name() + ", which its describe() does not say, expected " +
                     (writes ? "leaves() or writes_to()" : "taken() or also_reads()"));
}

/// A loop that only reads, in the first stage, need not say what.
bool ProcessClock::is_named_by(timing::LoopShape const& loop, unsigned port) const {
    auto const is_it = [port](auto const& access) { return access.port == port; };
    if (timing_.writes(port))
        return std::any_of(loop.writes.begin(), loop.writes.end(), is_it);
    return (loop.writes.empty() && loop.reads.empty()) || std::any_of(loop.reads.begin(), loop.reads.end(), is_it);
}

ProcessClock::SoundAccesses ProcessClock::sound_accesses_of(timing::LoopShape const& loop) const {
    SoundAccesses sound;
    if (loop.makes_attempts || fifos_.size() >= timing::Ports::in_masks)  // the memory may have a port besides
        return sound;
    for (unsigned port = 0; port < fifos_.size(); ++port)
        if (is_named_by(loop, port))
            sound.accesses |= timing::Ports::of(port).number();
    return sound;
}

}  // namespace dataflow
