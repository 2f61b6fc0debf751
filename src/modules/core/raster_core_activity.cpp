#include "modules/core/raster_core_activity.hpp"

#include <numeric>
#include <utility>

#include "faster/config/edge_map_design.hpp"
#include "faster/data/token_fields.hpp"
#include "modules/core/described_parts.hpp"
#include "modules/edge_map_builder/map_accesses.hpp"
#include "modules/inlier_unit/inlier_unit.hpp"

namespace faster {

namespace {
/// What an iteration of a loop of the inlier unit does around one pixel, as its description says.
AccessPattern accesses_of_inlier_unit(AcceleratorConfig const& config, char const* loop) {
    ModuleDescription unit = InlierUnit::describe(config);
    return loop_of(unit, loop).accesses.at(0).pattern;
}
}  // namespace

RasterCoreActivity::TokenBranch::TokenBranch(PerMap const& touches)
    : edge_map(touched_words(touches.edge_map, 1)), object_map(touched_words(touches.object_map, 1)) {}

RasterCoreActivity::RasterCoreActivity(AcceleratorConfig const& config, Machine const& machine)
    : machine_(machine),
      edge_map_config_(config.edge_map),
      edge_branch_(design_of(config.edge_map.algorithm).edge_token),
      object_branch_(design_of(config.edge_map.algorithm).object_token),
      second_(design_of(config.edge_map.algorithm).second),
      depth_clearing_(config.inlier_unit.clearing),
      fragment_words_(accesses_of_inlier_unit(config, "fragment")),
      sweep_words_(accesses_of_inlier_unit(config, "sweep")),
      sweep_(sweep_design(config)),
      extract_(extract_design(config)),
      extract_radius_(config.edge_extraction.neighbourhood / 2),
      side_(config.window),
      lanes_(config.inlier_unit.sweep_lanes),
      scans_groups_(config.rasterizer.lanes > 1),
      sweeps_touched_(config.inlier_unit.sweep_region == SweepRegion::touched),
      edge_map_builder_(machine.process("edge_map_builder")),
      inlier_unit_(machine.process("inlier_unit")),
      edge_token_(machine.fifo("edge_token")),
      fragment_index_(machine.fifo("fragment_index")),
      map_full_(machine.fifo("map_full")),
      map_free_(machine.fifo("map_free")),
      depth_full_(machine.fifo("depth_full")),
      depth_free_(machine.fifo("depth_free")),
      edge_map_(machine.memory("edge_map")),
      object_map_(machine.memory("object_map")),
      depth_buffer_(machine.memory("depth_buffer")),
      works_(machine.loops.size(), Work::nothing),
      buffers_(machine.processes.size()),
      regions_(machine.processes.size()) {
    note_works(machine);
}

/// A loop does the same wherever it stands: in its own module, or in one that reads a second buffer out.
void RasterCoreActivity::note_works(Machine const& machine) {
    auto const note = [&](std::size_t process, char const* loop, Work work) {
        works_[machine.loop(process, loop)] = work;
    };
    std::size_t const inlier_sweep = machine.process("inlier_sweep");
    note(edge_map_builder_, "clear", Work::clear_maps);
    note(edge_map_builder_, "token", Work::take_token);
    note(edge_map_builder_, "output", Work::read_maps_out);
    note(machine.process("edge_map_output"), "output", Work::read_maps_out);
    note(inlier_unit_, "clear", Work::clear_depths);
    note(inlier_unit_, "fragment", Work::draw_fragment);
    for (std::size_t const process : {inlier_unit_, inlier_sweep}) {
        note(process, "sweep", Work::sweep);
        note(process, "extract", Work::extract);
    }
}

void RasterCoreActivity::token_read(recording::TokenRead const& read) {
    if (read.fifo == edge_token_) {
        token_ = std::exchange(next_, edge_token_of(read.fields));
        token_read_ = read.cycle;
    } else if (read.fifo == fragment_index_) {
        Token const fragment{read.fields[0], read.fields[1], 0, scans_groups_ ? read.fields[2] : 1};
        fragment_before_ = std::exchange(fragment_, fragment);
        fragment_read_ = read.cycle;
    } else if (hands_over_buffer(read.fifo)) {
        take_buffer(read);
    }
}

/// The token says which buffer its reader has from now on.
void RasterCoreActivity::take_buffer(recording::TokenRead const& read) {
    buffers_[read.process] = static_cast<std::size_t>(read.fields[0]);
    if (!sweeps_touched_ || !hands_over_full_buffer(read.fifo))
        return;
    std::int64_t const* const corners = read.fields.data() + read.fields.size() - region_fields;
    regions_[read.process] = box_between({corners[0], corners[1]}, {corners[2], corners[3]});
}

/// Groups are of object pixels, and the one that closes the sample has none.
RasterCoreActivity::Token RasterCoreActivity::edge_token_of(recording::TokenValues const& fields) const {
    if (!scans_groups_)
        return {fields[0], fields[1], fields[2], 1};
    return {fields[0], fields[1], static_cast<std::int64_t>(EdgeTokenKind::Object), fields[2]};
}

void RasterCoreActivity::iterated(recording::LoopIteration const& iteration, recording::MemoryPorts& ports) {
    process_ = iteration.process;
    ports_ = &ports;
    switch (works_[iteration.loop]) {
        case Work::clear_maps:
            return clear_maps(iteration.number);
        case Work::take_token:
            return take_token(iteration.cycle);
        case Work::read_maps_out:
            return read_maps_out(iteration.number);
        case Work::clear_depths:
            return clear(depth_buffer_, depth_clearing_, iteration.number);
        case Work::draw_fragment:
            return draw_fragment(iteration.cycle);
        case Work::sweep:
            return sweep(iteration.number);
        case Work::extract:
            return extract(iteration.number);
        case Work::nothing:
            return;
    }
}

/// What two corners enclose, or the window.
PixelBox RasterCoreActivity::box_between(Token const& first, Token const& last) const {
    if (!sweeps_touched_)
        return {0, 0, static_cast<int>(side_), static_cast<int>(side_)};
    return {static_cast<int>(first.row), static_cast<int>(first.col), static_cast<int>(last.row) + 1,
            static_cast<int>(last.col) + 1};
}

/// That the process at hand reads out: it has read the corners last, or got them with its buffer.
PixelBox RasterCoreActivity::box_of_maps() const {
    bool const has_corners = process_ == edge_map_builder_;
    return has_corners || !sweeps_touched_ ? box_between(token_, next_) : regions_[process_];
}

PixelBox RasterCoreActivity::box_of_depths() const {
    bool const has_corners = process_ == inlier_unit_;
    return has_corners || !sweeps_touched_ ? box_between(fragment_before_, fragment_) : regions_[process_];
}

/// The pixels of the window in the iteration's token.
std::vector<std::int64_t> RasterCoreActivity::pixels_of(LaneRows const& rows, std::int64_t iteration) {
    if (iteration < 0 || static_cast<std::size_t>(iteration) >= rows.tokens())
        return {};
    LaneRows::Run const run = rows.run(static_cast<std::size_t>(iteration), 1);
    std::vector<std::int64_t> pixels(run.pixels);
    std::iota(pixels.begin(), pixels.end(), static_cast<std::int64_t>(run.first_pixel));
    return pixels;
}

bool RasterCoreActivity::is_inner(std::int64_t pixel) const {
    std::int64_t const row = pixel / side_;
    std::int64_t const col = pixel % side_;
    return row > 0 && col > 0 && row < side_ - 1 && col < side_ - 1;
}

void RasterCoreActivity::clear_maps(std::int64_t iteration) {
    EdgeMapDesign const& design = design_of(edge_map_config_.algorithm);
    if (design.clear.edge_map > 0)
        clear(edge_map_, edge_map_config_.clearing, iteration);
    if (design.clear.object_map > 0)
        clear(object_map_, edge_map_config_.clearing, iteration);
}

/// A word, or where the loop is wide, the same word of every bank.
void RasterCoreActivity::clear(std::size_t memory, MapClearing clearing, std::int64_t iteration) {
    if (clearing == MapClearing::wide)
        return clear_in_all_banks(memory, static_cast<std::uint64_t>(iteration));
    access(memory, true, iteration);
}

/// Banks with fewer words do not have it.
void RasterCoreActivity::clear_in_all_banks(std::size_t memory, std::uint64_t word) {
    BankPartition const& partition = machine_.memories[memory].partition;
    for (std::uint64_t bank = 0; word < partition.bank_words() && bank < partition.banks(); ++bank) {
        PixelOffset const at = partition.word_of(bank, word);
        if (at.row < side_ && at.col < side_ && partition.bank_of(at.row, at.col) == bank)
            access(memory, true, at.row, at.col);
    }
}

/// An iteration that reads the next token consumes the one before; the one behind it is that token's second.
void RasterCoreActivity::take_token(Cycles cycle) {
    bool const is_edge = token_.kind == static_cast<std::int64_t>(EdgeTokenKind::Edge);
    TokenBranch const& branch = cycle != token_read_ ? second_ : is_edge ? edge_branch_ : object_branch_;
    for (std::int64_t lane = 0; token_.mask >> lane != 0; ++lane) {
        std::int64_t const col = token_.col + lane;
        if ((token_.mask >> lane) % 2 == 0 || token_.row < 0 || token_.row >= side_ || col < 0 || col >= side_)
            continue;
        access_words(edge_map_, branch.edge_map, token_.row, col);
        access_words(object_map_, branch.object_map, token_.row, col);
    }
}

/// What an access pattern says of a pixel's word and of those around it.
void RasterCoreActivity::access_words(std::size_t memory, AccessPattern const& words, std::int64_t row,
                                      std::int64_t col) {
    for (PixelOffset const offset : words.reads)
        access(memory, false, row + offset.row, col + offset.col);
    for (PixelOffset const offset : words.writes)
        access(memory, true, row + offset.row, col + offset.col);
}

/// Iteration i sends token i; where the contour is taken from the object map, it reads a row ahead of what it sends.
/// What it has read it may clear.
void RasterCoreActivity::read_maps_out(std::int64_t iteration) {
    EdgeMapDesign const& design = design_of(edge_map_config_.algorithm);
    bool const clears = edge_map_config_.clearing == MapClearing::on_read_out;
    LaneRows const rows{static_cast<int>(side_), static_cast<int>(lanes_), box_of_maps()};
    for (std::int64_t const pixel : pixels_of(rows, iteration)) {
        access(design.output.edge_map > 0 ? edge_map_ : object_map_, false, pixel);
        if (clears && design.bits.edge_map > 0)
            access(edge_map_, true, pixel);
        if (clears && design.bits.object_map > 0)
            access(object_map_, true, pixel);
    }
}

void RasterCoreActivity::draw_fragment(Cycles cycle) {
    if (fragment_read_ != cycle)  // a triangle's, in a flattened loop
        return;
    access_around(depth_buffer_, false, fragment_words_.reads, fragment_);
    access_around(depth_buffer_, true, fragment_words_.writes, fragment_);
}

/// Line buffers and pixels with a depth of their own take each word once, in order. Otherwise the pixel and its four
/// neighbours, the border skipped; a word is cleared when its last neighbour has been judged.
void RasterCoreActivity::sweep(std::int64_t iteration) {
    bool const reads_neighbours = sweep_.accesses.reads.size() > static_cast<std::size_t>(lanes_);
    LaneRows const rows{static_cast<int>(side_), static_cast<int>(lanes_), box_of_depths()};
    for (std::int64_t const pixel : pixels_of(rows, iteration))
        reads_neighbours ? sweep_neighbours(pixel) : sweep_word(pixel);
    if (sweep_.accesses.writes.empty())
        return;
    auto const tail = static_cast<std::int64_t>(sweep_.tail(rows.tokens_per_row()));
    for (std::int64_t const pixel : pixels_of(rows, iteration - tail))
        access(depth_buffer_, true, pixel);
}

void RasterCoreActivity::sweep_word(std::int64_t pixel) {
    if (sweep_.has_line_buffers || is_inner(pixel))
        access(depth_buffer_, false, pixel);
}

void RasterCoreActivity::sweep_neighbours(std::int64_t pixel) {
    std::int64_t const row = pixel / side_;
    std::int64_t const col = pixel % side_;
    if (!is_inner(pixel))
        return;
    for (PixelOffset const offset : sweep_words_.reads) {
        std::int64_t const word = (row + offset.row) * side_ + col + offset.col;
        if (!ports_->has_read(depth_buffer_, static_cast<std::uint64_t>(word)))  // for another lane
            access(depth_buffer_, false, word);
    }
}

/// Reads the word that enters the line buffers, or the whole neighbourhood; writes the judged word with its edge bit.
void RasterCoreActivity::extract(std::int64_t iteration) {
    LaneRows const rows{static_cast<int>(side_), 1, box_of_depths()};
    auto const lead = static_cast<std::int64_t>(extract_.lead(rows.tokens_per_row()));
    for (std::int64_t const entered : pixels_of(rows, extract_.line_buffer_rows > 0 ? iteration : -1))
        access(depth_buffer_, false, entered);
    for (std::int64_t const judged : pixels_of(rows, iteration - lead))
        extract_pixel(judged);
}

void RasterCoreActivity::extract_pixel(std::int64_t judged) {
    for (std::int64_t row = -extract_radius_; extract_.line_buffer_rows == 0 && row <= extract_radius_; ++row)
        for (std::int64_t col = -extract_radius_; col <= extract_radius_; ++col)
            access(depth_buffer_, false, judged / side_ + row, judged % side_ + col);
    access(depth_buffer_, true, judged);
}

void RasterCoreActivity::access(std::size_t memory, bool writes, std::int64_t pixel) {
    auto const address = static_cast<std::uint64_t>(pixel);
    writes ? ports_->write(memory, address, buffers_[process_]) : ports_->read(memory, address, buffers_[process_]);
}

void RasterCoreActivity::access(std::size_t memory, bool writes, std::int64_t row, std::int64_t col) {
    if (row >= 0 && row < side_ && col >= 0 && col < side_)
        access(memory, writes, row * side_ + col);
}

void RasterCoreActivity::access_around(std::size_t memory, bool writes, std::vector<PixelOffset> const& words,
                                       Token const& token) {
    for (std::int64_t lane = 0; token.mask >> lane != 0; ++lane)
        if ((token.mask >> lane) % 2 != 0)
            for (PixelOffset const offset : words)
                access(memory, writes, token.row + offset.row, token.col + lane + offset.col);
}

}  // namespace faster
