#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <utility>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_readers.hpp"
#include "faster/workload/files/mesh_text.hpp"
#include "faster/workload/files/ply_header.hpp"

namespace faster::files {
namespace {

/// The numbers behind the header, in their order.
class PlyNumbers {
  public:
    PlyNumbers() = default;
    PlyNumbers(PlyNumbers const&) = delete;
    PlyNumbers& operator=(PlyNumbers const&) = delete;
    virtual ~PlyNumbers() = default;

    virtual void begin_row() = 0;
    /// The next number of the row. Throws InputError if there is none.
    virtual double next(PlyType const& type) = 0;
    /// Where the row stands, for messages.
    virtual std::string place() const = 0;
};

/// A row begins on a line of its own; what is behind it there is nothing that the header announces.
class TextNumbers : public PlyNumbers {
  public:
    TextNumbers(std::filesystem::path const& path, std::string_view rows, std::size_t first_line)
        : text_(path, rows, first_line) {}

    void begin_row() override {
        do {
            if (!text_.next_line_of_words())
                text_.fail("the file ends early, expected more rows, each on a line of its own");
            first_ = text_.word();
        } while (first_ == "comment" || first_ == "obj_info");
    }

    double next(PlyType const& /*type*/) override {
        std::string_view const word = first_.empty() ? text_.word_of_row() : std::exchange(first_, {});
        auto const number = number_in(word);
        if (!number)
            text_.fail(fmt::format("{} in a row, expected a number", shortened(word)));
        return *number;
    }

    std::string place() const override { return text_.place(); }

  private:
    MeshText text_;
    std::string_view first_;  ///< word of the row, until it is taken
};

class BinaryNumbers : public PlyNumbers {
  public:
    BinaryNumbers(std::filesystem::path const& path, std::string_view rows, bool is_little_endian)
        : path_(path), rest_(rows), is_little_endian_(is_little_endian) {}

    void begin_row() override {}

    double next(PlyType const& type) override {
        if (rest_.size() < type.bytes)
            io::fail(path_, "cannot be read as a mesh (it ends early), expected a valid ply file");
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < type.bytes; ++i)
            bits = bits << 8U | static_cast<unsigned char>(rest_[is_little_endian_ ? type.bytes - 1 - i : i]);
        rest_.remove_prefix(type.bytes);
        return value_of(bits, type);
    }

    std::string place() const override { return path_.string(); }

  private:
    template <typename Number, typename Bits> static double as(Bits bits) {
        Number number = 0;
        static_assert(sizeof number == sizeof bits);
        std::memcpy(&number, &bits, sizeof number);
        return static_cast<double>(number);
    }

    static double value_of(std::uint64_t bits, PlyType const& type) {
        if (type.kind == PlyType::Kind::real)
            return type.bytes == 8 ? as<double>(bits) : as<float>(static_cast<std::uint32_t>(bits));
        std::uint64_t const sign = std::uint64_t{1} << (8 * type.bytes - 1);
        double const value = static_cast<double>(bits);
        bool const is_negative = type.kind == PlyType::Kind::signed_integer && (bits & sign) != 0;
        return is_negative ? value - 2 * static_cast<double>(sign) : value;
    }

    std::filesystem::path const& path_;
    std::string_view rest_;
    bool is_little_endian_;
};

class PlyReader {
  public:
    PlyReader(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh)
        : path_(path), header_(read_ply_header(path, file)), mesh_(mesh) {
        std::string_view const rows = file.substr(header_.bytes);
        if (header_.format == PlyFormat::text)
            numbers_ = std::make_unique<TextNumbers>(path, rows, header_.lines + 1);
        else
            numbers_ = std::make_unique<BinaryNumbers>(path, rows, header_.format == PlyFormat::little_endian);
        for (PlyElement const& element : header_.elements)
            if (element.name == "vertex")
                vertices_ += element.rows;
    }

    void read() {
        for (PlyElement const& element : header_.elements) {
            if (element.rows == 0)
                continue;
            if (element.name == "vertex")
                read_vertices(element);
            else if (auto const list = list_of_corners(element))
                read_faces(element, *list);
            else if (!element.properties.empty())
                read_others(element);
        }
    }

  private:
    [[noreturn]] void fail_element(PlyElement const& element, std::string const& what) const {
        throw InputError(
            fmt::format("{}:{}: element {} {}", path_.string(), element.line, shortened(element.name), what));
    }

    void read_vertices(PlyElement const& element) {
        std::vector<int> axes;
        for (PlyProperty const& property : element.properties)
            axes.push_back(property.is_list || property.name.size() != 1 || property.name[0] < 'x' ||
                                   property.name[0] > 'z'
                               ? -1
                               : property.name[0] - 'x');
        for (int axis = 0; axis < 3; ++axis)
            if (std::count(axes.begin(), axes.end(), axis) != 1)
                fail_element(element, "has not one property of each of the names x, y and z, expected that");
        for (std::uint64_t row = 0; row < element.rows; ++row) {
            numbers_->begin_row();
            Eigen::Vector3d vertex;
            for (std::size_t i = 0; i < axes.size(); ++i)
                if (axes[i] < 0)
                    skip(element.properties[i]);
                else
                    vertex[axes[i]] = numbers_->next(element.properties[i].value);
            mesh_.add_vertex(vertex, [this] { return numbers_->place(); });
        }
    }

    /// Which property of an element of faces lists their corners.
    std::optional<std::size_t> list_of_corners(PlyElement const& element) const {
        bool const is_known = element.name == "face" || element.name == "tristrips";
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            PlyProperty const& property = element.properties[i];
            if (!property.is_list || (property.name != "vertex_indices" && property.name != "vertex_index"))
                continue;
            if (!is_known && element.name != "edge")
                fail_element(element, "lists vertices, which is not read; expected the elements face or tristrips");
            if (is_known && found)
                fail_element(element, fmt::format("has the lists {} and {}, expected one of them",
                                                  element.properties[*found].name, property.name));
            if (is_known)
                found = i;
        }
        if (is_known && !found)
            fail_element(element, "has no list vertex_indices, expected one");
        return found;
    }

    void read_faces(PlyElement const& element, std::size_t list) {
        bool const is_of_strips = element.name == "tristrips";
        for (std::uint64_t row = 0; row < element.rows; ++row) {
            numbers_->begin_row();
            for (std::size_t i = 0; i < element.properties.size(); ++i)
                if (i == list)
                    read_corners(element.properties[i], row, is_of_strips);
                else
                    skip(element.properties[i]);
            if (is_of_strips)
                add_strips();
            else
                add_face(row);
        }
    }

    std::uint64_t list_length(PlyProperty const& property) {
        double const length = numbers_->next(property.count);
        constexpr double longest = 1e15;
        if (!(length >= 0) || length > longest || length != std::floor(length))
            throw InputError(fmt::format("{}: a list {} of length {}, expected a count", numbers_->place(),
                                         shortened(property.name), length));
        return static_cast<std::uint64_t>(length);
    }

    void skip(PlyProperty const& property) {
        std::uint64_t const count = property.is_list ? list_length(property) : 1;
        for (std::uint64_t i = 0; i < count; ++i)
            numbers_->next(property.value);
    }

    /// Strips are parted by -1.
    void read_corners(PlyProperty const& property, std::uint64_t row, bool is_of_strips) {
        std::uint64_t const count = list_length(property);
        corners_.clear();
        for (std::uint64_t i = 0; i < count; ++i) {
            double const vertex = numbers_->next(property.value);
            bool const is_end = is_of_strips && vertex == -1;
            if (!is_end && (!(vertex >= 0) || vertex != std::floor(vertex) ||
                            vertex >= std::min(static_cast<double>(vertices_), most_vertices)))
                throw InputError(fmt::format(
                    "{}: {} {} (counted from 0) names vertex {}, which does not exist, expected one of {} vertices",
                    numbers_->place(), is_of_strips ? "strip" : "face", row, vertex, vertices_));
            corners_.push_back(is_end ? strip_end : static_cast<std::uint32_t>(vertex));
        }
    }

    void add_face(std::uint64_t row) {
        if (corners_.empty())
            throw InputError(
                fmt::format("{}: face {} (counted from 0) has no corners, expected some", numbers_->place(), row));
        mesh_.add_polygon(corners_);
    }

    /// Every second triangle of a strip runs the other way round. Those that only lead to another place have a corner
    /// twice.
    void add_strips() {
        bool is_turned = false;
        for (std::size_t i = 0; i + 2 < corners_.size(); ++i) {
            std::uint32_t const a = corners_[i], b = corners_[i + 1], c = corners_[i + 2];
            if (a == strip_end)
                is_turned = false;
            if (a == strip_end || b == strip_end || c == strip_end)
                continue;
            if (a != b && b != c && c != a)
                mesh_.add_polygon(is_turned ? std::vector<std::uint32_t>{b, a, c}
                                            : std::vector<std::uint32_t>{a, b, c});
            is_turned = !is_turned;
        }
    }

    void read_others(PlyElement const& element) {
        for (std::uint64_t row = 0; row < element.rows; ++row) {
            numbers_->begin_row();
            for (PlyProperty const& property : element.properties)
                skip(property);
        }
    }

    static constexpr std::uint32_t strip_end = 0xFFFFFFFF;
    static constexpr double most_vertices = strip_end;

    std::filesystem::path const& path_;
    PlyHeader header_;
    MeshBuilder& mesh_;
    std::unique_ptr<PlyNumbers> numbers_;
    std::uint64_t vertices_ = 0;  ///< as announced
    std::vector<std::uint32_t> corners_;
};

}  // namespace

void read_ply(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh) {
    PlyReader(path, file, mesh).read();
}

}  // namespace faster::files
