#pragma once
#include <deque>
#include <filesystem>
#include <optional>
#include <vector>

#include "kernel/recording/recorded_core.hpp"

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

}  // namespace faster::rtl
