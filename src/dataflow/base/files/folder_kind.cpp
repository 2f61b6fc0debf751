#include "dataflow/base/files/folder_kind.hpp"

#include <algorithm>
#include <fnmatch.h>
#include <fstream>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/input_error.hpp"

namespace dataflow::io {
namespace {

namespace fs = std::filesystem;

bool begins_with(fs::path const& file, std::string const& text) {
    std::string begin(text.size(), '\0');
    std::ifstream stream(file, std::ios::binary);
    return stream.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == text;
}

bool says_format(Json const& json, std::string const& format) {
    return json.is_object() && json.value("format", Json()) == Json(format);
}

bool says_format(YAML::Node const& root, std::string const& format) {
    YAML::Node const said = root.IsMap() ? root["format"] : YAML::Node();
    return said && said.IsScalar() && said.Scalar() == format;
}

}  // namespace

bool FolderKind::has(std::string const& file) const {
    return file == marker || std::any_of(others.begin(), others.end(),
                                         [&](std::string const& other) { return *fs::path(other).begin() == file; });
}

bool FolderKind::owns(fs::path const& path) const {
    return path == marker || std::any_of(others.begin(), others.end(), [&](std::string const& other) {
               return fnmatch(other.c_str(), path.c_str(), FNM_PATHNAME | FNM_PERIOD) == 0;
           });
}

bool FolderKind::has_page(fs::path const& folder, fs::path const& path) const {
    if (page.empty() || path != page || !fs::is_regular_file(fs::symlink_status(folder / path)))
        return false;
    try {
        std::string const text = read_file(folder / path);
        return std::any_of(page_texts.begin(), page_texts.end(),
                           [&](std::string const& own) { return text.find(own) != std::string::npos; });
    } catch (InputError const&) {  // nobody knows whose it is
        return false;
    }
}

bool FolderKind::is_kind_of(fs::path const& folder) const {
    fs::path const file = folder / marker;
    if (format.empty() || !fs::is_regular_file(file))
        return format.empty() && fs::exists(file);
    try {
        if (file.extension() == ".json")
            return says_format(read_json_file(file, name), format);
        if (file.extension() == ".yaml")
            return says_format(load_document(file), format);
        return begins_with(file, format);
    } catch (HostError const&) {
        throw;
    } catch (InputError const&) {  // something else
        return false;
    }
}

}  // namespace dataflow::io
