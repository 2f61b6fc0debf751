#include "faster/workload/files/ply_header.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>
#include <utility>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_text.hpp"

namespace faster::files {
namespace {

std::optional<PlyType> type_named(std::string_view name) {
    using Kind = PlyType::Kind;
    static constexpr std::array<std::pair<std::string_view, PlyType>, 16> types{
        {{"char", {Kind::signed_integer, 1}},
         {"uchar", {Kind::unsigned_integer, 1}},
         {"int8", {Kind::signed_integer, 1}},
         {"uint8", {Kind::unsigned_integer, 1}},
         {"short", {Kind::signed_integer, 2}},
         {"ushort", {Kind::unsigned_integer, 2}},
         {"int16", {Kind::signed_integer, 2}},
         {"uint16", {Kind::unsigned_integer, 2}},
         {"int", {Kind::signed_integer, 4}},
         {"uint", {Kind::unsigned_integer, 4}},
         {"int32", {Kind::signed_integer, 4}},
         {"uint32", {Kind::unsigned_integer, 4}},
         {"float", {Kind::real, 4}},
         {"float32", {Kind::real, 4}},
         {"double", {Kind::real, 8}},
         {"float64", {Kind::real, 8}}}};
    auto const found = std::find_if(types.begin(), types.end(), [&](auto const& type) { return type.first == name; });
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

class HeaderReader {
  public:
    HeaderReader(std::filesystem::path const& path, std::string_view file) : path_(path), file_(file), rest_(file) {
        std::size_t const first_end = file.find_first_of("\r\n");
        bool const ends_in_return = first_end != std::string_view::npos && file.substr(first_end, 2) != "\r\n";
        line_end_ = ends_in_return ? file[first_end] : '\n';
    }

    PlyHeader header() {
        MeshText magic = next_line();
        if (magic.word() != "ply")
            io::fail(path_, "cannot be read as a mesh (it does not begin with ply), expected a valid ply file");
        while (!is_over_) {
            MeshText words = next_line();
            obey(words.word(), words);
        }
        if (!has_format_)
            io::fail(path_, "has no line format in its header, expected one");
        header_.bytes = file_.size() - rest_.size();
        header_.lines = line_;
        return std::move(header_);
    }

  private:
    /// Takes one line off the front. Rows that are binary may begin with any byte: lines end as the first one does.
    MeshText next_line() {
        if (rest_.empty())
            io::fail(path_, "cannot be read as a mesh (it ends early), expected a valid ply file");
        std::size_t const end = std::min(rest_.find(line_end_), rest_.size());
        MeshText words(path_, rest_.substr(0, end), ++line_);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        words.next_line();
        return words;
    }

    /// Before the first element a line may be a comment that is not marked as one.
    void obey(std::string_view keyword, MeshText& words) {
        if (keyword == "format")
            read_format(words);
        else if (keyword == "element")
            read_element(words);
        else if (keyword == "property")
            read_property(words);
        else if (keyword == "end_header")
            is_over_ = true;
        else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info" && !header_.elements.empty())
            words.fail(
                fmt::format("{}: is no statement of a header, expected format, comment, obj_info, element, "
                            "property or end_header",
                            shortened(keyword)));
    }

    void read_format(MeshText& words) {
        if (has_format_)
            words.fail("a second line format, expected one");
        std::string_view const name = words.word();
        if (name == "ascii")
            header_.format = PlyFormat::text;
        else if (name == "binary_little_endian")
            header_.format = PlyFormat::little_endian;
        else if (name == "binary_big_endian")
            header_.format = PlyFormat::big_endian;
        else
            words.fail(
                fmt::format("format {}, expected ascii, binary_little_endian or binary_big_endian", shortened(name)));
        if (std::string_view const version = words.word(); !version.empty() && version != "1.0")
            words.fail(fmt::format("format of version {}, expected 1.0", shortened(version)));
        has_format_ = true;
    }

    void read_element(MeshText& words) {
        PlyElement element;
        element.name = words.word();
        element.line = line_;
        std::string_view const rows = words.word();
        auto const count = integer_in(rows);
        if (!count || *count < 0)
            words.fail(
                fmt::format("element {} of {} rows, expected a count", shortened(element.name), shortened(rows)));
        element.rows = static_cast<std::uint64_t>(*count);
        header_.elements.push_back(std::move(element));
    }

    void read_property(MeshText& words) {
        if (header_.elements.empty())
            words.fail("a property of no element, expected an element before");
        PlyProperty property;
        std::string_view type = words.word();
        property.is_list = type == "list";
        if (property.is_list) {
            property.count = type_of(words.word(), words);
            type = words.word();
        }
        property.value = type_of(type, words);
        property.name = words.word();
        header_.elements.back().properties.push_back(std::move(property));
    }

    static PlyType type_of(std::string_view name, MeshText const& words) {
        auto const type = type_named(name);
        if (!type)
            words.fail(
                fmt::format("a property of type {}, expected char, uchar, short, ushort, int, uint, float, "
                            "double or a list of them",
                            name.empty() ? "nothing" : shortened(name)));
        return *type;
    }

    std::filesystem::path const& path_;
    std::string_view file_;
    std::string_view rest_;
    char line_end_ = '\n';
    std::size_t line_ = 0;
    bool has_format_ = false;
    bool is_over_ = false;
    PlyHeader header_;
};

}  // namespace

PlyHeader read_ply_header(std::filesystem::path const& path, std::string_view file) {
    return HeaderReader(path, file).header();
}

}  // namespace faster::files
