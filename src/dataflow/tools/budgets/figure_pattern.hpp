#pragma once
#include <string>
#include <vector>

#include "dataflow/base/text_lines.hpp"
#include "dataflow/tools/budgets/figures.hpp"

namespace dataflow::budgets {

/// A figure's name in which each part may hold the wildcards of file names: `*`, `?` and `[...]`. A wildcard stands for
/// letters of one part, never for a point: "fifos.*.max_occupancy", "fifos.pixel_*.full_stall_cycles".
class FigurePattern {
  public:
    explicit FigurePattern(std::string const& text)
        : parts_(split_at_points(text)), literal_beginning_(text.substr(0, text.find_first_of("*?[\\"))) {}
    bool matches(std::string const& name) const;
    bool matches_any(Figures const& figures) const;
    bool has_wildcard() const;

  private:
    std::vector<std::string> parts_;
    std::string literal_beginning_;  // tells most names apart at once
};

/// The names among those of any run that the pattern may stand for, with 0 for the number of a core or sample.
std::vector<std::string> possible_names(std::string const& pattern);

/// What a pattern that stands for nothing was probably meant to be: ", did you mean ...?", or nothing.
std::string did_you_mean_figure(std::string const& pattern);

}  // namespace dataflow::budgets
