#include "dataflow/commands/waveform_size.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>

#include "dataflow/base/core_share.hpp"
#include "dataflow/base/files/hidden_name.hpp"
#include "dataflow/base/files/scratch.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/process_pool.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/tools/recording/waveform_file.hpp"

namespace dataflow {

namespace {

constexpr std::size_t samples_tried = 3;
constexpr double time_limit_s = 600;
constexpr double largest_bytes = 2e9;

/// What a waveform of some samples of the first core has shown.
struct Trial {
    Cycles cycles = 0;
    WaveformSize size;
    bool is_stuck = false;  ///< all cores end there
};

constexpr double surely_small_cycles = 100'000;  ///< of all cores: about 200 MB if all signals change in all of them

using recording::RecordingWindow;

/// Of the first core, and no more than are wanted.
std::size_t samples_to_try(Machine const& machine, RecordingWindow const& window, std::size_t samples) {
    std::size_t most = 1;
    for (std::size_t const core : window.cores)
        most = std::max(most, window.wanted_of(share_of(core, machine.cores, samples)).count);
    return std::min({samples_tried, most, share_of(0, machine.cores, samples).count});
}

bool is_surely_small(RecordingWindow const& window) {
    if (!window.to)
        return false;
    double const cycles = static_cast<double>(*window.to) - static_cast<double>(window.from) + 1;
    return cycles * static_cast<double>(window.cores.size()) <= surely_small_cycles;
}

Trial try_samples(RecordingRequest request, Machine const& machine, std::size_t samples,
                  SimulateDesign const& simulate) {
    Trial trial;
    request.vcd = request.vcd.empty() ? "" : "/dev/null";
    Recording recording;
    recording.window.cores = {0};
    recording.window.samples = recording::RecordingWindow::Samples{0, samples - 1};
    recording.done = [&](recording::RecordedWindow const& window) {
        std::optional<io::Scratch> scratch;
        if (!request.fst.empty())
            request.fst =
                scratch.emplace(std::filesystem::temp_directory_path() / "faster-sim.fst", io::Scratch::Kind::file)
                    .path();
        std::vector<double> const bytes = write_waveform_files(request, machine, window);
        trial.cycles = window.to() + 1 - window.from();
        trial.size.vcd_bytes = request.vcd.empty() ? 0 : bytes.front();
        trial.size.fst_bytes = request.fst.empty() ? 0 : bytes.back();
    };
    SimulationOptions options;
    options.at_any_size = true;
    options.most_samples = samples;
    options.recordings.push_back(recording);
    trial.is_stuck = simulate(options).deadlocked();
    return trial;
}

/// Of times, clock and number of the cycle, which all cores share: two lines for either half of a cycle, and one.
double bytes_of_clock(double cycles, Machine const& machine) {
    double const digits = std::floor(std::log10(std::max(1.0, cycles * recording::ticks_per_cycle(machine.clock_mhz))));
    double const bits = std::log2(std::max(2.0, cycles));
    return cycles * (2 * (digits + 6) + bits + 4);
}

/// What is recorded is so many times what the trial has, and takes so many times as long.
struct Scale {
    double samples = 0;
    double cycles = 0;
};

/// How many times the trial a core's window is. A window in cycles is as many of the trial's as the core, whose samples
/// take as long as those that were tried, has of it.
double times_of(Trial const& trial, RecordingWindow const& window, double wanted_samples, double tried_samples) {
    double const all = trial.is_stuck ? 1 : wanted_samples / tried_samples;
    auto const cycles = static_cast<double>(std::max<Cycles>(trial.cycles, 1));
    double const from = static_cast<double>(window.from) / cycles;
    double const to = window.to ? (static_cast<double>(*window.to) + 1) / cycles : all;
    return std::max(0.0, std::min(to, all) - from);
}

Scale scale_of(Trial const& trial, RecordingWindow const& window, Machine const& machine, std::size_t samples) {
    Scale scale;
    auto const tried = static_cast<double>(samples_to_try(machine, window, samples));
    for (std::size_t const core : window.cores) {
        auto const wanted = static_cast<double>(window.wanted_of(share_of(core, machine.cores, samples)).count);
        double const times = times_of(trial, window, wanted, tried);
        scale.samples += times;
        scale.cycles = std::max(scale.cycles, times);
    }
    return scale;
}

WaveformSize scaled(Trial const& trial, Scale const& scale, Machine const& machine) {
    auto const cycles = static_cast<double>(trial.cycles);
    double const changes = trial.size.vcd_bytes - bytes_of_clock(cycles, machine);
    WaveformSize size;
    if (trial.size.vcd_bytes > 0)
        size.vcd_bytes = changes * scale.samples + bytes_of_clock(cycles * scale.cycles, machine);
    size.fst_bytes = trial.size.fst_bytes * scale.samples;
    return size;
}

std::string text_of(double bytes) {
    if (bytes < 1e6)
        return fmt::format("{:.0f} kB", std::max(1.0, bytes / 1e3));
    return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9);
}

void require_small(char const* option, std::string const& file, double bytes) {
    if (bytes > largest_bytes)
        throw InputError(
            fmt::format("{} {}: would be about {}, expected at most {}: a smaller window (--vcd-samples, or "
                        "--vcd-from and --vcd-to), fewer --vcd-cores or --vcd-modules, or --force",
                        option, file, text_of(bytes), text_of(largest_bytes)));
}

}  // namespace

std::optional<WaveformSize> size_of_waveform(RecordingRequest const& request, Machine const& machine,
                                             std::size_t samples, SimulateDesign const& simulate) {
    if (samples == 0)
        return std::nullopt;
    RecordingWindow const window = waveform_window(request, machine, samples);
    if (is_surely_small(window))
        return std::nullopt;
    processes::Task task;
    task.time_limit_s = time_limit_s;
    task.work = [&] {
        Trial const trial = try_samples(request, machine, samples_to_try(machine, window, samples), simulate);
        return fmt::format("{} {} {} {}", trial.cycles, trial.size.vcd_bytes, trial.size.fst_bytes,
                           trial.is_stuck ? 1 : 0);
    };
    processes::SignalWatch const watch;
    processes::Outcome const outcome = processes::run_all({task}, 1, watch).front();
    Trial trial;
    std::istringstream words(outcome.output);
    if (!(words >> trial.cycles >> trial.size.vcd_bytes >> trial.size.fst_bytes >> trial.is_stuck))
        return std::nullopt;
    return scaled(trial, scale_of(trial, window, machine, samples), machine);
}

void announce_waveform(RecordingRequest const& request, Machine const& machine, std::size_t samples, bool force,
                       SimulateDesign const& simulate) {
    if (!request.has_waveform())
        return;
    std::optional<WaveformSize> const size = size_of_waveform(request, machine, samples, simulate);
    if (!size)
        return;
    if (!force) {
        require_small("--vcd", request.vcd, size->vcd_bytes);
        require_small("--fst", request.fst, size->fst_bytes);
    }
    if (!request.vcd.empty())
        say("{}: about {}\n", io::without_hidden_names(request.vcd).string(), text_of(size->vcd_bytes));
    if (!request.fst.empty())
        say("{}: about {}\n", io::without_hidden_names(request.fst).string(), text_of(size->fst_bytes));
    finish_saying();
}

}  // namespace dataflow
