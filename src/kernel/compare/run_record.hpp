#pragma once
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "common/tokens.hpp"
#include "kernel/base/cycles.hpp"

namespace faster::runs {

/// One key of the resolved configuration.
struct ConfigurationEntry {
    std::string key;
    std::string value;  ///< as JSON on one line
    friend bool operator==(ConfigurationEntry const& a, ConfigurationEntry const& b) {
        return a.key == b.key && a.value == b.value;
    }
};

/// How many of a module's cycles were of one class. Which classes there are is up to the run that wrote them.
struct CycleClass {
    std::string name;  ///< e.g. "busy_cycles"
    Cycles cycles = 0;
    friend bool operator==(CycleClass const& a, CycleClass const& b) {
        return a.name == b.name && a.cycles == b.cycles;
    }
};

struct ModuleRecord {
    std::uint64_t core = 0;
    std::string module;
    std::vector<CycleClass> classes;

    std::string name() const { return module; }
    friend bool operator==(ModuleRecord const& a, ModuleRecord const& b) {
        return a.core == b.core && a.module == b.module && a.classes == b.classes;
    }
};

struct FifoRecord {
    std::uint64_t core = 0;
    std::string fifo;
    std::string kind;  ///< as resolved
    std::uint64_t depth = 0;
    Cycles write_latency = 0;
    std::uint64_t writes = 0;
    std::uint64_t reads = 0;
    Cycles full_stall_cycles = 0;
    Cycles empty_stall_cycles = 0;
    std::uint64_t max_occupancy = 0;

    std::string name() const { return fifo; }
    auto figures() const {
        return std::tie(core, fifo, kind, depth, write_latency, writes, reads, full_stall_cycles, empty_stall_cycles,
                        max_occupancy);
    }
    friend bool operator==(FifoRecord const& a, FifoRecord const& b) { return a.figures() == b.figures(); }
};

struct LoopRecord {
    std::uint64_t core = 0;
    std::string module;
    std::string loop;
    Cycles ii_target = 0;
    Cycles ii_recurrence = 0;
    Cycles ii = 0;
    Cycles depth = 0;
    std::uint64_t entries = 0;
    std::uint64_t iterations = 0;
    Cycles port_conflict_cycles = 0;
    Cycles recurrence_cycles = 0;
    std::string limited_by;

    std::string name() const { return module + "." + loop; }
    auto figures() const {
        return std::tie(core, module, loop, ii_target, ii_recurrence, ii, depth, entries, iterations,
                        port_conflict_cycles, recurrence_cycles, limited_by);
    }
    friend bool operator==(LoopRecord const& a, LoopRecord const& b) { return a.figures() == b.figures(); }
};

struct SampleRecord {
    std::uint64_t core = 0;
    Cycles start_cycle = 0;
    Cycles end_cycle = 0;
    SampleCounters counters;

    Cycles latency_cycles() const { return end_cycle + 1 - start_cycle; }
    friend bool operator==(SampleRecord const& a, SampleRecord const& b) {
        return a.core == b.core && a.start_cycle == b.start_cycle && a.end_cycle == b.end_cycle &&
               a.counters == b.counters;
    }
};

/// A run as its output folder (docs/formats.md) tells it: simulated figures and configuration, no host times. Tables
/// have a row per core and item, every core the same items.
struct RunRecord {
    std::string folder;  ///< as the user named it
    Cycles total_cycles = 0;
    double milliseconds = 0;
    std::uint64_t raster_cores = 0;
    std::vector<ConfigurationEntry> configuration;
    std::vector<ModuleRecord> modules;
    std::vector<FifoRecord> fifos;
    std::vector<LoopRecord> loops;
    std::vector<SampleRecord> samples;  ///< by sample
};

}  // namespace faster::runs
