#include "dataflow/tools/report/timing_report.hpp"

#include <fmt/format.h>

#include "dataflow/tools/resources/machine_resources.hpp"

namespace dataflow::report {

namespace {

double period_ns(Machine const& machine) { return 1e3 / machine.clock_mhz; }

Json path_json(std::string const& module, UnitPath const& path) {
    Estimate const stage = path.of_stage();
    return {{"module", module},      {"from", path.from},
            {"to", path.to},         {"stages", path.stages},
            {"low_ns", stage.low},   {"typical_ns", stage.typical},
            {"high_ns", stage.high}, {"typical_mhz", 1e3 / stage.typical}};
}

/// A net of the netlist that has no name is "-" there.
std::string ends_text(UnitPath const& path) {
    auto const end = [](char const* word, std::string const& name) {
        return name == "-" ? "" : fmt::format(" {} {}", word, name);
    };
    return end("from", path.from) + end("to", path.to);
}

}  // namespace

Json timing_json(Machine const& machine) {
    Json modules = Json::array();
    bool closes = true;
    for (MachineResources::Module const& module : resources_of(machine).modules) {
        if (!module.slowest)
            continue;
        modules.push_back(path_json(module.sum.name, *module.slowest));
        closes = closes && module.slowest->of_stage().typical <= period_ns(machine);
    }
    if (modules.empty())
        return nullptr;
    return {{"clock_mhz", machine.clock_mhz}, {"closes", closes}, {"modules", std::move(modules)}};
}

std::string timing_text(Machine const& machine) {
    std::string text;
    for (MachineResources::Module const& module : resources_of(machine).modules) {
        if (!module.slowest || module.slowest->of_stage().typical <= period_ns(machine))
            continue;
        Estimate const stage = module.slowest->of_stage();
        text += fmt::format(
            "  At {:g} MHz {} would not close: {:.1f} ns{} ({:.1f} to {:.1f}), {:.0f} MHz; "
            "estimated.\n",
            machine.clock_mhz, module.sum.name, stage.typical, ends_text(*module.slowest), stage.low, stage.high,
            1e3 / stage.typical);
    }
    return text;
}

}  // namespace dataflow::report
