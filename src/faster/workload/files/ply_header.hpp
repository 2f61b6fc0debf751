#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace faster::files {

/// How a number of a PLY file is stored.
struct PlyType {
    enum class Kind { signed_integer, unsigned_integer, real };
    Kind kind = Kind::real;
    std::size_t bytes = 4;
};

/// A number or a list of them in each row of an element.
struct PlyProperty {
    std::string name;
    bool is_list = false;
    PlyType count;  ///< of a list
    PlyType value;
};

struct PlyElement {
    std::string name;
    std::uint64_t rows = 0;
    std::size_t line = 0;  ///< of the header
    std::vector<PlyProperty> properties;
};

enum class PlyFormat { text, little_endian, big_endian };

struct PlyHeader {
    PlyFormat format = PlyFormat::text;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;  ///< of the header; the rows follow
    std::size_t lines = 0;
};

/// The head of a PLY file. Throws InputError: "path:line: what, expected".
PlyHeader read_ply_header(std::filesystem::path const& path, std::string_view file);

}  // namespace faster::files
