#include "tb/show_command.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string>

#include "tb/run_folder.hpp"
#include "tb/terminal.hpp"
#include "tool/exit_codes.hpp"
#include "tool/options.hpp"
#include "workload/pictures/depth_scale.hpp"
#include "workload/pictures/terminal_picture.hpp"

namespace faster {

namespace {

std::string figures_text(std::int64_t sample, SampleFigures const& figures) {
    return fmt::format("sample {} on core {}: latency {} cycles, {} inliers, {} of {} edge pixels are edge inliers",
                       sample, figures.core, figures.latency_cycles, figures.inlier, figures.edge_inlier,
                       figures.valid_edge);
}

/// Marks of a picture, and what they mean.
struct Drawing {
    Image<pictures::Mark> marks;
    std::string legend;
};

Drawing contour_drawing(SampleMaps const& maps, bool in_colours) {
    return {pictures::contour_marks(maps.edge_map, maps.object_map),
            in_colours ? "edge map (red) over object map (green)" : "edge map (#) over object map (.)"};
}

Drawing depth_drawing(SampleMaps const& maps, int fraction_bits, bool in_colours) {
    pictures::DepthScale scale(fraction_bits);
    scale.include(maps.depth_buffer);
    std::string const legend =
        fmt::format("depth from {:.3f} m ({}) to {:.3f} m ({})", scale.nearest_metres(), in_colours ? "yellow" : "@",
                    scale.farthest_metres(), in_colours ? "violet" : ".");
    return {pictures::depth_marks(maps.depth_buffer, scale), legend};
}

/// A picture of the terminal's size, text above and prompt below included; or as wide as asked for, and no higher than
/// it is wide.
Image<pictures::Mark> fitted(Image<pictures::Mark> const& marks, Terminal const& terminal, int asked_width) {
    constexpr int lines_of_text = 3;
    if (asked_width > 0)
        return pictures::fitted_to_terminal(marks, asked_width, asked_width);
    int const lines = std::max(10, terminal.lines - lines_of_text);
    return pictures::fitted_to_terminal(marks, 2 * lines, terminal.columns);
}

void print_picture(Image<pictures::Mark> const& marks, bool in_colours) {
    fmt::print("{}", in_colours ? pictures::coloured_text(marks) : pictures::plain_text(marks));
}

}  // namespace

int show(ShowRequest const& request) {
    RunFolder const run(request.folder);
    auto const sample = static_cast<std::size_t>(request.sample);
    SampleMaps const maps = run.maps(sample);
    SampleFigures const figures = run.figures(sample);
    Terminal const terminal = terminal_on_stdout();
    bool const in_colours = terminal.takes_colours;
    Drawing const drawing =
        request.depth ? depth_drawing(maps, run.depth_fraction_bits(), in_colours) : contour_drawing(maps, in_colours);
    Image<pictures::Mark> const drawn = pictures::cropped(drawing.marks);
    fmt::print("{}\n{}\n", figures_text(request.sample, figures),
               drawn.empty() ? "nothing is drawn in its window" : drawing.legend);
    if (!drawn.empty())
        print_picture(fitted(drawn, terminal, static_cast<int>(request.width)), in_colours);
    return exit_done;
}

Subcommand show_command() {
    return {"show", "Print a small picture of one sample of an older run", [](CLI::App& command) {
                auto const request = std::make_shared<ShowRequest>();
                command.add_option("folder", request->folder, "Results of run --out DIR --images K")
                    ->required()
                    ->type_name("DIR");
                command.add_option("--sample", request->sample, "Index of the sample (0)")
                    ->type_name("N")
                    ->check(CLI::Range(0, 1000000));
                command.add_flag("--depth", request->depth, "The depth buffer instead of edge and object map");
                command.add_option("--width", request->width, "Columns at most (those of the terminal, else 80)")
                    ->type_name("N")
                    ->check(CLI::Range(10, 1000));
                return [request] { return show(*request); };
            }};
}

}  // namespace faster
