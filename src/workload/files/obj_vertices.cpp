#include "workload/files/obj_vertices.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

namespace faster::io {
namespace {

/// stof throws for what does not fit; strtof says infinite, which is what we look for.
bool is_finite_number(std::string const& word) { return std::isfinite(std::strtof(word.c_str(), nullptr)); }

bool has_bad_coordinate(std::istringstream& words) {
    std::string word;
    for (int axis = 0; axis < 3 && words >> word; ++axis) {
        if (!is_finite_number(word)) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::optional<ObjVertexPlace> first_bad_obj_vertex(std::string_view file) {
    std::istringstream lines{std::string(file)};
    std::string line;
    ObjVertexPlace place;
    while (std::getline(lines, line)) {
        ++place.line;
        std::istringstream words(line);
        std::string keyword;
        words >> keyword;
        if (keyword != "v") {
            continue;
        }
        if (has_bad_coordinate(words)) {
            return place;
        }
        ++place.index;
    }
    return std::nullopt;
}

}  // namespace faster::io
