#pragma once
#include <cstdint>
#include <deque>

#include "dataflow/core/memory/external_memory.hpp"
#include "dataflow/core/memory/memory_block.hpp"

namespace dataflow::timing {

/// Cuts a master's entries into bursts, in order.
class BurstCutter {
  public:
    explicit BurstCutter(ExternalMemory const& shape) : shape_(shape) {}

    void add(MemoryEntry entry) { entries_.push_back(std::move(entry)); }

    /// Goes to the next burst, if the entries so far have one. Before: tokens that come before it and need nothing.
    bool next();
    MemoryBurst const& burst() const { return burst_; }
    /// Entries that have been begun, counted from 1, and the sample of the last: that of the burst.
    std::uint64_t entry_number() const { return entry_number_; }
    std::uint64_t sample() const { return sample_; }
    /// Tokens that need nothing, before the burst or, if there is none, behind the last. Takes them.
    std::uint64_t take_free_tokens();

  private:
    bool find_piece();
    void begin_block(MemoryBlock const& block);
    void begin_row(std::uint64_t row);
    void skip_to_next_row();
    void cut();
    std::uint64_t end_of_row() const { return row_address_ + block_->bytes; }

    ExternalMemory const& shape_;
    std::deque<MemoryEntry> entries_;
    MemoryBurst burst_;
    std::uint64_t entry_number_ = 0;
    std::uint64_t sample_ = 0;
    std::uint64_t free_tokens_ = 0;
    // Where it is.
    bool in_entry_ = false;
    bool opens_entry_ = false;
    std::size_t next_block_ = 0;
    MemoryBlock const* block_ = nullptr;
    std::uint64_t row_ = 0;          // of those that are fetched
    std::uint64_t row_address_ = 0;  // of its first fetched byte
    std::uint64_t at_ = 0;           // next byte
    std::uint64_t token_ = 0;        // of the row, that ends next
};

}  // namespace dataflow::timing
