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

/// By what it writes to the driver.
bool is_ahead(timing::Lead::Follower const& follower, Machine const& machine) {
    return machine.fifos[follower.anchor].writer == follower.process;
}

/// One follower may be ahead. What comes from memory, no state of a process tells: who takes it only follows where it
/// is ahead, and then last.
bool may_follow(timing::Lead::Follower const& added, bool takes_memory, Machine const& machine,
                std::vector<timing::Lead::Follower> const& followers) {
    if (!is_ahead(added, machine))
        return !takes_memory;
    return std::none_of(followers.begin(), followers.end(),
                        [&machine](timing::Lead::Follower const& other) { return is_ahead(other, machine); });
}

/// From a process of the group.
bool is_told(timing::Lead::Follower const& follower, timing::Lead const& lead, Machine const& machine) {
    return std::any_of(machine.fifos.begin(), machine.fifos.end(), [&](MachineFifo const& fifo) {
        return fifo.is_present && fifo.reader == follower.process && lead.has(static_cast<unsigned>(fifo.writer));
    });
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
                may_follow(added, of_memory, machine, lead.followers))
                lead.followers.push_back(added);
        }
    // Who is ahead goes on with other things, at times of its own, of which states tell no more.
    auto const cannot_follow = [&](timing::Lead::Follower const& follower) {
        return is_ahead(follower, machine) && is_told(follower, lead, machine);
    };
    auto const found = std::find_if(lead.followers.begin(), lead.followers.end(), cannot_follow);
    if (found != lead.followers.end())
        lead.followers.erase(found);
    return lead;
}

}  // namespace dataflow
