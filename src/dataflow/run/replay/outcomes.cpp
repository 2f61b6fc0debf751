#include "dataflow/run/replay/outcomes.hpp"

#include <fmt/format.h>

#include "dataflow/base/program_name.hpp"

namespace dataflow::replay {

namespace {

void require_same(timing::ProcessTiming const& process, bool is_over) {
    auto const deviation = process.deviation(is_over);
    if (!deviation)
        return;
    throw OutcomeDiffers(
        fmt::format("module {} {} {} without waiting in cycle {}, and what it finds there might not be what "
                    "it found in the recorded run, expected changes that keep that; use {} run for others",
                    process.name(), process.writes(deviation->port) ? "writes" : "reads",
                    process.fifo(deviation->port).name(), deviation->cycle, program_name()));
}

}  // namespace

void require_outcomes(Cores const& cores, bool are_over) {
    for (auto const& core : cores)
        for (timing::ProcessTiming const& process : core->processes())
            require_same(process, are_over);
}

}  // namespace dataflow::replay
