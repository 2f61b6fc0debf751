#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "faster/config/adopt_trace.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/workload_source.hpp"
#include "modules/core/faster_simulation.hpp"
#include "modules/core/workload_iterations.hpp"
#include "tb/commands.hpp"
#include "tb/cosim/comparison.hpp"

namespace faster {

namespace {

/// `cosim`.
struct CosimRequest {
    std::string trace;                        ///< folder
    std::string config;                       ///< file; empty: defaults
    std::vector<std::string> overrides;       ///< of model and twin
    std::vector<std::string> twin_overrides;  ///< of the twin alone, to see a difference found
    std::string out = ".";                    ///< folder for the waveforms of a difference
    std::int64_t core = -1;                   ///< -1: all
    bool no_forwarding = false;               ///< see TwinSettings
    bool force = false;                       ///< however long it takes
};

LoadedConfig config_of(CosimRequest const& request, std::vector<std::string> const& more) {
    std::vector<std::filesystem::path> files;
    if (!request.config.empty())
        files.emplace_back(request.config);
    std::vector<std::string> overrides = request.overrides;
    overrides.insert(overrides.end(), more.begin(), more.end());
    overrides.push_back(setting_of_trace(request.trace, overrides));
    return layered_config(files, overrides);
}

/// What the twin's tokens cannot say.
void require_near_windows(Stimulus const& stimulus, std::string const& trace) {
    for (std::size_t i = 0; i < stimulus.samples.size(); ++i)
        for (std::int32_t const centre : {stimulus.samples[i].centre_row, stimulus.samples[i].centre_col})
            if (stimulus.near_window_offset(centre) != stimulus.window_offset(centre))
                throw InputError(
                    fmt::format("{}/samples.csv: sample {} has its centre at {} px, expected its window to begin "
                                "within {} px of the image for a comparison with the twin",
                                trace, i, centre, Stimulus::furthest_window));
}

rtl::TwinSettings settings_of(CosimRequest const& request) {
    LoadedConfig loaded = config_of(request, request.twin_overrides);
    Stimulus const stimulus = load_stimulus(loaded);
    require_near_windows(stimulus, request.trace);
    rtl::TwinSettings settings =
        rtl::twin_settings(accelerator_of(loaded.config), machine_of(loaded.config), stimulus.width, stimulus.height);
    settings.forwards = !request.no_forwarding;
    return settings;
}

/// Recording and twin, of one core or of all.
WorkSize size_of_comparison(Stimulus const& stimulus, std::size_t samples) {
    constexpr double iterations_per_s = 0.6e6;                                           // measured with the main job
    constexpr double bytes_of_pixel = 2 * sizeof(std::uint8_t) + sizeof(std::uint16_t);  // in KeptMaps, of all samples
    LoopIterations const iterations = loop_iterations(stimulus);
    double const compared = iterations.all() * static_cast<double>(samples) /
                            static_cast<double>(std::max(stimulus.samples.size(), std::size_t{1}));
    WorkSize size;
    size.command = "cosim";
    size.amount = fmt::format("{} samples, about {:.2g} loop iterations", samples, compared);
    size.seconds = compared / iterations_per_s;
    size.bytes = bytes_of_pixel * static_cast<double>(stimulus.window) * static_cast<double>(stimulus.window) *
                 static_cast<double>(stimulus.samples.size());
    return size;
}

/// Of cycles around the difference. Returns the names of both files.
std::string write_waveforms(std::filesystem::path const& folder, recording::RecordedCore const& core,
                            rtl::Difference const& difference) {
    std::filesystem::create_directories(folder);
    auto const write = [&](char const* side, rtl::RecentTokens const& tokens) {
        std::filesystem::path const file = folder / fmt::format("cosim_core_{}_{}.vcd", core.core, side);
        tokens.write_vcd(file, core, difference.from, difference.to);
        return file.lexically_normal().string();
    };
    std::string const model = write("model", difference.model);
    return model + ", " + write("twin", difference.twin);
}

/// True if nothing differs.
bool tell(recording::RecordedCore const& recorded, rtl::Compared const& compared, std::filesystem::path const& folder) {
    std::size_t const core = recorded.core;
    if (!compared.difference) {
        say("core {}: no difference in {} cycles: {} writes with their tokens, {} reads, {} maps; twin {:.2f} s, "
            "{:.0f} "
            "kHz\n",
            core, compared.cycles, compared.writes, compared.reads, compared.maps, compared.twin_seconds,
            static_cast<double>(compared.cycles) / compared.twin_seconds / 1e3);
        return true;
    }
    say("core {}, cycle {}: {}\n", core, compared.difference->cycle, compared.difference->what);
    for (std::string const& line : compared.difference->history)
        say("  {}\n", line);
    say("  waveforms of cycles {} to {}: {}\n", compared.difference->from, compared.difference->to,
        write_waveforms(folder, recorded, *compared.difference));
    return false;
}

/// Returns the exit code, 1 if model and twin differ; throws InputError on bad input.
int cosim(CosimRequest const& request) {
    if (!rtl::has_twin())
        throw InputError("cosim: expected a program built with Verilator (scripts/setup.sh --dev, then CMake again)");
    rtl::TwinSettings const settings = settings_of(request);
    LoadedConfig loaded = config_of(request, {});
    Stimulus const stimulus = load_stimulus(loaded);
    AcceleratorConfig const& config = accelerator_of(loaded.config);
    if (request.core >= 0 && static_cast<std::uint64_t>(request.core) >= config.cores)
        throw InputError(fmt::format("--core {}: expected 0 to {}", request.core, config.cores - 1));
    std::size_t const samples = stimulus.samples.size();
    if (samples == 0) {
        say("{}: no samples, nothing was compared\n", request.trace);
        return exit_done;
    }
    announce(
        size_of_comparison(
            stimulus,
            request.core < 0 ? samples : share_of(static_cast<std::size_t>(request.core), config.cores, samples).count),
        request.force);
    KeptMaps maps;
    bool is_same = true;
    SimulationOptions options;
    Recording recording;
    if (request.core >= 0)
        recording.window.cores = {static_cast<std::size_t>(request.core)};
    recording.done = [&](recording::RecordedWindow const& window) {
        for (recording::RecordedCore const& core : window.cores) {
            CoreShare const share = share_of(core.core, config.cores, samples);
            ProgressLine line("cycles compared");
            auto const compared = rtl::compare(core, maps, settings, stimulus, share,
                                               [&](Cycles done) { line.show(done, std::max(done, core.to)); });
            is_same = tell(core, compared, request.out) && is_same;
        }
    };
    options.recordings.push_back(recording);
    simulate(config, stimulus, Engine::decoupled, options, &maps);
    return is_same ? exit_done : exit_failed_check;
}

}  // namespace

Subcommand cosim_command() {
    return {
        "cosim", "Compare the model, cycle by cycle, with its register-transfer twin", [](CLI::App& command) {
            auto const request = std::make_shared<CosimRequest>();
            command.add_option("trace", request->trace, "Folder of the stimulus trace")->required()->type_name("TRACE");
            command.add_option("--config", request->config, "Configuration file (YAML)")->type_name("CONFIG");
            add_overrides(command, request->overrides);
            repeats(*command
                         .add_option("--twin-set", request->twin_overrides,
                                     "Override a key for the twin alone, to see the difference found; may be repeated")
                         ->type_name("KEY=VALUE"));
            command.add_option("--core", request->core, "Compare this core only")
                ->type_name("N")
                ->check(integer_in(0, 1000000));
            command.add_option("--out", request->out, "Folder for the waveforms of a difference")
                ->type_name("DIR")
                ->capture_default_str();
            command.add_flag("--no-forwarding", request->no_forwarding,
                             "The twin reads stale words of its memories, as hardware does without forwarding");
            add_force(command, request->force);
            return [request] { return cosim(*request); };
        }};
}

}  // namespace faster
