#include "kernel/report/power_report.hpp"

#include <fmt/format.h>

#include "kernel/figures/power.hpp"

namespace faster::report {

namespace {

bool is_known(RunStatistics const& run) { return run.total_cycles > 0 && run.machine.resources != nullptr; }

Json estimate_json(Estimate const& estimate) {
    return {{"low", estimate.low}, {"typical", estimate.typical}, {"high", estimate.high}};
}

std::string line(std::string const& name, Estimate const& estimate, char const* unit, int digits = 1) {
    return fmt::format("  {:<25} {:>9.{digits}f} {:>9.{digits}f} {:>9.{digits}f}  {}\n", name, estimate.low,
                       estimate.typical, estimate.high, unit, fmt::arg("digits", digits));
}

}  // namespace

Json power_json(RunStatistics const& run) {
    if (!is_known(run))
        return nullptr;
    RunPower const power = power_of(run);
    Json json;
    json["modules_mw"] = Json::object();
    for (PowerRow const& module : power.modules)
        json["modules_mw"][module.name] = estimate_json(module.milliwatts);
    json["fifos_mw"] = estimate_json(power.fifos.milliwatts);
    json["memories_mw"] = estimate_json(power.memories.milliwatts);
    json["beside_mw"] = estimate_json(power.beside.milliwatts);
    json["dynamic_w"] = estimate_json(power.dynamic_w);
    json["static_w"] = estimate_json(power.static_w);
    json["ps_w"] = estimate_json(power.ps_w);
    json["total_w"] = estimate_json(power.total_w);
    json["energy_mj"] = estimate_json(power.energy_mj);
    return json;
}

std::string power_text(RunStatistics const& run) {
    if (!is_known(run))
        return "";
    RunPower const power = power_of(run);
    std::string text = fmt::format("\nPower, estimated from the run's activity\n  {:<25} {:>9} {:>9} {:>9}\n", "",
                                   "low", "typical", "high");
    for (PowerRow const& module : power.modules)
        text += line(module.name, module.milliwatts, "mW");
    text += line("FIFOs", power.fifos.milliwatts, "mW");
    text += line("memories", power.memories.milliwatts, "mW");
    text += line("beside the cores", power.beside.milliwatts, "mW");
    text += line("dynamic", power.dynamic_w, "W", 2);
    text += line("static", power.static_w, "W", 2);
    text += line("processing system", power.ps_w, "W", 2);
    text += line("in all", power.total_w, "W", 2);
    return text + line("energy of the run", power.energy_mj, "mJ");
}

}  // namespace faster::report
