#include "kernel/sizing/sizing_text.hpp"

#include <fmt/format.h>
#include <iterator>

#include "kernel/config/enum_names.hpp"

namespace faster::sizing {

namespace {

double percent_over(Cycles cycles, Cycles reference) {
    return reference == 0 ? 0
                          : 100.0 * (static_cast<double>(cycles) - static_cast<double>(reference)) /
                                static_cast<double>(reference);
}

std::string cycles_text(Cycles cycles) {
    return cycles == Cut::deadlock ? std::string("deadlock") : fmt::format("{}", cycles);
}

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
    return fmt::format("  {:<11}{:>14} {:>12} {:>12.1f}  {}\n", name, cycles_text(choice.total_cycles),
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
        return "\n  Proven: no depths within the bound cost less.\n";
    if (sizing.is_given_up)
        return fmt::format(
            "\n  Not proven to be the cheapest: the search was given up. Nothing within the bound costs less than "
            "{:.1f} LUT.\n",
            sizing.least_cost);
    if (shares_memory(sizing.machine))
        return fmt::format(
            "\n  Nothing within the bound costs less than {:.1f} LUT: that would be too slow even if every master had "
            "the\n"
            "  memory to itself. They share it, so that more room may cost time: not proven that nothing in between is "
            "within.\n",
            sizing.least_cost);
    return fmt::format(
        "\n  Nothing within the bound costs less than {:.1f} LUT: that would be too slow even if tokens in front of a\n"
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
                                   sizing.options.within_percent, sizing.bound);
    text += fmt::format("  {:<11}{:>14} {:>12} {:>12}  per core, {} {}\n", "FIFOs", "total cycles", "change",
                        "cost [LUT]", sizing.machine.cores, sizing.machine.cores == 1 ? "core" : "cores alike");
    text += choice_line("unbounded", sizing.unbounded, sizing);
    text += choice_line("configured", sizing.configured, sizing);
    text += choice_line("answer", sizing.answer, sizing);
    text += proof(sizing) + remark(sizing);
    return text + fmt::format("  A RAMB36 counts as {:.2f} LUT.\n", sizing.options.weights.luts_per_ramb36);
}

std::string depths(Sizing const& sizing) {
    std::string text = fmt::format("\nThe answer\n  {:<20}{:>10}{:>8}  {:<15}{:>6}{:>12}{:>9}  {}\n", "FIFO",
                                   "configured", "depth", "kind", "bits", "cost [LUT]", "holds", "primitives");
    for (std::size_t const i : fifos_of(sizing.machine)) {
        MachineFifo const& fifo = sizing.machine.fifos[i];
        FifoChoice const& choice = sizing.answer.choice[i];
        Primitives const primitives = primitives_of(choice, freedom_of(fifo), sizing.options.weights);
        fmt::format_to(std::back_inserter(text), "  {:<20}{:>10}{:>8}  {:<15}{:>6}{:>12.1f}{:>9}  {}\n", fifo.name,
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
        "\nCost against cycles, the cheapest within each of several bounds\n  {:>12}{:>15} "
        "{:>12}  primitives of a core\n",
        "cost [LUT]", "total cycles", "change");
    for (FrontPoint const& point : sizing.front)
        fmt::format_to(std::back_inserter(text), "  {:>12.1f}{:>15} {:>12}  {}{}\n", point.cost,
                       point.found.total_cycles, change_text(point.found.total_cycles, sizing.unbounded.total_cycles),
                       primitives_text(point.primitives), point.found.is_proven ? "" : " (not proven)");
    return text;
}

}  // namespace

std::string sizing_text(Sizing const& sizing) {
    return head(sizing) + depths(sizing) + certificate(sizing) + front(sizing);
}

}  // namespace faster::sizing
