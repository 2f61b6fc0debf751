#include "dataflow/core/machine/core_ends.hpp"

namespace dataflow {

std::vector<Cycles> sample_begins(Machine const& machine, timing::CoreTiming const& core) {
    if (machine.begins != machine.ends)
        return core.processes()[machine.begins].stamps();
    timing::ProcessTiming const& process = core.processes()[machine.begins];
    std::vector<Cycles> begins;
    if (process.has_accessed() || !process.stamps().empty())
        begins.push_back(0);
    begins.insert(begins.end(), process.next_calls().begin(), process.next_calls().end());
    return begins;
}

std::vector<Cycles> const& sample_ends(Machine const& machine, timing::CoreTiming const& core) {
    return core.processes()[machine.ends].stamps();
}

std::optional<RunEnd> run_end(Machine const& machine, timing::CoreTiming const& core) {
    if (machine.is_over_with_last_sample) {
        std::vector<Cycles> const& ends = sample_ends(machine, core);
        return ends.empty() ? std::nullopt : std::optional(RunEnd{machine.ends, ends.back()});
    }
    std::optional<RunEnd> last;
    for (std::size_t i = 0; i < core.processes().size(); ++i) {
        Cycles const end = core.processes()[i].end();
        if (end > 0 && (!last || end - 1 > last->cycle))
            last = RunEnd{i, end - 1};
    }
    return last;
}

}  // namespace dataflow
