#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace faster::fuzz {

/// One reader, or the engine, fed with any bytes. An InputError is a fine answer to them; any other exception, a crash,
/// a hang or a sanitizer's report is not.
struct Target {
    char const* name;
    char const* feeds;  ///< what the bytes are
    void (*run)(std::string_view bytes);
};

std::vector<Target> const& targets();

/// The target of that name, or null.
Target const* find_target(std::string_view name);

/// Runs a target on bytes, an InputError included. Other exceptions pass through.
void feed(Target const& target, std::string_view bytes);

}  // namespace faster::fuzz
