#include "faster/workload/files/mesh_import.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_builder.hpp"
#include "faster/workload/files/mesh_readers.hpp"

namespace faster::files {
namespace {

namespace fs = std::filesystem;

void read_mesh(fs::path const& path, std::string_view file, MeshBuilder& mesh) {
    std::string const extension = lower_case_extension(path);
    if (extension == ".obj")
        read_obj(path, file, mesh);
    else if (extension == ".ply")
        read_ply(path, file, mesh);
    else if (extension == ".stl")
        read_stl(path, file, mesh);
    else
        read_off(path, file, mesh);
}

}  // namespace

std::string lower_case_extension(fs::path const& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return extension;
}

Mesh import_mesh(fs::path const& path) {
    std::string const file = read_file(path);
    std::string_view const mark = std::string_view(file).substr(0, 2);
    if ((mark == "\xFF\xFE" || mark == "\xFE\xFF") && lower_case_extension(path) != ".stl")
        fail(path, "is text in UTF-16, expected ASCII or UTF-8");
    MeshBuilder builder;
    read_mesh(path, file, builder);
    Mesh mesh = builder.mesh();
    if (mesh.faces.empty())
        fail(path, "has no triangles, expected at least one");
    return mesh;
}

}  // namespace faster::files
