#include "kernel/recording/vcd_core.hpp"

#include <fmt/format.h>

#include "kernel/recording/bram_ports.hpp"

namespace faster::recording {

using Kind = Event::Kind;

VcdCore::VcdCore(VcdFile& vcd, RecordedCore const& core, AcceleratorConfig const& config, SignalFilter const& filter,
                 std::size_t domain)
    : vcd_(vcd), core_(core), bram_model_(config) {
    for (timing::FifoShape const& shape : core.fifos)
        fifos_.emplace_back(shape);
    vcd.open_scope(fmt::format("core_{}", core.core));
    declare_samples(domain);
    for (std::size_t i = 0; i < module_count; ++i)
        declare_module(i, filter, domain);
    for (std::size_t i = 0; i < bram_count; ++i)
        declare_bram(i, config, filter, domain);
    for (std::size_t i = 0; i < fifo_count; ++i)
        declare_fifo(i, filter, domain);
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

void VcdCore::declare_module(std::size_t module, SignalFilter const& filter, std::size_t domain) {
    if (!filter.shows(static_cast<ModuleId>(module)))
        return;
    vcd_.open_scope(module_names[module]);
    module_signals_[module] = {vcd_.add("state", 8, domain), vcd_.add("iteration", 32, domain),
                               vcd_.add("stall", 8, domain)};
    vcd_.close_scope();
}

void VcdCore::declare_fifo(std::size_t fifo, SignalFilter const& filter, std::size_t domain) {
    if (!filter.shows(static_cast<FifoId>(fifo)))
        return;
    FifoSignals& signals = fifo_signals_[fifo];
    vcd_.open_scope(fmt::format("fifo_{}", fifo_names[fifo]));
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

void VcdCore::declare_bram(std::size_t bram, AcceleratorConfig const& config, SignalFilter const& filter,
                           std::size_t domain) {
    if (!filter.shows(static_cast<BramId>(bram)))
        return;
    auto const side = static_cast<std::uint64_t>(config.window);
    vcd_.open_scope(fmt::format("bram_{}", bram_names[bram]));
    for (std::string const& port : bram_port_names(static_cast<BramId>(bram), config))
        bram_signals_[bram].push_back({vcd_.add(port + "_enable", 1, domain),
                                       vcd_.add(port + "_write_enable", 1, domain),
                                       vcd_.add(port + "_address", bits_for(side * side - 1), domain)});
    vcd_.close_scope();
}

void VcdCore::begin() {
    for (std::size_t fifo = 0; fifo < fifo_count; ++fifo)
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
    ModuleSignals const& module = module_signals_[core_event.module];
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
            set(module.stall,
                stall_on(event.item, index_of(ends_of(core_.parts, FifoId{event.item}).writer) == core_event.module));
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
    show_bram(bram_model_.take(core_event, token_read_));
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
    bool const starts = event.module == index_of(ModuleId::rasterizer);
    vcd_.set(starts ? started_ : ended_, event.event.value);
    vcd_.pulse(starts ? start_ : end_);
}

void VcdCore::show_bram(std::vector<BramAccess> const& accesses) {
    for (BramAccess const& access : accesses) {
        if (bram_signals_[access.bram].empty())
            continue;
        BramPort const& port = bram_signals_[access.bram][access.port];
        vcd_.set_at(access.cycle, port.enable, 1);
        vcd_.set_at(access.cycle, port.write_enable, access.writes ? 1 : 0);
        vcd_.set_at(access.cycle, port.address, static_cast<std::int64_t>(access.address));
        vcd_.schedule(access.cycle + 1, port.enable, 0);
        if (access.writes)
            vcd_.schedule(access.cycle + 1, port.write_enable, 0);
    }
}

}  // namespace faster::recording
