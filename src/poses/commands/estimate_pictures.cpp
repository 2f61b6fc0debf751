#include "poses/commands/estimate_pictures.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "faster/workload/build_stimulus.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/pictures/convergence_sheet.hpp"
#include "faster/workload/pictures/drawing.hpp"
#include "faster/workload/pictures/line_plot.hpp"
#include "faster/workload/pictures/overlay.hpp"
#include "poses/estimation/counter_scorer.hpp"

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

EstimatePictures::EstimatePictures(Stimulus observed, AcceleratorConfig const& config, Pose const& shown)
    : stimulus_(std::move(observed)), config_(config) {
    workload::set_poses({shown}, stimulus_);
    SampleInput const& sample = stimulus_.samples.front();
    top_ = stimulus_.window_offset(sample.centre_row);
    left_ = stimulus_.window_offset(sample.centre_col);
    observed_edges_ = pictures::observed_edges_in_window(stimulus_, sample);
}

void EstimatePictures::mark(Pose const& pose, Image<std::uint8_t>& contours, Image<std::uint8_t>* object) {
    workload::set_poses({pose}, stimulus_);
    SampleInput const& sample = stimulus_.samples.front();
    reference::Scorer scorer = estimation::reference_scorer(stimulus_, config_);
    scorer.run(0);
    SampleMaps const& maps = scorer.maps();
    std::int64_t const down = stimulus_.window_offset(sample.centre_row) - top_;
    std::int64_t const right = stimulus_.window_offset(sample.centre_col) - left_;
    for (int row = 0; row < maps.edge_map.height(); ++row)
        for (int col = 0; col < maps.edge_map.width(); ++col) {
            std::int64_t const r = row + down, c = col + right;
            if (r < 0 || c < 0 || r >= contours.height() || c >= contours.width())
                continue;
            auto const at = std::pair(static_cast<int>(r), static_cast<int>(c));
            contours.at(at.first, at.second) |= maps.edge_map.at(row, col);
            if (object != nullptr)
                object->at(at.first, at.second) |= maps.object_map.at(row, col);
        }
}

Image<Colour> EstimatePictures::picture(DrawnIteration const& iteration) {
    Image<std::uint8_t> contours(stimulus_.window, stimulus_.window), object = contours;
    for (Pose const& pose : iteration.poses)
        mark(pose, contours, nullptr);
    mark(iteration.best, contours, &object);
    return pictures::overlay(contours, object, observed_edges_);
}

void EstimatePictures::write(std::filesystem::path const& folder, std::vector<DrawnIteration> const& iterations) {
    constexpr int usual_side = 600;
    std::filesystem::create_directories(folder);
    pictures::ConvergenceSheet sheet(iterations.size());
    for (DrawnIteration const& iteration : iterations) {
        Image<Colour> const drawn = picture(iteration);
        files::write_colour_png(folder / fmt::format("iteration_{:04}.png", iteration.number),
                                pictures::enlarged(drawn, std::max(1, usual_side / drawn.width())));
        sheet.add(iteration.label, drawn);
    }
    files::write_colour_png(folder / "convergence.png", sheet.picture());
}

}  // namespace faster
