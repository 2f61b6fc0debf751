#pragma once
#include <filesystem>

#include "kernel/compare/json_section.hpp"
#include "kernel/compare/run_record.hpp"

namespace faster::runs {

/// The JSON of a summary.json. Throws InputError if it is none, for example cut off.
Json parse_summary(std::filesystem::path const& path);

/// What a summary.json tells about a run: all of a RunRecord but folder and samples. Throws InputError for another
/// format or version, a missing or impossible value, and for tables in which a core lacks an item that another has, or
/// has one twice.
RunRecord read_summary(JsonSection const& summary);

}  // namespace faster::runs
