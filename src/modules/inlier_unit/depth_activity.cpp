#include "modules/inlier_unit/depth_activity.hpp"

#include <utility>

#include "modules/core/described_parts.hpp"
#include "modules/inlier_unit/inlier_unit.hpp"

namespace faster {

namespace {
/// What an iteration of a loop does around one pixel, as the module's description says.
AccessPattern accesses_of(AcceleratorConfig const& config, char const* loop) {
    ModuleDescription unit = InlierUnit::describe(config);
    return loop_of(unit, loop).accesses.at(0).pattern;
}
}  // namespace

/// A loop does the same wherever it stands: in its own module, or in the one that reads a second buffer out.
DepthActivity::DepthActivity(AcceleratorConfig const& config, Machine const& machine)
    : WindowActivity(config, machine,
                     {machine.process("inlier_unit"), machine.fifo("depth_full"), machine.fifo("depth_free")}),
      clearing_(config.inlier_unit.clearing),
      fragment_words_(accesses_of(config, "fragment")),
      sweep_words_(accesses_of(config, "sweep")),
      sweep_(sweep_design(config)),
      extract_(extract_design(config)),
      extract_radius_(config.edge_extraction.neighbourhood / 2),
      lanes_(config.inlier_unit.sweep_lanes),
      fragment_index_(machine.fifo("fragment_index")),
      depth_buffer_(machine.memory("depth_buffer")),
      works_(machine.loops.size(), Work::nothing) {
    std::size_t const unit = machine.process("inlier_unit");
    works_[machine.loop(unit, "clear")] = Work::clear;
    works_[machine.loop(unit, "fragment")] = Work::draw;
    for (std::size_t const process : {unit, machine.process("inlier_sweep")}) {
        works_[machine.loop(process, "sweep")] = Work::sweep;
        works_[machine.loop(process, "extract")] = Work::extract;
    }
}

void DepthActivity::token_read(recording::TokenRead const& read) {
    WindowActivity::token_read(read);
    if (read.fifo != fragment_index_)
        return;
    Token const fragment{read.fields[0], read.fields[1], 0, scans_groups() ? read.fields[2] : 1};
    fragment_before_ = std::exchange(fragment_, fragment);
    fragment_read_ = read.cycle;
}

void DepthActivity::access_for(recording::LoopIteration const& iteration) {
    switch (works_[iteration.loop]) {
        case Work::clear:
            return clear(depth_buffer_, clearing_, iteration.number);
        case Work::draw:
            return draw(iteration.cycle);
        case Work::sweep:
            return sweep(iteration.number);
        case Work::extract:
            return extract(iteration.number);
        case Work::nothing:
            return;
    }
}

bool DepthActivity::is_inner(std::int64_t pixel) const {
    std::int64_t const row = pixel / side();
    std::int64_t const col = pixel % side();
    return row > 0 && col > 0 && row < side() - 1 && col < side() - 1;
}

/// In a flattened loop, an iteration that reads no fragment is a triangle's.
void DepthActivity::draw(Cycles cycle) {
    if (fragment_read_ != cycle)
        return;
    access_fragment(false, fragment_words_.reads);
    access_fragment(true, fragment_words_.writes);
}

void DepthActivity::access_fragment(bool writes, std::vector<PixelOffset> const& words) {
    for (std::int64_t const col : cols_of(fragment_))
        access(depth_buffer_, writes, words, fragment_.row, col);
}

/// Line buffers and pixels with a depth of their own take each word once, in order. Otherwise the pixel and its four
/// neighbours, the border skipped; a word is cleared when its last neighbour has been judged.
void DepthActivity::sweep(std::int64_t iteration) {
    bool const reads_neighbours = sweep_.accesses.reads.size() > static_cast<std::size_t>(lanes_);
    LaneRows const rows = rows_at_hand(lanes_, fragment_before_, fragment_);
    for (std::int64_t const pixel : pixels_of(rows, iteration))
        reads_neighbours ? sweep_neighbours(pixel) : sweep_word(pixel);
    if (sweep_.accesses.writes.empty())
        return;
    auto const tail = static_cast<std::int64_t>(sweep_.tail(rows.tokens_per_row()));
    for (std::int64_t const pixel : pixels_of(rows, iteration - tail))
        access(depth_buffer_, true, pixel);
}

void DepthActivity::sweep_word(std::int64_t pixel) {
    if (sweep_.has_line_buffers || is_inner(pixel))
        access(depth_buffer_, false, pixel);
}

void DepthActivity::sweep_neighbours(std::int64_t pixel) {
    if (!is_inner(pixel))
        return;
    for (PixelOffset const offset : sweep_words_.reads) {
        std::int64_t const word = pixel + offset.row * side() + offset.col;
        if (!ports().has_read(depth_buffer_, static_cast<std::uint64_t>(word)))  // for another lane
            access(depth_buffer_, false, word);
    }
}

/// Reads the word that enters the line buffers, or the whole neighbourhood; writes the judged word with its edge bit.
void DepthActivity::extract(std::int64_t iteration) {
    LaneRows const rows = rows_at_hand(1, fragment_before_, fragment_);
    auto const lead = static_cast<std::int64_t>(extract_.lead(rows.tokens_per_row()));
    for (std::int64_t const entered : pixels_of(rows, extract_.line_buffer_rows > 0 ? iteration : -1))
        access(depth_buffer_, false, entered);
    for (std::int64_t const judged : pixels_of(rows, iteration - lead))
        extract_pixel(judged);
}

void DepthActivity::extract_pixel(std::int64_t judged) {
    for (std::int64_t row = -extract_radius_; extract_.line_buffer_rows == 0 && row <= extract_radius_; ++row)
        for (std::int64_t col = -extract_radius_; col <= extract_radius_; ++col)
            access(depth_buffer_, false, judged / side() + row, judged % side() + col);
    access(depth_buffer_, true, judged);
}

}  // namespace faster
