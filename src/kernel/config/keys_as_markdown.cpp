#include "kernel/config/keys_as_markdown.hpp"

#include <fmt/format.h>

#include "kernel/config/keys.hpp"

namespace faster {
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

/// The keys of one item of the list, below the row of the list itself.
std::string scene_object_rows() {
    SceneObjectConfig const defaults;
    std::string rows;
    for (SceneObjectKey const& key : scene_object_keys()) {
        Key typed;
        typed.kind = key.kind;
        std::string const value = key.required ? "" : json_text(defaults.*key.numbers);
        rows += row(key.text, "workload.scene.objects[i]." + key.text.name, range_text(typed), value);
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
        if (key.kind == KeyKind::objects) {
            text += scene_object_rows();
        }
    }
    return text;
}

}  // namespace faster
