#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

#include "dataflow/base/files/atomic_folder.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/choice_names.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/models/builtin_models.hpp"
#include "faster/workload/pictures/drawing.hpp"
#include "faster/workload/pictures/overlay.hpp"
#include "poses/commands/pose_commands.hpp"
#include "poses/quality/pose_survey.hpp"

namespace faster {

namespace {

/// `faster-sim edge-quality`.
struct EdgeQualityRequest {
    std::int64_t poses = 620;             ///< per class
    std::int64_t seed = 1;                ///< of the poses
    std::vector<std::string> classes;     ///< built-in objects; empty: all
    std::vector<std::string> algorithms;  ///< of accelerator.edge_map.algorithm; empty: all
    bool force = false;                   ///< however long it takes
    std::string out;                      ///< folder for quality.csv and pictures; empty: print only
};

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

io::FolderKind const quality_folder{
    "edge map quality", "quality.csv", {"pictures/*_best.png", "pictures/*_worst.png"}, "algorithm,object,poses,"};

/// `given`, each once, or all that are known if none is. Throws InputError if one is not.
Words chosen(char const* option, Words const& given, Words const& known) {
    Words words;
    for (std::string const& name : given) {
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw InputError(fmt::format("{} {}, expected one of {}{}", option, name, fmt::join(known, ", "),
                                         did_you_mean(name, known)));
        if (std::find(words.begin(), words.end(), name) == words.end())
            words.push_back(name);
    }
    return given.empty() ? known : words;
}

/// Found edges red, contour blue where it was missed and purple where it was found, silhouette green.
Image<Colour> picture_of(quality::Specimen const& specimen) {
    return pictures::enlarged(pictures::overlay(specimen.edge_map, specimen.silhouette, specimen.contour), 3);
}

void write_specimens(fs::path const& folder, std::vector<quality::PoseSurvey> const& rows) {
    fs::create_directories(folder);
    for (quality::PoseSurvey const& row : rows) {
        std::string const name = choice_name(row.algorithm) + "_" + row.object;
        files::write_colour_png(folder / (name + "_best.png"), picture_of(row.best));
        files::write_colour_png(folder / (name + "_worst.png"), picture_of(row.worst));
    }
}

WorkSize size_of(std::size_t objects, std::size_t algorithms, std::size_t poses) {
    constexpr double maps_per_s = 1000;
    auto const maps = static_cast<double>(objects * algorithms * poses);
    WorkSize size;
    size.command = "edge-quality";
    size.amount = fmt::format("{:.0f} edge maps", maps);
    size.seconds = maps / maps_per_s;
    return size;
}

/// Judges the edge maps of the algorithms. Throws InputError on bad input.
int edge_quality(EdgeQualityRequest const& request) {
    Words const objects = chosen("--classes", request.classes, models::names());
    std::vector<EdgeMapAlgorithm> algorithms;
    for (std::string const& name : chosen("--algorithms", request.algorithms, names_of_choices<EdgeMapAlgorithm>()))
        algorithms.push_back(choice_from_name<EdgeMapAlgorithm>(name));
    std::unique_ptr<io::AtomicFolder> const folder =
        request.out.empty() ? nullptr : std::make_unique<io::AtomicFolder>(request.out, quality_folder);
    announce(size_of(objects.size(), algorithms.size(), static_cast<std::size_t>(request.poses)), request.force);
    std::vector<quality::PoseSurvey> rows;
    ProgressLine line("edge maps");
    for (std::size_t i = 0; i < objects.size(); ++i) {
        std::string const& object = objects[i];
        auto const progress = [&](std::size_t done, std::size_t all) {
            line.show(i * all + done, objects.size() * all);
        };
        Mesh const mesh = models::make(object);
        auto const poses = quality::random_poses(mesh, static_cast<std::size_t>(request.poses),
                                                 static_cast<std::uint64_t>(request.seed));
        for (quality::PoseSurvey& row : quality::survey(object, mesh, poses, algorithms, progress))
            rows.push_back(std::move(row));
    }
    if (folder != nullptr) {
        io::write_file(folder->path() / "quality.csv", quality::survey_csv(rows));
        write_specimens(folder->path() / "pictures", rows);
        folder->commit();
    }
    say("{}", quality::survey_markdown(rows));
    say_written({request.out});
    return exit_done;
}

}  // namespace

Subcommand edge_quality_command() {
    return {"edge-quality", "Judge the edge maps of the algorithms by the exact contours of many random poses",
            [](CLI::App& command) {
                auto const request = std::make_shared<EdgeQualityRequest>();
                command.add_option("--poses", request->poses, "Poses per class")
                    ->type_name("N")
                    ->capture_default_str()
                    ->check(integer_in(1, 100000));
                command.add_option("--seed", request->seed, "Seed of the poses")
                    ->type_name("N")
                    ->capture_default_str()
                    ->check(integer_in(0, 9'000'000'000'000'000'000));
                command.add_option("--classes", request->classes, "Built-in objects, with commas between (all)")
                    ->type_name("NAMES")
                    ->delimiter(',');
                command
                    .add_option("--algorithms", request->algorithms,
                                "Of accelerator.edge_map.algorithm, likewise (all)")
                    ->type_name("NAMES")
                    ->delimiter(',');
                command
                    .add_option("--out", request->out,
                                "Write quality.csv and pictures of the best and worst poses to this folder")
                    ->type_name("DIR");
                add_force(command, request->force);
                return [request] { return edge_quality(*request); };
            }};
}

}  // namespace faster
