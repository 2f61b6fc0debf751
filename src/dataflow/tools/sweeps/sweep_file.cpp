#include "dataflow/tools/sweeps/sweep_file.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <set>

#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/value_reader.hpp"
#include "dataflow/tools/sweeps/dimension_reader.hpp"
#include "dataflow/tools/sweeps/key_cells.hpp"

namespace dataflow::sweeps {

namespace {

constexpr std::array<char const*, 5> keys{"format", "version", "base", "set", "dimensions"};

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
        throw_faults();
        for (char const* const needed : {"format", "version", "dimensions"})
            if (given_.count(needed) == 0)
                faults_.push_back({1, needed, std::nullopt, "missing, expected it at the top of the file"});
        throw_faults();
        check_size();
        return sweep_;
    }

  private:
    void reject(MapEntry const& entry, std::string const& expected) {
        faults_.push_back({entry.line, entry.name, shown(entry.value), "expected " + expected});
    }

    void read_entry(MapEntry const& entry) {
        given_.insert(entry.name);
        if (entry.name == "format")
            require_word(entry, "faster-sweep");
        else if (entry.name == "version")
            require_word(entry, "1");
        else if (entry.name == "base")
            read_base(entry);
        else if (entry.name == "set")
            read_settings(entry);
        else if (entry.name == "dimensions")
            read_dimensions(entry);
        else
            faults_.push_back({entry.line, shortened(entry.name), std::nullopt,
                               fmt::format("unknown key, expected one of {}{}", fmt::join(keys, ", "),
                                           did_you_mean(entry.name, keys))});
    }

    void require_word(MapEntry const& entry, std::string const& word) {
        if (!entry.value.IsScalar() || entry.value.Scalar() != word)
            reject(entry, word);
    }

    void read_base(MapEntry const& entry) {
        if (auto const path = cells_.path(entry.name, entry.value, entry.line))
            sweep_.base = *path;
    }

    void read_settings(MapEntry const& set) {
        if (!set.value.IsMap())
            return reject(set, "a map of dotted keys, e.g. {" + example_key() + ": 1}");
        for (MapEntry const& entry : read_entries(set.value, "set.", faults_))
            if (Key const* const key = cells_.key(entry.name, entry.line))
                if (auto const cell = cells_.cell(*key, entry.value, entry.line)) {
                    sweep_.settings.push_back(cell->setting);
                    take_column(entry.name, entry.line);
                }
    }

    void read_dimensions(MapEntry const& list) {
        if (!list.value.IsSequence() || list.value.size() == 0)
            return reject(list, "a list with at least one dimension");
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

    void throw_faults() {
        std::stable_sort(faults_.begin(), faults_.end(),
                         [](KeyFault const& a, KeyFault const& b) { return a.line < b.line; });
        std::vector<std::string> messages;
        for (KeyFault const& fault : faults_)
            messages.push_back(fmt::format("{}:{}: {}", sweep_.file, fault.line, fault.text()));
        throw_first(messages);
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
    std::set<std::string> given_;
    std::map<std::string, int> columns_;
};

}  // namespace

Sweep read_sweep_file(std::filesystem::path const& path) {
    return SweepReader(path).sweep(load_document(path, "a sweep file", {keys.begin(), keys.end()}));
}

}  // namespace dataflow::sweeps
