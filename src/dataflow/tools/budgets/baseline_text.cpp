#include "dataflow/tools/budgets/baseline_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/text_lines.hpp"
#include "dataflow/tools/budgets/figure_pattern.hpp"

namespace dataflow::budgets {

namespace {

/// Enough to say what moved: stalls by FIFO stand in the FIFOs' rows already.
bool is_always_kept(std::string const& name) {
    std::vector<std::string> const parts = split_at_points(name);
    bool const is_single = parts.size() > 1 && (parts[0] == "cores" || parts[0] == "samples");
    bool const is_repetition = parts.size() == 4 && parts[0] == "modules";
    return !is_single && !is_repetition;
}

std::vector<FigurePattern> patterns_with_baseline(std::vector<Limit> const& limits) {
    std::vector<FigurePattern> patterns;
    for (Limit const& limit : limits)
        if (limit.needs_baseline())
            patterns.emplace_back(limit.figure);
    return patterns;
}

std::string without_last_part(std::string const& name) {
    std::size_t const point = name.rfind('.');
    return point == std::string::npos ? "" : name.substr(0, point);
}

std::string figure_lines(Figures const& figures) {
    std::string text, open;
    for (Figure const& figure : figures.all()) {
        std::string const item = without_last_part(figure.name);
        if (item == open && !open.empty()) {
            text += fmt::format(", {}: {}", split_at_points(figure.name).back(), figure.value);
            continue;
        }
        text += open.empty() ? "" : "}\n";
        open = item;
        text += item.empty() ? fmt::format("    {}: {}\n", figure.name, figure.value)
                             : fmt::format("    {}: {{{}: {}", item, split_at_points(figure.name).back(), figure.value);
    }
    return text + (open.empty() ? "" : "}\n");
}

}  // namespace

Baseline baseline_of(Measurement const& measurement, std::vector<Limit> const& limits, std::string const& date,
                     std::string const& reason) {
    Baseline baseline{date, reason, measurement.configuration, measurement.accelerator, {}};
    std::vector<FigurePattern> const patterns = patterns_with_baseline(limits);
    for (Figure const& figure : measurement.figures.all())
        if (is_always_kept(figure.name) ||
            std::any_of(patterns.begin(), patterns.end(),
                        [&figure](FigurePattern const& pattern) { return pattern.matches(figure.name); }))
            baseline.figures.set(figure.name, figure.value);
    return baseline;
}

bool is_same_run(Baseline const& a, Baseline const& b) {
    auto const& left = a.figures.all();
    auto const& right = b.figures.all();
    return a.configuration == b.configuration && a.accelerator == b.accelerator &&
           std::equal(left.begin(), left.end(), right.begin(), right.end(), [](Figure const& one, Figure const& other) {
               return one.name == other.name && one.value == other.value;
           });
}

std::string baseline_block(Baseline const& baseline) {
    std::vector<std::string> settings;
    for (Setting const& setting : baseline.accelerator)
        settings.push_back(setting.key + ": " + yaml_value(setting.value));
    return fmt::format("baseline:\n  date: {}\n  reason: {}\n  configuration: {}\n  accelerator: {{{}}}\n  figures:\n",
                       baseline.date, nlohmann::json(baseline.reason).dump(), baseline.configuration,
                       fmt::join(settings, ", ")) +
           figure_lines(baseline.figures);
}

}  // namespace dataflow::budgets
