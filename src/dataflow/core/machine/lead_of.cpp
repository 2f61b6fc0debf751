#include "dataflow/core/machine/lead_of.hpp"

#include <algorithm>

namespace dataflow {

namespace {

bool uses_memory(std::string const& module, Machine const& machine) {
    return std::any_of(machine.streams.begin(), machine.streams.end(), [&](MachineStream const& stream) {
        return stream.is_present && machine.processes[stream.process].name == module;
    });
}

bool rewinds(Machine const& machine) {
    return std::any_of(machine.loops.begin(), machine.loops.end(),
                       [](MachineLoop const& loop) { return loop.rewinds; });
}

/// What comes from memory, no state of a process tells: who takes it only follows where it is ahead, and then last.
bool may_follow(timing::Lead::Follower const& added, Machine const& machine,
                std::vector<timing::Lead::Follower> const& followers) {
    auto const is_ahead = [&machine](timing::Lead::Follower const& other) {
        return machine.fifos[other.anchor].writer == other.process;
    };
    return is_ahead(added) && std::none_of(followers.begin(), followers.end(), is_ahead);
}

}  // namespace

timing::Lead lead_of(CoreDescription::Pace const& pace, Machine const& machine) {
    timing::Lead lead;
    if (pace.driver.empty() || uses_memory(pace.driver, machine))
        return lead;
    lead.driver = static_cast<unsigned>(machine.process(pace.driver));
    if (rewinds(machine))  // no state of a process tells of rests
        return lead;
    for (bool const of_memory : {false, true})
        for (CoreDescription::Pace::Follower const& follower : pace.followers) {
            timing::Lead::Follower const added{static_cast<unsigned>(machine.process(follower.module)),
                                               static_cast<unsigned>(machine.fifo(follower.anchor))};
            if (uses_memory(follower.module, machine) == of_memory && machine.fifos[added.anchor].is_present &&
                (!of_memory || may_follow(added, machine, lead.followers)))
                lead.followers.push_back(added);
        }
    return lead;
}

}  // namespace dataflow
