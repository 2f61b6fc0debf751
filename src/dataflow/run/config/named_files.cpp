#include "dataflow/run/config/named_files.hpp"

#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"

namespace dataflow {

namespace {

namespace fs = std::filesystem;

void add(std::string const& name, std::vector<fs::path>& files) {
    if (std::error_code error; name.empty() || !fs::exists(name, error))
        return;
    files.emplace_back(name);
    if (!fs::is_directory(name))
        return;
    try {
        for (fs::path const& file : design().files_of(name))
            files.push_back(file);
    } catch (InputError const&) {  // whoever reads it says what is wrong
    }
}

/// A bare name is no file, even if the current folder has one of that name.
void add_object(std::string const& name, std::vector<fs::path>& files) {
    if (!is_bare_name(name))
        add(name, files);
}

}  // namespace

std::vector<fs::path> named_files(RunConfig const& config) {
    std::vector<fs::path> files;
    for (Key const& key : all_keys()) {
        KeyValue const value = key.read(config);
        if (key.kind == KeyKind::path)
            add(std::get<std::string>(value), files);
        if (key.kind == KeyKind::object)
            add_object(std::get<std::string>(value), files);
        if (key.kind != KeyKind::items)
            continue;
        for (ItemValue const& item : std::get<std::vector<ItemValue>>(value))
            for (auto const& [field, content] : item.fields)
                if (auto const* const name = std::get_if<std::string>(&content))
                    add_object(*name, files);
    }
    return files;
}

}  // namespace dataflow
