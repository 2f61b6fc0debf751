#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "dataflow/base/device/resources.hpp"
#include "dataflow/core/machine/fifo_kind.hpp"

namespace dataflow {

/// A key of a unit's configuration. Values are numbers or names; `standard` is that of the unit's row `default`.
struct UnitKey {
    std::string name;
    std::string value;
    std::string standard;
};

/// Those that do not have their standard values.
std::map<std::string, std::string> differing_keys(std::vector<UnitKey> const& keys);

/// Figures of synthesized configurations of units.
///
/// A row is a unit, and the keys in which its configuration differs from the unit's row `default`. A configuration that
/// has no row is put together: from the row that shares most of its keys, every other key adds what it changes alone.
/// What a number changes lies on the straight line between the two rows next to it, and beyond the last row on the line
/// through the last two. A name without a row changes nothing.
class ResourceTable {
  public:
    /// CSV with columns unit, configuration, lut, ff, dsp, ramb36; a configuration is `default`, or KEY=VALUE parted by
    /// blanks. Errors: std::invalid_argument for anything else.
    explicit ResourceTable(std::string_view csv);

    /// Errors: std::out_of_range for a unit without a row `default`.
    ResourcePart unit(std::string const& name, std::vector<UnitKey> const& keys) const;
    /// Of a unit whose rows are a grid of the two keys: on straight lines along the one, then along the other.
    ResourcePart on_grid(std::string const& name, std::string const& first, double at_first, std::string const& second,
                         double at_second) const;
    /// A FIFO for `tokens` tokens, of a kind that is resolved: units fifo.shift_register and fifo.memory, by depth and
    /// bits. A memory is as deep as the next power of two. One that is deeper than all rows takes more than the deepest
    /// of them by what counted_fifo() says: it grows in steps, which no line through two rows has.
    ResourcePart fifo(FifoKind kind, std::uint64_t tokens, unsigned bits) const;

    struct Row {
        std::string unit;
        std::map<std::string, std::string> keys;
        Resources amount;
    };
    std::vector<Row> const& rows() const { return rows_; }

  private:
    using Keys = std::map<std::string, std::string>;
    Row const* row(std::string const& unit, Keys const& keys) const;
    Row const& nearest(std::string const& unit, Keys const& keys) const;
    Resources change(std::string const& unit, UnitKey const& key) const;
    double largest(std::string const& unit, std::string const& key) const;

    std::vector<Row> rows_;
};

}  // namespace dataflow
