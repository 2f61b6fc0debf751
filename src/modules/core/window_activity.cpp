#include "modules/core/window_activity.hpp"

#include <numeric>

#include "faster/data/token_fields.hpp"

namespace faster {

WindowActivity::WindowActivity(AcceleratorConfig const& config, Machine const& machine, Buffers const& buffers)
    : machine_(machine),
      fifos_(buffers),
      side_(config.window),
      scans_groups_(config.rasterizer.lanes > 1),
      has_regions_(config.inlier_unit.sweep_region == SweepRegion::touched),
      buffers_(machine.processes.size()),
      regions_(machine.processes.size()) {}

void WindowActivity::token_read(recording::TokenRead const& read) {
    if (read.fifo == fifos_.full || read.fifo == fifos_.free)
        take_buffer(read);
}

/// The token says which buffer its reader has from now on.
void WindowActivity::take_buffer(recording::TokenRead const& read) {
    buffers_[read.process] = static_cast<std::size_t>(read.fields[0]);
    if (!has_regions_ || read.fifo != fifos_.full)
        return;
    std::int64_t const* const corners = read.fields.data() + read.fields.size() - region_fields;
    regions_[read.process] = box_between({corners[0], corners[1]}, {corners[2], corners[3]});
}

void WindowActivity::iterated(recording::LoopIteration const& iteration, recording::MemoryPorts& ports) {
    process_ = iteration.process;
    ports_ = &ports;
    access_for(iteration);
}

PixelBox WindowActivity::box_between(Token const& first, Token const& last) {
    return {static_cast<int>(first.row), static_cast<int>(first.col), static_cast<int>(last.row) + 1,
            static_cast<int>(last.col) + 1};
}

PixelBox WindowActivity::box_at_hand(Token const& first, Token const& last) const {
    if (!has_regions_)
        return {0, 0, static_cast<int>(side_), static_cast<int>(side_)};
    return process_ == fifos_.filled_by ? box_between(first, last) : regions_[process_];
}

LaneRows WindowActivity::rows_at_hand(std::int64_t lanes, Token const& first, Token const& last) const {
    return {static_cast<int>(side_), static_cast<int>(lanes), box_at_hand(first, last)};
}

std::vector<std::int64_t> WindowActivity::cols_of(Token const& token) {
    std::vector<std::int64_t> cols;
    for (std::int64_t lane = 0; token.mask >> lane != 0; ++lane)
        if ((token.mask >> lane) % 2 != 0)
            cols.push_back(token.col + lane);
    return cols;
}

std::vector<std::int64_t> WindowActivity::pixels_of(LaneRows const& rows, std::int64_t iteration) {
    if (iteration < 0 || static_cast<std::size_t>(iteration) >= rows.tokens())
        return {};
    LaneRows::Run const run = rows.run(static_cast<std::size_t>(iteration), 1);
    std::vector<std::int64_t> pixels(run.pixels);
    std::iota(pixels.begin(), pixels.end(), static_cast<std::int64_t>(run.first_pixel));
    return pixels;
}

void WindowActivity::clear(std::size_t memory, MapClearing clearing, std::int64_t iteration) {
    if (clearing == MapClearing::wide)
        return clear_in_all_banks(memory, static_cast<std::uint64_t>(iteration));
    access(memory, true, iteration);
}

/// Banks with fewer words do not have it.
void WindowActivity::clear_in_all_banks(std::size_t memory, std::uint64_t word) {
    BankPartition const& partition = machine_.memories[memory].partition;
    for (std::uint64_t bank = 0; word < partition.bank_words() && bank < partition.banks(); ++bank) {
        PixelOffset const at = partition.word_of(bank, word);
        if (at.row < side_ && at.col < side_ && partition.bank_of(at.row, at.col) == bank)
            access(memory, true, at.row, at.col);
    }
}

void WindowActivity::access(std::size_t memory, bool writes, std::int64_t pixel) {
    auto const address = static_cast<std::uint64_t>(pixel);
    writes ? ports_->write(memory, address, buffers_[process_]) : ports_->read(memory, address, buffers_[process_]);
}

void WindowActivity::access(std::size_t memory, bool writes, std::int64_t row, std::int64_t col) {
    if (row >= 0 && row < side_ && col >= 0 && col < side_)
        access(memory, writes, row * side_ + col);
}

void WindowActivity::access(std::size_t memory, bool writes, std::vector<PixelOffset> const& words, std::int64_t row,
                            std::int64_t col) {
    for (PixelOffset const offset : words)
        access(memory, writes, row + offset.row, col + offset.col);
}

void WindowActivity::access_around(std::size_t memory, AccessPattern const& words, std::int64_t row, std::int64_t col) {
    access(memory, false, words.reads, row, col);
    access(memory, true, words.writes, row, col);
}

}  // namespace faster
