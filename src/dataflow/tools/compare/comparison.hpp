#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/run/figures/table_columns.hpp"

namespace dataflow::runs {

/// A setting in two runs, its values as JSON on one line; nothing where a run does not know it.
struct SettingChange {
    std::string key;
    std::optional<std::string> a;
    std::optional<std::string> b;
};

/// One figure of one item in two runs; nothing where a run does not know it, which counts as 0.
struct Change {
    std::string item;    ///< e.g. "reader"
    std::string figure;  ///< e.g. "busy_cycles"
    std::optional<std::uint64_t> a;
    std::optional<std::uint64_t> b;

    /// B - A.
    std::int64_t difference() const;
    /// See percent_of().
    std::optional<double> percent() const;
};

/// Largest absolute difference first.
void sort_by_difference(std::vector<Change>& changes);

/// B - A in per cent of A; nothing if A is 0.
std::optional<double> percent_of(double a, double b);

/// Figures of one kind and unit that differ, largest absolute difference first.
struct ChangeList {
    std::string name;   ///< in the JSON file
    std::string title;  ///< for people, with the unit
    std::vector<Change> changes;
};

/// A sample that did not score the same.
struct SampleChange {
    std::uint64_t sample = 0;
    Counters a;
    Counters b;
};

/// A run's headline.
struct RunHead {
    std::string folder;
    std::uint64_t samples = 0;
    std::uint64_t raster_cores = 0;
    Cycles total_cycles = 0;
    double milliseconds = 0;
};

/// What differs between run A and run B.
struct Comparison {
    RunHead a;
    RunHead b;
    bool identical = false;          ///< configuration, and every figure of every core and sample
    std::vector<std::string> notes;  ///< what to bear in mind, one sentence each
    std::size_t keys = 0;            ///< of the configurations, those of one run only included
    std::vector<SettingChange> configuration;
    std::size_t compared_samples = 0;        ///< those that both runs have
    std::vector<SampleChange> samples;       ///< by sample
    std::vector<SettingChange> fifo_shapes;  ///< depth and kind
    std::vector<ChangeList> figures;

    bool is_functionally_equal() const { return samples.empty() && a.samples == b.samples; }
};

}  // namespace dataflow::runs
