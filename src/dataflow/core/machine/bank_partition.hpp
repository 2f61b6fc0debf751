#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/core/machine/access_pattern.hpp"
#include "dataflow/core/machine/partition_config.hpp"

namespace dataflow {

/// The banks of a memory of `rows` x `cols` words. A bank has the ports of a memory to itself.
///
/// Cyclic with factor F: rows r, r + F, r + 2F, ... share a bank (dimension 1; 2: columns; 0: both, in F x F banks).
/// Block: so do the first ceil(rows / F) rows, then the next. Source: array_partition of Vitis HLS.
class BankPartition {
  public:
    BankPartition(PartitionConfig const& config, std::int64_t rows, std::int64_t cols);
    /// Of a square.
    BankPartition(PartitionConfig const& config, int side) : BankPartition(config, side, side) {}

    std::uint64_t banks() const { return row_banks_ * col_banks_; }

    /// Words of the largest bank.
    std::uint64_t bank_words() const;

    /// The bank of a word of the memory, from 0 on, row by row.
    std::uint64_t bank_of(std::int64_t row, std::int64_t col) const;

    /// The `index`-th word of a bank, counted row by row over a bank of bank_words(); it may lie beyond the memory, or
    /// be another bank's, where banks are not alike. bank_of() tells.
    PixelOffset word_of(std::uint64_t bank, std::uint64_t index) const;

    struct Access {
        PixelOffset at;
        bool writes = false;
    };
    /// The accesses of `pattern` that fall into one bank where most do, wherever in the memory the iteration's pixel
    /// lies. A static schedule has to provide for it. Words beyond the memory's border count: the schedule does not
    /// know the border. Reads first.
    std::vector<Access> fullest_bank(AccessPattern const& pattern) const;
    /// How many they are.
    std::uint64_t accesses_per_bank(AccessPattern const& pattern) const { return fullest_bank(pattern).size(); }

  private:
    std::vector<Access> fullest_of_cycle(std::vector<Access> const& all) const;
    std::vector<Access> fullest_block(std::vector<Access> const& all) const;

    PartitionType type_;
    std::uint64_t row_banks_;
    std::uint64_t col_banks_;
    std::int64_t block_rows_;  ///< of the largest bank
    std::int64_t block_cols_;
};

}  // namespace dataflow
