#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "dataflow/base/json.hpp"

namespace dataflow::sweeps {

// Rows of a file to which results are added as they come: a checksum of 16 letters, a blank, JSON on one line.

/// With its line end.
std::string journal_row(Json const& json);

/// Gives every whole row of `text` to `take`, and returns how many are damaged: cut off, of a wrong checksum, or such
/// that `take` throws a Json::exception.
std::size_t read_journal_rows(std::string_view text, std::function<void(Json const&)> const& take);

/// Whether a file may be one of these, empty or cut off somewhere, and not another's of the same name.
bool may_be_journal(std::string_view text);

}  // namespace dataflow::sweeps
