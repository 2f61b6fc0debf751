#include "dataflow/tools/compare/json_section.hpp"

#include <fmt/format.h>
#include <utility>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/program_name.hpp"

namespace dataflow::runs {

JsonSection::JsonSection(std::string file, std::string name, Json const& object)
    : file_(std::move(file)), name_(std::move(name)), object_(object) {
    if (!object_.is_object())
        throw InputError(fmt::format("{}: {} is {}, expected an object", file_, name_.empty() ? "the file" : name_,
                                     io::shown(object_)));
}

Json const& JsonSection::at(std::string const& key) const {
    auto const found = object_.find(key);
    if (found == object_.end())
        throw InputError(
            fmt::format("{}: no key {}, expected one as {} run writes it", file_, path_of(key), program_name()));
    return *found;
}

Json const& JsonSection::array_at(std::string const& key) const {
    Json const& value = at(key);
    if (!value.is_array())
        fail(key, "an array");
    return value;
}

JsonSection JsonSection::row(std::string const& key, Json const& rows, std::size_t i) const {
    return {file_, fmt::format("{}[{}]", path_of(key), i), rows[i]};
}

std::uint64_t JsonSection::integer(std::string const& key, std::uint64_t min, std::uint64_t max) const {
    Json const& value = at(key);
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() < min || value.get<std::uint64_t>() > max)
        fail(key, fmt::format("an integer in {}..{}", min, max));
    return value.get<std::uint64_t>();
}

double JsonSection::number(std::string const& key) const {
    Json const& value = at(key);
    if (!value.is_number() || value.get<double>() < 0)
        fail(key, "a number from 0");
    return value.get<double>();
}

std::string JsonSection::text(std::string const& key) const {
    Json const& value = at(key);
    if (!value.is_string())
        fail(key, "text");
    return value.get<std::string>();
}

void JsonSection::fail(std::string const& key, std::string const& expected) const {
    throw InputError(fmt::format("{}: {} = {}, expected {}", file_, path_of(key), io::shown(at(key)), expected));
}

}  // namespace dataflow::runs
