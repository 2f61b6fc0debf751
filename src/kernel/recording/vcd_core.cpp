#include "kernel/recording/vcd_core.hpp"

#include <fmt/format.h>

#include "kernel/recording/port_names.hpp"
#include "kernel/recording/state_codes.hpp"

namespace faster::recording {

using Kind = Event::Kind;

VcdCore::VcdCore(VcdFile& vcd, RecordedCore const& core, SignalFilter const& filter, std::size_t domain)
    : vcd_(vcd),
      core_(core),
      machine_(*core.machine),
      memory_trace_(core),
      fifos_(core.fifos.begin(), core.fifos.end()),
      fifo_signals_(machine_.fifos.size()),
      module_signals_(machine_.processes.size()),
      memory_signals_(machine_.memories.size()) {
    vcd.open_scope(fmt::format("core_{}", core.core));
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
    vcd.close_scope();
}

void VcdCore::declare_samples(std::size_t domain) {
    vcd_.open_scope("sample");
    started_ = vcd_.add("started", 32, domain);
    start_ = vcd_.add("start", 1, domain);
    ended_ = vcd_.add("ended", 32, domain);
    end_ = vcd_.add("end", 1, domain);
    vcd_.close_scope();
}

void VcdCore::declare_module(std::size_t module, std::size_t domain) {
    vcd_.open_scope(machine_.processes[module].name);
    module_signals_[module] = {vcd_.add("state", state_bits(machine_), domain), vcd_.add("iteration", 32, domain),
                               vcd_.add("stall", stall_bits(machine_), domain)};
    vcd_.close_scope();
}

void VcdCore::declare_memory(std::size_t memory, std::size_t domain) {
    MachineMemory const& shape = machine_.memories[memory];
    vcd_.open_scope(fmt::format("bram_{}", shape.name));
    for (std::string const& port : port_names(shape))
        memory_signals_[memory].push_back({vcd_.add(port + "_enable", 1, domain),
                                           vcd_.add(port + "_write_enable", 1, domain),
                                           vcd_.add(port + "_address", address_bits(shape), domain)});
    vcd_.close_scope();
}

void VcdCore::declare_fifo(std::size_t fifo, std::size_t domain) {
    FifoSignals& signals = fifo_signals_[fifo];
    vcd_.open_scope(fmt::format("fifo_{}", machine_.fifos[fifo].name));
    signals.write = vcd_.add("write", 1, domain);
    signals.read = vcd_.add("read", 1, domain);
    signals.occupancy = vcd_.add("occupancy", bits_for(core_.fifos[fifo].capacity), domain);
    signals.full = vcd_.add("full", 1, domain);
    signals.empty = vcd_.add("empty", 1, domain);
    for (TokenField const& field : core_.token_layouts[fifo])
        signals.written.push_back(vcd_.add("written_" + label(field), field.bits, domain));
    for (TokenField const& field : core_.token_layouts[fifo])
        signals.taken.push_back(vcd_.add("read_" + label(field), field.bits, domain));
    vcd_.close_scope();
}

void VcdCore::begin() {
    for (std::size_t fifo = 0; fifo < fifos_.size(); ++fifo)
        show_occupancy(fifo);
}

void VcdCore::show_occupancy(std::size_t fifo) {
    FifoSignals const& signals = fifo_signals_[fifo];
    std::uint64_t const occupancy = fifos_[fifo].occupancy();
    set(signals.occupancy, static_cast<std::int64_t>(occupancy));
    set(signals.full, occupancy == fifos_[fifo].shape().capacity ? 1 : 0);
    set(signals.empty, occupancy == 0 ? 1 : 0);
}

void VcdCore::show_token(std::vector<VcdFile::Signal> const& signals, TokenValues const& fields) {
    for (std::size_t i = 0; i < signals.size(); ++i)
        vcd_.set(signals[i], fields[i]);
}

void VcdCore::arrive() {
    std::size_t const fifo = arrivals_.top().second;
    arrivals_.pop();
    fifos_[fifo].arrive();
    show_occupancy(fifo);
}

void VcdCore::take(CoreEvent const& core_event) {
    Event const& event = core_event.event;
    ModuleSignals const& module = module_signals_[core_event.process];
    switch (event.kind) {
        case Kind::enter:
            set(module.state, in_loop(event.item));
            break;
        case Kind::leave:
            set(module.state, between_loops);
            break;
        case Kind::iterate:
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
        case Kind::stamp:
            take_stamp(core_event);
            break;
        case Kind::field:
            break;
    }
    show_accesses(memory_trace_.take(core_event, token_read_));
}

void VcdCore::take_write(CoreEvent const& event) {
    std::size_t const fifo = event.event.item;
    FifoState& state = fifos_[fifo];
    state.write(*event.fields);
    show_token(fifo_signals_[fifo].written, *event.fields);
    if (fifo_signals_[fifo].write != hidden)
        vcd_.pulse(fifo_signals_[fifo].write);
    if (state.shape().issue_latency > 0) {
        arrivals_.emplace(event.event.cycle + state.shape().issue_latency, fifo);
        return;
    }
    state.arrive();
    show_occupancy(fifo);
}

void VcdCore::take_read(CoreEvent const& event) {
    std::size_t const fifo = event.event.item;
    fifos_[fifo].read(token_read_);
    show_token(fifo_signals_[fifo].taken, token_read_);
    if (fifo_signals_[fifo].read != hidden)
        vcd_.pulse(fifo_signals_[fifo].read);
    show_occupancy(fifo);
}

void VcdCore::take_stamp(CoreEvent const& event) {
    if (event.process == machine_.begins) {
        vcd_.set(started_, event.event.value);
        vcd_.pulse(start_);
    }
    if (event.process == machine_.ends) {
        vcd_.set(ended_, event.event.value);
        vcd_.pulse(end_);
    }
}

void VcdCore::show_accesses(std::vector<PortAccess> const& accesses) {
    for (PortAccess const& access : accesses) {
        if (memory_signals_[access.memory].empty())
            continue;
        MemoryPort const& port = memory_signals_[access.memory][access.port];
        vcd_.set_at(access.cycle, port.enable, 1);
        vcd_.set_at(access.cycle, port.write_enable, access.writes ? 1 : 0);
        vcd_.set_at(access.cycle, port.address, static_cast<std::int64_t>(access.address));
        vcd_.schedule(access.cycle + 1, port.enable, 0);
        if (access.writes)
            vcd_.schedule(access.cycle + 1, port.write_enable, 0);
    }
}

}  // namespace faster::recording
