#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/core_share.hpp"
#include "dataflow/tools/recording/recorded_core.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/kept_maps.hpp"
#include "tb/cosim/twin_core.hpp"

namespace faster::rtl {

/// The last accesses to the FIFOs of one side of a comparison, with their tokens: enough for a waveform of the last
/// `kept_cycles` cycles. FIFOs have the machine's numbers.
class RecentTokens {
  public:
    static constexpr Cycles kept_cycles = 200;

    explicit RecentTokens(std::size_t fifos = 0) : tokens_(fifos) {}

    void write(std::size_t fifo, Cycles cycle, recording::TokenValues token) {
        tokens_[fifo].push_back({std::move(token), cycle, std::nullopt});
    }
    /// Takes the oldest token that is left. Cycles never go back.
    void read(std::size_t fifo, Cycles cycle);

    /// Writes cycles `from` to `to` as a value change dump. `core` says how machine, FIFOs and tokens are named.
    /// Errors: InputError if the file cannot be written.
    void write_vcd(std::filesystem::path const& file, recording::RecordedCore const& core, Cycles from,
                   Cycles to) const;

  private:
    struct Token {
        recording::TokenValues values;
        Cycles written;
        std::optional<Cycles> read;
    };
    recording::Spools spools_of(Machine const& machine) const;

    std::vector<std::deque<Token>> tokens_;  ///< by FIFO
};

/// Where model and twin differ first.
struct Difference {
    Cycles cycle = 0;
    std::string what;                  ///< FIFO or memory, and both values; one line
    std::vector<std::string> history;  ///< accesses of both in the last cycles with any, a line each
    // For waveforms: some cycles before it, and some after it, in which model and twin went on.
    Cycles from = 0;
    Cycles to = 0;
    RecentTokens model;
    RecentTokens twin;
};

/// What a comparison went through.
struct Compared {
    Cycles cycles = 0;
    std::uint64_t writes = 0;
    std::uint64_t reads = 0;
    std::uint64_t maps = 0;
    double twin_seconds = 0;  ///< of the host, for the twin alone
    std::optional<Difference> difference;
};

/// Goes with the twin through everything that was recorded of a core of the model, from cycle 0 on: every write with
/// its token, every read, in its cycle, and every sample's maps; up to the first difference. Behind the last access the
/// twin has to keep still. `progress` is told now and then how many cycles are done.
Compared compare(recording::RecordedCore const& model, KeptMaps const& maps, TwinSettings const& settings,
                 Stimulus const& stimulus, CoreShare share, std::function<void(Cycles)> const& progress = {});

}  // namespace faster::rtl
