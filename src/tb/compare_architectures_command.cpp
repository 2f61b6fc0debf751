#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/process_pool.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/tools/report/architecture_table.hpp"
#include "dataflow/tools/report/html/architectures_html.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/workload_source.hpp"
#include "modules/core/core_context.hpp"
#include "modules/core/faster_simulation.hpp"
#include "poses/commands/workload_iterations.hpp"
#include "poses/quality/sample_judge.hpp"
#include "tb/commands.hpp"

namespace faster {

namespace {

/// `faster-sim compare-architectures`.
struct CompareArchitecturesRequest {
    /// Presets by name, or configuration files that say what an architecture changes. Empty: all presets, `faster`
    /// first.
    std::vector<std::string> architectures;
    std::vector<std::string> workloads;  ///< configuration files to run them on
    std::vector<std::string> overrides;  ///< KEY=VALUE, for all
    std::int64_t jobs = 0;               ///< simulations at once; 0: the host's cores
    std::int64_t judged_samples = 0;     ///< how many edge maps to judge in every run
    bool force = false;                  ///< however long each takes, whatever memory there is
    std::string csv;                     ///< file; empty: none
    std::string html;                    ///< the same
};

/// Judges the edge maps of the first samples of a run by their silhouettes.
class EdgeMapJudge : public SampleProbe {
  public:
    /// `side`: which contour to judge by. `count`: number of samples. The stimulus is held by reference.
    EdgeMapJudge(Stimulus const& stimulus, quality::ContourSide side, std::size_t count)
        : judge_(stimulus, side), count_(count) {}

    void edge_maps_done(std::size_t sample, EdgeMapView const& maps) override;
    void depth_buffer_done(std::size_t, std::vector<std::uint16_t> const&) override {}

    quality::QualitySums const& sums() const { return sums_; }

  private:
    quality::SampleJudge judge_;
    std::size_t count_;
    quality::QualitySums sums_;
};

void EdgeMapJudge::edge_maps_done(std::size_t sample, EdgeMapView const& maps) {
    if (sample >= count_)
        return;
    Image<std::uint8_t> edge_map(maps.side, maps.side);
    std::copy_n(maps.edge, edge_map.pixels().size(), edge_map.pixels().begin());
    sums_.add(judge_.judge(sample, edge_map));
}

constexpr double time_limit_s = 3600;
constexpr double forced_time_limit_s = 86'400;
constexpr char row_mark = 'r';
constexpr char error_mark = 'e';

/// One simulation to do.
struct Point {
    std::string architecture;  ///< names for the table
    std::string workload;
    LoadedConfig loaded;
    bool says_warnings = false;  ///< of the workload, which other points have as well
};

std::string name_of(std::string const& file) { return std::filesystem::path(file).stem().string(); }

bool is_preset(std::string const& name) {
    return std::any_of(design().presets().begin(), design().presets().end(),
                       [&name](Preset const& preset) { return preset.name == name; });
}

/// Checked like any configuration.
LoadedConfig load_architecture(std::string const& name_or_file) {
    if (is_preset(name_or_file))
        return load_preset(name_or_file);
    if (!std::filesystem::exists(name_or_file))
        throw InputError(fmt::format("{}: no such file, and no architecture{}", name_or_file,
                                     did_you_mean(name_or_file, preset_names())));
    return load_config(name_or_file);
}

/// What an architecture sets, as settings for the command line.
std::vector<std::string> settings_of(std::string const& architecture) {
    LoadedConfig const loaded = load_architecture(architecture);
    std::vector<std::string> settings;
    for (Key const& key : all_keys()) {
        if (!loaded.origins.is_explicit(key.name()))
            continue;
        if (key.name().rfind("accelerator.", 0) != 0)
            throw InputError(fmt::format("{}: {}, expected keys of accelerator only: an architecture has no workload",
                                         loaded.origins.of(key.name()).place, key.name()));
        settings.push_back(key.name() + "=" + plain_text(key.read(loaded.config)));
    }
    return settings;
}

void check_names(std::vector<std::string> const& files, char const* what) {
    std::set<std::string> names;
    for (std::string const& file : files)
        if (!names.insert(name_of(file)).second)
            throw InputError(
                fmt::format("{}: another {} is called {} as well, expected each name once", file, what, name_of(file)));
}

/// Every row would be the same architecture.
void check_overrides(std::vector<std::string> const& overrides) {
    for (std::string const& setting : overrides)
        if (setting.rfind("accelerator.architecture=", 0) == 0)
            throw InputError("--set " + setting + ": expected the architecture among those to be compared");
}

std::vector<Point> points_of(CompareArchitecturesRequest const& request) {
    std::vector<std::string> const architectures =
        request.architectures.empty() ? preset_names() : request.architectures;
    check_names(architectures, "architecture");
    check_names(request.workloads, "workload");
    check_overrides(request.overrides);
    std::vector<Point> points;
    for (std::string const& architecture : architectures) {
        std::vector<std::string> settings = settings_of(architecture);
        settings.insert(settings.end(), request.overrides.begin(), request.overrides.end());
        for (std::string const& workload : request.workloads)
            points.push_back({name_of(architecture), name_of(workload), load_config(workload, settings),
                              &architecture == &architectures.front()});
    }
    return points;
}

void set_quality(quality::QualitySums const& sums, report::ArchitectureRow& row) {
    row.judged_samples = sums.poses;
    row.precision = sums.mean(sums.precision);
    row.recall = sums.mean(sums.recall);
    row.closed = sums.share(sums.closed);
    row.thin = sums.share(sums.thin);
}

/// Extracted edges are pixels of the object.
quality::ContourSide contour_side(AcceleratorConfig const& config) {
    return config.flow == Flow::fpga_grip ? quality::ContourSide::inside : quality::side_of(config.edge_map.algorithm);
}

/// Each for itself: they are done side by side, and each has a time limit.
void require_feasible(LoadedConfig const& loaded, Stimulus const& stimulus) {
    WorkSize size =
        size_of_run(loaded.config, machine_of(loaded.config), stimulus.samples.size(), loop_iterations(stimulus));
    size.command = "compare-architectures";
    require_memory(size);
    require_time(size);
}

report::ArchitectureRow measured(Point const& point, CompareArchitecturesRequest const& request) {
    auto const judged_samples = static_cast<std::size_t>(request.judged_samples);
    LoadedConfig loaded = point.loaded;
    Stimulus const stimulus = load_stimulus(loaded);
    if (point.says_warnings)
        say_warnings(stimulus_warnings(stimulus, workload_of(loaded.config)));
    if (!request.force)
        require_feasible(loaded, stimulus);
    AcceleratorConfig const& config = accelerator_of(loaded.config);
    EdgeMapJudge judge(stimulus, contour_side(config), judged_samples);
    report::ArchitectureRow row = report::architecture_row(
        simulate(config, stimulus, loaded.config.simulation.engine, {}, judged_samples > 0 ? &judge : nullptr));
    set_quality(judge.sums(), row);
    return row;
}

/// A row as text, or what is wrong with the input: some of it shows only while the workload is built.
std::string simulate_point(Point const& point, CompareArchitecturesRequest const& request) {
    try {
        return std::string(1, row_mark) + to_text(measured(point, request));
    } catch (InputError const& error) {
        return std::string(1, error_mark) + error.what();
    }
}

std::vector<processes::Outcome> simulate_all(std::vector<Point> const& points,
                                             CompareArchitecturesRequest const& request) {
    double const limit_s = request.force ? forced_time_limit_s : time_limit_s;
    std::vector<processes::Task> tasks;
    tasks.reserve(points.size());
    for (Point const& point : points)
        tasks.push_back({[&point, &request] { return simulate_point(point, request); }, limit_s});
    processes::SignalWatch const watch;
    ProgressLine progress("simulations");
    return processes::run_all(tasks, static_cast<std::size_t>(request.jobs), watch,
                              [&progress](std::size_t done, std::size_t all) { progress.show(done, all); });
}

report::ArchitectureRow row_of(Point const& point, processes::Outcome const& outcome) {
    if (outcome.output.front() == error_mark)
        throw InputError(outcome.output.substr(1));
    report::ArchitectureRow row = report::row_from_text(outcome.output.substr(1));
    row.architecture = point.architecture;
    row.workload = point.workload;
    return row;
}

/// Runs every architecture on every workload, each in a process of its own, and prints a table. The keys an
/// architecture's file sets win over the workload's. Throws InputError on bad input. Exit code 1 if a simulation
/// crashed.
int compare_architectures(CompareArchitecturesRequest const& request) {
    CommandPaths paths;
    for (std::string const& workload : request.workloads)
        paths.reads(workload);
    for (std::string const& architecture : request.architectures)
        paths.reads(architecture);
    paths.writes("--csv", request.csv);
    paths.writes("--html", request.html);
    auto const csv = io::optional_output_file(request.csv);
    auto const html = io::optional_output_file(request.html);
    std::vector<Point> const points = points_of(request);
    std::vector<processes::Outcome> const outcomes = simulate_all(points, request);
    std::vector<report::ArchitectureRow> rows;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (outcomes[i].kind != processes::Outcome::Kind::done) {
            warn("faster-sim: {} on {}: the simulation crashed, failed or took too long\n", points[i].architecture,
                 points[i].workload);
            return exit_failed_check;
        }
        rows.push_back(row_of(points[i], outcomes[i]));
    }
    if (csv)
        csv->commit(report::architecture_csv(rows));
    if (html)
        html->commit(report::architectures_html("Architectures side by side", rows));
    say("{}", report::architecture_markdown(rows));
    for (std::string const& file : {request.csv, request.html})
        if (!file.empty())
            say("\nwritten: {}\n", file);
    return exit_done;
}

}  // namespace

Subcommand compare_architectures_command() {
    return {"compare-architectures", "Run several architectures on several workloads, side by side",
            [](CLI::App& command) {
                auto const request = std::make_shared<CompareArchitecturesRequest>();
                command
                    .add_option("architectures", request->architectures,
                                "Presets (accelerator.architecture), or files that say what an architecture changes; "
                                "the first is 1. None: all presets")
                    ->type_name("NAME|FILE");
                command
                    .add_option("--workloads", request->workloads,
                                "Configurations to run them on, e.g. configs/banana.yaml")
                    ->required()
                    ->type_name("CONFIG");
                add_overrides(command, request->overrides);
                add_jobs(command, request->jobs, "Simulations at once");
                add_force(command, request->force);
                command
                    .add_option("--quality", request->judged_samples,
                                "Judge the edge maps of the first N samples of each run")
                    ->type_name("N")
                    ->check(CLI::Range(1, 1000000));
                command.add_option("--csv", request->csv, "Write a row per architecture and workload to this file")
                    ->type_name("FILE");
                command.add_option("--html", request->html, "Write the table and its plots as one HTML page")
                    ->type_name("FILE");
                return [request] { return compare_architectures(*request); };
            }};
}

}  // namespace faster
