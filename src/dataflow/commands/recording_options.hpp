#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "channels/simulate.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/core/machine/machine.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): as the library has it
class App;
}

namespace dataflow {

/// What of a run is to be recorded: options of `faster-sim run`.
struct RecordingRequest {
    std::string vcd;                       ///< file; empty: none
    std::string fst;                       ///< likewise
    std::string vcd_cores;                 ///< e.g. 0,2-4; empty: all
    std::vector<std::string> vcd_modules;  ///< glob patterns; empty: all
    std::optional<Cycles> vcd_from;
    std::optional<Cycles> vcd_to;
    std::string vcd_samples;  ///< e.g. 5 or 5-7; empty: by cycles
    std::string timeline;     ///< file; empty: none
    std::int64_t timeline_samples = 2;

    bool has_waveform() const { return !vcd.empty() || !fst.empty(); }
};

void add_recording_options(CLI::App& command, RecordingRequest& request);

/// Where no waveform is wanted. Errors: InputError for an option that says which part of it.
void refuse_without_waveform(RecordingRequest const& request);

/// The numbers of a list such as 0,2-4, for an option. Errors: InputError for what is none, or not below `end`.
std::vector<std::size_t> parse_numbers(char const* option, std::string const& text, std::size_t end);

/// The cores of which a waveform is wanted. Errors: InputError for cores that there are not.
std::vector<std::size_t> cores_recorded(RecordingRequest const& request, Machine const& machine);
/// The part of the run that it wants. Throws InputError.
recording::RecordingWindow waveform_window(RecordingRequest const& request, Machine const& machine,
                                           std::size_t samples);

/// Writes the waveform's files. Returns how long they are, in bytes: of the VCD first.
std::vector<double> write_waveform_files(RecordingRequest const& request, Machine const& machine,
                                         recording::RecordedWindow const& window);

/// Says what of its paths is written.
void add_paths(RecordingRequest const& request, CommandPaths& paths);

/// Where to write a file that is to have that name in the end.
using PlaceOf = std::function<std::filesystem::path(std::filesystem::path const& file)>;

/// The recordings that a request asks of a run; each writes its files when the run is over. Request and machine must
/// outlive them. Errors: InputError for what the run cannot give, and for files that cannot be written.
std::vector<Recording> make_recordings(
    RecordingRequest const& request, Machine const& machine, std::size_t samples,
    PlaceOf const& place_of = [](std::filesystem::path const& file) { return file; });

/// All files that it writes, as "a, b, c"; empty if none.
std::string written_files(RecordingRequest const& request);

}  // namespace dataflow
