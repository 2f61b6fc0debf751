#include <algorithm>
#include <cctype>
#include <cstring>
#include <fmt/format.h>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/little_endian.hpp"
#include "dataflow/base/text_lines.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_readers.hpp"
#include "faster/workload/files/mesh_text.hpp"

namespace faster::files {
namespace {

constexpr std::size_t stl_header_bytes = 84;  // of which the last four are the number of triangles
constexpr std::size_t triangle_bytes = 50;
constexpr std::size_t normal_bytes = 12;

std::uint64_t announced_triangles(std::string_view file) { return little_endian_at<4>(file.data() + 80); }

std::string lower_case(std::string_view word) {
    std::string text(word);
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
}

/// Both kinds may begin with "solid"; text has no zeros, and the length of a binary file is that of its triangles.
bool is_text(std::string_view file) {
    if (file.size() >= stl_header_bytes && file.size() == stl_header_bytes + triangle_bytes * announced_triangles(file))
        return false;
    file = without_byte_order_mark(file);
    std::size_t const start = std::min(file.find_first_not_of(" \t\r\n"), file.size());
    return lower_case(file.substr(start, 5)) == "solid" && file.find('\0') == std::string_view::npos;
}

float float_at(char const* bytes) {
    auto const bits = static_cast<std::uint32_t>(little_endian_at<4>(bytes));
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

void read_binary(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh) {
    constexpr char const* ends_early = "cannot be read as a mesh (it ends early), expected a valid stl file";
    if (file.size() < stl_header_bytes)
        fail(path, ends_early);
    std::uint64_t const triangles = announced_triangles(file);
    std::uint64_t const room = (file.size() - stl_header_bytes) / triangle_bytes;
    if (room < triangles)
        fail(path, ends_early);
    if (room > triangles)
        fail(path, fmt::format("has the bytes of {} triangles, expected {} as its header says", room, triangles));
    auto const place = [&] { return path.string(); };
    for (std::uint64_t i = 0; i < triangles; ++i) {
        char const* const triangle = file.data() + stl_header_bytes + triangle_bytes * i + normal_bytes;
        auto const first = static_cast<std::uint32_t>(mesh.vertices());
        for (std::size_t corner = 0; corner < 3; ++corner) {
            char const* const vertex = triangle + 12 * corner;
            mesh.add_vertex({float_at(vertex), float_at(vertex + 4), float_at(vertex + 8)}, place);
        }
        mesh.add_polygon({first, first + 1, first + 2});
    }
}

/// Lines of other words than vertices and the ends of loops and solids, such as normals and colours, are looked over.
class StlText {
  public:
    StlText(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh)
        : text_(path, file), mesh_(mesh) {}

    void read() {
        while (text_.next_line_of_words())
            for (std::string word = keyword(); !word.empty();)
                word = obey(word) ? keyword() : "";
        if (is_in_solid_ || is_in_loop_)
            text_.fail("the file ends early, expected endsolid");
    }

  private:
    /// Some write "end loop".
    std::string keyword() {
        std::string const word = lower_case(text_.word());
        return word == "end" ? word + lower_case(text_.word()) : word;
    }

    /// True if another keyword may follow on the line.
    bool obey(std::string const& keyword) {
        if (keyword == "solid") {
            is_in_solid_ = true;  // its name may be any words
            return false;
        }
        if (keyword == "outer")
            begin_loop();
        else if (keyword == "vertex")
            read_vertex();
        else if (keyword == "endloop")
            end_loop();
        else if (keyword == "endsolid")
            is_in_solid_ = false;
        return keyword != "endsolid";
    }

    void begin_loop() {
        if (is_in_loop_)
            text_.fail("outer loop within a loop, expected endloop before");
        is_in_loop_ = true;
        corners_.clear();
    }

    void read_vertex() {
        if (!is_in_loop_)
            text_.fail("a vertex outside of a loop, expected outer loop before");
        Eigen::Vector3d const vertex = text_.coordinates(mesh_.vertices());
        corners_.push_back(static_cast<std::uint32_t>(mesh_.vertices()));
        mesh_.add_vertex(vertex, [this] { return text_.place(); });
    }

    void end_loop() {
        if (!is_in_loop_ || corners_.size() < 3)
            text_.fail(fmt::format("endloop after {} vertices, expected a loop of at least three", corners_.size()));
        is_in_loop_ = false;
        mesh_.add_polygon(corners_);
        corners_.clear();
    }

    MeshText text_;
    MeshBuilder& mesh_;
    std::vector<std::uint32_t> corners_;
    bool is_in_solid_ = false;
    bool is_in_loop_ = false;
};

}  // namespace

void read_stl(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh) {
    if (is_text(file))
        StlText(path, file, mesh).read();
    else
        read_binary(path, file, mesh);
}

}  // namespace faster::files
