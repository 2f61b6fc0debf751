#include "tb/compare_architectures_command.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>

#include "common/input_error.hpp"
#include "config/keys.hpp"
#include "config/load_config.hpp"
#include "io/output_file.hpp"
#include "processes/process_pool.hpp"
#include "report/architecture_table.hpp"
#include "simulation/simulate.hpp"
#include "tb/progress_line.hpp"
#include "tb/run_command.hpp"
#include "tb/workload_source.hpp"

namespace faster {

namespace {

constexpr double time_limit_s = 3600;

/// One simulation to do.
struct Point {
    std::string architecture;  ///< names for the table
    std::string workload;
    LoadedConfig loaded;
};

std::string name_of(std::string const& file) { return std::filesystem::path(file).stem().string(); }

/// What an architecture's file sets, as settings for the command line. Checked like any configuration.
std::vector<std::string> settings_of(std::string const& file) {
    LoadedConfig const loaded = load_config(file);
    std::vector<std::string> settings;
    for (Key const& key : all_keys()) {
        if (!loaded.origins.is_explicit(key.name()))
            continue;
        if (key.name().rfind("accelerator.", 0) != 0)
            throw InputError(fmt::format("{}: {}, expected keys of accelerator only: an architecture has no workload",
                                         loaded.origins.of(key.name()).place, key.name()));
        KeyValue const value = key.read(loaded.config);
        auto const* const text = std::get_if<std::string>(&value);
        settings.push_back(key.name() + "=" + (text != nullptr ? *text : json_text(value)));
    }
    return settings;
}

std::vector<Point> points_of(CompareArchitecturesRequest const& request) {
    std::vector<Point> points;
    for (std::string const& architecture : request.architectures) {
        std::vector<std::string> settings = settings_of(architecture);
        settings.insert(settings.end(), request.overrides.begin(), request.overrides.end());
        for (std::string const& workload : request.workloads)
            points.push_back({name_of(architecture), name_of(workload), load_config(workload, settings)});
    }
    return points;
}

std::string simulate_point(Point const& point) {
    LoadedConfig loaded = point.loaded;
    Stimulus const stimulus = load_stimulus(loaded);
    AcceleratorConfig const& config = loaded.config.accelerator;
    return to_text(report::architecture_row(config, simulate(config, stimulus, loaded.config.simulation.engine)));
}

std::vector<processes::Outcome> simulate_all(std::vector<Point> const& points, std::int64_t jobs) {
    std::vector<processes::Task> tasks;
    tasks.reserve(points.size());
    for (Point const& point : points)
        tasks.push_back({[&point] { return simulate_point(point); }, time_limit_s});
    processes::SignalWatch const watch;
    ProgressLine progress("simulations");
    return processes::run_all(tasks, static_cast<std::size_t>(jobs), watch,
                              [&progress](std::size_t done, std::size_t all) { progress.show(done, all); });
}

report::ArchitectureRow row_of(Point const& point, processes::Outcome const& outcome) {
    report::ArchitectureRow row = report::row_from_text(outcome.output);
    row.architecture = point.architecture;
    row.workload = point.workload;
    return row;
}

}  // namespace

int compare_architectures(CompareArchitecturesRequest const& request) {
    auto const csv = io::optional_output_file(request.csv);
    std::vector<Point> const points = points_of(request);
    std::vector<processes::Outcome> const outcomes = simulate_all(points, request.jobs);
    std::vector<report::ArchitectureRow> rows;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (outcomes[i].kind != processes::Outcome::Kind::done) {
            fmt::print(stderr, "faster-sim: {} on {}: the simulation crashed, failed or took more than an hour\n",
                       points[i].architecture, points[i].workload);
            return exit_failed_check;
        }
        rows.push_back(row_of(points[i], outcomes[i]));
    }
    if (csv)
        csv->commit(report::architecture_csv(rows));
    fmt::print("{}", report::architecture_markdown(rows));
    if (csv)
        fmt::print("\nwritten: {}\n", request.csv);
    return exit_done;
}

}  // namespace faster
