#include "modules/inlier_unit/inlier_unit_variant.hpp"

#include <algorithm>

#include "faster/config/clear_design.hpp"
#include "faster/config/sweep_design.hpp"
#include "modules/core/conditions.hpp"
#include "modules/core/described_parts.hpp"
#include "modules/core/loop_branches.hpp"
#include "modules/core/read_corners.hpp"
#include "modules/core/token_widths.hpp"
#include "modules/core/watching.hpp"
#include "modules/inlier_unit/inlier_unit.hpp"

namespace faster {

bool InlierUnitVariant::is_needed(AcceleratorConfig const& config) {
    InlierUnitConfig const& own = config.inlier_unit;
    return config.rasterizer.lanes > 1 || own.sweep_lanes > 1 || has_depth_buffers(config, true).holds ||
           sweeps_touched_region(config).holds || extracts_edges(config).holds || contour_has_depth(config) ||
           own.clearing != MapClearing::loop || own.fragment_loop != FragmentLoop::per_triangle ||
           own.neighbour_access != NeighbourAccess::direct || counts_hidden(own);
}

ModuleDescription InlierUnitVariant::describe(AcceleratorConfig const& config) {
    Condition const two_buffers = has_depth_buffers(config, true);
    ModuleDescription module = InlierUnit::describe(config);
    Scoring::vary(module, config, has_depth_buffers(config, false));
    module.writes_to("depth_full")
        .carries("drawn depth buffers from the inlier unit to the inlier sweep (inlier_unit.buffers 2)")
        .of_bits(wires::buffer + wires::valid_raster + wires::region(config))
        .only_if(two_buffers);
    module.reads_from("depth_free").only_if(two_buffers);
    widen_branches(loop_of(module, "fragment"), config.rasterizer.lanes);
    MemoryDescription& depth_buffer = memory_of(module, "depth_buffer");
    depth_buffer.bits += extracts_edges(config).holds ? 1U : 0U;  // extracted edge bits ride in the words
    depth_buffer.in_buffers(static_cast<std::uint64_t>(config.inlier_unit.buffers)).read_out_by("inlier_sweep");
    Scoring::describe_line_buffer(module, config);
    return module;
}

InlierUnitVariant::InlierUnitVariant(sc_core::sc_module_name const& name, CoreContext const& core,
                                     DepthBuffers& buffers)
    : CoreModule(name, core), depth_unit_(core.stimulus.fraction), buffers_(buffers), scoring_(core, clock_) {}

void InlierUnitVariant::connect() {
    fragment_index_ = channel_of(fragment_index_in.pixels);
    index_groups_ = channel_of(fragment_index_in.groups);
    result_ = channel_of(result_out);
    depth_full_ = channel_of(depth_full_out);
    depth_free_ = channel_of(depth_free_in);
    ClockedFifo<Command>* const command = &channel_of(command_in);
    triangle_.connect(clock_, "fragment", &channel_of(area_reciprocal_in), command);
    fragment_.connect(clock_, "fragment", channel_of(fragment_depth_in.pixels), fragment_index_, command);
    group_.connect(clock_, "fragment", channel_of(fragment_depth_in.groups), index_groups_, command);
    distances_ = clock_.write_distances("fragment", "depth_buffer");
    if (result_ != nullptr)  // otherwise the sweep is another process's
        scoring_.connect(channel_of(edge_map_in), *channel_of(observed_depth_in), *channel_of(observed_edge_in));
}

void InlierUnitVariant::start() { depth_buffer_ = &buffers_.claim(buffer_); }

void InlierUnitVariant::work(std::size_t i) {
    counters_ = SampleCounters{};
    clock_.advance(1);
    clear();
    core_.config.inlier_unit.fragment_loop == FragmentLoop::flattened ? draw_in_one_loop() : draw_triangles();
    core_.show_depth_buffer(i, *depth_buffer_);
    buffers_.size() > 1 ? hand_over() : score(core_.first_sample + i);
}

void InlierUnitVariant::score(std::size_t sample) {
    scoring_.score(sample, *depth_buffer_, turn_to_sweep(), counters_);
    clock_.here();
    result_->write(counters_);
    clock_.advance(1);
}

/// The drawn buffer, for one that has been swept meanwhile.
void InlierUnitVariant::hand_over() {
    Corners const region = core_.sweeps_touched() ? read_region() : corners_of(core_.whole_window());
    buffers_.release(buffer_);
    clock_.here();
    depth_full_->write({BufferNumber(buffer_), counters_.valid_raster, region});
    clock_.advance(1);
    clock_.here();
    buffer_ = depth_free_->read().number;
    clock_.advance(1);
    depth_buffer_ = &buffers_.claim(buffer_);
}

void InlierUnitVariant::clear() {
    std::size_t const iterations = depth_clear_iterations(core_.config, core_.stimulus.window);
    bool const is_clear = iterations == 0 && core_.sweeps_touched();  // of what was in the region: Scoring
    if (!is_clear)
        std::fill(depth_buffer_->begin(), depth_buffer_->end(), far_depth_code);
    clock_.pipeline("clear", iterations);
}

/// As InlierUnit::draw_triangles(), kept apart so that the thesis's page stays whole.
void InlierUnitVariant::draw_triangles() {
    clock_.here();
    Command command = command_in.read();
    clock_.advance(1);
    while (command == Command::Triangle) {
        std::uint64_t reciprocal = 0;
        {
            Step const step(clock_);
            reciprocal = area_reciprocal_in.read();
            command = command_in.read();
        }
        clock_.advance(1);
        command = draw_fragments(reciprocal, command);
    }
}

/// The fragments of one triangle. `command` is read one ahead of them; returns the first that is no Fragment.
Command InlierUnitVariant::draw_fragments(std::uint64_t reciprocal, Command command) {
    if (command != Command::Fragment) {
        clock_.advance(1);
        return command;
    }
    fragment_.enter();
    take_fragments(reciprocal, command);
    fragment_.leave();
    return command;
}

/// All commands of the sample: an iteration that has a Triangle reads the reciprocal, and the command of the next.
void InlierUnitVariant::draw_in_one_loop() {
    clock_.here();
    Command command = command_in.read();
    clock_.advance(1);
    if (command == Command::End)
        return;
    std::uint64_t reciprocal = 0;
    fragment_.enter();
    while (command != Command::End) {
        if (command == Command::Triangle)
            take_triangle(reciprocal, command);
        else
            take_fragments(reciprocal, command);
    }
    fragment_.leave();
}

void InlierUnitVariant::take_triangle(std::uint64_t& reciprocal, Command& command) {
    triangle_.take_while([&](std::uint64_t area_reciprocal, Command next) {
        if (distances_ != nullptr)
            distances_->next_iteration();
        reciprocal = area_reciprocal;
        command = next;
        return false;
    });
}

/// While `command`, which is read one ahead, is Fragment.
void InlierUnitVariant::take_fragments(std::uint64_t reciprocal, Command& command) {
    FragmentDrawing const fragments{depth_unit_, depth_buffer_->data(), static_cast<unsigned>(core_.stimulus.window),
                                    reciprocal};
    with_watcher(distances_, [&](auto& watcher) {
        auto const go_on = [&](unsigned drawn, Command next) {
            counters_.valid_raster += drawn;
            command = next;
            return next == Command::Fragment;
        };
        if (index_groups_ == nullptr)
            fragment_.take_while([&](std::int64_t z_sum, FragmentIndex const& pixel, Command next) {
                watcher.next_iteration();
                return go_on(fragments.draw(z_sum, pixel, watcher) ? 1 : 0, next);
            });
        else
            group_.take_while([&](DepthGroup const& depths, PixelGroup const& pixels, Command next) {
                watcher.next_iteration();
                return go_on(fragments.draw_group(depths, pixels, watcher), next);
            });
    });
}

/// The pixels that are swept.
PixelBox InlierUnitVariant::turn_to_sweep() {
    if (core_.sweeps_touched())
        return box_of(read_region());
    clock_.advance(1);
    return core_.whole_window();
}

Corners InlierUnitVariant::read_region() {
    return read_corners(clock_, [this] { return read_corner(); });
}

FragmentIndex InlierUnitVariant::read_corner() {
    if (index_groups_ == nullptr)
        return fragment_index_->read();
    PixelGroup const group = index_groups_->read();
    return {group.row, group.col};
}

}  // namespace faster
