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

RunStatistics retime(RecordedRun const& run, AcceleratorConfig const& config) {
    auto const automaton = std::make_shared<timing::Automaton>();
    std::vector<std::unique_ptr<timing::CoreTiming>> timings;
    std::vector<FinishedCore> cores;
    for (std::size_t k = 0; k < config.raster_cores; ++k) {
        timings.push_back(core_variant(*run.blueprint, config));
        timing::CoreTiming& core = *timings.back();
        core.let_follow(rasterizer_and_followers(config.flow), automaton);
        CoreShare const share = share_of(k, config.raster_cores, run.tape.samples());
        Replay replay(run.tape, core);
        for (std::size_t i = 0; i < share.count; ++i)
            replay.feed(share.first + i);
        core.resolve();
        cores.push_back({share, core, run.counters.data() + share.first});
    }
    return collect(cores, config);
}

}  // namespace faster::retiming
