#include "dataflow/run/config/calls.hpp"

#include <algorithm>
#include <utility>

namespace dataflow {
namespace {

using When = FifoEnd::When;

/// Of a FIFO, behind its module; null if there is none.
std::pair<ModuleDescription*, FifoEnd*> find_end(CoreDescription& core, std::string const& fifo, bool writes) {
    for (ModuleDescription& module : core.modules)
        for (FifoEnd& end : module.ends)
            if (end.fifo == fifo && end.writes == writes)
                return {&module, &end};
    return {};
}

/// A token that a module hands to another in a cycle of their calls. Its ends are the last of both modules. Returns the
/// one that writes it.
FifoEnd& add_hand_over(CoreDescription& core, std::string const& name, ModuleDescription& from, When written,
                       ModuleDescription& to, When read) {
    core.fifos.push_back(name);
    to.reads_from(name).when = read;
    FifoEnd& write = from.writes_to(name);
    write.carries("a token for each call").when = written;
    return write;
}

void hand_over_buffers(CoreDescription& core, std::string const& name, MachineSettings const& settings) {
    auto const [writer, write] = find_end(core, name, true);
    auto const [reader, read] = find_end(core, name, false);
    if (read == nullptr)
        return;  // which is told as of any FIFO
    MemoryDescription memory;
    memory.name = name;
    memory.holds(write->tokens).of_words(1, write->buffer_words, write->bits);
    std::uint64_t const buffers = write->depth;
    memory.in_buffers(settings.fifo(name).depth.value_or(buffers));
    auto const place = read - reader->ends.data();
    write->bits = 0;  // the memory has them
    write->when = When::call_begins;
    write->sized_as = name;
    read->when = When::call_ends;
    writer->memories.push_back(memory);
    FifoEnd& filled = add_hand_over(core, filled_fifo(name), *writer, When::call_ends, *reader, When::call_begins);
    filled.sized_as = name;
    filled.depth = buffers;
    // In a step, the reader waits for the buffer where its description names it.
    std::rotate(reader->ends.begin() + place, reader->ends.end() - 1, reader->ends.end());
}

}  // namespace

CoreDescription with_calls(CoreDescription core, MachineSettings const& settings) {
    core.has_calls = true;
    for (std::string const& fifo : std::vector<std::string>(core.fifos))
        if (FifoEnd const* const end = find_end(core, fifo, true).second; end != nullptr && end->buffer_words > 0)
            hand_over_buffers(core, fifo, settings);
    for (std::size_t i = 1; settings.calls == CallOrder::in_turn && i < core.modules.size(); ++i) {
        std::string const name = core.modules[i].name;
        add_hand_over(core, name + "_begins", core.modules[0], When::region_begins, core.modules[i],
                      When::region_begins);
        add_hand_over(core, name + "_ends", core.modules[0], When::region_begins, core.modules[i], When::call_ends);
    }
    return core;
}

}  // namespace dataflow
