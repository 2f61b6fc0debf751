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
    if (!watched_.is_watched()) {
        for_each_run(group.mask, [&](unsigned first, unsigned end) {
            maps_->take_run(group.row, group.col + static_cast<int>(first), group.col + static_cast<int>(end), true);
        });
        return;
    }
    watched_.watch().next_iteration();
    for_each_bit(group.mask, [&](unsigned lane) {
        auto const col = static_cast<std::int16_t>(group.col + static_cast<int>(lane));
        maps_->take_watched({group.row, col, EdgeTokenKind::Object}, watched_.watch());
    });
}

}  // namespace faster
