#include "dataflow/tools/report/resource_report.hpp"

#include <fmt/format.h>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/base/grouped_digits.hpp"
#include "dataflow/tools/resources/machine_resources.hpp"

namespace dataflow::report {

namespace {

Device const& device = xczu9eg;

Resources percent_of_device(Resources const& amount) {
    Resources const& has = device.has;
    return {100 * amount.lut / has.lut, 100 * amount.ff / has.ff, 100 * amount.dsp / has.dsp,
            100 * amount.ramb36 / has.ramb36};
}

Json amount_json(Resources const& amount) {
    return {{"lut", amount.lut}, {"ff", amount.ff}, {"dsp", amount.dsp}, {"ramb36", amount.ramb36}};
}

Json part_json(char const* kind, ResourcePart const& part) {
    Json json{{kind, part.name}};
    json.update(amount_json(part.amount));
    json["basis"] = enumerator_name(part.basis);
    return json;
}

Json parts_json(char const* kind, std::vector<ResourcePart> const& parts) {
    Json rows = Json::array();
    for (ResourcePart const& part : parts)
        rows.push_back(part_json(kind, part));
    return rows;
}

Json modules_json(MachineResources const& resources) {
    Json rows = Json::array();
    for (MachineResources::Module const& module : resources.modules) {
        rows.push_back(part_json("module", module.sum));
        rows.back()["parts"] = parts_json("part", module.parts);
    }
    return rows;
}

Json sum_json(Resources const& amount) {
    Json json = amount_json(amount);
    json["percent_of_device"] = amount_json(percent_of_device(amount));
    return json;
}

std::string line(std::string const& name, Resources const& amount, std::string_view basis) {
    auto const count = [](double amount_of_it) { return grouped_digits(fmt::format("{:.0f}", amount_of_it)); };
    return fmt::format("  {:<25} {:>9} {:>9} {:>7} {:>8.4g}{}{}\n", name, count(amount.lut), count(amount.ff),
                       count(amount.dsp), amount.ramb36, basis.empty() ? "" : "  ", basis);
}
std::string line(ResourcePart const& part) { return line(part.name, part.amount, enumerator_name(part.basis)); }

std::string share(std::string const& name, Resources const& amount) {
    Resources const percent = percent_of_device(amount);
    return fmt::format("  {:<25} {:>8.1f}% {:>8.1f}% {:>6.1f}% {:>7.1f}%\n", name, percent.lut, percent.ff, percent.dsp,
                       percent.ramb36);
}

}  // namespace

Json resources_json(Machine const& machine) {
    MachineResources const resources = resources_of(machine);
    Json json;
    json["device"] = {{"name", device.name}};
    json["device"].update(amount_json(device.has));
    json["modules"] = modules_json(resources);
    json["fifos"] = parts_json("fifo", resources.fifos);
    json["memories"] = parts_json("bram", resources.memories);
    json["core"] = amount_json(resources.core.amount);
    json["core"]["basis"] = enumerator_name(resources.core.basis);
    json["cores"] = sum_json(resources.cores.amount);
    json["cores"]["basis"] = enumerator_name(resources.cores.basis);
    if (!resources.beside_is.empty()) {
        json["beside"] = amount_json(resources.beside);
        json["beside"]["is"] = resources.beside_is;
    }
    json["chip"] = sum_json(resources.chip);
    json["chip"]["fits"] = resources.fits(device);
    return json;
}

std::string resources_text(Machine const& machine) {
    MachineResources const resources = resources_of(machine);
    std::string text = fmt::format("\nResources of a core, estimated{}\n  {:<25} {:>9} {:>9} {:>7} {:>8}\n",
                                   resources.modules.empty() ? "; of its FIFOs and memories only" : "", "", "LUT", "FF",
                                   "DSP", "RAMB36");
    for (MachineResources::Module const& module : resources.modules)
        text += line(module.sum);
    text += line(sum_of(fmt::format("{} FIFOs", resources.fifos.size()), resources.fifos));
    text += line(sum_of(fmt::format("{} memories", resources.memories.size()), resources.memories));
    text += line(fmt::format("{} {}", machine.cores, machine.cores_are), resources.cores.amount,
                 enumerator_name(resources.cores.basis));
    text += share(fmt::format("of the {}", device.name), resources.cores.amount);
    if (!resources.beside_is.empty()) {
        text += line("with what is beside them", resources.chip, "");
        text += share(fmt::format("of the {}", device.name), resources.chip);
        text += fmt::format("  Beside them: {}.\n", resources.beside_is);
    }
    if (!resources.fits(device))
        text += fmt::format("  This does not fit the {}.\n", device.name);
    return text;
}

}  // namespace dataflow::report
