#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "dataflow/base/column.hpp"
#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::budgets {

/// One figure of a run, by its dotted name: a path through the output files, e.g. "fifos.lines.max_occupancy",
/// "samples.3.latency_cycles" or "cores.0.loops.filter.rows.ii".
struct Figure {
    std::string name;
    std::uint64_t value = 0;
};

/// Figures in the order in which they came, each name once.
class Figures {
  public:
    /// Replaces the value of a name that is there.
    void set(std::string const& name, std::uint64_t value);
    std::optional<std::uint64_t> find(std::string const& name) const;
    std::vector<Figure> const& all() const { return all_; }

  private:
    std::vector<Figure> all_;
    std::unordered_map<std::string, std::size_t> index_;
};

/// What the tables of columns say of a figure. Of a name that they do not know (a baseline may be older than they are):
/// work without a unit.
ColumnFacts const& facts_of(std::string const& name);

/// True for what is counted in clock cycles (of all cores together: lane-cycles), which a limit may give as a time too.
inline bool is_in_cycles(std::string const& name) { return facts_of(name).is_in_cycles(); }

/// Every figure of a finished run: those of the run, of all cores together (see is_largest_over_cores), of each sample,
/// and of each core under "cores.N.". Names and values are those of summary.json and samples.csv.
Figures run_figures(RunStatistics const& run);

}  // namespace dataflow::budgets
