#include "tool/report_page.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <mutex>

#include "kernel/base/input_error.hpp"
#include "kernel/base/program_name.hpp"
#include "kernel/config/resolved_config.hpp"
#include "kernel/explore/replayed_timeline.hpp"
#include "kernel/report/html/deadlock_html.hpp"
#include "kernel/report/html/html_report.hpp"
#include "kernel/report/standout_samples.hpp"
#include "tool/progress_line.hpp"
#include "tool/recording_options.hpp"

namespace faster {

namespace {

constexpr std::size_t most_samples = 1000;

/// Bars of the finest levels that a page holds, about eight bytes each.
constexpr std::size_t most_bars = 5'000'000;
constexpr std::size_t most_bars_of_sample = 50'000;

std::string title_of(std::string const& config) { return std::filesystem::path(config).filename().string(); }

/// Each once.
std::vector<SampleStatistics> shown_samples(RunStatistics const& run, std::vector<std::size_t> const& asked) {
    std::vector<std::size_t> numbers;
    for (report::StandoutSample const& standout : report::standout_samples(run))
        numbers.push_back(standout.sample->sample);
    numbers.insert(numbers.end(), asked.begin(), asked.end());
    std::vector<SampleStatistics> samples;
    std::vector<bool> is_there(run.samples.size(), false);
    for (std::size_t const number : numbers) {
        if (!is_there[number])
            samples.push_back(run.samples[number]);
        is_there[number] = true;
    }
    return samples;
}

std::vector<report::PackedTimeline> packed_timelines(replay::RecordedRun const& recorded, RunStatistics const& run,
                                                     std::vector<SampleStatistics> const& samples) {
    if (samples.empty())
        return {};
    ProgressLine progress("timelines");
    std::mutex mutex;
    std::size_t done = 0;
    std::size_t const bars = std::min(most_bars / samples.size(), most_bars_of_sample);
    std::vector<report::PackedTimeline> packed(samples.size());
    explore::replay_timelines(recorded, run.machine, samples, [&](std::size_t i, SampleTimeline timeline) {
        packed[i] = report::packed_timeline(run.machine, report::with_endless_waits(std::move(timeline), run), bars);
        std::lock_guard<std::mutex> const lock(mutex);
        progress.show(++done, samples.size());
    });
    return packed;
}

/// That of the core with the circle first.
std::vector<SampleStatistics> stuck_samples(RunStatistics const& run) {
    constexpr std::size_t most_shown = 10;
    std::vector<SampleStatistics> samples = run.unfinished;
    std::vector<StuckProcess> const circle = run.wait_cycle();
    std::stable_partition(samples.begin(), samples.end(), [&circle](SampleStatistics const& sample) {
        return !circle.empty() && sample.core == circle.front().core;
    });
    samples.resize(std::min(samples.size(), most_shown));
    return samples;
}

}  // namespace

std::vector<std::size_t> parse_report_samples(std::string const& text, std::size_t samples) {
    if (text.empty())
        return {};
    std::string const list = text == "all" && samples > 0 ? fmt::format("0-{}", samples - 1) : text;
    std::vector<std::size_t> numbers = parse_numbers("--report-samples", list, samples);
    if (numbers.size() > most_samples)
        throw InputError(
            fmt::format("--report-samples {}: {} samples, expected at most {}", text, numbers.size(), most_samples));
    return numbers;
}

void write_report(io::OutputFile const& file, std::string const& config, LoadedConfig const& loaded,
                  RunStatistics const& run, replay::RecordedRun const& recorded, std::vector<std::size_t> const& asked,
                  RunExtras const& extras) {
    std::vector<ResolvedKey> const keys = resolved_keys(loaded.config);
    std::vector<report::PackedTimeline> const timelines = packed_timelines(recorded, run, shown_samples(run, asked));
    file.commit(report::html_report({title_of(config), run, keys, timelines, extras.pictures()}));
}

void write_deadlock_page(io::OutputFile const& file, std::string const& config,
                         std::vector<std::string> const& overrides, LoadedConfig const& loaded,
                         RunStatistics const& run, replay::RecordedRun const& recorded) {
    report::RunCommand const command{program_name() + " run " + config, overrides};
    file.commit(report::deadlock_html(title_of(config), command, run, resolved_keys(loaded.config),
                                      packed_timelines(recorded, run, stuck_samples(run))));
}

}  // namespace faster
