#include "dataflow/core/machine/bank_partition.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace dataflow {
namespace {

std::uint64_t banks_along(std::uint64_t dimension, PartitionConfig const& config) {
    bool const is_split =
        config.type != PartitionType::none && (config.dimension == 0 || config.dimension == dimension);
    return is_split ? config.factor : 1;
}

std::int64_t largest_share(std::int64_t side, std::uint64_t banks) {
    auto const parts = static_cast<std::int64_t>(banks);
    return (side + parts - 1) / parts;
}

/// Remainder of 0 .. divisor - 1, of negative offsets too.
std::int64_t modulo(std::int64_t value, std::uint64_t divisor) {
    auto const m = static_cast<std::int64_t>(divisor);
    return ((value % m) + m) % m;
}

using Accesses = std::vector<BankPartition::Access>;

Accesses all_accesses(AccessPattern const& pattern) {
    Accesses all;
    for (PixelOffset const at : pattern.reads)
        all.push_back({at, false});
    for (PixelOffset const at : pattern.writes)
        all.push_back({at, true});
    return all;
}

}  // namespace

BankPartition::BankPartition(PartitionConfig const& config, std::int64_t rows, std::int64_t cols)
    : type_(config.type),
      row_banks_(banks_along(1, config)),
      col_banks_(banks_along(2, config)),
      block_rows_(largest_share(rows, row_banks_)),
      block_cols_(largest_share(cols, col_banks_)) {}

std::uint64_t BankPartition::bank_words() const { return static_cast<std::uint64_t>(block_rows_ * block_cols_); }

std::uint64_t BankPartition::bank_of(std::int64_t row, std::int64_t col) const {
    bool const is_block = type_ == PartitionType::block;
    std::int64_t const row_bank = is_block ? row / block_rows_ : modulo(row, row_banks_);
    std::int64_t const col_bank = is_block ? col / block_cols_ : modulo(col, col_banks_);
    return static_cast<std::uint64_t>(row_bank) * col_banks_ + static_cast<std::uint64_t>(col_bank);
}

PixelOffset BankPartition::word_of(std::uint64_t bank, std::uint64_t index) const {
    auto const place = [this](std::uint64_t in_bank, std::uint64_t of_dimension, std::uint64_t banks,
                              std::int64_t length) {
        std::uint64_t const block = of_dimension * static_cast<std::uint64_t>(length);
        return static_cast<int>(type_ == PartitionType::block ? block + in_bank : in_bank * banks + of_dimension);
    };
    auto const cols = static_cast<std::uint64_t>(block_cols_);
    return {place(index / cols, bank / col_banks_, row_banks_, block_rows_),
            place(index % cols, bank % col_banks_, col_banks_, block_cols_)};
}

std::vector<BankPartition::Access> BankPartition::fullest_bank(AccessPattern const& pattern) const {
    Accesses all = all_accesses(pattern);
    if (banks() == 1)
        return all;
    return type_ == PartitionType::block ? fullest_block(all) : fullest_of_cycle(all);
}

/// Moving the pixel only renames the banks.
Accesses BankPartition::fullest_of_cycle(Accesses const& all) const {
    std::map<std::uint64_t, Accesses> banks;
    Accesses const* fullest = nullptr;
    for (Access const& access : all) {
        Accesses& bank = banks[bank_of(access.at.row, access.at.col)];
        bank.push_back(access);
        if (fullest == nullptr || bank.size() > fullest->size())
            fullest = &bank;
    }
    return fullest == nullptr ? Accesses() : *fullest;
}

/// A bank is a rectangle, and the pixel may lie anywhere before, in and behind it. The fullest place has an access in
/// its first row and one in its first column: else it could be moved without losing any.
Accesses BankPartition::fullest_block(Accesses const& all) const {
    std::set<int> rows;
    std::set<int> cols;
    for (Access const& access : all) {
        rows.insert(access.at.row);
        cols.insert(access.at.col);
    }
    auto const is_in = [](int at, int first, std::int64_t length, std::uint64_t banks) {
        return banks == 1 || (at >= first && at < first + length);
    };
    Accesses fullest;
    for (int const row : rows)
        for (int const col : cols) {
            Accesses bank;
            std::copy_if(all.begin(), all.end(), std::back_inserter(bank), [&](Access const& access) {
                return is_in(access.at.row, row, block_rows_, row_banks_) &&
                       is_in(access.at.col, col, block_cols_, col_banks_);
            });
            if (bank.size() > fullest.size())
                fullest = std::move(bank);
        }
    return fullest;
}

}  // namespace dataflow
