#include "dataflow/tools/sizing/sizing_files.hpp"

#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/grouped_digits.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/run/config/choice_names.hpp"
#include "dataflow/run/config/idle_keys.hpp"
#include "dataflow/run/config/key_names.hpp"
#include "dataflow/run/config/resolved_config.hpp"

namespace dataflow::sizing {

namespace {

double percent_over(Cycles cycles, Cycles reference) {
    return reference == 0 ? 0
                          : 100.0 * (static_cast<double>(cycles) - static_cast<double>(reference)) /
                                static_cast<double>(reference);
}

std::string cycles_text(Cycles cycles) { return cycles == Cut::deadlock ? std::string("deadlock") : grouped(cycles); }

std::string change_text(Cycles cycles, Cycles reference) {
    return cycles == Cut::deadlock ? std::string("-") : fmt::format("{:+.3f} %", percent_over(cycles, reference));
}

std::string primitives_text(Primitives const& primitives) {
    if (primitives.ramb18 == 0)
        return fmt::format("{} LUT", primitives.luts);
    std::string const rams = fmt::format("{:g} RAMB36", static_cast<double>(primitives.ramb18) / 2);
    return primitives.luts == 0 ? rams : fmt::format("{} LUT + {}", primitives.luts, rams);
}

std::string choice_line(char const* name, SizedChoice const& choice, Sizing const& sizing) {
    return fmt::format("  {:<11}{:>14} {:>12} {:>14.1f}  {}\n", name, cycles_text(choice.total_cycles),
                       change_text(choice.total_cycles, sizing.unbounded.total_cycles), choice.cost,
                       primitives_text(choice.primitives));
}

std::string names_of(std::vector<std::size_t> const& fifos, Machine const& machine) {
    std::string names;
    for (std::size_t const i : fifos)
        names += (names.empty() ? "" : ", ") + machine.fifos[i].name;
    return names;
}

std::string proof(Sizing const& sizing) {
    if (sizing.is_proven)
        return fmt::format("\n  Proven: nothing below {:.1f} LUT-equivalents keeps the bound.\n", sizing.answer.cost);
    if (sizing.is_given_up)
        return fmt::format(
            "\n  Not proven to be the cheapest: the search was given up. Nothing below {:.1f} LUT-equivalents keeps "
            "the "
            "bound.\n",
            sizing.least_cost);
    if (shares_memory(sizing.machine))
        return fmt::format(
            "\n  Nothing below {:.1f} LUT-equivalents keeps the bound, not even if every master had the\n"
            "  memory to itself. They share it, so that more room may cost time: not proven that nothing in between is "
            "within.\n",
            sizing.least_cost);
    return fmt::format(
        "\n  Nothing below {:.1f} LUT-equivalents keeps the bound, not even if tokens in front of a\n"
        "  full {} closed up. They freeze, so that more room may cost time: not proven that nothing in between is "
        "within.\n",
        sizing.least_cost, names_of(freezing_fifos(sizing.machine), sizing.machine));
}

/// Of figures that a shared memory makes.
std::string remark(Sizing const& sizing) {
    return shares_memory(sizing.machine) ? "  The cores share a memory, so that more room may cost time, also more "
                                           "than unbounded FIFOs have. All totals\n"
                                           "  are those of all cores, retimed together.\n"
                                         : "";
}

std::string head(Sizing const& sizing) {
    std::string text = fmt::format("Cheapest FIFOs within {} % of unbounded ones: at most {} cycles\n\n",
                                   sizing.options.within_percent, grouped(sizing.bound));
    text += fmt::format("  {:<11}{:>14} {:>12} {:>14}  per core, {} {}\n", "FIFOs", "total cycles", "change",
                        "cost [LUT-eq]", sizing.machine.cores, sizing.machine.cores == 1 ? "core" : "cores alike");
    text += choice_line("unbounded", sizing.unbounded, sizing);
    text += choice_line("configured", sizing.configured, sizing);
    text += choice_line("answer", sizing.answer, sizing);
    text += proof(sizing) + remark(sizing);
    return text + fmt::format("  A RAMB36 counts as {:.2f} LUT-equivalents, a LUT as one.\n",
                              sizing.options.weights.luts_per_ramb36);
}

std::string depths(Sizing const& sizing) {
    std::string text = fmt::format("\nThe answer\n  {:<20}{:>10}{:>8}  {:<15}{:>6}{:>15}{:>9}  {}\n", "FIFO",
                                   "configured", "depth", "kind", "bits", "cost [LUT-eq]", "holds", "primitives");
    for (std::size_t const i : fifos_of(sizing.machine)) {
        MachineFifo const& fifo = sizing.machine.fifos[i];
        FifoChoice const& choice = sizing.answer.choice[i];
        Primitives const primitives = primitives_of(choice, freedom_of(fifo), sizing.options.weights);
        fmt::format_to(std::back_inserter(text), "  {:<20}{:>10}{:>8}  {:<15}{:>6}{:>15.1f}{:>9}  {}\n", fifo.name,
                       fifo.depth, choice.depth, choice_name(choice.kind), fifo.bits,
                       cost_of(primitives, sizing.options.weights), sizing.holds[i].depth, primitives_text(primitives));
    }
    if (sizing.holds_cycles.value_or(0) > sizing.answer.total_cycles)
        fmt::format_to(std::back_inserter(text), "  All as deep as they hold: {} cycles.\n",
                       cycles_text(*sizing.holds_cycles));
    return text;
}

std::string certificate(Sizing const& sizing) {
    std::string text = fmt::format(
        "\nCertificate: any one FIFO shallower breaks the bound; a core that does, retimed\n  {:<20}{:>8}{:>10}  "
        "{:<18}{:>6}{:>14} {:>12}\n",
        "FIFO", "depth", "shallower", "by", "core", "cycles", "change");
    for (CertificateRow const& row : sizing.certificate) {
        char const* const step = row.is_token_step && row.is_cost_step ? "token, cost step"
                                 : row.is_token_step                   ? "token"
                                                                       : "cost step";
        fmt::format_to(std::back_inserter(text), "  {:<20}{:>8}{:>10}  {:<18}{:>6}{:>14} {:>12}\n",
                       sizing.machine.fifos[row.fifo].name, sizing.answer.choice[row.fifo].depth, row.shallower.depth,
                       step, row.core, cycles_text(row.core_cycles),
                       change_text(row.core_cycles, sizing.unbounded.total_cycles));
    }
    return sizing.certificate.empty() ? std::string("\nAll FIFOs have depth 1: there is nothing shallower.\n") : text;
}

std::string front(Sizing const& sizing) {
    if (sizing.front.empty())
        return "";
    std::string text = fmt::format(
        "\nCost against cycles, the cheapest within each of several bounds\n  {:>14}{:>15} "
        "{:>12}  primitives of a core\n",
        "cost [LUT-eq]", "total cycles", "change");
    for (FrontPoint const& point : sizing.front)
        fmt::format_to(std::back_inserter(text), "  {:>14.1f}{:>15} {:>12}  {}{}\n", point.cost,
                       grouped(point.found.total_cycles),
                       change_text(point.found.total_cycles, sizing.unbounded.total_cycles),
                       primitives_text(point.primitives), point.found.is_proven ? "" : " (not proven)");
    return text;
}

/// Hundredths of a LUT are enough for anybody.
double rounded(double luts) { return std::round(luts * 100) / 100; }

Json ramb36(Primitives const& primitives) { return static_cast<double>(primitives.ramb18) / 2; }

/// null: a deadlock
Json cycles_or_null(Cycles cycles) { return cycles == Cut::deadlock ? Json() : Json(cycles); }

Json depths(Choice const& choice, Machine const& machine) {
    Json json = Json::object();
    for (std::size_t const i : fifos_of(machine))
        json[machine.fifos[i].name] = choice[i].depth;
    return json;
}

/// An unbounded `auto` FIFO is a memory, however shallow.
Json kinds(Choice const& choice, Machine const& machine) {
    Json json = Json::object();
    for (std::size_t const i : fifos_of(machine))
        json[machine.fifos[i].name] = choice_name(choice[i].kind);
    return json;
}

Json summary(SizedChoice const& choice, Machine const& machine) {
    Json json;
    json["total_cycles"] = cycles_or_null(choice.total_cycles);
    json["milliseconds"] =
        choice.total_cycles == Cut::deadlock ? Json() : Json(machine.milliseconds(choice.total_cycles));
    json["cost_luts"] = rounded(choice.cost);
    json["luts"] = choice.primitives.luts;
    json["ramb36"] = ramb36(choice.primitives);
    json["depths"] = depths(choice.choice, machine);
    json["kinds"] = kinds(choice.choice, machine);
    return json;
}

/// null: it is proven.
Json why_unproven(Sizing const& sizing) {
    if (sizing.is_proven)
        return {};
    if (sizing.is_given_up)
        return "given_up";
    return shares_memory(sizing.machine) ? "shared_memory" : "freezing";
}

Json freezing(Machine const& machine) {
    Json json = Json::array();
    for (std::size_t const i : freezing_fifos(machine))
        json.push_back(machine.fifos[i].name);
    return json;
}

Json fifo_row(Sizing const& sizing, std::size_t i) {
    MachineFifo const& fifo = sizing.machine.fifos[i];
    FifoChoice const& choice = sizing.answer.choice[i];
    Primitives const primitives = primitives_of(choice, freedom_of(fifo), sizing.options.weights);
    Json row;
    row["fifo"] = fifo.name;
    row["configured_depth"] = fifo.depth;
    row["configured_kind"] = choice_name(fifo.configured_kind);
    row["depth"] = choice.depth;
    row["kind"] = choice_name(choice.kind);
    row["bits"] = fifo.bits;
    row["luts"] = primitives.luts;
    row["ramb36"] = ramb36(primitives);
    row["cost_luts"] = rounded(cost_of(primitives, sizing.options.weights));
    row["holds"] = sizing.holds[i].depth;
    return row;
}

Json certificate_row(Sizing const& sizing, CertificateRow const& row) {
    Json json;
    json["fifo"] = sizing.machine.fifos[row.fifo].name;
    json["depth"] = sizing.answer.choice[row.fifo].depth;
    json["shallower_depth"] = row.shallower.depth;
    json["shallower_kind"] = choice_name(row.shallower.kind);
    json["token_step"] = row.is_token_step;
    json["cost_step"] = row.is_cost_step;
    json["core"] = row.core;
    json["core_cycles"] = cycles_or_null(row.core_cycles);
    return json;
}

Json front_row(Sizing const& sizing, FrontPoint const& point) {
    Json json = summary({point.found.choice, point.found.total_cycles, point.primitives, point.cost}, sizing.machine);
    json["proven"] = point.found.is_proven;
    return json;
}

}  // namespace

std::string sizing_text(Sizing const& sizing) {
    return head(sizing) + depths(sizing) + certificate(sizing) + front(sizing);
}

std::string sizing_json(Sizing const& sizing) {
    Json json;
    json["format"] = "faster-sizing";
    json["version"] = 1;
    json["within_percent"] = sizing.options.within_percent;
    json["bound_cycles"] = sizing.bound;
    json["raster_cores"] = sizing.machine.cores;
    json["clock_mhz"] = sizing.machine.clock_mhz;
    json["luts_per_ramb36"] = sizing.options.weights.luts_per_ramb36;
    json["proven"] = sizing.is_proven;
    json["unproven_because"] = why_unproven(sizing);
    json["least_cost_luts"] = rounded(sizing.least_cost);
    json["freezing_fifos"] = freezing(sizing.machine);
    json["shares_memory"] = shares_memory(sizing.machine);
    json["unbounded"] = summary(sizing.unbounded, sizing.machine);
    json["configured"] = summary(sizing.configured, sizing.machine);
    json["answer"] = summary(sizing.answer, sizing.machine);
    json["fifos"] = Json::array();
    for (std::size_t const i : fifos_of(sizing.machine))
        json["fifos"].push_back(fifo_row(sizing, i));
    if (sizing.holds_cycles)
        json["holds_total_cycles"] = cycles_or_null(*sizing.holds_cycles);
    json["certificate"] = Json::array();
    for (CertificateRow const& row : sizing.certificate)
        json["certificate"].push_back(certificate_row(sizing, row));
    json["front"] = Json::array();
    for (FrontPoint const& point : sizing.front)
        json["front"].push_back(front_row(sizing, point));
    return io::text_of(json, 2) + "\n";
}

/// The machine that was sized: depths and kinds, and what else is not the default. A preset has said what it had to.
static bool belongs_to_answer(ResolvedKey const& key, IdleKeys const& idle) {
    auto const is = [&key](std::string const& ending) {
        return key.key.size() > ending.size() &&
               key.key.compare(key.key.size() - ending.size(), ending.size(), ending) == 0;
    };
    bool const is_of_fifo = key.key.rfind("accelerator.fifos.", 0) == 0 && (is(".depth") || is(".kind"));
    return key.key.rfind("accelerator.", 0) == 0 && key.key != architecture_key_name &&
           idle.decider_of(key.key) == nullptr && (is_of_fifo || !key.is_default);
}

std::string pareto_csv(Sizing const& sizing) {
    std::string text = "cost_luts,luts,ramb36,total_cycles,milliseconds,proven";
    for (std::size_t const i : fifos_of(sizing.machine))
        text += ',' + sizing.machine.fifos[i].name;
    text += '\n';
    for (FrontPoint const& point : sizing.front) {
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}", rounded(point.cost), point.primitives.luts,
                       static_cast<double>(point.primitives.ramb18) / 2, point.found.total_cycles,
                       sizing.machine.milliseconds(point.found.total_cycles), point.found.is_proven ? 1 : 0);
        for (std::size_t const i : fifos_of(sizing.machine))
            fmt::format_to(std::back_inserter(text), ",{}", point.found.choice[i].depth);
        text += '\n';
    }
    return text;
}

std::string depths_yaml(Sizing const& sizing, std::string const& title) {
    RunConfig sized = sizing.config;
    sized.machine() = with_choice(sized.machine(), sizing.machine, sizing.answer.choice);
    IdleKeys const idle = idle_keys(sizing.config);
    std::vector<ResolvedKey> keys;
    for (ResolvedKey& key : resolved_keys(sized))
        if (belongs_to_answer(key, idle))
            keys.push_back(std::move(key));
    return fmt::format("# {}\n# {} cycles, {} LUT and {:g} RAMB36 a core.\n", title, sizing.answer.total_cycles,
                       sizing.answer.primitives.luts, static_cast<double>(sizing.answer.primitives.ramb18) / 2) +
           to_yaml(keys);
}

}  // namespace dataflow::sizing
