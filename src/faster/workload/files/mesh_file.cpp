#include "faster/workload/files/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <new>

#include "dataflow/base/confinement.hpp"
#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/process_pool.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_import.hpp"

namespace faster::files {

namespace {

using Face = std::array<std::uint32_t, 3>;
constexpr std::size_t vertex_size = 3 * sizeof(double);

struct Counts {
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
};

void put(void const* bytes, std::size_t count, std::string& text) {
    text.append(static_cast<char const*>(bytes), count);
}

namespace fs = std::filesystem;
using processes::Outcome;

/// The first byte of what the child sends.
enum Reply : char { reply_mesh = 'm', reply_complaint = 'c', reply_host = 'h', reply_no_memory = 'n' };

std::string reply_of(fs::path const& path, MeshLimits const& limits) {
    try {
        processes::confine_process(limits.memory_bytes());
        return char{reply_mesh} + mesh_bytes(import_mesh(path));
    } catch (HostError const& error) {
        return char{reply_host} + std::string(error.what());
    } catch (InputError const& error) {
        return char{reply_complaint} + std::string(error.what());
    } catch (std::bad_alloc const&) {
        return {reply_no_memory};
    }
}

[[noreturn]] void fail_reading(fs::path const& path, std::string const& why, std::string const& way_out = {}) {
    fail(path, fmt::format("cannot be read as a mesh ({}), expected a valid {} file{}", why,
                           lower_case_extension(path).substr(1), way_out));
}

[[noreturn]] void fail_limit(fs::path const& path, std::string const& why, MeshLimits const& limits,
                             char const* limit) {
    fail_reading(path, why, limits.section.empty() ? "" : fmt::format(", or a larger {}.{}", limits.section, limit));
}

void require_readable(fs::path const& path, MeshLimits const& limits) {
    if (require_mesh_file(path) > limits.file_bytes())
        fail_limit(path, fmt::format("it is longer than {} MiB", limits.file_mib), limits, "file_limit_mib");
}

Mesh mesh_of(fs::path const& path, MeshLimits const& limits, Outcome const& outcome) {
    if (outcome.kind == Outcome::Kind::timed_out)
        fail_limit(path, fmt::format("it took more than {:g} s", limits.seconds), limits, "time_limit_s");
    if (outcome.kind == Outcome::Kind::crashed && outcome.signal == SIGKILL)
        throw HostError(path.string() + ": cannot be read (the process that reads it was killed)");
    if (outcome.kind == Outcome::Kind::crashed)
        fail_reading(path, fmt::format("the process that reads it crashed: {}", strsignal(outcome.signal)));
    std::string_view const output = outcome.output;
    if (outcome.kind == Outcome::Kind::done && !output.empty()) {
        if (output.front() == reply_host)
            throw HostError(std::string(output.substr(1)));
        if (output.front() == reply_complaint)
            throw InputError(std::string(output.substr(1)));
        if (output.front() == reply_no_memory)
            fail_limit(path, fmt::format("it took more than {} MiB of memory", limits.memory_mib), limits,
                       "memory_limit_mib");
        if (auto mesh = output.front() == reply_mesh ? mesh_from_bytes(output.substr(1)) : std::nullopt)
            return std::move(*mesh);
    }
    fail_reading(path, "the process that reads it failed");
}

}  // namespace

std::string mesh_bytes(Mesh const& mesh) {
    Counts const counts{mesh.vertices.size(), mesh.faces.size()};
    std::string text;
    text.reserve(sizeof counts + mesh.vertices.size() * vertex_size + mesh.faces.size() * sizeof(Face));
    put(&counts, sizeof counts, text);
    for (Eigen::Vector3d const& vertex : mesh.vertices)
        put(vertex.data(), vertex_size, text);
    put(mesh.faces.data(), mesh.faces.size() * sizeof(Face), text);
    return text;
}

std::optional<Mesh> mesh_from_bytes(std::string_view bytes) {
    Counts counts;
    if (bytes.size() < sizeof counts)
        return std::nullopt;
    std::memcpy(&counts, bytes.data(), sizeof counts);
    bytes.remove_prefix(sizeof counts);
    if (counts.vertices > bytes.size() / vertex_size || counts.faces > bytes.size() / sizeof(Face) ||
        counts.vertices * vertex_size + counts.faces * sizeof(Face) != bytes.size())
        return std::nullopt;
    Mesh mesh;
    mesh.vertices.resize(counts.vertices);
    for (Eigen::Vector3d& vertex : mesh.vertices) {
        std::memcpy(vertex.data(), bytes.data(), vertex_size);
        bytes.remove_prefix(vertex_size);
    }
    mesh.faces.resize(counts.faces);
    if (!bytes.empty())
        std::memcpy(mesh.faces.data(), bytes.data(), bytes.size());
    auto const is_there = [&](std::uint32_t vertex) { return vertex < counts.vertices; };
    auto const is_sound = [&](Face const& face) { return std::all_of(face.begin(), face.end(), is_there); };
    bool const is_finite = std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                                       [](Eigen::Vector3d const& vertex) { return vertex.allFinite(); });
    if (!is_finite || !std::all_of(mesh.faces.begin(), mesh.faces.end(), is_sound))
        return std::nullopt;
    return mesh;
}

std::vector<std::string> const& mesh_extensions() {
    static std::vector<std::string> const extensions{".obj", ".ply", ".stl", ".off"};
    return extensions;
}

bool has_mesh_extension(fs::path const& path) {
    auto const& known = mesh_extensions();
    return std::find(known.begin(), known.end(), lower_case_extension(path)) != known.end();
}

std::uint64_t require_mesh_file(fs::path const& path) {
    require_file(path);
    if (!has_mesh_extension(path))
        fail(path,
             fmt::format("is of an unknown format, expected a mesh file ({})", fmt::join(mesh_extensions(), ", ")));
    std::error_code error;
    auto const size = fs::file_size(path, error);
    if (error)
        fail(path, "is no regular file, expected a mesh file");
    return size;
}

std::vector<Mesh> load_meshes(std::vector<fs::path> const& paths, MeshLimits const& limits, std::size_t jobs) {
    std::vector<processes::Task> tasks;
    for (fs::path const& path : paths) {
        require_readable(path, limits);
        tasks.push_back({[&] { return reply_of(path, limits); }, limits.seconds, limits.memory_bytes()});
    }
    processes::SignalWatch const watch;
    std::vector<Outcome> const outcomes = processes::run_all(tasks, jobs, watch);
    std::vector<Mesh> meshes;
    for (std::size_t i = 0; i < paths.size(); ++i)
        meshes.push_back(mesh_of(paths[i], limits, outcomes[i]));
    return meshes;
}

Mesh load_mesh(fs::path const& path, MeshLimits const& limits) { return std::move(load_meshes({path}, limits, 1)[0]); }

}  // namespace faster::files
