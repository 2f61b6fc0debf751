#include "dataflow/tools/report/power_report.hpp"

#include <fmt/format.h>
#include <string_view>
#include <vector>

#include "dataflow/tools/resources/power.hpp"

namespace dataflow::report {

namespace {

bool is_known(RunStatistics const& run) { return run.total_cycles > 0 && run.machine.resources != nullptr; }

Json estimate_json(Estimate const& estimate) {
    return {{"low", estimate.low}, {"typical", estimate.typical}, {"high", estimate.high}};
}

std::string line(std::string const& name, Estimate const& estimate, std::string_view unit) {
    int const digits = unit == "W" ? 2 : 1;
    return fmt::format("  {:<25} {:>9.{digits}f} {:>9.{digits}f} {:>9.{digits}f}  {}\n", name, estimate.low,
                       estimate.typical, estimate.high, unit, fmt::arg("digits", digits));
}

/// A figure of all modules: its key in summary.json, its name for people, its unit.
struct Total {
    char const* key;
    char const* name;
    char const* unit;
    Estimate estimate;
};

std::vector<Total> totals_of(RunPower const& power) {
    return {{"fifos_mw", "FIFOs", "mW", power.fifos.milliwatts},
            {"memories_mw", "memories", "mW", power.memories.milliwatts},
            {"beside_mw", "beside the cores", "mW", power.beside.milliwatts},
            {"dynamic_w", "dynamic", "W", power.dynamic_w},
            {"static_w", "static", "W", power.static_w},
            {"ps_w", "processing system", "W", power.ps_w},
            {"total_w", "in all", "W", power.total_w},
            {"energy_mj", "energy of the run", "mJ", power.energy_mj}};
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
    for (Total const& total : totals_of(power))
        json[total.key] = estimate_json(total.estimate);
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
    for (Total const& total : totals_of(power))
        text += line(total.name, total.estimate, total.unit);
    return text;
}

}  // namespace dataflow::report
