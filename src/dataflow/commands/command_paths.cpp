#include "dataflow/commands/command_paths.hpp"

#include <fmt/format.h>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/named_files.hpp"

namespace dataflow {

namespace {

namespace fs = std::filesystem;

/// As far as links can be followed; what is wrong with the others is found by who opens them.
fs::path resolved(fs::path const& path) {
    std::error_code error;
    fs::path known = fs::weakly_canonical(fs::absolute(path), error);
    if (error)
        known = fs::absolute(path).lexically_normal();
    return known.has_filename() ? known : known.parent_path();
}

}  // namespace

void CommandPaths::reads(fs::path const& path) { add("", path, nullptr); }

void CommandPaths::reads(RunConfig const& config) {
    for (fs::path const& file : named_files(config))
        reads(file);
}

void CommandPaths::reads(fs::path const& path, io::FolderKind const& kind) { add("", path, &kind); }

void CommandPaths::writes(std::string const& what, fs::path const& file) { add(what, file, nullptr); }

void CommandPaths::writes(std::string const& what, fs::path const& folder, io::FolderKind const& kind) {
    add(what, folder, &kind);
}

void CommandPaths::add(std::string const& what, fs::path const& given, io::FolderKind const* kind) {
    std::error_code error;
    bool const is_wrong = !what.empty() && kind == nullptr && fs::is_directory(given, error);  // who writes says so
    if (given.empty() || io::is_device(given) || is_wrong)
        return;
    GivenPath const place{what, given, resolved(given), kind};
    for (GivenPath const& other : paths_)
        if (!(what.empty() && other.what.empty()))
            require_apart(other, place);
    paths_.push_back(place);
}

/// Whether a path is that place, or below it: in a folder of results only what is of its kind, and nothing can be below
/// a file that is written.
bool CommandPaths::covers(GivenPath const& place, fs::path const& path) {
    fs::path const below = path.lexically_relative(place.path);
    if (below.empty() || *below.begin() == "..")
        return false;
    if (below == ".")
        return true;
    return place.kind != nullptr ? place.kind->has(below.begin()->string()) : !place.what.empty();
}

void CommandPaths::require_apart(GivenPath const& older, GivenPath const& newer) {
    if (!covers(older, newer.path) && !covers(newer, older.path))
        return;
    if (!older.what.empty() && !newer.what.empty())
        throw InputError(fmt::format("{} {} and {} {}: one would replace the other, expected different paths",
                                     older.what, older.given.string(), newer.what, newer.given.string()));
    GivenPath const& output = older.what.empty() ? newer : older;
    GivenPath const& input = older.what.empty() ? older : newer;
    throw InputError(fmt::format("{} {}: would replace {}, which is read, expected another path", output.what,
                                 output.given.string(), input.given.string()));
}

}  // namespace dataflow
