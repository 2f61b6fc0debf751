#pragma once
#include <string>
#include <vector>

#include "dataflow/base/byte_stream.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::chance {

/// All figures of a run that are compared, a line each, under names.
struct Figures {
    std::vector<std::string> lines;
    bool is_stuck = false;
    Cycles total_cycles = 0;
    std::vector<std::string>
        hand_overs;  ///< FIFOs that hand over calls, of which the simulation cycle by cycle has none
    /// Of a simulation cycle by cycle: what attempts found, a letter each; by process of all cores and FIFO, as
    /// attempts of one cycle have no order.
    std::vector<std::string> outcomes;

    /// In the order of names, as designs list their FIFOs in another one than machines.
    void add_in_order(std::vector<std::string> fifos);
};

/// To and from another process. Not the outcomes.
void put(ValueWriter& writer, Figures const& figures);
Figures figures_from(ValueReader& reader);

/// Of a run that got stuck: when, who waits for whom, and what FIFOs have done until then. Otherwise totals, samples
/// and tables.
Figures figures_of(RunStatistics const& run);

std::string sample_line(std::uint64_t sample, Cycles begin, Cycles end);
std::string fifo_line(std::size_t core, std::string const& name, std::uint64_t writes, std::uint64_t reads, Cycles full,
                      Cycles empty, std::uint64_t most);
std::string loop_line(std::size_t core, std::string const& name, Cycles ii, std::uint64_t entries,
                      std::uint64_t iterations);
std::string process_line(std::size_t core, std::string const& name, Cycles memory, Cycles empty, Cycles full,
                         Cycles idle_before, Cycles idle_after);
std::string wait_line(std::size_t core, std::string const& process, std::string const& fifo, bool to_write,
                      Cycles since, std::string const& other, std::uint64_t occupancy);

/// The first line in which two differ, of both; empty if none does.
std::string first_difference(Figures const& found, Figures const& expected);

}  // namespace faster::chance
