#include "channels/process_clock.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <systemc>

#include "channels/dataflow_core.hpp"
#include "channels/fifo_channel.hpp"

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
      time_base_(core.time_base()),
      ticks_per_cycle_(core.time_base().ticks_per_cycle()) {}

void ProcessClock::connect_all() {
    Machine const& machine = dataflow_core_.machine();
    MachineProcess const& process = machine.processes[timing_.index()];
    for (MachineEnd const& end : process.ends)
        end.writes ? connect_writes(channel_of(end.fifo)) : connect_reads(channel_of(end.fifo));
    std::string const loop_of_stream = connect_stream();
    for (std::size_t const number : process.loops) {
        MachineLoop const& loop = machine.loops[number];
        timing::LoopShape shape = loop.shape();
        shape.uses_memory = loop.name == loop_of_stream;
        add_loop(std::move(shape), channels_of(loop.writes), channels_of(loop.reads));
    }
    set_setup_cycles(process.setup_cycles);
    timing_.let_stamps_look_back(process.stamps_look_back);
}

/// Last, though a step accesses it first: so the other ports have the numbers that they always have. Returns the loop
/// that takes its tokens.
std::string ProcessClock::connect_stream() {
    Machine const& machine = dataflow_core_.machine();
    std::vector<std::size_t> const streams = streams_of(machine);
    for (std::size_t i = 0; i < streams.size(); ++i)
        if (machine.streams[streams[i]].process == timing_.index()) {
            timing_.add_stream(core_.stream(i));
            return machine.streams[streams[i]].loop;
        }
    return {};
}

timing::Ports ProcessClock::memory_port() const {
    return uses_memory() ? timing::Ports::of(timing_.stream_port()) : timing::no_ports;
}

void ProcessClock::tell_entry(timing::MemoryEntry entry) {
    dataflow_core_.add_entry(timing_.index(), std::move(entry));
}

FifoChannel& ProcessClock::channel_of(std::size_t fifo) const {
    FifoChannel* const channel = dataflow_core_.channels()[fifo];
    if (channel == nullptr)
        throw std::logic_error(std::string(dataflow_core_.name()) + ": the FIFO " +
                               dataflow_core_.machine().fifos[fifo].name + " of " + timing_.name() +
                               " has no channel, expected a ClockedFifo made with its fifo_timing()");
    return *channel;
}

/// Of those that are there.
std::vector<FifoChannel*> ProcessClock::channels_of(std::vector<std::size_t> const& fifos) const {
    std::vector<FifoChannel*> channels;
    for (std::size_t const fifo : fifos)
        if (dataflow_core_.machine().fifos[fifo].is_present)
            channels.push_back(&channel_of(fifo));
    return channels;
}

unsigned ProcessClock::loop(std::string_view name) const {
    std::vector<timing::LoopShape> const& loops = timing_.loops();
    for (unsigned i = 0; i < loops.size(); ++i)
        if (loops[i].name == name)
            return i;
    throw std::out_of_range("process " + timing_.name() + " has no loop " + std::string(name));
}

std::uint64_t ProcessClock::number(std::string_view name) const {
    auto const& numbers = dataflow_core_.machine().processes[timing_.index()].numbers;
    auto const found = numbers.find(name);
    if (found == numbers.end())
        throw std::out_of_range("process " + timing_.name() + " has no number " + std::string(name));
    return found->second;
}

WriteDistances* ProcessClock::write_distances(std::string_view loop, std::string_view memory) {
    WriteDistances* const distances = dataflow_core_.write_distances(timing_.index(), loop, memory);
    Machine const& machine = dataflow_core_.machine();
    MachineLoop const& described = machine.loops[machine.loop(timing_.index(), loop)];
    std::optional<std::size_t> const found = described.dependence_on(machine.memory(memory));
    if (found && described.dependences[*found].interlocks())
        interlocks_.push_back({this->loop(loop), static_cast<std::uint32_t>(*found),
                               described.dependences[*found].longest_span, distances});
    return distances;
}

bool ProcessClock::has_interlocks(unsigned loop) const {
    return std::any_of(interlocks_.begin(), interlocks_.end(),
                       [loop](Interlock const& interlock) { return interlock.loop == loop; });
}

/// Whatever the initiation interval is, so that the operations are right for any.
void ProcessClock::await_writes(unsigned loop, bool of_one_before) {
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

/// How many iterations after the one that takes a token of the FIFO the loop has begun by then.
std::uint64_t ProcessClock::iterations_behind(std::string_view name, FifoChannel const& fifo) const {
    return fifo.timing().shape().read_stage / timing_.loops()[loop(name)].interval.achieved;
}

void ProcessClock::begin_sample() { dataflow_core_.begin_sample(timing_.index()); }

void ProcessClock::end_sample() { dataflow_core_.end_sample(); }

void ProcessClock::connect_reads(FifoChannel& fifo) {
    fifos_.push_back(&fifo);
    fifo.connect_reader(*this, timing_.add_reads(fifo.timing()));
}

void ProcessClock::connect_writes(FifoChannel& fifo) {
    fifos_.push_back(&fifo);
    fifo.connect_writer(*this, timing_.add_writes(fifo.timing()));
}

unsigned ProcessClock::add_loop(timing::LoopShape shape, std::vector<FifoChannel*> const& written,
                                std::vector<FifoChannel*> const& read) {
    for (FifoChannel const* fifo : written)
        shape.writes.push_back({fifo->write_port().first(), fifo->timing().shape().write_latency});
    for (FifoChannel const* fifo : read)
        shape.reads.push_back({fifo->read_port().first(), fifo->timing().shape().read_stage});
    if (shape.uses_memory)
        shape.reads.push_back({timing_.stream_port(), 0});
    return timing_.add_loop(std::move(shape));
}

void ProcessClock::catch_up() {
    core_.resolve(false);
    log_limit_ = std::max(log_limit_, 2 * timing_.log().pending());  // what is left waits for others: let them talk
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

void ProcessClock::follow_in_lockstep() {
    using Status = timing::ProcessTiming::Status;
    for (Status status = timing_.front(); status != Status::exhausted; status = timing_.front()) {
        if (uses_memory())
            dataflow_core_.tell_memory();
        if (status == Status::blocked && is_memory(timing_.blocking_port())) {
            sc_core::wait(dataflow_core_.memory_event(timing_.index()));
            continue;
        }
        if (status == Status::blocked) {
            FifoChannel& fifo = *fifos_[timing_.blocking_port()];
            bool const writing = timing_.writes(timing_.blocking_port());
            (writing ? fifo.writer_waits_ : fifo.reader_waits_) = true;
            wake_behind_flushing();
            sc_core::wait(writing ? fifo.read_ : fifo.written_);
            continue;
        }
        bring_kernel_to(timing_.front_cycle());
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
}

void ProcessClock::wake_writer(FifoChannel& fifo) {
    fifo.wake_writer();
    if (fifo.writer_ != nullptr && fifo.timing().shape().flushing_stages > 0)
        fifo.writer_->let_out();
}

void ProcessClock::bring_kernel_to(Cycles cycle) {
    sc_dt::uint64 const target = cycle * ticks_per_cycle_;
    sc_dt::uint64 const now = sc_core::sc_time_stamp().value();
    if (target > now)
        sc_core::wait(sc_core::sc_time::from_value(target - now));
}

void ProcessClock::wait_for_tokens(FifoChannel& fifo) {
    timing_.set_starving(static_cast<int>(fifo.read_port().first()));
    timing_.note_site(fifo.read_port().first(), site_);
    fifo.reader_waits_ = true;
    sc_core::wait(fifo.written_);
    timing_.set_starving(-1);
}

void ProcessClock::wait_for_room(FifoChannel& fifo) {
    fifo.writer_waits_ = true;
    sc_core::wait(fifo.read_);
}

}  // namespace dataflow
