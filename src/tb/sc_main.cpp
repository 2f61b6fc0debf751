#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <systemc>

#include "kernel/base/input_error.hpp"
#include "kernel/base/keep_memory.hpp"
#include "kernel/base/nearest_name.hpp"
#include "kernel/config/keys_as_markdown.hpp"
#include "tb/check_command.hpp"
#include "tb/compare_architectures_command.hpp"
#include "tb/compare_command.hpp"
#include "tb/edge_quality_command.hpp"
#include "tb/exit_codes.hpp"
#include "tb/grip_command.hpp"
#include "tb/run_command.hpp"
#include "tb/sensitivities_command.hpp"
#include "tb/show_command.hpp"
#include "tb/size_fifos_command.hpp"
#include "tb/sweep_command.hpp"
#include "tb/sweep_merge_command.hpp"
#include "tb/whatif_command.hpp"

namespace {

/// CLI::Range lets nan pass, and prints six digits of everything.
CLI::Validator number_in(double least, double most) {
    auto const check = [least, most](std::string const& text) {
        double number = 0;
        bool const is_sound = CLI::detail::lexical_cast(text, number) && number >= least && number <= most;
        return is_sound ? std::string{} : fmt::format("expected a number from {} to {}, found {}", least, most, text);
    };
    return CLI::Validator(check, fmt::format("NUMBER in [{} - {}]", least, most));
}

/// SystemC prints its banner before sc_main runs; a tool's output starts with its own.
bool const banner_is_off = setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1) == 0;

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
    command
        .add_option("--set", overrides, "Override a key of the configuration, e.g. accelerator.fifos.vertex.depth=16")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

void add_run(CLI::App& app, faster::RunRequest& request) {
    CLI::App& command = *app.add_subcommand("run", "Simulate a configuration and print its report");
    command.add_option("config", request.config, "Configuration file (YAML)")->required()->type_name("CONFIG");
    command.add_option("--out", request.out, "Write summary.json, samples.csv, fifos.csv and loops.csv to this folder")
        ->type_name("DIR");
    command.add_option("--trace", request.trace, "Replay a stimulus trace instead of the configured workload")
        ->type_name("DIR");
    command.add_option("--report", request.report, "Write the run as one HTML page")->type_name("FILE.html");
    command.add_option("--events", request.events, "Write what the run did, for whatif and sensitivities")
        ->type_name("FILE");
    command.add_flag("--critical-path", request.critical_path, "Trace along which operations the total comes about");
    command.add_flag("--sensitivities", request.sensitivities,
                     "Work out what one step of each timing key changes (retimes the run about 100 times)");
    command
        .add_option(
            "--images", request.images,
            "Write pictures of the first K samples to DIR/images and into the HTML report (needs --out or --report)")
        ->type_name("K")
        ->check(CLI::Range(0, 1000000));
    add_overrides(command, request.overrides);
    add_recording_options(command, request.recording);
}

void add_check_outputs(CLI::App& command, faster::CheckRequest& request) {
    command.add_option("--junit", request.junit, "Write the results in the JUnit format of CI services")
        ->type_name("FILE");
    command.add_option("--json", request.json, "Write the results, and all that moved, as JSON")->type_name("FILE");
}

void add_check(CLI::App& app, faster::CheckRequest& request) {
    CLI::App& command = *app.add_subcommand("check", "Check latency budgets: limits on the figures of runs");
    command.add_option("budgets", request.budgets, "Budget files (docs/budgets.md)")->type_name("BUDGET");
    add_check_outputs(command, request);
    command.add_option("-j,--jobs", request.jobs, "Simulations at once (the host's cores)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    command.add_option("--time-limit", request.time_limit_s, "Give up a simulation after this time (time_limit_s, 60)")
        ->type_name("SECONDS")
        ->check(number_in(0.001, 86400));
    add_overrides(command, request.overrides);
    command.add_flag("--update", request.update, "Take today's figures as the baselines (needs --reason)");
    command.add_option("--reason", request.reason, "Why the figures may move; kept in the file with date and hash")
        ->type_name("TEXT");
    command.add_option("--init", request.init, "Start a budget from a run of this configuration")->type_name("CONFIG");
    command.add_option("--trace", request.trace, "With --init: replay this stimulus trace")->type_name("DIR");
    command.add_option("--out", request.out, "With --init: where to (CONFIG's name .budget.yaml)")->type_name("FILE");
    command.footer(
        "Exit code 0: every limit is kept; 1: a limit is broken, or a run deadlocked, crashed or took too long;\n"
        "2: a budget is no good. --set shows what a change would cost; its paths are relative to the budget's folder.");
}

void add_record(CLI::App& app, faster::RecordRequest& request) {
    CLI::App& command = *app.add_subcommand("record", "Write a configuration's workload as a stimulus trace");
    command.add_option("config", request.config, "Configuration file (YAML)")->required()->type_name("CONFIG");
    command.add_option("--out", request.out, "Folder of the trace")->required()->type_name("DIR");
    add_overrides(command, request.overrides);
}

void add_compare(CLI::App& app, faster::CompareRequest& request) {
    CLI::App& command = *app.add_subcommand("compare", "Say what changed from one run to another, largest first");
    command.add_option("run_a", request.run_a, "Output folder of a run")->required()->type_name("RUN_A");
    command.add_option("run_b", request.run_b, "Output folder of another run")->required()->type_name("RUN_B");
    command.add_option("--top", request.top, "Rows of each list; the others are counted")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(0, 1000000));
    command.add_option("--json", request.json, "Write the whole comparison to this file")->type_name("FILE");
}

void add_compare_architectures(CLI::App& app, faster::CompareArchitecturesRequest& request) {
    CLI::App& command =
        *app.add_subcommand("compare-architectures", "Run several architectures on several workloads, side by side");
    command
        .add_option("architectures", request.architectures,
                    "Presets (accelerator.architecture), or files that say what an architecture changes; the first is "
                    "1. None: all presets")
        ->type_name("NAME|FILE");
    command.add_option("--workloads", request.workloads, "Configurations to run them on, e.g. configs/banana.yaml")
        ->required()
        ->type_name("CONFIG");
    add_overrides(command, request.overrides);
    command.add_option("-j,--jobs", request.jobs, "Simulations at once (the host's cores)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    command.add_option("--quality", request.judged_samples, "Judge the edge maps of the first N samples of each run")
        ->type_name("N")
        ->check(CLI::Range(1, 1000000));
    command.add_option("--csv", request.csv, "Write a row per architecture and workload to this file")
        ->type_name("FILE");
    command.add_option("--html", request.html, "Write the table and its plots as one HTML page")->type_name("FILE");
}

void add_edge_quality(CLI::App& app, faster::EdgeQualityRequest& request) {
    CLI::App& command = *app.add_subcommand(
        "edge-quality", "Judge the edge maps of the algorithms by the exact contours of many random poses");
    command.add_option("--poses", request.poses, "Poses per class")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 100000));
    command.add_option("--seed", request.seed, "Seed of the poses")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    command.add_option("--classes", request.classes, "Built-in objects, with commas between (all)")
        ->type_name("NAMES")
        ->delimiter(',');
    command.add_option("--algorithms", request.algorithms, "Of accelerator.edge_map.algorithm, likewise (all)")
        ->type_name("NAMES")
        ->delimiter(',');
    command
        .add_option("--out", request.out, "Write quality.csv and pictures of the best and worst poses to this folder")
        ->type_name("DIR");
}

void add_grip(CLI::App& app, faster::GripRequest& request) {
    CLI::App& command = *app.add_subcommand("grip",
                                            "Score the poses by the thesis's CPU and GPU baseline, untimed, and "
                                            "compare the ranking with the configured design's");
    command.add_option("config", request.config, "Configuration file (YAML)")->required()->type_name("CONFIG");
    command.add_option("--out", request.out, "Write scores.csv and summary.json to this folder")->type_name("DIR");
    add_overrides(command, request.overrides);
    command.add_option("-j,--jobs", request.jobs, "Threads (the host's cores)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    command.add_option("--inlier-distance", request.inlier_distance_m, "Points closer than this agree (eq. 2.1)")
        ->type_name("METRES")
        ->capture_default_str()
        ->check(number_in(0.000001, 10));
}

void add_show(CLI::App& app, faster::ShowRequest& request) {
    CLI::App& command = *app.add_subcommand("show", "Print a small picture of one sample of an older run");
    command.add_option("folder", request.folder, "Results of faster-sim run --out DIR --images K")
        ->required()
        ->type_name("DIR");
    command.add_option("--sample", request.sample, "Index of the sample (0)")
        ->type_name("N")
        ->check(CLI::Range(0, 1000000));
    command.add_flag("--depth", request.depth, "The depth buffer instead of edge and object map");
    command.add_option("--width", request.width, "Columns at most (those of the terminal, else 80)")
        ->type_name("N")
        ->check(CLI::Range(10, 1000));
}

void add_whatif(CLI::App& app, faster::WhatifRequest& request) {
    CLI::App& command =
        *app.add_subcommand("whatif", "Say how long a recorded run would take with other timing, without running it");
    command.add_option("events", request.events, "Event file of faster-sim run --events")
        ->required()
        ->type_name("EVENTS");
    add_overrides(command, request.overrides);
    CLI::Option* const out = command.add_option("--out", request.out, "Write the files of faster-sim run --out");
    out->type_name("DIR");
    command
        .add_option("--matrix", request.matrix,
                    "A row for each configuration of this file: a YAML list of maps from keys to values")
        ->type_name("FILE")
        ->excludes(out);
    command.add_option("--csv", request.csv, "Write the rows of --matrix to this file")
        ->type_name("FILE")
        ->needs("--matrix");
    command.add_option("--top", request.top, "Rows of each list of the comparison; the others are counted")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(0, 1000000));
}

void add_sensitivities(CLI::App& app, faster::SensitivitiesRequest& request) {
    CLI::App& command = *app.add_subcommand(
        "sensitivities", "Say what one step of each timing key changes for a recorded run, and which have slack");
    command.add_option("events", request.events, "Event file of faster-sim run --events")
        ->required()
        ->type_name("EVENTS");
    command.add_option("--csv", request.csv, "Write a row per key and direction to this file")->type_name("FILE");
    command.add_option("--json", request.json, "Write the same as JSON to this file")->type_name("FILE");
}

void add_sweep_merge(CLI::App& sweep, faster::SweepMergeRequest& request) {
    CLI::App& command = *sweep.add_subcommand("merge", "Join the folders of a sweep's shards");
    command.add_option("folders", request.folders, "Output folders of the shards")->required()->type_name("DIR");
    command.add_option("--out", request.out, "Folder of the whole sweep")->required()->type_name("DIR");
}

void add_sweep(CLI::App& app, faster::SweepRequest& request, faster::SweepMergeRequest& merge) {
    CLI::App& command = *app.add_subcommand(
        "sweep",
        "Run a configuration in many variants, or merge what several hosts did; goes on where it was (docs/sweeps.md)");
    command.add_option("sweep", request.sweep, "Sweep file (YAML); required, but for merge")->type_name("SWEEP");
    command.add_option("--out", request.out, "Folder of the results; required")->type_name("DIR");
    command.add_option("-j,--jobs", request.jobs, "Processes at once (the host's cores)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    command.add_option("--shard", request.shard, "Only part I of N parts of the same size; join them with sweep merge")
        ->type_name("I/N");
    command.add_option("--time-limit", request.time_limit_s, "Give up a point after this time (86400)")
        ->type_name("SECONDS")
        ->check(number_in(0.001, 1e9));
    command.add_flag("--retry-failed", request.retry_failed, "Do points that failed before again");
    command.add_flag("--keep-events", request.keep_events, "Keep the event files, in case points are added later");
    add_sweep_merge(command, merge);
}

void add_size_fifos(CLI::App& app, faster::SizeFifosRequest& request) {
    CLI::App& command = *app.add_subcommand(
        "size-fifos",
        "Find the cheapest FIFO depths with which a recorded run takes hardly longer than with unbounded ones");
    command.add_option("events", request.events, "Event file of faster-sim run --events")
        ->required()
        ->type_name("EVENTS");
    command.add_option("--within", request.within_percent, "How much longer than with unbounded FIFOs, in per cent")
        ->required()
        ->type_name("PERCENT")
        ->check(number_in(0, 1e6));
    command
        .add_option("--out", request.out, "Write depths.yaml, sizing.json, pareto.csv and sizing.html to this folder")
        ->type_name("DIR");
    command.add_option("--ramb36-luts", request.luts_per_ramb36, "LUTs that a block RAM of 36 Kbit is worth (300.53)")
        ->type_name("LUTS")
        ->check(number_in(0.01, 1e6));
    command.add_option("--points", request.front_points, "Bounds at which cost is weighed against cycles; 0: none")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(0, 1000));
    command.add_option("-j,--jobs", request.jobs, "Threads (the host's cores)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    add_overrides(command, request.overrides);
    command.footer("Only depths are searched; kinds stay as configured, auto being a memory above depth 2.");
}

int one_line_error(std::string text) {
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    fmt::print(stderr, "faster-sim: {}\n", text);
    return faster::exit_bad_input;
}

/// The parser would only say that some subcommand is missing.
std::string unknown_subcommand(int argc, char** argv) {
    std::vector<std::string> const known{
        "run",   "check",        "record", "whatif", "sensitivities", "size-fifos", "compare", "compare-architectures",
        "sweep", "edge-quality", "grip",   "show",   "keys"};
    std::string const given = argc > 1 ? argv[1] : "";
    if (given.empty() || given.front() == '-' || std::find(known.begin(), known.end(), given) != known.end())
        return "";
    return fmt::format("unknown command {}, expected one of {}{}", given, fmt::join(known, ", "),
                       faster::did_you_mean(given, known));
}

int run_tool(int argc, char** argv) {
    if (std::string const error = unknown_subcommand(argc, argv); !error.empty())
        return one_line_error(error);
    CLI::App app{"Cycle-approximate model of the FASTER pose-scoring accelerator", "faster-sim"};
    app.set_version_flag("--version", FASTER_VERSION);
    app.require_subcommand(1);
    faster::RunRequest run_request;
    faster::RecordRequest record_request;
    faster::CompareRequest compare_request;
    add_run(app, run_request);
    faster::CheckRequest check_request;
    add_check(app, check_request);
    add_record(app, record_request);
    add_compare(app, compare_request);
    faster::CompareArchitecturesRequest architectures_request;
    add_compare_architectures(app, architectures_request);
    faster::EdgeQualityRequest edge_quality_request;
    add_edge_quality(app, edge_quality_request);
    faster::GripRequest grip_request;
    add_grip(app, grip_request);
    faster::WhatifRequest whatif_request;
    add_whatif(app, whatif_request);
    faster::SensitivitiesRequest sensitivities_request;
    add_sensitivities(app, sensitivities_request);
    faster::SizeFifosRequest size_fifos_request;
    add_size_fifos(app, size_fifos_request);
    faster::SweepRequest sweep_request;
    faster::SweepMergeRequest sweep_merge_request;
    add_sweep(app, sweep_request, sweep_merge_request);
    faster::ShowRequest show_request;
    add_show(app, show_request);
    app.add_subcommand("keys", "Print every configuration key with meaning, unit, range and default (Markdown)");
    try {
        app.parse(argc, argv);
    } catch (CLI::ParseError const& error) {
        if (error.get_exit_code() == 0)
            return app.exit(error);  // --help, --version
        return one_line_error(std::string(error.what()) + " (see faster-sim --help)");
    }
    if (app.got_subcommand("keys")) {
        fmt::print("{}", faster::keys_as_markdown());
        return faster::exit_done;
    }
    if (app.got_subcommand("record"))
        return record(record_request);
    if (app.got_subcommand("whatif"))
        return whatif(whatif_request);
    if (app.got_subcommand("sensitivities"))
        return print_sensitivities(sensitivities_request);
    if (app.got_subcommand("size-fifos"))
        return print_fifo_sizes(size_fifos_request);
    if (app.got_subcommand("sweep") && app.get_subcommand("sweep")->got_subcommand("merge"))
        return merge_sweeps(sweep_merge_request);
    if (app.got_subcommand("sweep") && (sweep_request.sweep.empty() || sweep_request.out.empty()))
        return one_line_error("sweep: expected a sweep file and --out DIR (see faster-sim sweep --help)");
    if (app.got_subcommand("sweep"))
        return sweep(sweep_request);
    if (app.got_subcommand("compare"))
        return compare(compare_request);
    if (app.got_subcommand("compare-architectures"))
        return compare_architectures(architectures_request);
    if (app.got_subcommand("edge-quality"))
        return edge_quality(edge_quality_request);
    if (app.got_subcommand("grip"))
        return grip_baseline(grip_request);
    if (app.got_subcommand("check"))
        return check(check_request);
    if (app.got_subcommand("show"))
        return show(show_request);
    if (run_request.images > 0 && run_request.out.empty() && run_request.report.empty())
        return one_line_error("--images " + std::to_string(run_request.images) +
                              ": expected --out DIR or --report FILE as well");
    return run(run_request);
}

}  // namespace

int sc_main(int argc, char** argv) {
    faster::keep_freed_memory();
    try {
        return run_tool(argc, argv);
    } catch (faster::InputError const& error) {
        return one_line_error(error.what());
    } catch (std::exception const& error) {
        return one_line_error(std::string("unexpected error: ") + error.what());
    }
}
