#include "dataflow/core/machine/build_core.hpp"

#include <algorithm>

namespace dataflow {

namespace {

/// Builds one process of a core.
class ProcessBuilder {
  public:
    ProcessBuilder(timing::CoreTiming& core, Machine const& machine, std::size_t process)
        : core_(core),
          machine_(machine),
          described_(machine.processes[process]),
          process_(core.add_process(described_.name)) {
        for (MachineEnd const& end : described_.ends)
            end.writes ? process_.add_writes(core.fifo(end.fifo)) : process_.add_reads(core.fifo(end.fifo));
        process_.set_setup_cycles(described_.setup_cycles);
        process_.set_call_start(described_.call_start);
        process_.let_stamps_look_back(described_.stamps_look_back);
    }

    /// The i-th stream of the core.
    void add_stream(std::size_t i, MachineStream const& stream) {
        process_.add_stream(core_.stream(i));
        stream_ = &stream;
    }

    void add_loops() {
        for (std::size_t const loop : described_.loops)
            process_.add_loop(shape_of(machine_.loops[loop]));
    }

  private:
    timing::LoopShape shape_of(MachineLoop const& loop) const {
        timing::LoopShape shape = loop.shape();
        bool const is_of_stream = stream_ != nullptr && loop.name == stream_->loop;
        shape.uses_stream = is_of_stream && !stream_->writes;
        if (is_of_stream && stream_->writes)
            shape.writes.push_back({process_.stream_port(), shape.depth - 1});
        for (std::size_t const fifo : loop.writes)
            if (machine_.fifos[fifo].is_present)
                shape.writes.push_back({port_of(fifo, true), core_.fifo(fifo).shape().write_latency});
        for (std::size_t const fifo : loop.reads)
            if (machine_.fifos[fifo].is_present)
                shape.reads.push_back({port_of(fifo, false), core_.fifo(fifo).shape().read_stage});
        if (shape.uses_stream)
            shape.reads.push_back({process_.stream_port(), 0});
        return shape;
    }

    unsigned port_of(std::size_t fifo, bool writes) const {
        auto const end = std::find_if(described_.ends.begin(), described_.ends.end(),
                                      [=](MachineEnd const& one) { return one.fifo == fifo && one.writes == writes; });
        return static_cast<unsigned>(end - described_.ends.begin());
    }

    timing::CoreTiming& core_;
    Machine const& machine_;
    MachineProcess const& described_;
    timing::ProcessTiming& process_;
    MachineStream const* stream_ = nullptr;
};

}  // namespace

void build_core(timing::CoreTiming& core, Machine const& machine, std::vector<std::size_t> const& streams) {
    for (MachineFifo const& fifo : machine.fifos)
        core.add_fifo(fifo.shape());
    for (std::size_t const stream : streams)
        core.add_stream(machine.streams[stream].name, machine.streams[stream].enters_by());
    for (std::size_t process = 0; process < machine.process_places(); ++process) {
        ProcessBuilder builder(core, machine, process);
        for (std::size_t i = 0; i < streams.size(); ++i)
            if (machine.streams[streams[i]].process == process)
                builder.add_stream(i, machine.streams[streams[i]]);
        builder.add_loops();
    }
}

void build_core(timing::CoreTiming& core, Machine const& machine) { build_core(core, machine, streams_of(machine)); }

}  // namespace dataflow
