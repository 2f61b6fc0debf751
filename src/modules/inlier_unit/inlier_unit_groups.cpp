#include <algorithm>

#include "dataflow/base/each_bit.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/inlier_unit/inlier_unit_variant.hpp"

namespace faster {

/// As take_fragments(), of which each token holds the covered pixels of several lanes.
void InlierUnitVariant::take_groups(std::uint64_t reciprocal, Command& command) {
    std::size_t const drawn = draw_groups(reciprocal, command);
    clock_.await_writes(fragment_loop_);
    clock_.iterate(fragment_ports_, drawn);
    depth_groups_->consume(drawn);
    index_groups_->consume(drawn);
    command_->consume(drawn);
}

/// Returns the number of groups drawn.
std::size_t InlierUnitVariant::draw_groups(std::uint64_t reciprocal, Command& command) {
    std::size_t available = std::min(depth_groups_->peek(), most_at_once_);
    available = std::min(available, index_groups_->peek());
    available = std::min(available, command_->peek());
    NoWriteDistances nobody;
    std::size_t n = 0;
    for (; n < available && command == Command::Fragment; ++n) {
        DepthGroup const& depths = depth_groups_->front()[n];
        PixelGroup const& pixels = index_groups_->front()[n];
        counters_.valid_raster += distances_ != nullptr ? draw_group(*distances_, reciprocal, depths, pixels)
                                                        : draw_group(nobody, reciprocal, depths, pixels);
        command = command_->front()[n];
    }
    return n;
}

/// Returns how many pixels of a group were drawn. What lies outside the window is dropped lane by lane.
template <class Distances>
unsigned InlierUnitVariant::draw_group(Distances& distances, std::uint64_t reciprocal, DepthGroup const& depths,
                                       PixelGroup const& pixels) {
    distances.next_iteration();
    int const side = core_.stimulus.window;
    if (pixels.row < 0 || pixels.row >= side)
        return 0;
    std::size_t const first = static_cast<std::size_t>(pixels.row) * static_cast<std::size_t>(side);
    unsigned drawn = 0;
    for_each_bit(pixels.mask, [&](unsigned lane) {
        int const col = pixels.col + static_cast<int>(lane);
        if (col < 0 || col >= side)
            return;
        std::int64_t const z_sum = depths.z_sum + std::int64_t{lane} * depths.z_sum_per_column;
        std::uint64_t const depth = depth_unit_.fragment_depth(static_cast<std::uint64_t>(z_sum), reciprocal);
        std::size_t const word = first + static_cast<std::size_t>(col);
        bool const is_drawn = depth_unit_.draw(depth, (*depth_buffer_)[word]);
        distances.read(word);
        if (is_drawn)
            distances.overwrite(word);
        drawn += is_drawn ? 1U : 0U;
    });
    return drawn;
}

}  // namespace faster
