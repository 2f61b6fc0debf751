#include "dataflow/commands/recording_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <memory>
#include <set>
#include <utility>

#include "dataflow/base/core_share.hpp"
#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/tools/recording/fst_file.hpp"
#include "dataflow/tools/recording/gtkwave_save.hpp"
#include "dataflow/tools/recording/thinned_timeline.hpp"
#include "dataflow/tools/recording/timeline_json.hpp"
#include "dataflow/tools/recording/vcd_file.hpp"
#include "dataflow/tools/recording/write_waveform.hpp"

namespace dataflow {

namespace {

using recording::RecordingWindow;
using recording::ValueNames;

/// "5" or "5-7".
RecordingWindow::Samples parse_range(char const* option, std::string const& text, std::size_t end,
                                     char const* expected = "a number or a range such as 5-7") {
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
                                  : fmt::format("{} {}: expected {}, within 0-{}", option, text, expected, end - 1));
    return range;
}

/// Before the work whose results would be lost. Pipes and devices are refused.
void require_regular(std::string const& file) {
    if (!file.empty())
        io::OutputFile const probe(file);
}

/// A file that can be written; pipes and devices are taken as they are.
void require_writable(std::string const& file) {
    if (!io::is_device(file))
        require_regular(file);
}

/// What a timeline may hold: about 100 MB of JSON.
constexpr std::size_t most_spans = 800'000;

/// What is known of a timeline when the run is over.
struct Timeline {
    std::vector<recording::CoreTimeline> cores;
    std::optional<recording::MemoryTimeline> memory;
    Cycles from = ~Cycles{0};  ///< first and last cycle of all cores
    Cycles to = 0;
};

/// The first samples of every core, as far as they go.
Recording timeline_recording(std::size_t core, CoreShare const& share, std::int64_t samples) {
    Recording recording;
    recording.window.cores = {core};
    std::size_t const count = std::min(share.count, static_cast<std::size_t>(samples));
    recording.window.samples = RecordingWindow::Samples{share.first, share.first + count - 1};
    return recording;
}

std::vector<Recording> timeline_recordings(RecordingRequest const& request, Machine const& machine, std::size_t samples,
                                           PlaceOf const& place_of) {
    require_regular(request.timeline);
    auto const timeline = std::make_shared<Timeline>();
    std::vector<Recording> recordings;
    for (std::size_t core = 0; core < machine.cores; ++core) {
        CoreShare const share = share_of(core, machine.cores, samples);
        if (share.count == 0)
            continue;
        recordings.push_back(timeline_recording(core, share, request.timeline_samples));
        recordings.back().done = [timeline, &machine](recording::RecordedWindow const& window) {
            std::size_t const most = most_spans / machine.cores;
            for (recording::RecordedCore const& recorded : window.cores)
                timeline->cores.push_back(recording::thinned(recording::make_timeline(recorded, {}), most));
            if (window.cores.empty())
                return;
            timeline->from = std::min(timeline->from, window.from());
            timeline->to = std::max(timeline->to, window.to());
        };
    }
    Recording last;  // after those of all cores
    last.window.samples = RecordingWindow::Samples{~std::size_t{0} - 1, ~std::size_t{0} - 1};
    last.done = [timeline, &request, &machine, place_of](recording::RecordedWindow const& window) {
        if (window.memory != nullptr)
            timeline->memory =
                recording::make_memory_timeline(*window.memory, timeline->from, timeline->to, most_spans / 4);
        io::write_file_atomically(place_of(request.timeline),
                                  recording::timeline_json(timeline->cores, timeline->memory, machine.clock_mhz));
    };
    recordings.push_back(std::move(last));
    return recordings;
}

/// Those that can have files beside them, the VCD last: its save file says what values mean to both.
std::vector<std::pair<std::filesystem::path, ValueNames>> waveforms_of(RecordingRequest const& request) {
    std::vector<std::pair<std::filesystem::path, ValueNames>> files;
    if (!request.fst.empty() && !io::is_device(request.fst))
        files.emplace_back(request.fst, ValueNames::in_waveform);
    if (!request.vcd.empty() && !io::is_device(request.vcd))
        files.emplace_back(request.vcd, ValueNames::in_tables);
    return files;
}

/// What values mean, as write_gtkwave_save() writes it beside a VCD.
std::vector<std::string> tables_beside(std::filesystem::path const& waveform) {
    std::string const begin = waveform.stem().string() + ".";
    std::vector<std::string> tables;
    for (auto const& entry : std::filesystem::directory_iterator(std::filesystem::absolute(waveform).parent_path())) {
        std::string const name = entry.path().filename().string();
        bool const is_named = name.rfind(begin, 0) == 0 && name.find('.', begin.size()) != std::string::npos;
        if (is_named && entry.path().extension() == ".txt")
            tables.push_back((waveform.parent_path() / name).string());
    }
    return tables;
}

RecordingRequest placed(RecordingRequest request, PlaceOf const& place_of) {
    for (std::string* const file : {&request.vcd, &request.fst})
        if (!file->empty())
            *file = place_of(*file).string();
    return request;
}

/// Both files hold the same, and are written at once.
Recording waveform_recording(RecordingRequest const& request, Machine const& machine, std::size_t samples,
                             PlaceOf const& place_of) {
    require_writable(request.vcd);
    require_regular(request.fst);
    Recording recording;
    recording.window = waveform_window(request, machine, samples);
    recording::SignalFilter const filter(request.vcd_modules, machine);
    recording.done = [&request, &machine, filter, place_of](recording::RecordedWindow const& window) {
        if (request.vcd_from && window.to() < *request.vcd_from)
            say_warnings(
                {fmt::format("--vcd-from {}: the run ends before, so the waveform is empty", *request.vcd_from)});
        RecordingRequest const files = placed(request, place_of);
        write_waveform_files(files, machine, window);
        for (auto const& [file, names] : waveforms_of(files))
            recording::write_gtkwave_save(file, names, machine, window, filter);
    };
    return recording;
}

}  // namespace

std::vector<std::size_t> parse_numbers(char const* option, std::string const& text, std::size_t end) {
    std::vector<std::size_t> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        std::size_t const comma = std::min(text.find(',', begin), text.size());
        auto const range =
            parse_range(option, text.substr(begin, comma - begin), end, "a number, or several such as 0,2-4");
        for (std::size_t number = range.first; number <= range.last; ++number)
            numbers.push_back(number);
        begin = comma + 1;
    }
    return numbers;
}

std::vector<std::size_t> cores_recorded(RecordingRequest const& request, Machine const& machine) {
    std::string const cores = request.vcd_cores.empty() ? fmt::format("0-{}", machine.cores - 1) : request.vcd_cores;
    return parse_numbers("--vcd-cores", cores, machine.cores);
}

/// A sample is in the waveform of the core that scores it.
void require_scoring_core(RecordingRequest const& request, RecordingWindow const& window, Machine const& machine,
                          std::size_t samples) {
    auto const scores = [&](std::size_t core) {
        return window.wanted_of(share_of(core, machine.cores, samples)).count > 0;
    };
    if (std::any_of(window.cores.begin(), window.cores.end(), scores))
        return;
    std::size_t core = 0;
    while (!scores(core))
        ++core;
    throw InputError(fmt::format("--vcd-cores {}: none of them scores what --vcd-samples {} asks for, expected core {}",
                                 request.vcd_cores, request.vcd_samples, core));
}

RecordingWindow waveform_window(RecordingRequest const& request, Machine const& machine, std::size_t samples) {
    RecordingWindow window;
    window.cores = cores_recorded(request, machine);
    if (!request.vcd_samples.empty()) {
        if (request.vcd_from || request.vcd_to)
            throw InputError("--vcd-samples: expected it without --vcd-from and --vcd-to");
        window.samples = parse_range("--vcd-samples", request.vcd_samples, samples);
        require_scoring_core(request, window, machine, samples);
    }
    window.from = request.vcd_from.value_or(0);
    window.to = request.vcd_to;
    if (window.to && *window.to < window.from)
        throw InputError(
            fmt::format("--vcd-to {}: expected a cycle not before --vcd-from {}", *window.to, window.from));
    return window;
}

std::vector<double> write_waveform_files(RecordingRequest const& request, Machine const& machine,
                                         recording::RecordedWindow const& window) {
    recording::WaveformFiles files;
    if (!request.vcd.empty())
        files.push_back(std::make_unique<recording::VcdFile>(request.vcd, machine.clock_mhz));
    if (!request.fst.empty())
        files.push_back(std::make_unique<recording::FstFile>(request.fst, machine.clock_mhz));
    ProgressLine progress("cycles of the waveform");
    recording::write_waveform(files, machine, window, recording::SignalFilter(request.vcd_modules, machine),
                              progress.teller());
    std::vector<double> bytes;
    for (auto const& file : files)
        bytes.push_back(static_cast<double>(file->bytes()));
    return bytes;
}

namespace {
/// Who opens a waveform goes by the ending of its name. `other`: the option that writes files with that one.
std::function<std::string(std::string const&)> no_file_of(char const* ending, char const* other) {
    return [ending, other](std::string const& file) {
        bool const is_of_other = std::filesystem::path(file).extension() == ending;
        return is_of_other ? fmt::format("{}, expected another ending than {}, which is for {}", file, ending, other)
                           : std::string();
    };
}
}  // namespace

void add_recording_options(CLI::App& command, RecordingRequest& request) {
    std::string const waveforms = "Waveforms";
    auto const for_vcd = [&](CLI::Option* option, char const* type) { option->type_name(type)->group(waveforms); };
    for_vcd(command.add_option("--vcd", request.vcd, "Write a value change dump, and a GTKWave save file beside it")
                ->check(no_file_of(".fst", "--fst")),
            "FILE");
    for_vcd(command.add_option("--fst", request.fst, "Write the same as FST, as GTKWave and Surfer read it")
                ->check(no_file_of(".vcd", "--vcd")),
            "FILE");
    for_vcd(command.add_option("--vcd-cores", request.vcd_cores, "Only these cores, e.g. 0,2-4"), "LIST");
    for_vcd(
        command
            .add_option("--vcd-modules", request.vcd_modules,
                        "Only modules, FIFOs and block RAMs whose name matches, e.g. '*_token'; a module's FIFOs and "
                        "block RAMs come with it")
            ->delimiter(','),
        "GLOB,...");
    for_vcd(command.add_option("--vcd-samples", request.vcd_samples, "Only these samples, e.g. 5 or 5-7"), "RANGE");
    auto const is_cycle = [](std::string const& text) {  // below 0 it would become a number near 2^64
        Cycles cycle = 0;
        auto const parsed = std::from_chars(text.data(), text.data() + text.size(), cycle);
        bool const is_whole = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
        return is_whole ? std::string() : text + ", expected a cycle, 0 or more";
    };
    for_vcd(command.add_option("--vcd-from", request.vcd_from, "First cycle")->check(is_cycle), "CYCLE");
    for_vcd(command.add_option("--vcd-to", request.vcd_to, "Last cycle")->check(is_cycle), "CYCLE");
    command.add_option("--timeline", request.timeline, "Write a timeline for Perfetto or chrome://tracing (JSON)")
        ->type_name("FILE")
        ->group(waveforms);
    command.add_option("--timeline-samples", request.timeline_samples, "Samples of each core in the timeline")
        ->type_name("N")
        ->capture_default_str()
        ->check(integer_in(1, 1000000))
        ->group(waveforms)
        ->needs("--timeline");
}

void refuse_without_waveform(RecordingRequest const& request) {
    auto const refuse_if = [](bool is_given, char const* option) {
        if (is_given)
            throw InputError(fmt::format("{}: expected it with --vcd or --fst", option));
    };
    refuse_if(!request.vcd_cores.empty(), "--vcd-cores");
    refuse_if(!request.vcd_modules.empty(), "--vcd-modules");
    refuse_if(!request.vcd_samples.empty(), "--vcd-samples");
    refuse_if(request.vcd_from.has_value(), "--vcd-from");
    refuse_if(request.vcd_to.has_value(), "--vcd-to");
}

void add_paths(RecordingRequest const& request, CommandPaths& paths) {
    paths.writes("--vcd", request.vcd);
    paths.writes("--fst", request.fst);
    paths.writes("--timeline", request.timeline);
    std::set<std::filesystem::path> beside;
    for (auto const& [file, names] : waveforms_of(request))
        for (std::filesystem::path const& one : recording::files_beside(file, names))
            if (beside.insert(one).second)
                paths.writes("what is beside " + file.string(), one);
}

std::string written_files(RecordingRequest const& request) {
    std::vector<std::string> files;
    for (std::string const& file : {request.timeline, request.vcd, request.fst})
        if (!file.empty())
            files.push_back(file);
    std::set<std::string> beside;
    for (auto const& [file, names] : waveforms_of(request)) {
        for (std::filesystem::path const& one : recording::files_beside(file, names))
            beside.insert(one.string());
        if (names == ValueNames::in_tables)
            for (std::string const& table : tables_beside(file))
                beside.insert(table);
    }
    files.insert(files.end(), beside.begin(), beside.end());
    return fmt::format("{}", fmt::join(files, ", "));
}

std::vector<Recording> make_recordings(RecordingRequest const& request, Machine const& machine, std::size_t samples,
                                       PlaceOf const& place_of) {
    std::vector<Recording> recordings;
    if (!request.timeline.empty())
        recordings = timeline_recordings(request, machine, samples, place_of);
    if (request.has_waveform())
        recordings.push_back(waveform_recording(request, machine, samples, place_of));
    else
        refuse_without_waveform(request);
    return recordings;
}

}  // namespace dataflow
