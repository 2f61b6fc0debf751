#pragma once
#include <string>
#include <variant>

#include "kernel/config/key_value.hpp"

namespace faster {

/// The value as people write it on the command line: text without the quotes of JSON.
inline std::string plain_text(KeyValue const& value) {
    auto const* const word = std::get_if<std::string>(&value);
    return word != nullptr ? *word : json_text(value);
}

}  // namespace faster
