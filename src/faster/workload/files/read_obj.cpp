#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_readers.hpp"
#include "faster/workload/files/mesh_text.hpp"

namespace faster::files {
namespace {

/// Statements of surfaces that are not polygons of this file.
constexpr std::array<std::string_view, 4> foreign_surfaces{"surf", "bzp", "bsp", "cdp"};
/// And of what stands in another file, or comes from another program.
constexpr std::array<std::string_view, 2> inclusions{"call", "csh"};

template <std::size_t count> bool is_one_of(std::array<std::string_view, count> const& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader {
  public:
    ObjReader(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh)
        : text_(path, file), mesh_(mesh) {
        text_.join_lines();
    }

    /// True if there was a vertex or a face.
    bool read() {
        bool is_obj = false;
        while (text_.next_line()) {
            std::string_view const statement = text_.word();
            if (statement == "v")
                read_vertex();
            else if (statement == "f" || statement == "fo")
                read_face();
            else if (is_one_of(inclusions, statement))
                text_.fail(fmt::format("{}: what it includes is not read, expected polygons (f)", statement));
            else if (is_one_of(foreign_surfaces, statement))
                text_.fail(fmt::format("{}: a surface that is not read, expected polygons (f)", statement));
            else
                continue;
            is_obj = true;
        }
        check_forward_references();
        return is_obj;
    }

  private:
    /// A face may name vertices that follow; these are the first to be looked at again.
    struct ForwardReference {
        std::int64_t vertex = 0;
        std::string place;
        std::size_t face = 0;
    };

    void read_vertex() {
        Eigen::Vector3d const vertex = text_.coordinates(mesh_.vertices());
        mesh_.add_vertex(vertex, [this] { return text_.place(); });
    }

    void read_face() {
        corners_.clear();
        for (std::string_view word = text_.word(); !word.empty(); word = text_.word())
            corners_.push_back(vertex_of(word.substr(0, word.find('/')), word));
        mesh_.add_polygon(corners_);
    }

    /// The vertex that a corner names, counted from 0.
    std::uint32_t vertex_of(std::string_view index, std::string_view corner) {
        auto const number = integer_in(index);
        if (!number || *number == 0)
            text_.fail(
                fmt::format("face {} (counted from 0) has {} as a corner, expected the number of a vertex, "
                            "from 1, or from -1 backwards",
                            mesh_.polygons(), shortened(corner)));
        auto const known = static_cast<std::int64_t>(mesh_.vertices());
        std::int64_t const vertex = *number > 0 ? *number - 1 : known + *number;
        if (vertex < 0 || vertex >= most_vertices)
            fail_index({*number, text_.place(), mesh_.polygons()});
        if (vertex >= known && vertex > furthest_.vertex - 1)
            furthest_ = {*number, text_.place(), mesh_.polygons()};
        return static_cast<std::uint32_t>(vertex);
    }

    void check_forward_references() const {
        if (furthest_.vertex > static_cast<std::int64_t>(mesh_.vertices()))
            fail_index(furthest_);
    }

    [[noreturn]] void fail_index(ForwardReference const& reference) const {
        throw InputError(fmt::format(
            "{}: face {} (counted from 0) names vertex {}, which does not exist, expected one of {} vertices",
            reference.place, reference.face, reference.vertex, mesh_.vertices()));
    }

    static constexpr std::int64_t most_vertices = 0xFFFFFFFF;

    MeshText text_;
    MeshBuilder& mesh_;
    std::vector<std::uint32_t> corners_;
    ForwardReference furthest_;
};

}  // namespace

void read_obj(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh) {
    if (!ObjReader(path, file, mesh).read())
        fail(path, "cannot be read as a mesh (no line begins with v or f), expected a valid obj file");
}

}  // namespace faster::files
