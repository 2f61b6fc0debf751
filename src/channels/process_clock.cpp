#include "channels/process_clock.hpp"

#include <algorithm>
#include <cmath>
#include <systemc>

#include "channels/dataflow_core.hpp"
#include "channels/fifo_channel.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"

namespace dataflow {

std::uint64_t TimeBase::ticks_per_cycle() const {
    double const seconds = 1e-6 / clock_mhz;
    return std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::llround(seconds / sc_core::sc_get_time_resolution().to_seconds())));
}

ProcessClock::ProcessClock(DataflowCore& core, std::string_view process)
    : dataflow_core_(core),
      core_(core.timing()),
      timing_(core.timing().process(core.machine().process(process))),
      log_(&timing_.log()),
      time_base_(core.time_base()),
      ticks_per_cycle_(core.time_base().ticks_per_cycle()) {
    core.add_process(timing_.index());
}

void ProcessClock::connect_all() {
    Machine const& machine = dataflow_core_.machine();
    if (timing::OperationLog* const log = dataflow_core_.log_for_thread(timing_.index()))
        log_ = log;
    for (MachineEnd const& end : machine.processes[timing_.index()].ends) {
        auto const port = static_cast<unsigned>(fifos_.size());
        fifos_.push_back(&channel_of(end.fifo));
        end.writes ? fifos_.back()->connect_writer(*this, port) : fifos_.back()->connect_reader(*this, port);
        if (end.when != FifoEnd::When::within_call)
            hand_overs_[end.when] = hand_overs_[end.when] | timing::Ports::of(port);
        may_attempt_.push_back(end.makes_attempts);
    }
    require_described_ports();
    for (std::size_t const stream : streams_of(machine))
        if (machine.streams[stream].process == timing_.index())
            stream_ = &machine.streams[stream];
    has_memory_port_ = std::any_of(machine.streams.begin(), machine.streams.end(),
                                   [this](MachineStream const& stream) { return stream.process == timing_.index(); });
    for (timing::LoopShape const& loop : timing_.loops())
        sound_by_loop_.push_back(sound_accesses_of(loop));
}

/// What a module does at a port counts as what its description names, so the port is bound to that.
void ProcessClock::require_described_ports() const {
    for (FifoChannel const* const fifo : dataflow_core_.channels()) {
        if (fifo == nullptr || std::count(fifos_.begin(), fifos_.end(), fifo) > 0)
            continue;
        std::vector<std::string> const& modules = fifo->bound_modules();
        if (std::count(modules.begin(), modules.end(), timing_.name()) > 0)
            throw InputError("module " + timing_.name() + " has a port bound to the FIFO " + fifo->timing().name() +
                             ", which its describe() does not name, expected it bound to one that it names");
    }
}

void ProcessClock::begin_call() {
    if (dataflow_core_.machine().has_calls)
        say([](OperationLog& log) { log.await_call(); });
    hand_over(FifoEnd::When::call_begins);
}

void ProcessClock::end_call() {
    for (unsigned port = 0; port < fifos_.size(); ++port)
        fifos_[port]->end_call(timing_.writes(port));
    hand_over(FifoEnd::When::call_ends);
}

void ProcessClock::hand_over(FifoEnd::When when) {
    if (timing::Ports const ports = hand_overs_[when]; !ports.is_empty())
        step(ports);
}

FifoChannel& ProcessClock::channel_of(std::size_t fifo) const {
    FifoChannel* const channel = dataflow_core_.channels()[fifo];
    if (channel == nullptr)
        throw InputError("the FIFO " + dataflow_core_.machine().fifos[fifo].name + " of module " + timing_.name() +
                         " has no channel, expected a ClockedFifo made with its fifo_timing() in the core");
    return *channel;
}

unsigned ProcessClock::loop(std::string_view name) const {
    std::vector<timing::LoopShape> const& loops = timing_.loops();
    for (unsigned i = 0; i < loops.size(); ++i)
        if (loops[i].name == name)
            return i;
    std::vector<std::string> names;
    names.reserve(loops.size());
    for (timing::LoopShape const& loop : loops)
        names.push_back(loop.name);
    throw InputError("module " + timing_.name() + " runs a loop " + std::string(name) +
                     ", which it does not describe, expected loop(\"" + std::string(name) + "\") in its describe()" +
                     did_you_mean(name, names));
}

bool ProcessClock::is_pipelined(unsigned loop) const {
    Machine const& machine = dataflow_core_.machine();
    return machine.loops[machine.loop(timing_.index(), timing_.loops()[loop].name)].is_pipelined;
}

std::uint64_t ProcessClock::number(std::string_view name) const {
    auto const& numbers = dataflow_core_.machine().processes[timing_.index()].numbers;
    auto const found = numbers.find(name);
    if (found == numbers.end())
        throw InputError("module " + timing_.name() + " asks for its number " + std::string(name) +
                         ", which its describe() does not have, expected number(\"" + std::string(name) + "\")");
    return found->second;
}

WriteDistances* ProcessClock::write_distances(std::string_view loop, std::string_view memory) {
    WriteDistances* const distances = dataflow_core_.write_distances(timing_.index(), loop, memory);
    Machine const& machine = dataflow_core_.machine();
    MachineLoop const& described = machine.loops[machine.loop(timing_.index(), loop)];
    if (distances != nullptr)
        distances_.emplace_back(this->loop(loop), distances);
    std::optional<std::size_t> const found = described.dependence_on(machine.memory(memory));
    if (found && described.dependences[*found].interlocks())
        interlocks_.push_back({this->loop(loop), static_cast<std::uint32_t>(*found),
                               described.dependences[*found].longest_span, distances});
    return distances;
}

/// Of what has just been told: iterations meet those of the same entry.
void ProcessClock::tell_distances() {
    if (!entries_.take(log_->last(), *timing_.shape()))
        return;
    for (auto const& [loop, distances] : distances_)
        if (loop == entries_.loop)
            distances->enter();
}

bool ProcessClock::reads_first(unsigned loop) const {
    timing::LoopShape const& shape = timing_.loops()[loop];
    return !shape.makes_attempts && std::all_of(shape.reads.begin(), shape.reads.end(),
                                                [](timing::LoopAccess const& read) { return read.stage == 0; });
}

bool ProcessClock::has_interlocks(unsigned loop) const {
    return std::any_of(interlocks_.begin(), interlocks_.end(),
                       [loop](Interlock const& interlock) { return interlock.loop == loop; });
}

/// Whatever the initiation interval is, so that the operations are right for any.
void ProcessClock::await_writes(unsigned loop, bool of_one_before) {
    has_waited_ = true;
    for (Interlock const& interlock : interlocks_) {
        std::uint64_t const distance =
            of_one_before ? interlock.distances->nearest_before() : interlock.distances->nearest();
        if (interlock.loop == loop && distance > 0 && distance < interlock.longest_span)
            say([&](OperationLog& log) {
                log.await_write(interlock.dependence, static_cast<std::uint32_t>(distance));
            });
    }
}

timing::Ports ProcessClock::read_port_of(FifoChannel const& fifo) { return fifo.read_port(); }

// A pipelined loop. In decoupled, the module runs ahead of time, and waits for tokens only. In lockstep it must not be
// kept from what it does in a step by accesses of later steps, of iterations that it has told of: others may wait for
// what it does there. So the process is let go as far as the module has got, step by step.

void ProcessClock::open_loop(unsigned loop, SourceSite site) {
    if (is_away_)
        throw InputError("a loop of module " + timing_.name() +
                         " is begun outside of its thread, expected each module to use its own clock_");
    enter_loop(loop, site);
    std::vector<timing::LoopAccess> const& reads = timing_.loops()[loop].reads;
    pipelined_ = loop;
    is_pipelining_ = true;
    sound_ = sound_by_loop_[loop];
    makes_attempts_ = timing_.loops()[loop].makes_attempts;
    is_held_ = makes_attempts_ ||
               std::any_of(reads.begin(), reads.end(), [](timing::LoopAccess const& read) { return read.stage > 0; });
    may_wait_ = has_interlocks(loop);
    is_plain_ = !is_held_ && !may_wait_ && !lockstep() && !timing_.is_taped();
    has_begun_ = false;
    reached_ = 0;
}

/// The begin of an iteration.
void ProcessClock::reach(std::uint64_t iteration) {
    if (!is_held_)
        return;
    std::uint64_t const step = iteration * timing_.loops()[pipelined_].interval.achieved;
    if (makes_attempts_) {
        if (iteration > 0)
            end_iteration(step);
        has_begun_ = true;
        return;
    }
    take_before(step);
    reached_ = step;
    follow();
}

void ProcessClock::take_before(std::uint64_t step) {
    while (!takings_.empty() && takings_.front().step < step) {
        Taking const taking = std::move(takings_.front());
        takings_.pop_front();
        if (makes_attempts_) {
            if (!taking.reads.is_empty() && taking.step > reached_) {
                reach_step(taking.step, true);
                taken_ = timing::no_ports;
            }
        } else {
            reached_ = std::max(reached_, taking.step);
            follow();
        }
        taking.take();
    }
}

void ProcessClock::close_loop() {
    if (makes_attempts_)
        drain();
    leave_loop();
    take_before(all_steps);
    is_held_ = is_pipelining_ = is_plain_ = makes_attempts_ = decides_trip_count_ = false;
    sound_ = {};
    follow();
}

void ProcessClock::later(FifoChannel const& fifo, std::function<void()> taking) {
    if (is_pipelining_ && !collecting_)
        refuse_later(fifo.read_port().first());
    note_end(fifo.read_port());
    Cycles const stage = fifo.timing().shape().read_stage;
    if (!is_held_ || stage == 0) {
        if (collecting_)
            taken_ = taken_ | fifo.read_port();
        taking();
        return;
    }
    put_off(step_of_read(fifo), std::move(taking), fifo.read_port());
}

/// What is taken later may be what ends the loop.
void ProcessClock::note_end(timing::Ports port) {
    if (decides_trip_count_)
        timing_.notes(pipelined_).ends = timing_.notes(pipelined_).ends | port;
}

/// Of the iteration at hand.
std::uint64_t ProcessClock::step_of_read(FifoChannel const& fifo) const {
    return reached_ + (makes_attempts_ ? step_of(fifo.read_port().first()) : fifo.timing().shape().read_stage);
}

void ProcessClock::put_off(std::uint64_t step, std::function<void()> taking, timing::Ports reads) {
    Taking due{step, std::move(taking), reads};
    auto const at = std::upper_bound(takings_.begin(), takings_.end(), due,
                                     [](Taking const& one, Taking const& other) { return one.step < other.step; });
    takings_.insert(at, std::move(due));
}

void ProcessClock::begin_sample() {
    dataflow_core_.begin_sample(timing_.index());
    is_away_ = false;
}

void ProcessClock::end_sample() { dataflow_core_.end_sample(); }

void ProcessClock::catch_up() {
    log_ == &timing_.log() ? core_.resolve(false) : dataflow_core_.catch_up();
    log_limit_ = std::max(log_limit_, 2 * log_->pending());  // what is left waits for others: let them talk
}

/// The reader of a flushing pipeline's tokens may have one to read now.
void ProcessClock::wake_behind_flushing() {
    if (timing_.flushes())
        fifos_[timing_.flushing_port()]->wake_reader();
}

/// There is room for a token.
void ProcessClock::let_out() {
    timing_.let_out();
    wake_behind_flushing();
}

/// All that is told, or in a pipelined loop, all that is before a step. Returns whether others had a turn meanwhile.
bool ProcessClock::follow_in_lockstep(std::uint64_t end) {
    using Status = timing::ProcessTiming::Status;
    bool has_waited = false;
    auto const wait_for = [&has_waited, this](auto const& what) {
        has_waited = true;
        suspend(what);
    };
    for (Status status = timing_.front(); status != Status::exhausted; status = timing_.front()) {
        if (is_held_ && timing_.in_loop() && timing_.front_step() >= end)
            break;
        if (uses_memory())
            dataflow_core_.tell_memory();
        if (status == Status::blocked && is_memory(timing_.blocking_port())) {
            wait_for(dataflow_core_.memory_event(timing_.index()));
            continue;
        }
        if (status == Status::blocked) {
            FifoChannel& fifo = *fifos_[timing_.blocking_port()];
            bool const writing = timing_.writes(timing_.blocking_port());
            (writing ? fifo.writer_waits_ : fifo.reader_waits_) = true;
            wake_behind_flushing();
            wait_for(writing ? fifo.read_ : fifo.written_);
            continue;
        }
        if (sc_core::sc_time const left = left_until(timing_.front_cycle()); left > sc_core::SC_ZERO_TIME)
            wait_for(left);
        timing::Ports const ports = timing_.front_ports();
        timing_.commit_front();
        ports.each([this](unsigned port) {
            if (is_memory(port))
                return;
            timing_.writes(port) ? fifos_[port]->wake_reader() : wake_writer(*fifos_[port]);
        });
    }
    wake_behind_flushing();
    if (uses_memory())
        dataflow_core_.tell_memory();
    return has_waited;
}

void ProcessClock::wake_writer(FifoChannel& fifo) {
    fifo.wake_writer();
    if (fifo.writer_ != nullptr && fifo.timing().shape().flushing_stages > 0)
        fifo.writer_->let_out();
}

/// For the SystemC kernel to go.
sc_core::sc_time ProcessClock::left_until(Cycles cycle) const {
    sc_dt::uint64 const target = cycle * ticks_per_cycle_;
    sc_dt::uint64 const now = sc_core::sc_time_stamp().value();
    return sc_core::sc_time::from_value(target - std::min(target, now));
}

void ProcessClock::wait_for_tokens(FifoChannel& fifo, timing::Ports others) {
    if (is_held_ && collecting_ && lockstep() && follow_in_lockstep(reached_ + fifo.timing().shape().read_stage))
        return;  // a token may have come
    timing_.set_starving(static_cast<int>(fifo.read_port().first()), site_);
    taken_.each([&](unsigned port) {
        if (collected_.has(port))
            others = others | timing::Ports::of(port);
    });
    if (collecting_ && is_held_)
        for (Taking const& taking : takings_)
            if (taking.step == step_of_read(fifo))
                others = others | taking.reads;
    timing_.set_starving_with(others);
    fifo.reader_waits_ = true;
    suspend(fifo.written_);
    timing_.set_starving(-1);
}

void ProcessClock::wait_for_room(FifoChannel& fifo) {
    fifo.writer_waits_ = true;
    suspend(fifo.read_);
}

}  // namespace dataflow
