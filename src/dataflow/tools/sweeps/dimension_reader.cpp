#include "dataflow/tools/sweeps/dimension_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/tools/sweeps/random_dimension.hpp"
#include "dataflow/tools/sweeps/results_table.hpp"
#include "dataflow/tools/sweeps/sweep_file.hpp"
#include "dataflow/tools/sweeps/value_lists.hpp"

namespace dataflow::sweeps {

namespace {

constexpr auto most_rows = static_cast<std::int64_t>(most_points);

/// Reads one item: the entry that comes first in `ways` says what it is.
class DimensionReader {
  public:
    DimensionReader(int line, KeyCells const& cells) : line_(line), cells_(cells), lists_(cells) {}

    std::optional<Dimension> dimension(YAML::Node const& item) {
        std::size_t const before = cells_.faults().size();
        if (item.IsMap())
            read_item(item);
        else
            lists_.fault(line_, "dimensions", fmt::format("{}, expected a map, one of {}", shown(item), all_ways()));
        if (cells_.faults().size() == before && dimension_.rows.empty())
            lists_.fault(line_, "dimensions", "no values, expected at least one");
        return cells_.faults().size() == before ? std::optional(dimension_) : std::nullopt;
    }

  private:
    struct Way {
        std::vector<std::string> names;  ///< the first says which way it is
        void (DimensionReader::*read)();
    };
    static std::vector<Way> const& ways() {
        static std::vector<Way> const all{{{"range", "key", "step"}, &DimensionReader::read_range},
                                          {{"key", "values"}, &DimensionReader::read_values},
                                          {{"overlay", "files"}, &DimensionReader::read_overlay},
                                          {{"zip"}, &DimensionReader::read_zip},
                                          {{"random", "count", "seed"}, &DimensionReader::read_random},
                                          {{"seeds", "count", "first"}, &DimensionReader::read_seeds}};
        return all;
    }
    static char const* all_ways() {
        return "{key, values}, {key, range, step}, {overlay, files}, {zip}, {random, count, seed}, {seeds, count, "
               "first}";
    }

    void read_item(YAML::Node const& item) {
        entries_ = read_entries(item, "dimensions.", cells_.faults());
        for (Way const& way : ways())
            if (find(way.names.front()) != nullptr)
                return read_as(way);
        std::vector<std::string> names;
        for (Way const& way : ways())
            names.insert(names.end(), way.names.begin(), way.names.end());
        std::string const name = entries_.empty() ? "" : entries_.front().name;
        lists_.fault(line_, "dimensions",
                     fmt::format("{}, expected one of {}{}", name.empty() ? "an empty map" : shortened(name),
                                 all_ways(), did_you_mean(name, names)));
    }

    void read_as(Way const& way) {
        std::size_t const before = cells_.faults().size();
        for (MapEntry const& entry : entries_)
            if (std::find(way.names.begin(), way.names.end(), entry.name) == way.names.end())
                lists_.fault(entry.line, "dimensions." + shortened(entry.name),
                             fmt::format("unknown key beside {}, expected one of {}{}", way.names.front(),
                                         fmt::join(way.names, ", "), did_you_mean(entry.name, way.names)));
        if (cells_.faults().size() == before)
            (this->*way.read)();
    }

    MapEntry const* find(std::string const& name) const {
        auto const found = std::find_if(entries_.begin(), entries_.end(),
                                        [&name](MapEntry const& entry) { return entry.name == name; });
        return found == entries_.end() ? nullptr : &*found;
    }
    MapEntry const* need(std::string const& name, std::string const& expected) const {
        MapEntry const* const entry = find(name);
        if (entry == nullptr)
            lists_.fault(line_, "dimensions." + name, "missing, expected " + expected);
        return entry;
    }

    /// Of the entry `key`.
    Key const* named_key() const {
        MapEntry const* const entry = need("key", "a dotted key such as " + example_key());
        if (entry == nullptr)
            return nullptr;
        if (entry->value.IsScalar())
            return cells_.key(entry->value.Scalar(), entry->line);
        lists_.reject(*entry, "a dotted key such as " + example_key());
        return nullptr;
    }

    void read_values() {
        MapEntry const* const values = need("values", "a list, or range");
        Key const* const key = named_key();
        if (values == nullptr || key == nullptr)
            return;
        dimension_.columns = {key->name()};
        for (Cell const& cell : lists_.cells_of(*key, *values, true))
            dimension_.rows.push_back({cell});
    }

    void read_range() {
        Key const* const key = named_key();
        if (key == nullptr)
            return;
        auto const limits = lists_.bounds(*key, *find("range"));
        double const step = read_step(*key);
        if (!limits || !(step > 0))
            return;
        constexpr double rounding = 1e-9;
        double const steps = std::floor((limits->second - limits->first) / step + rounding);
        if (steps >= static_cast<double>(most_points))
            return lists_.fault(line_, "dimensions.range",
                                fmt::format("more than {} values, expected a larger step", most_points));
        dimension_.columns = {key->name()};
        for (int i = 0; i <= static_cast<int>(steps); ++i)
            dimension_.rows.push_back({KeyCells::cell(*key, of_kind(*key, limits->first + i * step))});
    }

    static KeyValue of_kind(Key const& key, double value) {
        if (key.kind == KeyKind::integer)
            return static_cast<std::int64_t>(std::llround(value));
        return std::stod(fmt::format("{:.12g}", value));  // as one writes it: 0.3, not 0.30000000000000004
    }

    /// 1 unless given; 0 if it is no good.
    double read_step(Key const& key) const {
        MapEntry const* const entry = find("step");
        if (entry == nullptr)
            return 1;
        auto const step = entry->value.IsScalar() ? parse_number(entry->value.Scalar()) : std::nullopt;
        bool const is_whole = step && std::floor(*step) == *step;
        if (step && *step > 0 && (is_whole || key.kind != KeyKind::integer))
            return *step;
        lists_.reject(*entry, key.kind == KeyKind::integer ? "a whole number above 0" : "a number above 0");
        return 0;
    }

    static bool is_column_name(YAML::Node const& node) {
        return node.IsScalar() && is_plain_text(node.Scalar()) &&
               node.Scalar().find_first_of(". \t,\"") == std::string::npos;
    }

    void read_overlay() {
        MapEntry const& name = *find("overlay");
        MapEntry const* const files = need("files", "a list of configuration files");
        std::vector<std::string> const& taken = result_columns();
        if (!is_column_name(name.value))
            return lists_.reject(name, "a name for the column, one word without points");
        if (std::find(taken.begin(), taken.end(), name.value.Scalar()) != taken.end())
            return lists_.reject(name, "another name, results.csv has a column of this one");
        if (files == nullptr)
            return;
        if (!files->value.IsSequence() || files->value.size() == 0)
            return lists_.reject(*files, "a list of configuration files");
        dimension_.columns = {name.value.Scalar()};
        for (YAML::Node const& file : files->value)
            if (auto const path = cells_.path("files", file, file.Mark().line + 1))
                dimension_.rows.push_back({{file.Scalar(), "", *path}});
    }

    void read_zip() {
        MapEntry const& zip = *find("zip");
        if (!zip.value.IsMap())
            return lists_.reject(zip, "a map from keys to lists of the same length");
        for (MapEntry const& entry : read_entries(zip.value, "zip.", cells_.faults()))
            if (Key const* const key = cells_.key(entry.name, entry.line))
                add_zipped(entry, lists_.cells_of(*key, entry, false));
    }

    void add_zipped(MapEntry const& entry, std::vector<Cell> const& cells) {
        if (dimension_.columns.empty())
            dimension_.rows.resize(cells.size());
        dimension_.columns.push_back(entry.name);
        if (cells.size() != dimension_.rows.size())
            return lists_.fault(entry.line, entry.name,
                                fmt::format("{} values, expected {} as in {}", cells.size(), dimension_.rows.size(),
                                            dimension_.columns.front()));
        for (std::size_t i = 0; i < cells.size(); ++i)
            dimension_.rows[i].push_back(cells[i]);
    }

    /// Of the entry of that name.
    std::optional<std::int64_t> whole_number(std::string const& name, std::int64_t least, std::int64_t most,
                                             std::string const& meaning) const {
        MapEntry const* const entry = need(name, meaning);
        return entry == nullptr ? std::nullopt : lists_.whole_number(*entry, least, most);
    }

    void read_random() {
        auto const count = whole_number("count", 1, most_rows, "how many");
        auto const seed = whole_number("seed", 0, INT64_MAX, "a whole number, so that the draws can be repeated");
        MapEntry const& random = *find("random");
        if (!random.value.IsMap())
            return lists_.reject(random,
                                 "a map from keys to {range: [2, 64]}, {log_range: [2, 64]} or {choices: [...]}");
        dimension_ = random_dimension(random, count.value_or(1), static_cast<std::uint64_t>(seed.value_or(0)), lists_);
    }

    void read_seeds() {
        auto const count = whole_number("count", 1, most_rows, "how many");
        auto const first = find("first") == nullptr ? std::optional<std::int64_t>(1)
                                                    : lists_.whole_number(*find("first"), 0, INT32_MAX);
        std::vector<Key const*> const keys = seed_keys(*find("seeds"));
        for (Key const* const key : keys)
            dimension_.columns.push_back(key->name());
        for (std::int64_t i = 0; i < count.value_or(1); ++i) {
            dimension_.rows.emplace_back();
            for (Key const* const key : keys)
                dimension_.rows.back().push_back(KeyCells::cell(*key, KeyValue(first.value_or(1) + i)));
        }
    }

    std::vector<Key const*> seed_keys(MapEntry const& entry) const {
        std::vector<Key const*> keys;
        bool const is_list = entry.value.IsSequence() && entry.value.size() > 0;
        if (!is_list)
            lists_.reject(entry, "a list of keys, e.g. [workload.samples.seed]");
        for (YAML::Node const& name : is_list ? entry.value : YAML::Node(YAML::NodeType::Sequence)) {
            Key const* const key = cells_.key(name.IsScalar() ? name.Scalar() : shown(name), entry.line);
            if (key != nullptr && key->text.name.substr(key->text.name.rfind('.')) != ".seed")
                lists_.fault(entry.line, key->name(),
                             "is no seed, expected workload.samples.seed or workload.scene.seed");
            else if (key != nullptr)
                keys.push_back(key);
        }
        return keys;
    }

    int line_;
    KeyCells const& cells_;
    ValueLists lists_;
    std::vector<MapEntry> entries_;
    Dimension dimension_;
};

}  // namespace

std::optional<Dimension> read_dimension(YAML::Node const& item, int line, KeyCells const& cells) {
    return DimensionReader(line, cells).dimension(item);
}

}  // namespace dataflow::sweeps
