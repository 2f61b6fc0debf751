#pragma once
#include <string>
#include <vector>

#include "kernel/base/files/output_file.hpp"
#include "kernel/config/load_config.hpp"
#include "kernel/figures/run_statistics.hpp"
#include "kernel/replay/recorded_run.hpp"
#include "tool/run_extras.hpp"

namespace faster {

/// The samples that --report-samples asks for: "all", or numbers and ranges such as 0-9,617. Errors: InputError for
/// samples that there are not, and for more than a page can hold.
std::vector<std::size_t> parse_report_samples(std::string const& text, std::size_t samples);

/// Writes the page of a finished run, which was recorded. It gets the timelines of the median sample, the slowest, the
/// fastest, and those asked for.
void write_report(io::OutputFile const& file, std::string const& config, LoadedConfig const& loaded,
                  RunStatistics const& run, replay::RecordedRun const& recorded, std::vector<std::size_t> const& asked,
                  RunExtras const& extras);

/// Writes the page of a run that got stuck, with the timelines of samples that did not end. `overrides`: its settings.
void write_deadlock_page(io::OutputFile const& file, std::string const& config,
                         std::vector<std::string> const& overrides, LoadedConfig const& loaded,
                         RunStatistics const& run, replay::RecordedRun const& recorded);

}  // namespace faster
