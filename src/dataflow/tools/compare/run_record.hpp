#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "dataflow/run/figures/module_row.hpp"
#include "dataflow/run/figures/table_columns.hpp"

namespace dataflow::runs {

/// One key of the resolved configuration.
struct ConfigurationEntry {
    std::string key;
    std::string value;  ///< as JSON on one line
    friend bool operator==(ConfigurationEntry const& a, ConfigurationEntry const& b) {
        return a.key == b.key && a.value == b.value;
    }
};

struct ModuleRecord {
    std::uint64_t core = 0;
    std::string module;
    std::vector<NamedCycles>
        classes;  ///< columns such as "busy_cycles": which there are is up to the run that wrote them

    std::string name() const { return module; }
    friend bool operator==(ModuleRecord const& a, ModuleRecord const& b) {
        return a.core == b.core && a.module == b.module && a.classes == b.classes;
    }
};

/// A run as its output folder (docs/formats.md) tells it: simulated figures and configuration, no host times. Of FIFOs
/// and loops it has the columns of the CSV files. Tables have a row per core and item, every core the same items.
struct RunRecord {
    std::string folder;  ///< as the user named it
    Cycles total_cycles = 0;
    double milliseconds = 0;
    std::uint64_t raster_cores = 0;
    std::vector<ConfigurationEntry> configuration;
    std::vector<ModuleRecord> modules;
    std::vector<FifoRow> fifos;
    std::vector<LoopRow> loops;
    std::vector<SampleStatistics> samples;  ///< by sample
};

}  // namespace dataflow::runs
