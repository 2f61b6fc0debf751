#pragma once
#include <cstdint>
#include <deque>
#include <optional>

#include "dataflow/core/memory/burst_cutter.hpp"
#include "dataflow/core/memory/memory_figures.hpp"
#include "dataflow/core/memory/memory_stream.hpp"

namespace dataflow::timing {

/// One master: decides when it asks for which burst (docs/memory-model.md). It follows its process's stream, and a
/// header stream's takes if it prefetches what headers tell of.
class MemoryMaster {
  public:
    /// The cycle after that in which a core's header was handed out; by sample.
    using HandedOut = std::deque<Cycles>;

    MemoryMaster(ExternalMemory const& shape, MemoryStream& stream, Prefetch prefetch, HandedOut const& handed_out);

    MemoryStream& stream() const { return stream_; }
    void add(MemoryEntry entry) { cutter_.add(std::move(entry)); }

    /// Looks at what the process has done since. Then the next burst may be known, and when it is asked for. True if
    /// tokens have been delivered that need nothing.
    bool follow(HandedOut* handing_out);
    /// Of the next burst, if that is known already.
    std::optional<Cycles> next_ask() const { return ask_; }
    MemoryBurst const& next_burst() const { return cutter_.burst(); }
    /// The next burst has been served: its first beat, or its acknowledgement, is in a cycle. Delivers its tokens.
    /// Returns from when on the first of them can be read; `never` if there is none.
    Cycles served(Cycles cycle);
    MasterFigures const& figures() const { return figures_; }

    static constexpr Cycles never = ~Cycles{0};

  private:
    struct Served {
        std::uint64_t last_token = 0;  ///< that ends in it, in the stream; counted from 1; 0: none does
        Cycles after_last_beat = 0;
    };

    Cycles deliver(MemoryBurst const& burst, Cycles first_beat);
    void take_up_next();
    void find_ask();
    void free_slots(HandedOut* handing_out);
    Cycles cycle_of_entry();
    bool knows_entry() const;

    ExternalMemory const& shape_;
    MemoryStream& stream_;
    Prefetch prefetch_;
    HandedOut const& handed_out_;
    BurstCutter cutter_;
    bool has_burst_ = false;
    std::optional<Cycles> ask_;
    Cycles ask_from_ = 0;        // rule 1: the cycle after the last burst was asked for
    std::uint64_t entries_ = 0;  // of which the cycle is known; of a write, tokens
    Cycles entry_cycle_ = 0;
    std::uint64_t unused_slots_;    // of `outstanding`, that no burst has had yet
    std::deque<Cycles> free_from_;  // the others that are free: from which cycle on
    std::deque<Served> served_;     // and not done
    std::uint64_t delivered_ = 0;   // tokens
    std::uint64_t forgotten_ = 0;   // tokens taken
    MasterFigures figures_;
};

}  // namespace dataflow::timing
