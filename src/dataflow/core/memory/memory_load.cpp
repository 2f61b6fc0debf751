#include "dataflow/core/memory/memory_load.hpp"

#include <algorithm>
#include <deque>

#include "dataflow/core/memory/memory_system.hpp"
#include "dataflow/core/time/core_timing.hpp"

namespace dataflow::timing {

namespace {

/// What takes a port's beats: a loop that does nothing else.
class Loader {
  public:
    explicit Loader(MemoryEntry const& entry) : process_(core_.add_process("load")) {
        LoopShape loop;
        loop.name = "load";
        loop.interval = schedule(1, 1, {});
        loop.uses_stream = true;
        loop.reads = {{process_.add_stream(core_.add_stream("load", MemoryStream::EntersBy::loop)), 0}};
        process_.add_loop(std::move(loop));
        if (std::uint64_t const beats = entry.all_tokens(); beats > 0)
            take(beats);
    }

    CoreTiming& core() { return core_; }
    /// One behind the last cycle in which it takes something.
    Cycles end() const { return process_.local_time(); }

  private:
    void take(std::uint64_t beats) {
        process_.log().enter(0);
        for (std::uint64_t taken = 0; taken < beats;) {
            auto const count = static_cast<std::uint32_t>(std::min<std::uint64_t>(beats - taken, 1U << 16));
            process_.log().iterate(Ports::of(process_.stream_port()).number(), 0, count);
            taken += count;
        }
        process_.log().leave();
    }

    CoreTiming core_;
    ProcessTiming& process_;
};

/// Ports with a core whose memory it is, or the first of the cores that share a copy.
std::vector<bool> ports_that_bring(LoadedRange const& range, std::size_t ports, std::size_t cores) {
    std::size_t const sharers = range.copies == 0 ? 1 : (cores + range.copies - 1) / range.copies;
    std::vector<bool> bring(ports);
    for (std::size_t first = 0; first < cores; first += sharers)
        bring[first % ports] = true;
    return bring;
}

}  // namespace

std::vector<MemoryEntry> loads_of_ports(ExternalMemory const& shape, std::vector<LoadedRange> const& ranges,
                                        std::size_t cores) {
    std::vector<MemoryEntry> loads(shape.ports);
    for (LoadedRange const& range : ranges) {
        std::vector<bool> const bring = ports_that_bring(range, shape.ports, cores);
        for (std::size_t port = 0; port < loads.size(); ++port)
            if (bring[port])
                loads[port].blocks.push_back(beats_of(shape, range.address, range.bytes));
    }
    return loads;
}

Cycles cycles_of_load(ExternalMemory const& shape, std::vector<MemoryEntry> const& of_ports) {
    std::deque<Loader> loaders;
    MemorySystem memory(shape, {{}});
    for (MemoryEntry const& entry : of_ports) {
        loaders.emplace_back(entry);
        memory.add_core(loaders.back().core(), true);
    }
    for (std::size_t port = 0; port < of_ports.size(); ++port)
        memory.add(port, 0, of_ports[port]);
    memory.go_on(true);
    Cycles end = 0;
    for (Loader const& loader : loaders)
        end = std::max(end, loader.end());
    return end;
}

MemoryBlock beats_of(ExternalMemory const& shape, std::uint64_t address, std::uint64_t bytes) {
    MemoryBlock block;
    block.address = address;
    block.bytes = bytes;
    block.lead = address % shape.port_bytes;
    block.token_bytes = shape.port_bytes;
    block.tokens = bytes == 0 ? 0 : (block.lead + bytes + shape.port_bytes - 1) / shape.port_bytes;
    return block;
}

}  // namespace dataflow::timing
