#pragma once
#include <cstdint>
#include <vector>

namespace dataflow::timing {

/// Rows of tokens that a process takes from memory, or one range, which is a row. A row is a grid of tokens; of its
/// bytes only those from `address` on are fetched, `bytes` of them, as if the others were known. Tokens without fetched
/// bytes need nothing.
struct MemoryBlock {
    std::uint64_t address = 0;  ///< of the first byte fetched of the first row that fetches any
    std::uint64_t bytes = 0;    ///< fetched of a row; 0: nothing is fetched at all
    std::uint64_t lead = 0;     ///< bytes of a row's tokens before the first that is fetched
    std::uint64_t token_bytes = 1;
    std::uint64_t tokens = 1;        ///< of a row
    std::uint64_t rows = 1;          ///< in all
    std::uint64_t first_row = 0;     ///< that fetches
    std::uint64_t fetched_rows = 1;  ///< from first_row on
    std::uint64_t pitch = 0;         ///< bytes from a row to the next

    std::uint64_t all_tokens() const { return rows * tokens; }
};

/// What a process takes from memory, or puts there, in one go: in one entry of a loop, or in a step.
struct MemoryEntry {
    std::uint64_t sample = 0;  ///< of its core, from 0 on
    std::vector<MemoryBlock> blocks;

    std::uint64_t all_tokens() const {
        std::uint64_t tokens = 0;
        for (MemoryBlock const& block : blocks)
            tokens += block.all_tokens();
        return tokens;
    }
};

/// A piece of a range that is asked for at once. A token ends in the burst that has its last byte.
struct MemoryBurst {
    std::uint64_t address = 0;  ///< a multiple of a beat's bytes
    std::uint64_t beats = 0;
    std::uint64_t granules = 0;
    std::uint64_t tokens = 0;      ///< that end in it
    std::uint64_t first_last = 0;  ///< address of the last byte of the first of them
    std::uint64_t last_last = 0;   ///< and at most that of the others
    std::uint64_t token_bytes = 1;
    bool opens_entry = false;  ///< the first of an entry
    bool is_cut = false;       ///< within a token, at its end

    std::uint64_t last_byte_of(std::uint64_t token) const {
        std::uint64_t const last = first_last + token * token_bytes;
        return last < last_last ? last : last_last;
    }
};

}  // namespace dataflow::timing
