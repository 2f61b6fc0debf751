#include "tool/recording_options.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <fmt/format.h>

#include "kernel/base/files/output_file.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/machine/core_share.hpp"
#include "kernel/recording/gtkwave_save.hpp"
#include "kernel/recording/timeline_json.hpp"
#include "kernel/recording/vcd_trace.hpp"

namespace faster {

namespace {

using recording::RecordingWindow;

/// "5" or "5-7".
RecordingWindow::Samples parse_range(char const* option, std::string const& text, std::size_t end) {
    RecordingWindow::Samples range;
    char const* const last = text.data() + text.size();
    auto [at, error] = std::from_chars(text.data(), last, range.first);
    range.last = range.first;
    bool good = error == std::errc{};
    if (good && at != last) {
        good = *at == '-';
        auto const second = std::from_chars(at + 1, last, range.last);
        good = good && second.ec == std::errc{} && second.ptr == last;
    }
    if (!good || range.first > range.last || range.last >= end)
        throw InputError(end == 0 ? fmt::format("{} {}: the run has none", option, text)
                                  : fmt::format("{} {}: expected a number or a range such as 5-7, within 0-{}", option,
                                                text, end - 1));
    return range;
}

std::vector<std::size_t> parse_cores(std::string const& text, std::size_t count) {
    std::vector<std::size_t> cores;
    for (std::size_t begin = 0; begin <= text.size();) {
        std::size_t const end = std::min(text.find(',', begin), text.size());
        auto const range = parse_range("--vcd-cores", text.substr(begin, end - begin), count);
        for (std::size_t core = range.first; core <= range.last; ++core)
            cores.push_back(core);
        begin = end + 1;
    }
    return cores;
}

RecordingWindow vcd_window(RecordingRequest const& request, Machine const& machine, std::size_t samples) {
    RecordingWindow window;
    if (!request.vcd_cores.empty())
        window.cores = parse_cores(request.vcd_cores, machine.cores);
    if (!request.vcd_samples.empty()) {
        if (request.vcd_from || request.vcd_to)
            throw InputError("--vcd-samples: expected it without --vcd-from and --vcd-to");
        window.samples = parse_range("--vcd-samples", request.vcd_samples, samples);
    }
    window.from = request.vcd_from.value_or(0);
    window.to = request.vcd_to;
    if (window.to && *window.to < window.from)
        throw InputError(
            fmt::format("--vcd-to {}: expected a cycle not before --vcd-from {}", *window.to, window.from));
    return window;
}

/// Before the work whose results would be lost.
void require_writable(std::string const& file) {
    if (!io::is_device(file))
        io::OutputFile const probe(file);
}

/// The first samples of every core, as far as they go.
std::vector<Recording> timeline_recordings(RecordingRequest const& request, Machine const& machine, std::size_t samples,
                                           std::shared_ptr<std::vector<recording::CoreTimeline>> const& timelines) {
    std::vector<Recording> recordings;
    for (std::size_t core = 0; core < machine.cores; ++core) {
        CoreShare const share = share_of(core, machine.cores, samples);
        if (share.count == 0)
            continue;
        Recording recording;
        recording.window.cores = {core};
        std::size_t const count = std::min(share.count, static_cast<std::size_t>(request.timeline_samples));
        recording.window.samples = RecordingWindow::Samples{share.first, share.first + count - 1};
        recording.done = [timelines](std::vector<recording::RecordedCore> const& cores) {
            for (recording::RecordedCore const& recorded : cores)
                timelines->push_back(recording::make_timeline(recorded, {}));
        };
        recordings.push_back(std::move(recording));
    }
    return recordings;
}

}  // namespace

void add_recording_options(CLI::App& command, RecordingRequest& request) {
    std::string const vcd = "Waveforms";
    command.add_option("--vcd", request.vcd, "Write a value change dump, and a GTKWave save file beside it")
        ->type_name("FILE")
        ->group(vcd);
    auto const for_vcd = [&](CLI::Option* option, char const* type) {
        option->type_name(type)->group(vcd)->needs("--vcd");
    };
    for_vcd(command.add_option("--vcd-cores", request.vcd_cores, "Only these cores, e.g. 0,2-4"), "LIST");
    for_vcd(
        command
            .add_option("--vcd-modules", request.vcd_modules,
                        "Only modules, FIFOs and block RAMs whose name matches, e.g. '*_token'; a module's FIFOs and "
                        "block RAMs come with it")
            ->delimiter(','),
        "GLOB,...");
    for_vcd(command.add_option("--vcd-samples", request.vcd_samples, "Only these samples, e.g. 5 or 5-7"), "RANGE");
    for_vcd(command.add_option("--vcd-from", request.vcd_from, "First cycle"), "CYCLE");
    for_vcd(command.add_option("--vcd-to", request.vcd_to, "Last cycle"), "CYCLE");
    command.add_option("--timeline", request.timeline, "Write a timeline for Perfetto or chrome://tracing (JSON)")
        ->type_name("FILE")
        ->group(vcd);
    command.add_option("--timeline-samples", request.timeline_samples, "Samples of each core in the timeline")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000000))
        ->group(vcd)
        ->needs("--timeline");
}

Recording sample_timeline_recording(Machine const& machine, std::size_t samples,
                                    std::vector<SampleTimeline>& timelines) {
    CoreShare const share = share_of(0, machine.cores, samples);
    std::size_t const sample = share.count > 1 ? 1 : 0;
    Recording recording;
    recording.window.cores = {0};
    recording.window.samples = RecordingWindow::Samples{sample, sample};
    recording.done = [&timelines, sample](std::vector<recording::RecordedCore> const& cores) {
        for (recording::RecordedCore const& core : cores)
            timelines.push_back(recording::sample_timeline(core, sample));
    };
    return recording;
}

void add_paths(RecordingRequest const& request, CommandPaths& paths) {
    paths.writes_vcd("--vcd", request.vcd);
    paths.writes("--timeline", request.timeline);
}

std::string written_files(RecordingRequest const& request) {
    std::vector<std::string> files;
    if (!request.timeline.empty())
        files.push_back(request.timeline);
    if (!request.vcd.empty())
        files.push_back(request.vcd);
    if (!request.vcd.empty() && !io::is_device(request.vcd))
        for (std::filesystem::path const& beside : recording::files_beside(request.vcd))
            files.push_back(beside.string());
    return fmt::format("{}", fmt::join(files, ", "));
}

std::vector<Recording> make_recordings(RecordingRequest const& request, Machine const& machine, std::size_t samples,
                                       PlaceOf const& place_of) {
    std::vector<Recording> recordings;
    if (!request.timeline.empty()) {
        require_writable(request.timeline);
        auto const timelines = std::make_shared<std::vector<recording::CoreTimeline>>();
        recordings = timeline_recordings(request, machine, samples, timelines);
        Recording last;  // after those of all cores
        last.window.samples = RecordingWindow::Samples{~std::size_t{0} - 1, ~std::size_t{0} - 1};
        last.done = [timelines, &request, &machine, place_of](std::vector<recording::RecordedCore> const&) {
            io::write_file_atomically(place_of(request.timeline),
                                      recording::timeline_json(*timelines, machine.clock_mhz));
        };
        recordings.push_back(std::move(last));
    }
    if (!request.vcd.empty()) {
        require_writable(request.vcd);
        Recording vcd;
        vcd.window = vcd_window(request, machine, samples);
        recording::SignalFilter const filter(request.vcd_modules, machine);
        vcd.done = [&request, &machine, filter, place_of](std::vector<recording::RecordedCore> const& cores) {
            recording::write_vcd(place_of(request.vcd), machine, cores, filter);
        };
        recordings.push_back(std::move(vcd));
    }
    return recordings;
}

}  // namespace faster
