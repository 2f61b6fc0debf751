#include "dataflow/tools/sweeps/sweep_file.hpp"

#include <fmt/format.h>
#include <map>
#include <string>
#include <vector>

#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/entry_faults.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/value_reader.hpp"
#include "dataflow/tools/sweeps/dimension_reader.hpp"
#include "dataflow/tools/sweeps/key_cells.hpp"

namespace dataflow::sweeps {

namespace {

std::vector<std::string> const keys{"format", "version", "base", "set", "dimensions"};

class SweepReader {
  public:
    explicit SweepReader(std::filesystem::path const& file) : cells_(file.parent_path(), faults_) {
        sweep_.file = file.string();
    }

    Sweep sweep(YAML::Node const& root) {
        if (!root.IsMap())
            throw InputError(fmt::format("{}:1: {}, expected a sweep: a map with {}", sweep_.file, shown(root),
                                         fmt::join(keys, ", ")));
        for (MapEntry const& entry : read_entries(root, "", faults_))
            read_entry(entry);
        throw_first_of(faults_, sweep_.file);
        require_given(faults_, given_, {"format", "version", "dimensions"});
        throw_first_of(faults_, sweep_.file);
        check_size();
        return sweep_;
    }

  private:
    void read_entry(MapEntry const& entry) {
        given_.push_back(entry.name);
        if (entry.name == "format")
            require_word(faults_, entry, "faster-sweep");
        else if (entry.name == "version")
            require_word(faults_, entry, "1");
        else if (entry.name == "base")
            read_base(entry);
        else if (entry.name == "set")
            read_settings(entry);
        else if (entry.name == "dimensions")
            read_dimensions(entry);
        else
            reject_name(faults_, entry, keys);
    }

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
    std::vector<std::string> given_;
    std::map<std::string, int> columns_;
};

}  // namespace

Sweep read_sweep_file(std::filesystem::path const& path) {
    return SweepReader(path).sweep(load_document(path, "a sweep file", keys));
}

}  // namespace dataflow::sweeps
