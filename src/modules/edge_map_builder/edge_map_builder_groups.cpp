#include <array>

#include "dataflow/base/each_bit.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/edge_map_builder/edge_map_builder_variant.hpp"

namespace faster {

namespace {
bool ends_sample(PixelGroup const& group) { return group.mask == 0; }
}  // namespace

/// EdgeMapBuilder::build() with tokens of several pixels. inner_border alone has them, and no second iterations.
void EdgeMapBuilderVariant::build_of_groups() {
    clock_.here();
    PixelGroup current = edge_groups_->read();
    clock_.advance(1);
    if (ends_sample(current)) {
        clock_.advance(1);
        return;
    }
    watched_.enter();
    group_.run_while([&](PixelGroup const& next) {
        take_group(current);
        current = next;
        return !ends_sample(current);
    });
}

void EdgeMapBuilderVariant::take_group(PixelGroup const& group) {
    std::array<EdgeToken, most_scan_lanes> tokens;
    unsigned count = 0;
    for_each_bit(group.mask, [&](unsigned lane) {
        tokens[count++] = {group.row, static_cast<std::int16_t>(group.col + static_cast<int>(lane)),
                           EdgeTokenKind::Object};
    });
    if (!watched_.is_watched()) {
        maps_->take(tokens[0], &tokens[1], count);
        return;
    }
    watched_.watch().next_iteration();
    for (unsigned i = 0; i < count; ++i)
        maps_->take_watched(tokens[i], watched_.watch());
}

}  // namespace faster
