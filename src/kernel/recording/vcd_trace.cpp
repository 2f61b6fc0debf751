#include "kernel/recording/vcd_trace.hpp"

#include <algorithm>
#include <memory>

#include "kernel/base/files/output_file.hpp"
#include "kernel/recording/gtkwave_save.hpp"

namespace faster::recording {

namespace {

using Cores = std::vector<std::unique_ptr<VcdCore>>;

/// Tokens that arrive by themselves come between events.
void arrive_until(Cycles cycle, VcdFile& vcd, Cores const& cores) {
    for (;;) {
        VcdCore* first = nullptr;
        for (auto const& core : cores)
            if (first == nullptr || core->next_arrival() < first->next_arrival())
                first = core.get();
        if (first == nullptr || first->next_arrival() > cycle || first->next_arrival() == ~Cycles{0})
            return;
        vcd.advance(std::max(vcd.cycle(), first->next_arrival()));
        first->arrive();
    }
}

}  // namespace

void write_vcd(std::filesystem::path const& file, Machine const& machine, std::vector<RecordedCore> const& cores,
               SignalFilter const& filter) {
    VcdFile vcd(file, machine.clock_mhz);
    Cores signals;
    std::vector<std::pair<Cycles, Cycles>> windows;
    std::vector<std::pair<std::size_t, Spools*>> spools;
    vcd.open_scope("accelerator");
    for (std::size_t i = 0; i < cores.size(); ++i) {
        signals.push_back(std::make_unique<VcdCore>(vcd, cores[i], filter, i));
        windows.emplace_back(cores[i].from, cores[i].to);
        spools.emplace_back(i, cores[i].spools);
    }
    vcd.close_scope();
    vcd.begin(windows);
    for (auto const& core : signals)
        core->begin();
    for_each_event(spools, [&](CoreEvent const& event) {
        if (event.event.cycle > vcd.cycle()) {
            arrive_until(event.event.cycle, vcd, signals);
            vcd.advance(event.event.cycle);
        }
        signals[event.core]->take(event);
    });
    for (auto const& [from, to] : windows)
        arrive_until(to, vcd, signals);
    vcd.finish();
    if (!io::is_device(file))
        write_gtkwave_save(file, machine, cores, filter);
}

}  // namespace faster::recording
