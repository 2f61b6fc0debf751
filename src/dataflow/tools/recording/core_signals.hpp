#pragma once
#include <functional>
#include <queue>
#include <vector>

#include "dataflow/tools/recording/fifo_state.hpp"
#include "dataflow/tools/recording/memory_trace.hpp"
#include "dataflow/tools/recording/recorded_core.hpp"
#include "dataflow/tools/recording/signal_filter.hpp"
#include "dataflow/tools/recording/waveform.hpp"

namespace dataflow::recording {

/// The signals of one core in a waveform.
class CoreSignals {
  public:
    /// `core` must outlive it.
    CoreSignals(Waveform& waveform, RecordedCore const& core, SignalFilter const& filter, std::size_t domain);

    /// After the waveform has begun: what signals say before anything happens.
    void begin();
    /// The first cycle at which a token arrives by itself; ~0: none on the way.
    Cycles next_arrival() const { return arrivals_.empty() ? ~Cycles{0} : arrivals_.top().first; }
    /// The waveform stands at that cycle.
    void arrive();
    void take(CoreEvent const& event);

  private:
    static constexpr Waveform::Signal hidden = ~Waveform::Signal{0};
    struct FifoSignals {
        Waveform::Signal write = hidden, read = hidden, occupancy = hidden, full = hidden, empty = hidden;
        std::vector<Waveform::Signal> written, taken;
    };
    struct ModuleSignals {
        Waveform::Signal state = hidden, iteration = hidden, stall = hidden;
    };
    struct MemoryPort {
        Waveform::Signal enable = hidden, write_enable = hidden, address = hidden;
    };

    void declare_samples(std::size_t domain);
    void declare_module(std::size_t module, std::size_t domain);
    void declare_memory(std::size_t memory, std::size_t domain);
    void declare_fifo(std::size_t fifo, std::size_t domain);
    void set(Waveform::Signal signal, Waveform::Value value) {
        if (signal != hidden)
            waveform_.set(signal, value);
    }
    void show_occupancy(std::size_t fifo);
    void show_token(std::vector<Waveform::Signal> const& signals, TokenValues const& fields);
    void show_accesses(std::vector<PortAccess> const& accesses);
    void take_write(CoreEvent const& event);
    void take_read(CoreEvent const& event);
    void take_sample(Waveform::Signal number, Waveform::Signal pulse, Event const& event);

    Waveform& waveform_;
    RecordedCore const& core_;
    Machine const& machine_;
    MemoryTrace memory_trace_;
    std::vector<FifoState> fifos_;
    TokenValues token_read_{};
    // By number of the part; hidden, or none, of what is not shown.
    std::vector<FifoSignals> fifo_signals_;
    std::vector<ModuleSignals> module_signals_;
    std::vector<std::vector<MemoryPort>> memory_signals_;
    Waveform::Signal started_ = hidden, start_ = hidden, ended_ = hidden, end_ = hidden;
    using Arrival = std::pair<Cycles, std::size_t>;  ///< cycle, FIFO
    std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> arrivals_;
};

}  // namespace dataflow::recording
