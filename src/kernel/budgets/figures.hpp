#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace faster::budgets {

/// One figure of a run, by its dotted name: a path through the output files, e.g. "fifos.edge_token.max_occupancy",
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

/// What a name's parts are: "fifos", "edge_token", "max_occupancy".
std::vector<std::string> parts_of(std::string const& name);

}  // namespace faster::budgets
