#include "dataflow/tools/recording/core_signals.hpp"

#include <fmt/format.h>

#include "dataflow/tools/recording/state_codes.hpp"

namespace dataflow::recording {

using Kind = Event::Kind;

CoreSignals::CoreSignals(Waveform& waveform, RecordedCore const& core, SignalFilter const& filter, std::size_t domain)
    : waveform_(waveform),
      core_(core),
      machine_(*core.machine),
      memory_trace_(core),
      fifos_(core.fifos.begin(), core.fifos.end()),
      fifo_signals_(machine_.fifos.size()),
      module_signals_(machine_.processes.size()),
      memory_signals_(machine_.memories.size()) {
    waveform.open_scope(fmt::format("core_{}", core.core));
    if (filter.shows_samples())
        declare_samples(domain);
    for (std::size_t i = 0; i < machine_.processes.size(); ++i)
        if (filter.shows_process(i))
            declare_module(i, domain);
    for (std::size_t i = 0; i < machine_.memories.size(); ++i)
        if (filter.shows_memory(i))
            declare_memory(i, domain);
    for (std::size_t i = 0; i < machine_.fifos.size(); ++i)
        if (filter.shows_fifo(i))
            declare_fifo(i, domain);
    waveform.close_scope();
}

void CoreSignals::declare_samples(std::size_t domain) {
    waveform_.open_scope("sample");
    started_ = waveform_.add({"started", 32, {}}, domain);
    start_ = waveform_.add({"start", 1, {}}, domain);
    ended_ = waveform_.add({"ended", 32, {}}, domain);
    end_ = waveform_.add({"end", 1, {}}, domain);
    waveform_.close_scope();
}

void CoreSignals::declare_module(std::size_t module, std::size_t domain) {
    waveform_.open_scope(machine_.processes[module].name);
    module_signals_[module] = {waveform_.add({"state", state_bits(machine_), state_names(machine_)}, domain),
                               waveform_.add({"iteration", 32, {}}, domain),
                               waveform_.add({"stall", stall_bits(machine_), stall_names(machine_)}, domain)};
    waveform_.close_scope();
}

void CoreSignals::declare_memory(std::size_t memory, std::size_t domain) {
    MachineMemory const& shape = machine_.memories[memory];
    waveform_.open_scope(fmt::format("bram_{}", shape.name));
    for (std::string const& port : port_names(shape))
        memory_signals_[memory].push_back(
            {waveform_.add({port + "_enable", 1, {}}, domain), waveform_.add({port + "_write_enable", 1, {}}, domain),
             waveform_.add({port + "_address", address_bits(shape), {}}, domain, std::nullopt)});
    waveform_.close_scope();
}

void CoreSignals::declare_fifo(std::size_t fifo, std::size_t domain) {
    FifoSignals& signals = fifo_signals_[fifo];
    waveform_.open_scope(fmt::format("fifo_{}", machine_.fifos[fifo].name));
    signals.write = waveform_.add({"write", 1, {}}, domain);
    signals.read = waveform_.add({"read", 1, {}}, domain);
    signals.occupancy = waveform_.add({"occupancy", signal_bits(core_.fifos[fifo].capacity), {}}, domain);
    signals.full = waveform_.add({"full", 1, {}}, domain);
    signals.empty = waveform_.add({"empty", 1, {}}, domain);
    for (TokenField const& field : core_.token_layouts[fifo])
        signals.written.push_back(waveform_.add({"written_" + label(field), field.bits, value_names(field)}, domain));
    for (TokenField const& field : core_.token_layouts[fifo])
        signals.taken.push_back(waveform_.add({"read_" + label(field), field.bits, value_names(field)}, domain));
    waveform_.close_scope();
}

void CoreSignals::begin() {
    for (std::size_t fifo = 0; fifo < fifos_.size(); ++fifo)
        show_occupancy(fifo);
}

void CoreSignals::show_occupancy(std::size_t fifo) {
    FifoSignals const& signals = fifo_signals_[fifo];
    std::uint64_t const occupancy = fifos_[fifo].occupancy();
    set(signals.occupancy, static_cast<std::int64_t>(occupancy));
    set(signals.full, occupancy == fifos_[fifo].shape().capacity ? 1 : 0);
    set(signals.empty, occupancy == 0 ? 1 : 0);
}

void CoreSignals::show_token(std::vector<Waveform::Signal> const& signals, TokenValues const& fields) {
    for (std::size_t i = 0; i < signals.size(); ++i)
        waveform_.set(signals[i], fields[i]);
}

void CoreSignals::arrive() {
    std::size_t const fifo = arrivals_.top().second;
    arrivals_.pop();
    fifos_[fifo].arrive();
    show_occupancy(fifo);
}

void CoreSignals::take(CoreEvent const& core_event) {
    Event const& event = core_event.event;
    ModuleSignals const& module = module_signals_[core_event.process];
    switch (event.kind) {
        case Kind::enter:
            set(module.state, in_loop(event.item));
            set(module.iteration, 0);
            break;
        case Kind::leave:
            set(module.state, between_loops);
            break;
        case Kind::iterate:
        case Kind::at_iteration:
            set(module.iteration, event.value);
            break;
        case Kind::stall:
            set(module.stall, stall_on(machine_, event.item, core_event.process));
            break;
        case Kind::resume:
            set(module.stall, no_stall);
            break;
        case Kind::read:
            take_read(core_event);
            break;
        case Kind::write:
            take_write(core_event);
            break;
        case Kind::begin:
            take_sample(started_, start_, event);
            break;
        case Kind::end:
            take_sample(ended_, end_, event);
            break;
        case Kind::field:
            break;
    }
    show_accesses(memory_trace_.take(core_event, token_read_));
}

void CoreSignals::take_write(CoreEvent const& event) {
    std::size_t const fifo = event.event.item;
    FifoState& state = fifos_[fifo];
    state.write(*event.fields);
    show_token(fifo_signals_[fifo].written, *event.fields);
    if (fifo_signals_[fifo].write != hidden)
        waveform_.pulse(fifo_signals_[fifo].write);
    if (state.shape().issue_latency > 0) {
        arrivals_.emplace(event.event.cycle + state.shape().issue_latency, fifo);
        return;
    }
    state.arrive();
    show_occupancy(fifo);
}

void CoreSignals::take_read(CoreEvent const& event) {
    std::size_t const fifo = event.event.item;
    fifos_[fifo].read(token_read_);
    show_token(fifo_signals_[fifo].taken, token_read_);
    if (fifo_signals_[fifo].read != hidden)
        waveform_.pulse(fifo_signals_[fifo].read);
    show_occupancy(fifo);
}

void CoreSignals::take_sample(Waveform::Signal number, Waveform::Signal pulse, Event const& event) {
    set(number, event.value);
    if (pulse != hidden)
        waveform_.pulse(pulse);
}

void CoreSignals::show_accesses(std::vector<PortAccess> const& accesses) {
    for (PortAccess const& access : accesses) {
        if (memory_signals_[access.memory].empty())
            continue;
        MemoryPort const& port = memory_signals_[access.memory][access.port];
        waveform_.set_at(access.cycle, port.enable, 1);
        waveform_.set_at(access.cycle, port.write_enable, access.writes ? 1 : 0);
        waveform_.set_at(access.cycle, port.address, static_cast<std::int64_t>(access.address));
        waveform_.schedule(access.cycle + 1, port.enable, 0);
        waveform_.schedule(access.cycle + 1, port.address, std::nullopt);
        if (access.writes)
            waveform_.schedule(access.cycle + 1, port.write_enable, 0);
    }
}

}  // namespace dataflow::recording
