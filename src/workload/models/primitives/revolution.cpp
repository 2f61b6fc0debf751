#include "workload/models/primitives/revolution.hpp"

#include "workload/models/primitives/skin.hpp"

namespace faster::models {

Mesh revolution(std::vector<ProfilePoint> const& profile, double edge_length) {
    std::vector<Section> sections;
    sections.reserve(profile.size());
    for (ProfilePoint const& point : profile) {
        sections.push_back({{0.0, 0.0, point.height}, {point.radius, 0.0, 0.0}, {0.0, point.radius, 0.0}});
    }
    return skin(sections, edge_length);
}

}  // namespace faster::models
