#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/replay/recorded_run.hpp"

namespace dataflow::events {

/// An event file (docs/formats.md, "Event files"): all that a run did, without the time it took, and what came of it.
struct EventFile {
    LoadedConfig loaded;  ///< of the recorded run; the engine, which changes nothing, has its default
    replay::RecordedRun run;
    std::string summary;  ///< the recorded run's summary.json, without host times
    std::vector<SampleStatistics> samples;
    std::string function;  ///< what it was recorded as: the hash that a sweep knows it by; empty if it is no sweep's
};

/// Writes the file: complete or not at all, the operations of one sample after the other. `summary` is the summary.json
/// of a run that did not deadlock. Both engines write the same bytes. `function`: see EventFile.
void write_event_file(io::OutputFile const& file, RunConfig const& config, replay::RecordedRun const& run,
                      RunStatistics const& statistics, std::string const& summary, std::string const& function = "");

/// Reads all but the operations, which stay in the file until they are needed. Throws InputError for what is no event
/// file, of another version, cut off or damaged.
EventFile read_event_file(std::filesystem::path const& path);

/// The program that wrote an event file, the only one that knows its design. Throws InputError for what is none.
std::string recording_program(std::filesystem::path const& path);

}  // namespace dataflow::events
