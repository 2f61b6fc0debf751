#include "dataflow/run/config/value_reader.hpp"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <map>

#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/utf8.hpp"
#include "dataflow/run/config/plain_text.hpp"

namespace dataflow {
namespace {

/// yaml-cpp's tag of a quoted scalar. A plain one has "?", one made by us none.
constexpr char const* quoted_tag = "!";
constexpr char const* plain_tag = "?";

bool is_quoted(YAML::Node const& node) { return node.Tag() == quoted_tag; }
bool is_plain_scalar(YAML::Node const& node) {
    return node.IsScalar() && (node.Tag().empty() || node.Tag() == plain_tag);
}

int line_of(YAML::Node const& node, int otherwise) { return node.Mark().is_null() ? otherwise : node.Mark().line + 1; }

/// Reads one value, of a key or of a part of it (`name` is then like "workload.offset[1]").
class ValueReader {
  public:
    ValueReader(std::string name, int line, std::filesystem::path const& folder, KeyFaults& faults)
        : name_(std::move(name)), line_(line), folder_(folder), faults_(faults) {}

    std::optional<KeyValue> read(Key const& key, YAML::Node const& node) const {
        switch (key.kind) {
            case KeyKind::boolean:
                return plain(key, node, parse_boolean, [](bool) { return true; });
            case KeyKind::integer:
                return plain(key, node, parse_integer,
                             [&key](std::int64_t value) { return accepts(key.integers, value); });
            case KeyKind::number:
                return plain(key, node, parse_number, [&key](double value) { return accepts(key.numbers, value); });
            case KeyKind::choice:
                return choice(key, node);
            case KeyKind::path:
                return path(key, node);
            case KeyKind::object:
                return held(object(node, expectation(key)));
            case KeyKind::vector:
                return held(vector(node, expectation(key)));
            case KeyKind::items:
                return items(key, node);
        }
        return std::nullopt;
    }

    std::optional<ItemValue> item(std::vector<ItemField> const& fields, YAML::Node const& node) const {
        if (!node.IsMap()) {
            expected(node, "a map");
            return std::nullopt;
        }
        std::size_t const faults_before = faults_.size();
        ItemValue result;
        for (ItemField const& field : fields) {
            result.fields.emplace_back(field.text.name, field.otherwise);
        }
        std::vector<std::string> given;
        for (MapEntry const& entry : read_entries(node, name_ + '.', faults_)) {
            read_field(fields, entry, result);
            given.push_back(entry.name);
        }
        require_fields(fields, given);
        return faults_.size() == faults_before ? std::optional{result} : std::nullopt;
    }

  private:
    template <class Part> static std::optional<KeyValue> held(std::optional<Part> const& part) {
        return part ? std::optional<KeyValue>{*part} : std::nullopt;
    }

    void expected(YAML::Node const& node, std::string const& what) const {
        int const stands_in = line_of(node, line_);
        std::string const where = stands_in < line_ ? fmt::format(" (in line {})", stands_in) : "";  // for an alias
        faults_.push_back({line_, name_, shown(node) + where, "expected " + what});
    }

    ValueReader element(std::size_t index, YAML::Node const& node) const {
        return {fmt::format("{}[{}]", name_, index), std::max(line_of(node, line_), line_), folder_, faults_};
    }

    template <class Parse, class Accepts>
    std::optional<KeyValue> plain(Key const& key, YAML::Node const& node, Parse parse, Accepts is_accepted) const {
        auto const value = is_plain_scalar(node) ? parse(node.Scalar()) : std::nullopt;
        if (!value || !is_accepted(*value)) {
            expected(node, expectation(key) + bound_passed(key, node));
            return std::nullopt;
        }
        return held(value);
    }

    /// By an integer that would be accepted if it could be kept.
    static std::string bound_passed(Key const& key, YAML::Node const& node) {
        constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
        bool const is_open = key.kind == KeyKind::integer && key.integers.max == most;
        bool const is_too_long =
            is_open && is_plain_scalar(node) && is_integer_text(node.Scalar()) && !parse_integer(node.Scalar());
        return is_too_long ? fmt::format(", up to {}", most) : "";
    }

    std::optional<KeyValue> choice(Key const& key, YAML::Node const& node) const {
        auto const name = text(node);
        if (!name || std::find(key.choices.begin(), key.choices.end(), *name) == key.choices.end()) {
            expected(node, expectation(key) + did_you_mean(name.value_or(""), key.choices));
            return std::nullopt;
        }
        return name;
    }

    std::optional<KeyValue> path(Key const& key, YAML::Node const& node) const {
        auto const name = text(node);
        if (!name) {
            expected(node, expectation(key));
            return std::nullopt;
        }
        return name->empty() ? *name : beside_folder(*name);
    }

    std::optional<std::string> object(YAML::Node const& node, std::string const& expectation) const {
        auto const name = text(node);
        if (!name || name->empty()) {
            expected(node, expectation);
            return std::nullopt;
        }
        return is_bare_name(*name) ? *name : beside_folder(*name);
    }

    std::optional<std::array<double, 3>> vector(YAML::Node const& node, std::string const& expectation) const {
        if (!node.IsSequence() || node.size() != 3) {
            expected(node, expectation);
            return std::nullopt;
        }
        std::array<double, 3> values{};
        bool is_good = true;
        for (std::size_t index = 0; index < values.size(); ++index) {
            YAML::Node const item = node[index];
            auto const value = is_plain_scalar(item) ? parse_number(item.Scalar()) : std::nullopt;
            if (!value) {
                element(index, item).expected(item, "a number");
                is_good = false;
            }
            values[index] = value.value_or(0);
        }
        return is_good ? std::optional{values} : std::nullopt;
    }

    std::optional<KeyValue> items(Key const& key, YAML::Node const& node) const {
        if (!node.IsSequence()) {
            expected(node, expectation(key));
            return std::nullopt;
        }
        std::vector<ItemValue> result;
        for (std::size_t index = 0; index < node.size(); ++index) {
            if (auto const one = element(index, node[index]).item(key.fields, node[index])) {
                result.push_back(*one);
            }
        }
        return result.size() == node.size() ? std::optional<KeyValue>{result} : std::nullopt;
    }

    void read_field(std::vector<ItemField> const& fields, MapEntry const& entry, ItemValue& result) const {
        ValueReader const reader(name_ + '.' + entry.name, entry.line, folder_, faults_);
        for (std::size_t index = 0; index < fields.size(); ++index) {
            if (fields[index].text.name == entry.name) {
                reader.read_part(fields[index], entry.value, result.fields[index].second);
                return;
            }
        }
        faults_.push_back({entry.line, reader.name_, std::nullopt,
                           fmt::format("unknown key, expected one of {}", fmt::join(names_of(fields), ", "))});
    }

    void read_part(ItemField const& field, YAML::Node const& node, ItemPart& part) const {
        std::string const what = expectation(key_of(field));
        if (field.kind == KeyKind::object) {
            part = object(node, what).value_or("");
        } else {
            part = vector(node, what).value_or(std::array<double, 3>{});
        }
    }

    static std::vector<std::string> names_of(std::vector<ItemField> const& fields) {
        std::vector<std::string> names;
        names.reserve(fields.size());
        for (ItemField const& field : fields) {
            names.push_back(field.text.name);
        }
        return names;
    }

    void require_fields(std::vector<ItemField> const& fields, std::vector<std::string> const& given) const {
        for (ItemField const& field : fields) {
            if (field.required && std::find(given.begin(), given.end(), field.text.name) == given.end()) {
                faults_.push_back({line_, name_, std::nullopt, "no key " + field.text.name + ", expected one"});
            }
        }
    }

    /// Quoted text, or a plain word that YAML does not take for something else.
    std::optional<std::string> text(YAML::Node const& node) const {
        bool const is_text = node.IsScalar() && (is_quoted(node) || node.Tag().empty() ||
                                                 (is_plain_scalar(node) && is_plain_text(node.Scalar())));
        if (!is_text || node.Scalar().find_first_of("\t\r\n") != std::string::npos || first_bad_byte(node.Scalar())) {
            return std::nullopt;
        }
        return node.Scalar();
    }

    std::string beside_folder(std::string const& path) const { return (folder_ / path).lexically_normal().string(); }

    std::string name_;
    int line_;
    std::filesystem::path const& folder_;
    KeyFaults& faults_;
};

}  // namespace

std::optional<KeyValue> read_value(Key const& key, YAML::Node const& node, int line,
                                   std::filesystem::path const& folder, KeyFaults& faults) {
    return ValueReader(key.name(), line, folder, faults).read(key, node);
}

std::vector<MapEntry> read_entries(YAML::Node const& map, std::string const& prefix, KeyFaults& faults) {
    std::vector<MapEntry> entries;
    std::map<std::string, int> first_lines;
    for (auto const& pair : map) {
        int const line = line_of(pair.first, line_of(map, 1));
        if (!pair.first.IsScalar()) {
            faults.push_back({line, prefix + shown(pair.first), std::nullopt, "not a name, expected a key"});
            continue;
        }
        std::string const name = pair.first.Scalar();
        auto const [first, is_new] = first_lines.try_emplace(name, line);
        if (!is_new) {
            faults.push_back({line, prefix + shortened(name), std::nullopt,
                              fmt::format("stands twice, expected once (first in line {})", first->second)});
            continue;
        }
        entries.push_back({name, line, pair.second});
    }
    return entries;
}

std::string shown(YAML::Node const& node) {
    switch (node.Type()) {
        case YAML::NodeType::Map:
            return "a map";
        case YAML::NodeType::Sequence:
            return fmt::format("a list of {}", node.size());
        case YAML::NodeType::Scalar:
            break;
        default:
            return "nothing";
    }
    if (is_quoted(node)) {
        return '"' + shortened(node.Scalar()) + '"';
    }
    return shortened(is_plain_scalar(node) ? node.Scalar() : node.Tag() + ' ' + node.Scalar());
}

}  // namespace dataflow
