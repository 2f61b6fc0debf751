#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "faster/dataflow_names.hpp"
#include "support/twin_function.hpp"

namespace faster::testing {

// The rules of docs/memory-model.md once more, written from that page alone and cycle by cycle.

/// Keys `accelerator.memory.*` as plain values, with the defaults of that page.
struct TwinMemory {
    bool is_axi = false;
    std::uint64_t ports = 3;
    std::uint64_t port_bytes = 16;
    std::uint64_t burst_bytes = 256;
    std::uint64_t outstanding = 16;
    Cycles request_cycles = 24;
    double read_latency_ns = 120;
    double dram_gb_per_s = 19.2;
    double dram_efficiency = 0.75;
    bool prefetch = false;
    bool mesh_on_chip = false;
    bool observation_on_chip = false;
    std::uint64_t observation_copies = 1;
    std::uint64_t mesh_address = 0x10000000;
    std::uint64_t image_address = 0x20000000;
    std::uint64_t table_address = 0x28000000;
    std::uint64_t header_address = 0x30000000;
    std::uint64_t result_address = 0x38000000;
};

/// Cores that share a copy of the observation on the chip.
std::size_t cores_of_a_copy(TwinMemory const& memory, std::size_t cores);

/// A core's masters, in the order that settles ties.
enum class TwinMaster : std::uint8_t { header, vertex, observation, result };
constexpr std::size_t master_count = 4;

/// Bytes that a master reads or writes one after the other, token by token. A token of 0 bytes is not fetched.
struct TwinRange {
    std::uint64_t address = 0;
    std::vector<std::uint64_t> token_bytes;
};
using TwinRanges = std::vector<TwinRange>;

TwinRanges header_ranges(TwinMemory const& memory, std::size_t sample);
TwinRanges mesh_ranges(TwinMemory const& memory, std::size_t triangles);
TwinRanges table_ranges(TwinMemory const& memory, Stimulus const& stimulus, std::size_t sample);
TwinRanges row_ranges(TwinMemory const& memory, Stimulus const& stimulus, std::size_t sample, TwinRegion const& region,
                      std::size_t lanes);
TwinRanges result_ranges(TwinMemory const& memory, std::size_t sample);

/// What became of a master's bursts.
struct TwinTraffic {
    std::uint64_t bursts = 0;
    std::uint64_t bytes = 0;     ///< in whole beats
    std::uint64_t granules = 0;  ///< of 64 bytes
    Cycles latency_sum = 0;      ///< from asking to the last beat, or the acknowledgement
    Cycles latency_max = 0;
    Cycles last_asked = 0;

    friend bool operator==(TwinTraffic const& a, TwinTraffic const& b) {
        return a.bursts == b.bursts && a.bytes == b.bytes && a.granules == b.granules &&
               a.latency_sum == b.latency_sum && a.latency_max == b.latency_max && a.last_asked == b.last_asked;
    }
};

/// Asks for the bursts of its entries, in order, and knows when their tokens are there.
class TwinMasterModel {
  public:
    static constexpr Cycles never = std::numeric_limits<Cycles>::max();

    TwinMasterModel(TwinMemory const& memory, std::size_t port, bool writes)
        : memory_(&memory), port_(port), writes_(writes) {}

    /// The ranges of an entry, which begins in a cycle that `begin_entry` will say.
    void add_entry(TwinRanges const& ranges);
    void begin_entry(std::size_t entry, Cycles cycle) {
        entries_.at(entry).begin = cycle;
        entries_.at(entry).given.assign(entries_.at(entry).given.size(), cycle);
    }
    /// Of what is written, token by token instead: from which cycle on it is there.
    void give(std::size_t entry, std::size_t token, Cycles cycle) { entries_.at(entry).given.at(token) = cycle; }
    std::size_t entries() const { return entries_.size(); }

    /// First cycle in which a token can be read; `never` while its burst has not been asked for.
    Cycles token_legal_from(std::size_t entry, std::size_t token) const;
    void take(std::size_t entry, std::size_t token, Cycles cycle);
    std::size_t tokens(std::size_t entry) const { return entries_.at(entry).tokens.size(); }

    /// When it will ask for its next burst, as far as is known.
    Cycles next_ask() const;
    TwinTraffic traffic() const;

  private:
    friend class TwinMemoryModel;

    struct Burst {
        std::size_t entry = 0;
        std::uint64_t beats = 0;
        std::uint64_t granules = 0;
        std::size_t tokens_to_take = 0;  ///< of those that end in it
        Cycles last_taken = 0;
        std::size_t last_token = 0;  ///< that has a byte in it
        Cycles asked = never;
        Cycles first_beat = never;
        Cycles answered = never;  ///< last beat, or acknowledgement
    };
    struct Token {
        bool is_fetched = false;
        std::size_t burst = 0;   ///< in which it ends
        std::uint64_t beat = 0;  ///< of the burst: with its last byte
    };
    struct Entry {
        Cycles begin = never;
        std::vector<Token> tokens;
        std::vector<Cycles> given;  ///< by token
    };

    void cut(std::uint64_t begin, std::uint64_t end);
    void note_token(std::size_t first_burst, std::uint64_t range_begin, std::uint64_t begin, std::uint64_t end);
    static Cycles done(Burst const& burst);

    TwinMemory const* memory_;
    std::size_t port_;
    bool writes_;
    std::vector<Entry> entries_;
    std::vector<Burst> bursts_;
    std::size_t next_ = 0;  ///< burst to ask for
};

/// Ports and controller. Masters are added in the order that settles ties.
class TwinMemoryModel {
  public:
    /// Throws std::invalid_argument on values outside the ranges of docs/memory-model.md.
    TwinMemoryModel(TwinMemory const& memory, double clock_mhz);
    TwinMemoryModel(TwinMemoryModel const&) = delete;  // its masters refer to its parameters
    TwinMemoryModel& operator=(TwinMemoryModel const&) = delete;
    TwinMemoryModel(TwinMemoryModel&&) = delete;
    TwinMemoryModel& operator=(TwinMemoryModel&&) = delete;
    ~TwinMemoryModel() = default;

    /// Returns its number.
    std::size_t add_master(std::size_t port, bool writes);
    TwinMasterModel& master(std::size_t number) { return masters_.at(number); }
    TwinMasterModel const& master(std::size_t number) const { return masters_.at(number); }

    /// All that processes do in this cycle is done.
    void end_cycle(Cycles cycle);
    /// Nobody will ask for anything, as far as is known.
    bool is_idle() const;

    std::uint64_t port_beats(std::size_t port) const { return ports_.at(port).beats; }
    std::uint64_t controller_ps() const { return controller_ps_; }

  private:
    struct Port {
        Cycles free_from = 0;  ///< for the next read's first beat
        std::uint64_t beats = 0;
    };

    void serve(TwinMasterModel& master, Cycles asked);

    TwinMemory const memory_;
    std::uint64_t const period_ps_;
    std::uint64_t const latency_ps_;
    std::uint64_t const granule_ps_;
    std::vector<TwinMasterModel> masters_;
    std::vector<Port> ports_;
    std::uint64_t controller_end_ps_ = 0;
    std::uint64_t controller_ps_ = 0;  ///< spent serving
};

/// Cycles before cycle 0 in which meshes and images are brought to the chip.
Cycles load_cycles(TwinMemory const& memory, double clock_mhz, Stimulus const& stimulus, std::size_t cores);

}  // namespace faster::testing
