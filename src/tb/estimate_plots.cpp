#include "tb/estimate_plots.hpp"

#include "workload/pictures/line_plot.hpp"

namespace faster {

namespace {

template <class ValueOf>
pictures::PlottedLine line(char const* name, std::vector<IterationRow> const& rows, ValueOf value_of) {
    pictures::PlottedLine plotted{name, {}};
    for (IterationRow const& row : rows)
        plotted.values.push_back(value_of(row));
    return plotted;
}

}  // namespace

Image<Colour> estimate_plots(std::vector<IterationRow> const& rows) {
    constexpr char const* across = "iteration";
    std::vector<pictures::LinePlot> plots{
        {"weight",
         across,
         {line("best", rows, [](IterationRow const& row) { return row.best_weight; }),
          line("mean", rows, [](IterationRow const& row) { return row.mean_weight; })}},
        {"effective samples",
         across,
         {line("of weight^sharpness", rows, [](IterationRow const& row) { return row.effective_samples; })}},
        {"spread",
         across,
         {line("of the middles [mm]", rows, [](IterationRow const& row) { return row.spread_mm; }),
          line("of the rotations [degrees]", rows, [](IterationRow const& row) { return row.spread_deg; })}}};
    if (!rows.empty() && rows.front().best)
        plots.push_back({"best sample's error [mm]",
                         across,
                         {line("ADD", rows, [](IterationRow const& row) { return 1000 * row.best->add_m; }),
                          line("ADD-S", rows, [](IterationRow const& row) { return 1000 * row.best->adds_m; })}});
    return pictures::drawn_plots(plots);
}

}  // namespace faster
