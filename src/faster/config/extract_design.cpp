#include "faster/config/extract_design.hpp"

namespace faster {
namespace {

AccessPattern whole_neighbourhood(int radius) {
    AccessPattern pattern;
    for (int row = -radius; row <= radius; ++row) {
        for (int col = -radius; col <= radius; ++col) {
            pattern.reads.push_back({row, col});
        }
    }
    pattern.writes.push_back({0, 0});
    return pattern;
}

}  // namespace

ExtractDesign extract_design(AcceleratorConfig const& config) {
    int const radius = config.edge_extraction.neighbourhood / 2;
    ExtractDesign design;
    if (config.edge_extraction.neighbour_access == NeighbourAccess::direct) {
        design.accesses = whole_neighbourhood(radius);
        return design;
    }
    // The pixel judged lies `radius` rows and pixels behind the word that enters the line buffers.
    design.accesses = {{{0, 0}}, {{-radius, -radius}}};
    design.line_buffer_rows = 2 * static_cast<std::uint64_t>(radius);
    return design;
}

}  // namespace faster
