#include "dataflow/tools/sweeps/sweep_file.hpp"

#include <fmt/format.h>
#include <map>
#include <string>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/entry_faults.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/value_reader.hpp"
#include "dataflow/tools/sweeps/dimension_reader.hpp"
#include "dataflow/tools/sweeps/key_cells.hpp"

namespace dataflow::sweeps {

namespace {

class SweepReader {
  public:
    explicit SweepReader(std::filesystem::path const& file) : cells_(file.parent_path(), faults_) {
        sweep_.file = file.string();
    }

    Sweep sweep() {
        read_top(sweep_.file, "a sweep", "faster-sweep",
                 {{"base", [this](MapEntry const& entry) { read_base(entry); }},
                  {"set", [this](MapEntry const& entry) { read_settings(entry); }},
                  {"dimensions", [this](MapEntry const& entry) { read_dimensions(entry); }}},
                 {"dimensions"}, faults_);
        throw_first_of(faults_, sweep_.file);
        check_size();
        return sweep_;
    }

  private:
    void read_base(MapEntry const& entry) {
        if (auto const path = cells_.path(entry.name, entry.value, entry.line))
            sweep_.base = *path;
    }

    void read_settings(MapEntry const& set) {
        if (!set.value.IsMap())
            return reject(faults_, set, "a map of dotted keys, e.g. {" + example_key() + ": 1}");
        for (MapEntry const& entry : read_entries(set.value, "set.", faults_))
            if (Key const* const key = cells_.key(entry.name, entry.line))
                if (auto const cell = cells_.cell(*key, entry.value, entry.line)) {
                    sweep_.settings.push_back(cell->setting);
                    take_column(entry.name, entry.line);
                }
    }

    void read_dimensions(MapEntry const& list) {
        if (!list.value.IsSequence() || list.value.size() == 0)
            return reject(faults_, list, "a list with at least one dimension");
        for (YAML::Node const& item : list.value) {
            int const line = item.Mark().is_null() ? list.line : item.Mark().line + 1;
            if (auto dimension = read_dimension(item, line, cells_)) {
                for (std::string const& column : dimension->columns)
                    take_column(column, line);
                sweep_.dimensions.push_back(std::move(*dimension));
            }
        }
    }

    void take_column(std::string const& column, int line) {
        if (auto const [first, is_new] = columns_.try_emplace(column, line); !is_new)
            faults_.push_back({line, column, std::nullopt,
                               fmt::format("stands twice, expected once (first in line {})", first->second)});
    }

    void check_size() const {
        double count = 1;
        for (Dimension const& dimension : sweep_.dimensions)
            count *= static_cast<double>(dimension.rows.size());
        if (count > static_cast<double>(most_points))
            throw InputError(
                fmt::format("{}: dimensions make {:.0f} points, expected at most {}", sweep_.file, count, most_points));
    }

    KeyFaults faults_;
    KeyCells cells_;
    Sweep sweep_;
    std::map<std::string, int> columns_;
};

}  // namespace

Sweep read_sweep_file(std::filesystem::path const& path) { return SweepReader(path).sweep(); }

}  // namespace dataflow::sweeps
