#include "dataflow/run/config/key_value.hpp"

#include <fmt/format.h>

#include "dataflow/base/json.hpp"

namespace dataflow {
namespace {

std::string text_of(bool value) { return value ? "true" : "false"; }
std::string text_of(std::int64_t value) { return fmt::format("{}", value); }
std::string text_of(double value) { return fmt::format("{}", value); }

/// No reader lets control characters pass, but a path may have them from the folder that its file lies in.
std::string text_of(std::string const& value) {
    return Json(value).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string text_of(std::array<double, 3> const& value) {
    return fmt::format("[{}, {}, {}]", value[0], value[1], value[2]);
}

std::string text_of(ItemValue const& value) {
    std::string text = "{";
    for (auto const& [name, part] : value.fields) {
        text += (text.size() > 1 ? ", " : "") + text_of(name) + ": ";
        text += std::visit([](auto const& held) { return text_of(held); }, part);
    }
    return text + '}';
}

std::string text_of(std::vector<ItemValue> const& value) {
    std::string text = "[";
    for (ItemValue const& item : value) {
        text += (text.size() > 1 ? ", " : "") + text_of(item);
    }
    return text + ']';
}

}  // namespace

std::string json_text(KeyValue const& value) {
    return std::visit([](auto const& held) { return text_of(held); }, value);
}

}  // namespace dataflow
