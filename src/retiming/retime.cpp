#include "retiming/retime.hpp"

#include <algorithm>

#include "modules/core_shapes.hpp"
#include "retiming/core_variant.hpp"

namespace faster::retiming {

namespace {

void replay(OperationTape const& tape, timing::CoreTiming& core) {
    for (std::size_t round = 0; round < tape.rounds(); ++round) {
        tape.read_round(round, [&core](std::size_t process, std::vector<timing::Operation> const& operations) {
            for (timing::Operation const& operation : operations)
                core.process(process).log().append(operation);
        });
        core.resolve(false);
    }
    core.resolve();
}

Cycles end_of(timing::CoreTiming const& core) {
    std::vector<Cycles> const& results = core.processes()[index_of(ModuleId::result_collector)].stamps();
    return results.empty() ? 0 : results.back() + 1;
}

}  // namespace

Retimed retime(RecordedRun const& run, AcceleratorConfig const& config) {
    Retimed retimed;
    auto const automaton = std::make_shared<timing::Automaton>();
    for (OperationTape const& tape : run.cores) {
        std::unique_ptr<timing::CoreTiming> const core = core_variant(*run.blueprint, config);
        core->let_follow(rasterizer_and_followers(), automaton);
        replay(tape, *core);
        retimed.deadlocked = retimed.deadlocked || !core->waits().empty();
        retimed.total_cycles = std::max(retimed.total_cycles, end_of(*core));
    }
    return retimed;
}

}  // namespace faster::retiming
