#include "dataflow/tools/sweeps/key_cells.hpp"

#include <fmt/format.h>

#include "dataflow/base/printable.hpp"
#include "dataflow/base/utf8.hpp"
#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/run/config/value_reader.hpp"

namespace dataflow::sweeps {

Key const* KeyCells::key(std::string const& name, int line) const {
    Key const* const found = find_key(name);
    if (found == nullptr && is_section(name))
        faults_.push_back(
            {line, shortened(name), std::nullopt,
             fmt::format("is a section, expected a key in it, one of {}", fmt::join(names_in_section(name), ", "))});
    else if (found == nullptr)
        faults_.push_back({line, shortened(name), std::nullopt, unknown_key_problem(name)});
    return found;
}

std::optional<Cell> KeyCells::cell(Key const& key, YAML::Node const& value, int line) const {
    auto const read = read_value(key, value, line, folder_, faults_);
    if (!read)
        return std::nullopt;
    Cell made = cell(key, *read);
    if (value.IsScalar() && std::holds_alternative<std::string>(*read))
        made.text = value.Scalar();  // a path as it was written, wherever the caller stands
    return made;
}

Cell KeyCells::cell(Key const& key, KeyValue const& value) {
    std::string const text = plain_text(value);
    return {text, key.name() + "=" + text, {}};
}

std::optional<std::filesystem::path> KeyCells::path(std::string const& name, YAML::Node const& value, int line) const {
    if (!value.IsScalar() || value.Scalar().empty() || first_bad_byte(value.Scalar())) {
        faults_.push_back({line, name, shown(value), "expected a path of a configuration file, relative to this file"});
        return std::nullopt;
    }
    return (folder_ / value.Scalar()).lexically_normal();
}

}  // namespace dataflow::sweeps
