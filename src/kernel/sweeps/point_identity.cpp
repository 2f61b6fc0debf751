#include "kernel/sweeps/point_identity.hpp"

#include <fmt/format.h>

#include "faster/retimable.hpp"
#include "kernel/base/files/text_file.hpp"
#include "kernel/base/fnv1a.hpp"
#include "kernel/config/keys.hpp"
#include "workload/files/trace_manifest.hpp"

namespace faster::sweeps {

namespace {

std::string hexadecimal(Fnv1a const& hash) { return fmt::format("{:016x}", hash.value()); }

/// Length first, so that no two lists of files look the same.
void add_file(std::filesystem::path const& path, Fnv1a& hash) {
    std::string const bytes = io::read_file(path);
    hash.add(fmt::format("{}:", bytes.size()));
    hash.add(bytes);
}

void add_trace(std::filesystem::path const& folder, Fnv1a& hash) {
    std::filesystem::path const manifest = folder / io::TraceManifest::file_name;
    io::TraceManifest::Files const files = io::read_manifest(manifest).files;
    add_file(manifest, hash);
    for (std::string const& file : {files.samples, files.triangles, files.depth, files.edges})
        add_file(folder / file, hash);
}

}  // namespace

PointIdentity Identifier::identity(RunConfig const& config) {
    Fnv1a point, function;
    for (Key const& key : all_keys()) {
        if (key.name() == "simulation.engine")
            continue;
        std::string const line = key.name() + "=" + text_of(key, config) + "\n";
        point.add(line);
        if (!is_retimable(key, config.accelerator))
            function.add(line);
    }
    return {hexadecimal(point), hexadecimal(function)};
}

std::string Identifier::text_of(Key const& key, RunConfig const& config) {
    KeyValue const value = key.read(config);
    if (key.kind == KeyKind::path && !std::get<std::string>(value).empty())
        return content(std::get<std::string>(value));
    if (key.kind == KeyKind::object)
        return object(std::get<std::string>(value));
    if (key.kind != KeyKind::objects)
        return json_text(value);
    auto objects = std::get<std::vector<SceneObjectConfig>>(value);
    for (SceneObjectConfig& item : objects)
        item.object = object(item.object);
    return json_text(objects);
}

/// A class is a bare name, and part of this program. What a mesh file means depends on its ending too.
std::string Identifier::object(std::string const& name) {
    if (name.find_first_of("/.") == std::string::npos)
        return name;
    return std::filesystem::path(name).extension().string() + ":" + content(name);
}

std::string const& Identifier::content(std::filesystem::path const& path) {
    auto const known = contents_.find(path);
    if (known != contents_.end())
        return known->second;
    Fnv1a hash;
    if (std::filesystem::is_directory(path))
        add_trace(path, hash);
    else
        add_file(path, hash);
    return contents_[path] = hexadecimal(hash);
}

}  // namespace faster::sweeps
