#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include "dataflow/base/files/csv_integers.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/files/sample_picture.hpp"
#include "faster/workload/pictures/depth_scale.hpp"
#include "faster/workload/pictures/terminal_picture.hpp"
#include "tb/commands.hpp"

namespace faster {

namespace {

/// `faster-sim show`.
struct ShowRequest {
    std::string folder;       ///< results of a run
    std::int64_t sample = 0;  ///< index
    std::int64_t width = 0;   ///< columns; 0: what fits the terminal
    bool depth = false;       ///< the depth buffer rather than the contour
};

/// What samples.csv says about one sample.
struct SampleFigures {
    std::int64_t core = 0;
    std::int64_t latency_cycles = 0;
    std::int64_t inlier = 0;
    std::int64_t valid_edge = 0;
    std::int64_t edge_inlier = 0;
};

/// The results of an older run, as `faster-sim run --out DIR --images K` left them. All functions throw InputError: on
/// what is missing, with the command that would make it.
class RunFolder {
  public:
    /// Requires the folder and pictures in it.
    explicit RunFolder(std::filesystem::path folder);

    SampleMaps maps(std::size_t sample) const;
    SampleFigures figures(std::size_t sample) const;
    /// Fractional bits of the depth buffer's codes.
    int depth_fraction_bits() const;

  private:
    std::size_t samples() const;
    std::size_t pictured_samples() const;
    void require_pictures_of(std::size_t sample) const;
    std::filesystem::path picture(std::size_t sample, std::string const& content) const;
    std::string how_to_make(std::size_t images) const;

    std::filesystem::path folder_;
    std::filesystem::path images_;
};

namespace fs = std::filesystem;

constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();

/// Samples are numbered from 0: "0", "0..5".
std::string range_text(std::size_t count) {
    return count < 2 ? (count == 0 ? "no sample at all" : "0") : fmt::format("0..{}", count - 1);
}

/// In the place of what was to be a folder.
std::string what_is_there(fs::path const& file) {
    std::error_code ignored;
    return fs::exists(file, ignored) ? "is a file" : "no such folder";
}

template <class Pixel>
void require_size_of_edges(fs::path const& file, Image<Pixel> const& found, Image<std::uint8_t> const& edges) {
    files::require_size(file, found.width(), found.height(), edges.width(), edges.height(), "the size of the edge map");
}

bool is_folder(fs::path const& folder) {
    std::error_code ignored;
    return fs::is_directory(folder, ignored);
}

RunFolder::RunFolder(fs::path folder) : folder_(std::move(folder)), images_(folder_ / "images") {
    if (!is_folder(folder_))
        throw InputError(fmt::format("{}: {}, expected the results of a run; {}", folder_.string(),
                                     what_is_there(folder_), how_to_make(1)));
    if (!is_folder(images_))
        throw InputError(fmt::format("{}: {}, expected pictures of a run; {}", images_.string(), what_is_there(images_),
                                     how_to_make(1)));
    if (pictured_samples() == 0)
        throw InputError(fmt::format("{}: no picture in it, expected sample_NNNN_{{edges,object,depth}}.png; {}",
                                     images_.string(), how_to_make(1)));
}

std::string RunFolder::how_to_make(std::size_t images) const {
    return fmt::format("faster-sim run CONFIG --out {} --images {} writes them", folder_.string(), images);
}

std::size_t RunFolder::samples() const {
    std::size_t rows = 0;
    io::read_csv_integers(folder_ / "samples.csv", {{"sample", 0, any}},
                          [&rows](std::size_t, std::int64_t const*) { ++rows; });
    return rows;
}

/// A run writes pictures of its first samples.
std::size_t RunFolder::pictured_samples() const {
    std::size_t count = 0;
    while (fs::exists(files::sample_picture(images_, count, "edges")))
        ++count;
    return count;
}

void RunFolder::require_pictures_of(std::size_t sample) const {
    if (std::size_t const count = samples(); sample >= count)
        throw InputError(fmt::format("--sample {}: no row of it in {}, expected {}; {}", sample,
                                     (folder_ / "samples.csv").string(), range_text(count), how_to_make(count)));
    if (std::size_t const count = pictured_samples(); sample >= count)
        throw InputError(fmt::format("--sample {}: no picture of it in {}, expected {}; {}", sample, images_.string(),
                                     range_text(count), how_to_make(sample + 1)));
}

SampleMaps RunFolder::maps(std::size_t sample) const {
    require_pictures_of(sample);
    SampleMaps maps;
    maps.edge_map = files::read_png8(picture(sample, "edges"));
    maps.object_map = files::read_png8(picture(sample, "object"));
    maps.depth_buffer = files::read_png16(picture(sample, "depth"));
    require_size_of_edges(picture(sample, "object"), maps.object_map, maps.edge_map);
    require_size_of_edges(picture(sample, "depth"), maps.depth_buffer, maps.edge_map);
    return maps;
}

fs::path RunFolder::picture(std::size_t sample, std::string const& content) const {
    fs::path file = files::sample_picture(images_, sample, content);
    if (!fs::exists(file))
        throw InputError(
            fmt::format("{}: no such file, expected a picture of a run; {}", file.string(), how_to_make(sample + 1)));
    return file;
}

SampleFigures RunFolder::figures(std::size_t sample) const {
    std::vector<io::CsvColumn> const columns{{"sample", 0, any}, {"core", 0, any},       {"latency_cycles", 0, any},
                                             {"inlier", 0, any}, {"valid_edge", 0, any}, {"edge_inlier", 0, any}};
    SampleFigures figures;
    bool found = false;
    io::read_csv_integers(folder_ / "samples.csv", columns, [&](std::size_t, std::int64_t const* row) {
        if (row[0] == static_cast<std::int64_t>(sample)) {
            figures = {row[1], row[2], row[3], row[4], row[5]};
            found = true;
        }
    });
    if (!found)
        throw InputError(fmt::format("{}: no row of sample {}, expected one; {}", (folder_ / "samples.csv").string(),
                                     sample, how_to_make(sample + 1)));
    return figures;
}

int RunFolder::depth_fraction_bits() const {
    fs::path const file = folder_ / "summary.json";
    std::string const key = "accelerator.fraction_bits.depth_buffer";
    try {
        return nlohmann::json::parse(io::read_file(file)).at("configuration").at(key).at("value").get<int>();
    } catch (nlohmann::json::exception const&) {
        throw InputError(fmt::format("{}: no configuration with {}, expected the summary of a run; {}", file.string(),
                                     key, how_to_make(1)));
    }
}

/// What stdout can show.
struct Terminal {
    bool takes_colours = false;  ///< a terminal that says it takes 24-bit colours, and NO_COLOR is not set
    int columns = 80;
    int lines = 40;
};

std::string environment(char const* name) {
    char const* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

/// COLORTERM is the custom of terminals with 24-bit colours; "-direct" that of terminfo. Others would show rubbish.
bool says_24_bit_colours() {
    std::string const colours = environment("COLORTERM");
    return colours == "truecolor" || colours == "24bit" || environment("TERM").find("-direct") != std::string::npos;
}

/// Asks the system and the environment (COLORTERM, NO_COLOR, TERM).
Terminal terminal_on_stdout() {
    Terminal terminal;
    if (isatty(STDOUT_FILENO) == 0)
        return terminal;
    terminal.takes_colours = environment("NO_COLOR").empty() && says_24_bit_colours();
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
        terminal.columns = size.ws_col;
        terminal.lines = size.ws_row;
    }
    return terminal;
}

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

/// Prints a sample's figures and a small picture of it. Returns the exit code; throws InputError on bad input.
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

}  // namespace

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
