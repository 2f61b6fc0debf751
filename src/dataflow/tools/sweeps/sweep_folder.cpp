#include "dataflow/tools/sweeps/sweep_folder.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <system_error>

#include "dataflow/base/files/durable_file.hpp"
#include "dataflow/base/files/hidden_name.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"

namespace dataflow::sweeps {

namespace fs = std::filesystem;

namespace {

constexpr char const* manifest_file = "sweep.json";

bool is_hidden(fs::directory_entry const& entry) { return entry.path().filename().string().front() == '.'; }

void remove_partial_files_in(fs::path const& folder) {
    std::error_code ignored;
    for (fs::path const& file : io::all_hidden_in(folder, "partial"))
        fs::remove(file, ignored);
}

}  // namespace

void take_folder(fs::path const& folder, std::string const& kind, std::function<bool()> const& is_of_that_kind) {
    std::error_code error;
    if (fs::exists(folder) && !fs::is_directory(folder))
        throw InputError(fmt::format("{}: is a file, expected a folder for {}", folder.string(), kind));
    fs::create_directories(folder, error);
    if (error)
        throw InputError(folder.string() + ": cannot be made (" + error.message() + ")");
    bool const is_free = std::all_of(fs::directory_iterator(folder), fs::directory_iterator(), is_hidden);
    if (!is_free && !is_of_that_kind())
        throw InputError(
            fmt::format("{}: holds other files, expected a new or empty folder or that of {}", folder.string(), kind));
}

SweepFolder::SweepFolder(fs::path const& folder) : folder_(folder) {
    if (folder_.empty())
        throw InputError("the name of the output folder is empty, expected a path");
    take_folder(folder_, "a sweep", [this] { return fs::exists(folder_ / manifest_file); });
    lock_.emplace(folder_);
}

SweepFolder::~SweepFolder() { remove_partial_files(); }

void SweepFolder::adopt(Manifest const& manifest) {
    if (fs::exists(folder_ / manifest_file)) {
        Manifest const older = read_manifest_of(folder_);
        if (std::string const why = why_no_part_of(older, manifest); !why.empty())
            throw InputError(
                fmt::format("{}: holds the sweep {}: {}; expected the same sweep, or one that only adds "
                            "points, or another --out",
                            folder_.string(), older.sweep, why));
        if (to_text(older) == to_text(manifest))
            return;
    }
    io::write_file_durably(folder_ / manifest_file, to_text(manifest));
}

fs::path SweepFolder::events(std::string const& function) const { return folder_ / "events" / (function + ".events"); }

void SweepFolder::prepare_events() const {
    std::error_code error;
    fs::create_directory(folder_ / "events", error);
    if (error)
        throw InputError((folder_ / "events").string() + ": cannot be made (" + error.message() + ")");
    remove_partial_files();
}

void SweepFolder::remove_partial_files() const {
    remove_partial_files_in(folder_);
    remove_partial_files_in(folder_ / "events");
}

void SweepFolder::remove_events_folder() const {
    std::error_code ignored;
    fs::remove(folder_ / "events", ignored);
}

bool is_sweep_folder(fs::path const& folder) { return fs::exists(folder / manifest_file); }

Manifest read_manifest_of(fs::path const& folder) {
    fs::path const file = folder / manifest_file;
    io::require_folder(folder, "the output folder of a sweep");
    if (!fs::exists(file))
        throw InputError(folder.string() + ": has no " + manifest_file + ", expected the output folder of a sweep");
    return manifest_from_text(io::read_file(file), file.string());
}

}  // namespace dataflow::sweeps
