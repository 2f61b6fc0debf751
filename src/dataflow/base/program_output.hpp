#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dataflow {

/// What a program of the host writes to stdout when it is given `input` on stdin. `words`: its name, which is looked
/// for in PATH, and its arguments. Nothing if there is no such program; what it complains of is not shown. Errors:
/// HostError if there is one and it fails, is killed or cannot be started, or what it wrote cannot be read.
/// `is_wanted` is asked while it runs; once it is not, it is killed. Empty: it is.
std::optional<std::string> program_output(std::vector<std::string> words, std::string const& input,
                                          std::function<bool()> const& is_wanted = {});

}  // namespace dataflow
