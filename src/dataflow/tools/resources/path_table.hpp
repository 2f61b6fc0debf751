#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace faster {

/// An estimate with its range.
struct Estimate {
    double low = 0;
    double typical = 0;
    double high = 0;
};

/// A longest path of a unit, clock to clock.
struct UnitPath {
    std::string from;
    std::string to;
    unsigned stages = 1;  ///< that its logic may be spread over
    Estimate delay_ns;    ///< of all of it

    Estimate of_stage() const { return {delay_ns.low / stages, delay_ns.typical / stages, delay_ns.high / stages}; }
};

/// Longest paths of synthesized configurations of units: rtl/timing.csv, of which the columns unit, configuration,
/// stages, low_ns, typical_ns, high_ns, from and to count.
class PathTable {
  public:
    /// Errors: std::invalid_argument, std::out_of_range for a table without these columns.
    explicit PathTable(std::string_view csv);

    /// The paths of the row that has most of a configuration's keys and no other; none for a unit that is not there.
    std::vector<UnitPath> paths(std::string const& unit, std::map<std::string, std::string> const& keys) const;

  private:
    struct Row {
        std::string unit;
        std::map<std::string, std::string> keys;
        UnitPath path;
    };
    std::vector<Row> rows_;
};

}  // namespace faster
