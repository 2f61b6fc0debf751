#include "dataflow/core/memory/burst_cutter.hpp"

#include <algorithm>
#include <utility>

namespace dataflow::timing {

namespace {
/// To multiples of a power of two.
std::uint64_t round_down(std::uint64_t value, std::uint64_t to) { return value & ~(to - 1); }
std::uint64_t round_up(std::uint64_t value, std::uint64_t to) { return round_down(value + to - 1, to); }
}  // namespace

bool BurstCutter::next() {
    if (!find_piece())
        return false;
    cut();
    return true;
}

std::uint64_t BurstCutter::take_free_tokens() { return std::exchange(free_tokens_, 0); }

/// The next byte that is to be fetched; counts tokens on the way there that need nothing.
bool BurstCutter::find_piece() {
    for (;;) {
        if (block_ != nullptr && at_ < end_of_row())
            return true;
        if (block_ != nullptr) {
            skip_to_next_row();
        } else if (in_entry_ && next_block_ < entries_.front().blocks.size()) {
            begin_block(entries_.front().blocks[next_block_++]);
        } else if (in_entry_) {
            entries_.pop_front();
            in_entry_ = false;
        } else if (entries_.empty()) {
            return false;
        } else {
            in_entry_ = opens_entry_ = true;
            next_block_ = 0;
            ++entry_number_;
            sample_ = entries_.front().sample;
        }
    }
}

void BurstCutter::begin_block(MemoryBlock const& block) {
    bool const fetches = block.bytes > 0 && block.fetched_rows > 0;
    free_tokens_ += fetches ? block.first_row * block.tokens : block.all_tokens();
    if (!fetches)
        return;
    block_ = &block;
    begin_row(0);
}

void BurstCutter::begin_row(std::uint64_t row) {
    row_ = row;
    row_address_ = at_ = block_->address + row * block_->pitch;
    token_ = block_->lead / block_->token_bytes;
    free_tokens_ += token_;
}

void BurstCutter::skip_to_next_row() {
    MemoryBlock const& block = *block_;
    free_tokens_ += block.tokens - token_;
    if (row_ + 1 == block.fetched_rows) {
        free_tokens_ += (block.rows - block.first_row - block.fetched_rows) * block.tokens;
        block_ = nullptr;
        return;
    }
    begin_row(row_ + 1);
}

void BurstCutter::cut() {
    MemoryBlock const& block = *block_;
    std::uint64_t const end = std::min(end_of_row(), round_down(at_, shape_.burst_bytes) + shape_.burst_bytes);
    std::uint64_t const widened_end = round_up(end, shape_.port_bytes);
    burst_.address = round_down(at_, shape_.port_bytes);
    burst_.beats = (widened_end - burst_.address) / shape_.port_bytes;
    burst_.granules = (round_up(widened_end, ExternalMemory::granule_bytes) -
                       round_down(burst_.address, ExternalMemory::granule_bytes)) /
                      ExternalMemory::granule_bytes;
    // Ends of tokens, as bytes behind the row's grid.
    std::uint64_t const fetched = end - row_address_ + block.lead;
    bool const ends_row = end == end_of_row();
    std::uint64_t const whole =
        ends_row ? (fetched + block.token_bytes - 1) / block.token_bytes : fetched / block.token_bytes;
    burst_.tokens = whole - token_;
    burst_.is_cut = !ends_row && fetched % block.token_bytes != 0;
    burst_.token_bytes = block.token_bytes;
    burst_.first_last = row_address_ + (token_ + 1) * block.token_bytes - block.lead - 1;
    burst_.last_last = end_of_row() - 1;
    burst_.opens_entry = std::exchange(opens_entry_, false);
    token_ = whole;
    at_ = end;
}

}  // namespace dataflow::timing
