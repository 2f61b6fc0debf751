#include "kernel/recording/bram_model.hpp"

#include <algorithm>
#include <numeric>

#include "common/token_fields.hpp"
#include "faster/edge_map_design.hpp"

namespace faster::recording {

using Kind = Event::Kind;

namespace {
/// Its tokens say which buffer their reader has from now on.
bool hands_over_buffers(FifoId id) {
    return id == FifoId::map_full || id == FifoId::map_free || id == FifoId::depth_full || id == FifoId::depth_free;
}
bool hands_over_full_buffers(FifoId id) { return id == FifoId::map_full || id == FifoId::depth_full; }
}  // namespace

BramModel::BramModel(AcceleratorConfig const& config)
    : edge_map_(config.edge_map),
      depth_clearing_(config.inlier_unit.clearing),
      sweep_(sweep_design(config)),
      extract_(extract_design(config)),
      extract_radius_(config.edge_extraction.neighbourhood / 2),
      side_(config.window),
      lanes_(config.inlier_unit.sweep_lanes),
      scans_groups_(config.rasterizer.lanes > 1),
      sweeps_touched_(config.inlier_unit.sweep_region == SweepRegion::touched) {
    for (std::size_t i = 0; i < bram_count; ++i) {
        ports_[i] = config.brams[i].ports;
        partitions_.emplace_back(config.brams[i].partition, config.window);
    }
}

std::vector<BramAccess> const& BramModel::take(CoreEvent const& core_event, TokenValues const& fields) {
    Event const& event = core_event.event;
    accesses_.clear();
    module_ = core_event.module;
    if (event.kind == Kind::enter) {
        loop_[core_event.module] = event.item;
    } else if (event.kind == Kind::read && event.item == index_of(FifoId::edge_token)) {
        token_ = next_;
        next_ = token_of(fields);
        token_read_ = event.cycle;
    } else if (event.kind == Kind::read && event.item == index_of(FifoId::fragment_index)) {
        fragment_before_ = fragment_;
        fragment_ = {fields[0], fields[1], 0, scans_groups_ ? fields[2] : 1};
        fragment_read_ = event.cycle;
    } else if (event.kind == Kind::read && hands_over_buffers(FifoId{event.item})) {
        take_buffer(FifoId{event.item}, fields);
    } else if (event.kind == Kind::iterate) {
        iterate(configured_as(static_cast<LoopId>(loop_[module_])), event);
    }
    return accesses_;
}

void BramModel::take_buffer(FifoId fifo, TokenValues const& fields) {
    buffer_[module_] = static_cast<std::size_t>(fields[0]);
    if (!sweeps_touched_ || !hands_over_full_buffers(fifo))
        return;
    std::int64_t const* const corners = fields.data() + fields.size() - region_fields;
    region_[module_] = box_between({corners[0], corners[1]}, {corners[2], corners[3]});
}

/// Groups are of object pixels, and the one that closes the sample has none.
BramModel::Token BramModel::token_of(TokenValues const& fields) const {
    if (!scans_groups_)
        return {fields[0], fields[1], fields[2], 1};
    return {fields[0], fields[1], static_cast<std::int64_t>(EdgeTokenKind::Object), fields[2]};
}

void BramModel::add_pixels(BramId bram, bool writes, Token const& token, Cycles cycle) {
    for (std::int64_t lane = 0; token.mask >> lane != 0; ++lane)
        if ((token.mask >> lane) % 2 != 0)
            add(bram, writes, token.row, token.col + lane, cycle);
}

void BramModel::iterate(LoopId loop, Event const& event) {
    switch (loop) {
        case LoopId::edge_clear:
            if (design_of(edge_map_.algorithm).clear.edge_map > 0)
                clear_iteration(BramId::edge_map, edge_map_.clearing, event);
            if (design_of(edge_map_.algorithm).clear.object_map > 0)
                clear_iteration(BramId::object_map, edge_map_.clearing, event);
            return;
        case LoopId::output:
            return output_iteration(event.value, event.cycle);
        case LoopId::depth_clear:
            return clear_iteration(BramId::depth_buffer, depth_clearing_, event);
        case LoopId::token:
            return token_iteration(event.cycle);
        case LoopId::fragment:
            return fragment_iteration(event.cycle);
        case LoopId::sweep:
            return sweep_iteration(event.value, event.cycle);
        case LoopId::extract:
            return extract_iteration(event.value, event.cycle);
        case LoopId::vertex:
        case LoopId::scan:
        default:
            return;
    }
}

/// A word, or where the loop is wide, the same word of every bank; banks with fewer words have none.
void BramModel::clear_iteration(BramId bram, MapClearing clearing, Event const& event) {
    if (clearing != MapClearing::wide)
        return add(bram, true, event.value, event.cycle);
    BankPartition const& partition = partitions_[index_of(bram)];
    auto const word = static_cast<std::uint64_t>(event.value);
    for (std::uint64_t bank = 0; word < partition.bank_words() && bank < partition.banks(); ++bank) {
        PixelOffset const at = partition.word_of(bank, word);
        if (at.row < side_ && at.col < side_ && partition.bank_of(at.row, at.col) == bank)
            add(bram, true, at.row, at.col, event.cycle);
    }
}

/// What two corners enclose, or the window.
PixelBox BramModel::box_between(Token const& first, Token const& last) const {
    if (!sweeps_touched_)
        return {0, 0, static_cast<int>(side_), static_cast<int>(side_)};
    return {static_cast<int>(first.row), static_cast<int>(first.col), static_cast<int>(last.row) + 1,
            static_cast<int>(last.col) + 1};
}

/// That the process at hand reads out: it has read the corners last, or got them with its buffer.
PixelBox BramModel::box_of_maps() const {
    bool const has_corners = module_ == index_of(ModuleId::edge_map_builder);
    return has_corners || !sweeps_touched_ ? box_between(token_, next_) : region_[module_];
}

PixelBox BramModel::box_of_depths() const {
    bool const has_corners = module_ == index_of(ModuleId::inlier_unit);
    return has_corners || !sweeps_touched_ ? box_between(fragment_before_, fragment_) : region_[module_];
}

LaneRows BramModel::swept_rows() const { return {static_cast<int>(side_), static_cast<int>(lanes_), box_of_depths()}; }

/// The pixels of the window in the iteration's token.
std::vector<std::int64_t> BramModel::pixels_of(LaneRows const& rows, std::int64_t iteration) {
    if (iteration < 0 || static_cast<std::size_t>(iteration) >= rows.tokens())
        return {};
    LaneRows::Run const run = rows.run(static_cast<std::size_t>(iteration), 1);
    std::vector<std::int64_t> pixels(run.pixels);
    std::iota(pixels.begin(), pixels.end(), static_cast<std::int64_t>(run.first_pixel));
    return pixels;
}

/// An iteration that reads the next token consumes the one before; the one behind it is that token's second.
void BramModel::token_iteration(Cycles cycle) {
    auto const& [row, col, kind, mask] = token_;
    bool const has_neighbours = edge_map_.algorithm != EdgeMapAlgorithm::inner_border;
    if (has_neighbours && (row < 0 || row >= side_ || col < 0 || col >= side_))
        return;
    switch (edge_map_.algorithm) {
        case EdgeMapAlgorithm::threshold:
        case EdgeMapAlgorithm::transition:
        case EdgeMapAlgorithm::bounded:
            return single_map_token(cycle);
        case EdgeMapAlgorithm::dual_map:
        case EdgeMapAlgorithm::dual_map_4_1_2:
            return dual_map_token(cycle == token_read_, cycle);
        case EdgeMapAlgorithm::inner_border:
            if (kind == static_cast<std::int64_t>(EdgeTokenKind::Object))
                add_pixels(BramId::object_map, true, token_, cycle);
            return;
    }
}

/// An edge token looks at its pixel and writes it; so does every token of `threshold`. An object token writes its
/// pixel; in `bounded` it looks at the pixels above and below as well, and writes them.
void BramModel::single_map_token(Cycles cycle) {
    auto const& [row, col, kind, mask] = token_;
    bool const is_edge = kind == static_cast<std::int64_t>(EdgeTokenKind::Edge);
    bool const looks_around = !is_edge && edge_map_.algorithm == EdgeMapAlgorithm::bounded;
    if (is_edge)
        add(BramId::edge_map, false, row, col, cycle);
    for (std::int64_t const side : {1, -1})
        if (looks_around)
            add(BramId::edge_map, false, row + side, col, cycle);
    add(BramId::edge_map, true, row, col, cycle);
    for (std::int64_t const side : {1, -1})
        if (looks_around)
            add(BramId::edge_map, true, row + side, col, cycle);
}

void BramModel::dual_map_token(bool is_first, Cycles cycle) {
    auto const& [row, col, kind, mask] = token_;
    bool const writes_first = edge_map_.algorithm == EdgeMapAlgorithm::dual_map_4_1_2;
    if (kind == static_cast<std::int64_t>(EdgeTokenKind::Edge)) {
        add(BramId::object_map, false, row, col, cycle);
        add(BramId::edge_map, true, row, col, cycle);
        return;
    }
    if (is_first) {
        add(BramId::edge_map, true, row, col, cycle);
        add(BramId::object_map, false, row + 1, col, cycle);
        add(BramId::object_map, false, row - 1, col, cycle);
    }
    if (is_first == writes_first)
        add(BramId::object_map, true, row, col, cycle);
    if (!is_first) {
        add(BramId::edge_map, true, row + 1, col, cycle);
        add(BramId::edge_map, true, row - 1, col, cycle);
    }
}

/// Iteration i sends token i; where the contour is taken from the object map, it reads a row ahead of what it sends.
/// What it has read it may clear.
void BramModel::output_iteration(std::int64_t iteration, Cycles cycle) {
    EdgeMapDesign const& design = design_of(edge_map_.algorithm);
    bool const clears = edge_map_.clearing == MapClearing::on_read_out;
    LaneRows const rows{static_cast<int>(side_), static_cast<int>(lanes_), box_of_maps()};
    for (std::int64_t const pixel : pixels_of(rows, iteration)) {
        add(design.output.edge_map > 0 ? BramId::edge_map : BramId::object_map, false, pixel, cycle);
        if (clears && design.bits.edge_map > 0)
            add(BramId::edge_map, true, pixel, cycle);
        if (clears && design.bits.object_map > 0)
            add(BramId::object_map, true, pixel, cycle);
    }
}

void BramModel::fragment_iteration(Cycles cycle) {
    if (fragment_read_ != cycle)  // a triangle's, in a flattened loop
        return;
    add_pixels(BramId::depth_buffer, false, fragment_, cycle);
    add_pixels(BramId::depth_buffer, true, fragment_, cycle);
}

/// Reads the word that enters the line buffers, or the whole neighbourhood; writes the judged word with its edge bit.
void BramModel::extract_iteration(std::int64_t iteration, Cycles cycle) {
    LaneRows const rows{static_cast<int>(side_), 1, box_of_depths()};
    auto const lead = static_cast<std::int64_t>(extract_.lead(rows.tokens_per_row()));
    for (std::int64_t const entered : pixels_of(rows, extract_.line_buffer_rows > 0 ? iteration : -1))
        add(BramId::depth_buffer, false, entered, cycle);
    for (std::int64_t const judged : pixels_of(rows, iteration - lead))
        extract_pixel(judged, cycle);
}

void BramModel::extract_pixel(std::int64_t judged, Cycles cycle) {
    for (std::int64_t row = -extract_radius_; extract_.line_buffer_rows == 0 && row <= extract_radius_; ++row)
        for (std::int64_t col = -extract_radius_; col <= extract_radius_; ++col)
            add(BramId::depth_buffer, false, judged / side_ + row, judged % side_ + col, cycle);
    add(BramId::depth_buffer, true, judged, cycle);
}

/// Line buffers and pixels with a depth of their own take each word once, in order. Otherwise the pixel and its four
/// neighbours, the border skipped; a word is cleared when its last neighbour has been judged.
void BramModel::sweep_iteration(std::int64_t iteration, Cycles cycle) {
    bool const reads_neighbours = sweep_.accesses.reads.size() > static_cast<std::size_t>(lanes_);
    LaneRows const rows = swept_rows();
    for (std::int64_t const pixel : pixels_of(rows, iteration))
        reads_neighbours ? sweep_neighbours(pixel, cycle) : sweep_word(pixel, cycle);
    if (!sweep_.accesses.writes.empty())
        for (std::int64_t const pixel :
             pixels_of(rows, iteration - static_cast<std::int64_t>(sweep_.tail(rows.tokens_per_row()))))
            add(BramId::depth_buffer, true, pixel, cycle);
}

void BramModel::sweep_word(std::int64_t pixel, Cycles cycle) {
    if (sweep_.has_line_buffers || is_inner(pixel))
        add(BramId::depth_buffer, false, pixel, cycle);
}

void BramModel::sweep_neighbours(std::int64_t pixel, Cycles cycle) {
    std::int64_t const row = pixel / side_;
    std::int64_t const col = pixel % side_;
    if (!is_inner(pixel))
        return;
    for (auto const& [r, c] : {std::pair{row + 1, col}, {row - 1, col}, {row, col + 1}, {row, col - 1}, {row, col}})
        if (!is_read(BramId::depth_buffer, r * side_ + c))  // by another lane
            add(BramId::depth_buffer, false, r, c, cycle);
}

bool BramModel::is_read(BramId bram, std::int64_t address) const {
    return std::any_of(accesses_.begin(), accesses_.end(), [&](BramAccess const& access) {
        return !access.writes && access.bram == index_of(bram) && access.address == static_cast<std::uint64_t>(address);
    });
}

bool BramModel::is_inner(std::int64_t pixel) const {
    std::int64_t const row = pixel / side_;
    std::int64_t const col = pixel % side_;
    return row > 0 && col > 0 && row < side_ - 1 && col < side_ - 1;
}

void BramModel::add(BramId bram, bool writes, std::int64_t row, std::int64_t col, Cycles cycle) {
    if (row >= 0 && row < side_ && col >= 0 && col < side_)
        add(bram, writes, row * side_ + col, cycle);
}

void BramModel::add(BramId bram, bool writes, std::int64_t address, Cycles cycle) {
    std::size_t const i = index_of(bram);
    std::size_t const buffer = buffer_[module_];
    std::uint64_t const bank =
        buffer * partitions_[i].banks() + partitions_[i].bank_of(address / side_, address % side_);
    std::uint64_t const number = accesses_so_far(i, bank);
    accesses_.push_back({i, bank * ports_[i] + number % ports_[i], cycle + number / ports_[i], writes,
                         static_cast<std::uint64_t>(address), buffer});
}

std::uint64_t BramModel::accesses_so_far(std::size_t bram, std::uint64_t bank) const {
    auto const is_in_bank = [&](BramAccess const& access) {
        return access.bram == bram && access.port / ports_[bram] == bank;
    };
    return static_cast<std::uint64_t>(std::count_if(accesses_.begin(), accesses_.end(), is_in_bank));
}

}  // namespace faster::recording
