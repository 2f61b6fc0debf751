#include "dataflow/tools/budgets/figure_pattern.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fnmatch.h>

#include "dataflow/base/nearest_name.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/tools/budgets/figures.hpp"

namespace dataflow::budgets {

namespace {

bool part_matches(std::string const& pattern, std::string const& part) {
    return fnmatch(pattern.c_str(), part.c_str(), 0) == 0;
}

/// That of the defaults, and every part that any configuration may have.
Machine with_all_parts() {
    Machine machine = machine_of(RunConfig());
    auto const add_all = [](auto& parts) {
        for (auto& part : parts)
            part.is_present = true;
    };
    add_all(machine.processes);
    add_all(machine.fifos);
    add_all(machine.loops);
    add_all(machine.memories);
    machine.external_memory.emplace();
    return machine;
}

/// The names of a run with one core and one sample.
std::vector<std::string> make_template_names() {
    RunStatistics run;
    run.machine = with_all_parts();
    run.samples.resize(1);
    run.samples[0].counters.resize(design().counters().size());
    run.cores.push_back(empty_core(run.machine));
    Figures const figures = run_figures(run);
    std::vector<std::string> names;
    for (Figure const& figure : figures.all())
        names.push_back(figure.name);
    return names;
}

std::vector<std::string> const& template_names() {
    static std::vector<std::string> const names = make_template_names();
    return names;
}

/// "samples.17.latency_cycles" as "samples.*.latency_cycles": whether there is such a sample is the run's business.
std::string with_any_number(std::string const& pattern) {
    std::vector<std::string> parts = split_at_points(pattern);
    bool const has_number = parts.size() > 1 && (parts[0] == "samples" || parts[0] == "cores");
    if (has_number && (parse_integer(parts[1]) || parts[1].find_first_of("*?[") != std::string::npos))
        parts[1] = "*";
    return fmt::format("{}", fmt::join(parts, "."));
}

/// A candidate in the words of whoever wrote `pattern`: with its wildcards and numbers where they fit.
std::string in_the_words_of(std::vector<std::string> const& pattern, std::string const& name) {
    std::vector<std::string> parts = split_at_points(name);
    for (std::size_t i = 0; i < std::min(parts.size(), pattern.size()); ++i)
        if (part_matches(pattern[i], parts[i]) || (parts[i] == "0" && parse_integer(pattern[i])))
            parts[i] = pattern[i];
    return fmt::format("{}", fmt::join(parts, "."));
}

}  // namespace

bool FigurePattern::matches(std::string const& name) const {
    if (name.compare(0, literal_beginning_.size(), literal_beginning_) != 0)
        return false;
    std::vector<std::string> const parts = split_at_points(name);
    return parts.size() == parts_.size() && std::equal(parts_.begin(), parts_.end(), parts.begin(), part_matches);
}

bool FigurePattern::matches_any(Figures const& figures) const {
    return std::any_of(figures.all().begin(), figures.all().end(),
                       [this](Figure const& figure) { return matches(figure.name); });
}

bool FigurePattern::has_wildcard() const {
    return std::any_of(parts_.begin(), parts_.end(),
                       [](std::string const& part) { return part.find_first_of("*?[") != std::string::npos; });
}

std::vector<std::string> possible_names(std::string const& pattern) {
    FigurePattern const any_number(with_any_number(pattern));
    std::vector<std::string> names = template_names();
    names.erase(std::remove_if(names.begin(), names.end(),
                               [&any_number](std::string const& name) { return !any_number.matches(name); }),
                names.end());
    return names;
}

std::string did_you_mean_figure(std::string const& pattern) {
    std::vector<std::string> const words = split_at_points(pattern);
    std::vector<std::string> candidates{"milliseconds"};
    for (std::string const& name : template_names())
        candidates.push_back(in_the_words_of(words, name));
    return did_you_mean(pattern, candidates);
}

}  // namespace dataflow::budgets
