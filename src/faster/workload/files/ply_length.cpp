#include "faster/workload/files/ply_length.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace faster::files {
namespace {

struct Property {
    std::size_t count_bytes = 0;  // of the length in front of a list; 0: no list
    std::size_t value_bytes = 0;
};

struct Element {
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    std::string format;
    std::vector<Element> elements;
};

std::size_t bytes_of(std::string const& type) {
    static std::array<std::pair<char const*, std::size_t>, 16> const types{{{"char", 1},
                                                                            {"uchar", 1},
                                                                            {"int8", 1},
                                                                            {"uint8", 1},
                                                                            {"short", 2},
                                                                            {"ushort", 2},
                                                                            {"int16", 2},
                                                                            {"uint16", 2},
                                                                            {"int", 4},
                                                                            {"uint", 4},
                                                                            {"int32", 4},
                                                                            {"uint32", 4},
                                                                            {"float", 4},
                                                                            {"float32", 4},
                                                                            {"double", 8},
                                                                            {"float64", 8}}};
    for (auto const& [name, bytes] : types) {
        if (type == name) {
            return bytes;
        }
    }
    return 0;
}

Property parse_property(std::istringstream& words) {
    std::string type, count_type;
    words >> type;
    if (type != "list") {
        return {0, bytes_of(type)};
    }
    words >> count_type >> type;
    return {bytes_of(count_type), bytes_of(type)};
}

/// Takes one line off the front of `text`.
std::string take_line(std::string_view& text) {
    auto const end = text.find('\n');
    std::string line(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

/// Takes the header off the front of `file`.
std::optional<Header> take_header(std::string_view& file) {
    Header header;
    while (!file.empty()) {
        std::istringstream words(take_line(file));
        std::string keyword, name;
        words >> keyword;
        if (keyword == "format") {
            words >> header.format;
        } else if (keyword == "element") {
            header.elements.emplace_back();
            words >> name >> header.elements.back().count;
        } else if (keyword == "property" && !header.elements.empty()) {
            header.elements.back().properties.push_back(parse_property(words));
        } else if (keyword == "end_header") {
            return header;
        }
    }
    return std::nullopt;
}

bool lacks_lines(Header const& header, std::string_view body) {
    std::uint64_t expected = 0, found = 0;
    for (Element const& element : header.elements) {
        expected += element.count;
    }
    while (!body.empty()) {
        bool const is_blank = take_line(body).find_first_not_of(" \t\r") == std::string::npos;
        found += is_blank ? 0U : 1U;
    }
    return found < expected;
}

/// Length of a list, which stands in front of it.
std::uint64_t list_length(std::string_view bytes, bool is_little_endian) {
    std::uint64_t length = 0;
    for (std::size_t position = 0; position < bytes.size(); ++position) {
        std::size_t const most_significant_first = is_little_endian ? bytes.size() - 1 - position : position;
        length = length << 8 | static_cast<unsigned char>(bytes[most_significant_first]);
    }
    return length;
}

/// Takes one row of an element off the front of `body`; false if it is not all there.
bool take_row(Element const& element, bool is_little_endian, std::string_view& body) {
    for (Property const& property : element.properties) {
        if (body.size() < property.count_bytes) {
            return false;
        }
        bool const is_list = property.count_bytes > 0;
        std::uint64_t const values = is_list ? list_length(body.substr(0, property.count_bytes), is_little_endian) : 1;
        body.remove_prefix(property.count_bytes);
        if (property.value_bytes > 0 && values > body.size() / property.value_bytes) {
            return false;
        }
        body.remove_prefix(static_cast<std::size_t>(values) * property.value_bytes);
    }
    return true;
}

bool takes_no_room(Element const& element) {
    return std::all_of(element.properties.begin(), element.properties.end(),
                       [](Property const& property) { return property.count_bytes == 0 && property.value_bytes == 0; });
}

bool lacks_bytes(Header const& header, std::string_view body) {
    for (Element const& element : header.elements) {
        if (takes_no_room(element)) {
            continue;  // however many there are
        }
        for (std::uint64_t row = 0; row < element.count; ++row) {
            if (!take_row(element, header.format == "binary_little_endian", body)) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace

bool is_truncated_ply(std::string_view file) {
    auto const header = take_header(file);
    if (!header) {
        return true;
    }
    return header->format == "ascii" ? lacks_lines(*header, file) : lacks_bytes(*header, file);
}

}  // namespace faster::files
