#pragma once
#include <array>
#include <functional>
#include <queue>
#include <vector>

#include "faster/accelerator_config.hpp"
#include "kernel/recording/bram_model.hpp"
#include "kernel/recording/fifo_state.hpp"
#include "kernel/recording/signal_filter.hpp"
#include "kernel/recording/vcd_file.hpp"

namespace faster::recording {

/// What is known of one recorded core besides its events.
struct RecordedCore {
    std::size_t core = 0;
    Parts parts;
    Cycles from = 0;  ///< first and last cycle
    Cycles to = 0;
    std::vector<timing::FifoShape> fifos;                ///< by FifoId
    std::vector<std::vector<TokenField>> token_layouts;  ///< by FifoId
    Spools* spools = nullptr;
};

/// The values of a module's `stall`: none, or a FIFO and whether it is empty or full.
constexpr std::int64_t no_stall = 0;
constexpr std::int64_t stall_on(std::size_t fifo, bool is_full) {
    return static_cast<std::int64_t>(1 + 2 * fifo + (is_full ? 1 : 0));
}
/// The values of a module's `state`: between its loops, or in a loop.
constexpr std::int64_t between_loops = 0;
constexpr std::int64_t in_loop(std::size_t loop) { return static_cast<std::int64_t>(1 + loop); }

/// The signals of one core in a value change dump.
class VcdCore {
  public:
    VcdCore(VcdFile& vcd, RecordedCore const& core, AcceleratorConfig const& config, SignalFilter const& filter,
            std::size_t domain);

    /// After the file has begun: what signals say before anything happens.
    void begin();
    /// The first cycle at which a token arrives by itself; ~0: none on the way.
    Cycles next_arrival() const { return arrivals_.empty() ? ~Cycles{0} : arrivals_.top().first; }
    /// The file stands at that cycle.
    void arrive();
    void take(CoreEvent const& event);

  private:
    static constexpr VcdFile::Signal hidden = ~VcdFile::Signal{0};
    struct FifoSignals {
        VcdFile::Signal write = hidden, read = hidden, occupancy = hidden, full = hidden, empty = hidden;
        std::vector<VcdFile::Signal> written, taken;
    };
    struct ModuleSignals {
        VcdFile::Signal state = hidden, iteration = hidden, stall = hidden;
    };
    struct BramPort {
        VcdFile::Signal enable = hidden, write_enable = hidden, address = hidden;
    };

    void declare_module(std::size_t module, SignalFilter const& filter, std::size_t domain);
    void declare_fifo(std::size_t fifo, SignalFilter const& filter, std::size_t domain);
    void declare_bram(std::size_t bram, AcceleratorConfig const& config, SignalFilter const& filter,
                      std::size_t domain);
    void declare_samples(std::size_t domain);
    void set(VcdFile::Signal signal, std::int64_t value) {
        if (signal != hidden)
            vcd_.set(signal, value);
    }
    void show_occupancy(std::size_t fifo);
    void show_token(std::vector<VcdFile::Signal> const& signals, TokenValues const& fields);
    void show_bram(std::vector<BramAccess> const& accesses);
    void take_write(CoreEvent const& event);
    void take_read(CoreEvent const& event);
    void take_stamp(CoreEvent const& event);

    VcdFile& vcd_;
    RecordedCore const& core_;
    BramModel bram_model_;
    std::vector<FifoState> fifos_;
    TokenValues token_read_{};
    std::array<FifoSignals, fifo_count> fifo_signals_;
    std::array<ModuleSignals, module_count> module_signals_;
    std::array<std::vector<BramPort>, bram_count> bram_signals_;
    VcdFile::Signal started_ = hidden, start_ = hidden, ended_ = hidden, end_ = hidden;
    using Arrival = std::pair<Cycles, std::size_t>;  ///< cycle, FIFO
    std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> arrivals_;
};

}  // namespace faster::recording
