#include "workload/models/primitives/loft.hpp"

#include "workload/models/primitives/skin.hpp"

namespace faster::models {

Mesh loft(std::vector<Level> const& levels, double edge_length) {
    std::vector<Section> sections;
    sections.reserve(levels.size());
    for (Level const& level : levels) {
        sections.push_back(
            {{level.centre_x, 0.0, level.height}, {level.half_x, 0.0, 0.0}, {0.0, level.half_y, 0.0}, level.exponent});
    }
    return skin(sections, edge_length);
}

}  // namespace faster::models
