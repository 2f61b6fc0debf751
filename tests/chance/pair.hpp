#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "channels/clocked_fifo.hpp"
#include "channels/port_binding.hpp"
#include "channels/sample_module.hpp"
#include "channels/simulate.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/core/machine/core_of.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "faster/dataflow_names.hpp"
#include "support/fresh_kernel.hpp"

namespace faster::chance {

// A design of two modules, a writer and a reader, that do whatever a test has them do.

using Token = std::uint32_t;

/// What a module does for a sample.
using Work = std::function<void(ProcessClock& clock, ClockedFifo<Token>& fifo)>;

class Worker : public SampleModule {
  public:
    Worker(sc_core::sc_module_name const& name, DataflowCore& core, Work work)
        : SampleModule(name, core), its_core_(core), work_(std::move(work)) {}

    OptionalFifoIn<Token> port{"port"};

  private:
    void work(std::size_t /*sample*/) override { work_(clock_, its_core_.fifo<Token>("f")); }

    DataflowCore& its_core_;
    Work work_;
};

struct Pair {
    ModuleDescription writer{"writer"}, reader{"reader"};
    Work writes, reads;
    std::optional<std::size_t> results = {};  ///< that the core has in the end; as many as samples
    std::string bound_to = {};                ///< the FIFO to which the reader's port is bound
    bool has_channels = true;                 ///< the core makes its FIFOs
    bool has_reader = true;                   ///< the core makes its second module
};

class PairCore : public DataflowCore {
  public:
    PairCore(sc_core::sc_module_name const& name, std::shared_ptr<Machine const> const& machine, CoreShare share,
             TimeBase const& time_base, Pair const& pair)
        : DataflowCore(name, machine, share, time_base), results_(pair.results) {
        for (MachineFifo const& fifo : machine->fifos)
            if (pair.has_channels)
                make_fifo<Token>(fifo.name);
        workers_.push_back(std::make_unique<Worker>("writer", *this, pair.writes));
        if (pair.has_reader)
            workers_.push_back(std::make_unique<Worker>("reader", *this, pair.reads));
        if (!pair.bound_to.empty())
            workers_.back()->port(fifo<Token>(pair.bound_to));
    }

    std::size_t results() const override { return results_.value_or(DataflowCore::results()); }

  private:
    std::optional<std::size_t> results_;
    std::vector<std::unique_ptr<Worker>> workers_;
};

/// Ten tokens, by loops.
inline Pair sound_pair() {
    Pair pair;
    pair.writer.writes_to("f").of_bits(32).leaves("send", 1);
    pair.writer.loop("send").of_depth(3);
    pair.reader.reads_from("f").taken("receive", 0);
    pair.reader.loop("receive").of_depth(3);
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("send", 10, [&](std::uint64_t i) { fifo.write(static_cast<Token>(i)); });
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("receive", 10, [&](std::uint64_t) { fifo.read(); });
    };
    return pair;
}

/// What the modules of a run have to say; behind its total.
inline std::string& notes() {
    static std::string text;
    return text;
}

inline std::unique_ptr<DataflowAccelerator> accelerator_of(Pair const& pair,
                                                           std::shared_ptr<Machine const> const& machine,
                                                           std::size_t samples, Engine engine) {
    return std::make_unique<DataflowAccelerator>(
        "accelerator", machine, samples, engine,
        [&pair](char const* name, std::shared_ptr<Machine const> const& of, CoreShare share,
                TimeBase const& time_base) { return std::make_unique<PairCore>(name, of, share, time_base, pair); });
}

/// What is thrown; otherwise the total, and of several samples when they end; or how many are stuck. `retimed_with`: of
/// a retiming of the run with those.
inline std::string outcome_of(Pair const& pair, Engine engine, MachineSettings const& settings = {},
                              MachineSettings const* retimed_with = nullptr, std::size_t samples = 1,
                              std::vector<Recording> const& recordings = {}) {
    testing::FreshKernel const kernel;
    notes().clear();
    try {
        auto const machine =
            std::make_shared<Machine const>(make_machine(core_of({pair.writer, pair.reader}), settings));
        auto const accelerator = accelerator_of(pair, machine, samples, engine);
        replay::RecordedRun recorded;
        SimulationOptions options;
        options.recordings = recordings;
        options.recorded = retimed_with != nullptr ? &recorded : nullptr;
        RunStatistics run = simulate(*accelerator, options);
        if (retimed_with != nullptr)
            run = replay::retime(recorded, make_machine(core_of({pair.writer, pair.reader}), *retimed_with));
        std::string ends;
        for (std::size_t i = 0; samples > 1 && i < run.samples.size(); ++i)
            ends += " " + std::to_string(run.samples[i].end_cycle);
        return run.deadlocked() ? "stuck " + std::to_string(run.stuck.size())
                                : std::to_string(run.total_cycles) + ends + leftover_tokens(run) + notes();
    } catch (InputError const& error) {
        return error.what();
    }
}

}  // namespace faster::chance
