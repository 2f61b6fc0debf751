#include <fmt/format.h>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/printable.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_readers.hpp"
#include "faster/workload/files/mesh_text.hpp"

namespace faster::files {
namespace {

class OffReader {
  public:
    OffReader(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh)
        : path_(path), text_(path, file), mesh_(mesh) {}

    void read() {
        std::uint64_t const vertices = first_count();
        std::uint64_t const faces = count_in(text_.word_of_row(), "faces");
        skip_edges();
        for (std::uint64_t i = 0; i < vertices; ++i)
            read_vertex();
        for (std::uint64_t i = 0; i < faces; ++i)
            read_face();
    }

  private:
    [[noreturn]] void fail_format() const {
        io::fail(path_, "cannot be read as a mesh (it does not begin with OFF), expected a valid off file");
    }

    /// The number of vertices, which may stand right behind the keyword, or without one. The keyword's letters say what
    /// else a vertex has, which is looked over; but for two of them, which change what its numbers mean.
    std::uint64_t first_count() {
        if (!text_.next_line_of_words())
            fail_format();
        std::string_view const word = text_.word();
        if (integer_in(word))
            return count_in(word, "vertices");
        std::size_t const name = word.find("OFF");
        if (name == std::string_view::npos)
            fail_format();
        if (word.substr(0, name).find_first_of("4n") != std::string_view::npos)
            text_.fail(fmt::format("{}: vertices of other than three dimensions, expected OFF", shortened(word)));
        std::string_view const behind = word.substr(name + 3);
        if (!behind.empty())
            return count_in(behind, "vertices");
        std::string_view const next = text_.word_of_row();
        if (next == "BINARY")
            text_.fail("OFF BINARY: is not read, expected an OFF file of text");
        return count_in(next, "vertices");
    }

    std::uint64_t count_in(std::string_view word, char const* what) const {
        auto const count = integer_in(word);
        if (!count || *count < 0)
            text_.fail(fmt::format("{} as the number of {}, expected a count", shortened(word), what));
        return static_cast<std::uint64_t>(*count);
    }

    /// The number of edges, which some files leave out, and some have on a line of its own.
    void skip_edges() {
        if (!text_.word().empty())
            return;
        MeshText ahead = text_;
        bool const is_alone = ahead.next_line_of_words() && !ahead.word().empty() && ahead.word().empty();
        if (is_alone)
            text_ = ahead;
    }

    void begin_row() {
        if (!text_.next_line_of_words())
            text_.fail_at_end();
    }

    void read_vertex() {
        begin_row();
        Eigen::Vector3d const vertex = text_.coordinates(mesh_.vertices(), &MeshText::word_of_row);
        mesh_.add_vertex(vertex, [this] { return text_.place(); });
    }

    /// Colours may follow on the line.
    void read_face() {
        begin_row();
        std::uint64_t const count = count_in(text_.word(), "corners");
        if (count == 0)
            text_.fail(fmt::format("face {} (counted from 0) has no corners, expected some", mesh_.polygons()));
        corners_.clear();
        for (std::uint64_t i = 0; i < count; ++i) {
            std::string_view const word = text_.word_of_row();
            auto const vertex = integer_in(word);
            if (!vertex || *vertex < 0 || static_cast<std::uint64_t>(*vertex) >= mesh_.vertices())
                text_.fail(fmt::format(
                    "face {} (counted from 0) names vertex {}, which does not exist, expected one of {} vertices",
                    mesh_.polygons(), shortened(word), mesh_.vertices()));
            corners_.push_back(static_cast<std::uint32_t>(*vertex));
        }
        mesh_.add_polygon(corners_);
    }

    std::filesystem::path const& path_;
    MeshText text_;
    MeshBuilder& mesh_;
    std::vector<std::uint32_t> corners_;
};

}  // namespace

void read_off(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh) {
    OffReader(path, file, mesh).read();
}

}  // namespace faster::files
