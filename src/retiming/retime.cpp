#include "retiming/retime.hpp"

#include <algorithm>

#include "config/core_share.hpp"
#include "modules/core_shapes.hpp"
#include "retiming/collect.hpp"
#include "retiming/core_variant.hpp"

namespace faster::retiming {

namespace {

/// Lets one core do the operations of its samples, one sample after the other.
class Replay {
  public:
    Replay(OperationTape const& tape, timing::CoreTiming& core)
        : tape_(tape), core_(core), is_stuck_(core.processes().size(), false) {}

    void feed(std::size_t sample) {
        tape_.read(sample, core_, operations_);
        for (std::size_t i = 0; i < operations_.size(); ++i)
            if (!is_stuck_[i])
                append(operations_[i], core_.process(i).log());
        core_.resolve(false);
        if (backlog() > usual_backlog)
            find_stuck();
    }

  private:
    static constexpr std::size_t usual_backlog = std::size_t{1} << 18;  // operations: a few samples' worth

    /// The first may wait on from where the last sample ended: one wait then, as the process itself would have said it.
    static void append(std::vector<timing::Operation> const& operations, timing::OperationLog& log) {
        auto operation = operations.begin();
        if (operation != operations.end() && operation->kind() == timing::Operation::Kind::wait &&
            !operation->is_setup())
            log.wait((operation++)->count());
        for (; operation != operations.end(); ++operation)
            log.append(*operation);
    }

    std::size_t backlog() {
        std::size_t operations = 0;
        for (std::size_t i = 0; i < is_stuck_.size(); ++i)
            operations += is_stuck_[i] ? 0 : core_.process(i).log().pending();
        return operations;
    }

    /// All that samples so far want done has been logged. So what cannot be done now never will be, and what comes
    /// after it would only fill the memory.
    void find_stuck() {
        core_.resolve();
        for (std::size_t i = 0; i < is_stuck_.size(); ++i)
            is_stuck_[i] = !core_.processes()[i].finished();
    }

    OperationTape const& tape_;
    timing::CoreTiming& core_;
    SampleOperations operations_;
    std::vector<bool> is_stuck_;
};

}  // namespace

std::unique_ptr<timing::CoreTiming> retime_core(RecordedRun const& run, AcceleratorConfig const& config,
                                                std::size_t core, std::shared_ptr<timing::Automaton> automaton,
                                                bool leaves_trail) {
    std::unique_ptr<timing::CoreTiming> timing = core_variant(*run.blueprint, config);
    timing->let_follow(rasterizer_and_followers(), std::move(automaton));
    if (leaves_trail)
        timing->leave_trail();
    CoreShare const share = share_of(core, config.raster_cores, run.tape.samples());
    Replay replay(run.tape, *timing);
    for (std::size_t i = 0; i < share.count; ++i)
        replay.feed(share.first + i);
    timing->resolve();
    return timing;
}

RunStatistics retime(RecordedRun const& run, AcceleratorConfig const& config) {
    auto const automaton = std::make_shared<timing::Automaton>();
    std::vector<std::unique_ptr<timing::CoreTiming>> timings;
    std::vector<FinishedCore> cores;
    for (std::size_t k = 0; k < config.raster_cores; ++k) {
        timings.push_back(retime_core(run, config, k, automaton));
        CoreShare const share = share_of(k, config.raster_cores, run.tape.samples());
        cores.push_back({share, *timings.back(), run.counters.data() + share.first});
    }
    return collect(cores, config);
}

}  // namespace faster::retiming
