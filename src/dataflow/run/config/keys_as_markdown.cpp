#include "dataflow/run/config/keys_as_markdown.hpp"

#include <fmt/format.h>

#include "dataflow/run/config/keys.hpp"

namespace dataflow {
namespace {

/// "accelerator.fifos" for accelerator.fifos.area.depth, "accelerator" for accelerator.window.
std::string group_of(std::string const& name) {
    std::size_t const first = name.find('.');
    std::size_t const second = name.find('.', first + 1);
    return name.substr(0, second == std::string::npos ? first : second);
}

std::string heading(std::string const& group) {
    return fmt::format(
        "\n### {}\n\n| key | meaning | unit | range | default | source |\n"
        "| --- | --- | --- | --- | --- | --- |\n",
        group);
}

std::string row(KeyText const& text, std::string const& name, std::string const& range, std::string const& value) {
    return fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", name, text.meaning, text.unit.empty() ? "-" : text.unit,
                       range, value.empty() ? "-" : '`' + value + '`', text.source);
}

/// The fields of one item of the list, below the row of the list itself.
std::string rows_of_fields(Key const& list) {
    std::string rows;
    for (ItemField const& field : list.fields) {
        std::string const value =
            field.required ? "" : std::visit([](auto const& held) { return json_text(held); }, field.otherwise);
        rows += row(field.text, list.name() + "[i]." + field.text.name, range_text(key_of(field)), value);
    }
    return rows;
}

/// Choices are written without the quotes of JSON, as people write them.
std::string default_text(Key const& key) {
    KeyValue const value = key.read(RunConfig{});
    auto const* const text = std::get_if<std::string>(&value);
    return text != nullptr && !text->empty() ? *text : json_text(value);
}

}  // namespace

std::string keys_as_markdown() {
    std::string text;
    std::string group;
    for (Key const& key : all_keys()) {
        if (group_of(key.name()) != group) {
            group = group_of(key.name());
            text += heading(group);
        }
        text += row(key.text, key.name(), range_text(key), default_text(key));
        text += rows_of_fields(key);
    }
    return text;
}

}  // namespace dataflow
