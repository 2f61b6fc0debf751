#include "modules/edge_map_builder/map_activity.hpp"

#include <utility>

#include "faster/config/edge_map_design.hpp"
#include "modules/edge_map_builder/map_accesses.hpp"

namespace faster {

MapActivity::Branch::Branch(PerMap const& touches)
    : edge_map(touched_words(touches.edge_map, 1)), object_map(touched_words(touches.object_map, 1)) {}

MapActivity::MapActivity(AcceleratorConfig const& config, Machine const& machine)
    : WindowActivity(config, machine,
                     {machine.process("edge_map_builder"), machine.fifo("map_full"), machine.fifo("map_free")}),
      maps_(config.edge_map),
      edge_(design_of(config.edge_map.algorithm).edge_token),
      object_(design_of(config.edge_map.algorithm).object_token),
      second_(design_of(config.edge_map.algorithm).second),
      lanes_(config.inlier_unit.sweep_lanes),
      edge_token_(machine.fifo("edge_token")),
      edge_map_(machine.memory("edge_map")),
      object_map_(machine.memory("object_map")),
      works_(machine.loops.size(), Work::nothing) {
    std::size_t const builder = machine.process("edge_map_builder");
    works_[machine.loop(builder, "clear")] = Work::clear;
    works_[machine.loop(builder, "token")] = Work::take_token;
    works_[machine.loop(builder, "output")] = Work::read_out;
    works_[machine.loop(machine.process("edge_map_output"), "output")] = Work::read_out;
}

void MapActivity::token_read(recording::TokenRead const& read) {
    WindowActivity::token_read(read);
    if (read.fifo != edge_token_)
        return;
    token_ = std::exchange(next_, token_of(read.fields));
    token_read_ = read.cycle;
}

/// Groups are of object pixels, and the one that closes the sample has none.
WindowActivity::Token MapActivity::token_of(recording::TokenValues const& fields) const {
    if (!scans_groups())
        return {fields[0], fields[1], fields[2], 1};
    return {fields[0], fields[1], static_cast<std::int64_t>(EdgeTokenKind::Object), fields[2]};
}

void MapActivity::access_for(recording::LoopIteration const& iteration) {
    switch (works_[iteration.loop]) {
        case Work::clear:
            return clear_maps(iteration.number);
        case Work::take_token:
            return take_token(iteration.cycle);
        case Work::read_out:
            return read_out(iteration.number);
        case Work::nothing:
            return;
    }
}

void MapActivity::clear_maps(std::int64_t iteration) {
    EdgeMapDesign const& design = design_of(maps_.algorithm);
    if (design.clear.edge_map > 0)
        clear(edge_map_, maps_.clearing, iteration);
    if (design.clear.object_map > 0)
        clear(object_map_, maps_.clearing, iteration);
}

/// An iteration that reads the next token consumes the one before; the one behind it is that token's second.
MapActivity::Branch const& MapActivity::branch_at(Cycles cycle) const {
    if (cycle != token_read_)
        return second_;
    return token_.kind == static_cast<std::int64_t>(EdgeTokenKind::Edge) ? edge_ : object_;
}

void MapActivity::take_token(Cycles cycle) {
    Branch const& branch = branch_at(cycle);
    for (std::int64_t const col : cols_of(token_)) {
        if (token_.row < 0 || token_.row >= side() || col < 0 || col >= side())
            continue;
        access_around(edge_map_, branch.edge_map, token_.row, col);
        access_around(object_map_, branch.object_map, token_.row, col);
    }
}

/// Iteration i sends token i; where the contour is taken from the object map, it reads a row ahead of what it sends.
/// What it has read it may clear.
void MapActivity::read_out(std::int64_t iteration) {
    EdgeMapDesign const& design = design_of(maps_.algorithm);
    bool const clears = maps_.clearing == MapClearing::on_read_out;
    for (std::int64_t const pixel : pixels_of(rows_at_hand(lanes_, token_, next_), iteration)) {
        access(design.output.edge_map > 0 ? edge_map_ : object_map_, false, pixel);
        if (clears && design.bits.edge_map > 0)
            access(edge_map_, true, pixel);
        if (clears && design.bits.object_map > 0)
            access(object_map_, true, pixel);
    }
}

}  // namespace faster
