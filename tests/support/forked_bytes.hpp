#pragma once
#include <functional>
#include <string>

namespace faster::testing {

/// What a function returns in a process of its own, for a program has one design and its keys. Errors:
/// std::runtime_error if a signal ends the process, or it fails.
std::string forked_bytes(std::function<std::string()> const& work);

}  // namespace faster::testing
