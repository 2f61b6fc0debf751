#include "dataflow/tools/sweeps/point_identity.hpp"

#include <fmt/format.h>

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/fnv1a.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"

namespace dataflow::sweeps {

namespace {

/// Length first, so that no two lists of files look the same.
void add_file(std::filesystem::path const& path, Fnv1a& hash) {
    std::string const bytes = io::read_file(path);
    hash.add(fmt::format("{}:", bytes.size()));
    hash.add(bytes);
}

}  // namespace

PointIdentity Identifier::identity(RunConfig const& config) {
    bool const depends_on_time = makes_attempts(machine_of(config));
    Fnv1a point, function;
    for (Key const& key : figure_keys()) {
        std::string const line = key.name() + "=" + text_of(key, config) + "\n";
        point.add(line);
        if (depends_on_time || !is_retimable(key, config))
            function.add(line);
    }
    return {point.digits(), function.digits()};
}

std::string Identifier::text_of(Key const& key, RunConfig const& config) {
    KeyValue const value = key.read(config);
    if (key.kind == KeyKind::path && !std::get<std::string>(value).empty())
        return content(std::get<std::string>(value));
    if (key.kind == KeyKind::object)
        return object(std::get<std::string>(value));
    if (key.kind != KeyKind::items)
        return json_text(value);
    auto items = std::get<std::vector<ItemValue>>(value);
    for (ItemValue& item : items)
        for (std::size_t i = 0; i < key.fields.size(); ++i)
            if (key.fields[i].kind == KeyKind::object)
                item.fields[i].second = object(std::get<std::string>(item.fields[i].second));
    return json_text(items);
}

/// What has a bare name is part of this program. What a file means depends on its ending too.
std::string Identifier::object(std::string const& name) {
    if (is_bare_name(name))
        return name;
    return std::filesystem::path(name).extension().string() + ":" + content(name);
}

std::string const& Identifier::content(std::filesystem::path const& path) {
    auto const known = contents_.find(path);
    if (known != contents_.end())
        return known->second;
    Fnv1a hash;
    if (std::filesystem::is_directory(path))
        for (std::filesystem::path const& file : design().files_of(path))
            add_file(file, hash);
    else
        add_file(path, hash);
    return contents_[path] = hash.digits();
}

}  // namespace dataflow::sweeps
