#include <algorithm>
#include <cmath>

#include "dataflow/base/input_error.hpp"
#include "dataflow/core/machine/lead_of.hpp"
#include "dataflow/core/machine/machine.hpp"

namespace dataflow {

namespace {

/// The key of the first condition that does not hold; empty if all do.
std::string first_failing(Conditions const& conditions) {
    auto const failing =
        std::find_if(conditions.begin(), conditions.end(), [](Condition const& one) { return !one.holds; });
    return failing == conditions.end() ? std::string() : failing->key;
}

std::string first_failing(Conditions const& of_module, Conditions const& own) {
    std::string const key = first_failing(of_module);
    return key.empty() ? first_failing(own) : key;
}

template <class Part> void decide(Part& part, std::string const& key) {
    part.is_present = key.empty();
    part.decided_by = key;
}

/// An end of a FIFO, and whose it is.
struct PlacedEnd {
    FifoEnd const* end = nullptr;
    std::size_t module = 0;
    std::string decided_by;
};

/// docs/memory-model.md: whole picoseconds, halves up.
std::uint64_t rounded(double value) { return static_cast<std::uint64_t>(std::floor(value + 0.5)); }

std::optional<timing::ExternalMemory> shape_of(MachineSettings const& settings) {
    ExternalMemorySettings const& memory = settings.external_memory;
    if (memory.model == MemoryModel::ideal)
        return std::nullopt;
    timing::ExternalMemory shape;
    shape.burst_bytes = memory.burst_bytes;
    shape.port_bytes = memory.port_bytes;
    shape.outstanding = memory.outstanding;
    shape.prefetches = memory.prefetch;
    shape.ports = memory.ports;
    shape.request_cycles = memory.request_cycles;
    shape.period_ps = std::max<std::uint64_t>(1, rounded(1e6 / settings.clock_mhz));
    shape.latency_ps = rounded(1e3 * memory.read_latency_ns);
    shape.granule_ps = rounded(64e3 / (memory.dram_gb_per_s * memory.dram_efficiency));
    return shape;
}

class Maker {
  public:
    Maker(CoreDescription const& core, MachineSettings const& settings) : core_(core), settings_(settings) {
        machine_.cores = settings.cores;
        machine_.clock_mhz = settings.clock_mhz;
        machine_.cores_are = core.cores_are;
        machine_.remark = core.remark;
        if (core.resources)
            machine_.resources = std::make_shared<TellResources const>(core.resources);
        machine_.external_memory = shape_of(settings);
        for (ModuleDescription const& module : core.modules)
            add_process(module);
        for (std::string const& fifo : core.fifos)
            add_fifo(fifo);
        for (std::size_t i = 0; i < core.modules.size(); ++i)
            for (StreamDescription const& stream : core.modules[i].streams)
                add_stream(i, stream);
        for (bool const is_loaded : {false, true})
            for (std::size_t i = 0; i < core.modules.size(); ++i)
                for (MemoryDescription const& memory : core.modules[i].memories)
                    if (memory.is_loaded == is_loaded)
                        add_memory(i, memory);
        for (std::size_t i = 0; i < core.modules.size(); ++i)
            for (LoopDescription const& loop : core.modules[i].loops)
                add_loop(i, loop);
        for (std::size_t i = 0; i < core.modules.size(); ++i) {
            add_setup(i);
            add_numbers(i);
            list_ends(i);
            list_loops(i);
        }
        machine_.begins = machine_.process(core.begins);
        machine_.ends = machine_.process(core.ends);
        machine_.processes[machine_.ends].call_start.ends_samples = true;
        machine_.is_over_with_last_sample = core.is_over_with_last_sample;
        machine_.has_calls = core.has_calls;
        machine_.lead = lead_of(core_.pace, machine_);
    }

    Machine machine() && { return std::move(machine_); }

  private:
    void add_process(ModuleDescription const& module) {
        MachineProcess process;
        process.name = module.name;
        process.stamps_look_back = module.stamps_look_back;
        process.call_start = {settings_.start(module.name), settings_.calls == CallOrder::in_turn};
        process.described_at = module.described_at;
        decide(process, first_failing(module.conditions));
        machine_.processes.push_back(std::move(process));
        machine_.line_buffers.insert(machine_.line_buffers.end(), module.line_buffers.begin(),
                                     module.line_buffers.end());
    }

    /// Of several modules that may have an end of a FIFO, the one that has it; otherwise the first.
    PlacedEnd find_end(std::string const& fifo, bool writes) const {
        PlacedEnd found;
        for (std::size_t i = 0; i < core_.modules.size(); ++i)
            for (FifoEnd const& end : core_.modules[i].ends) {
                if (end.fifo != fifo || end.writes != writes || (found.end != nullptr && found.decided_by.empty()))
                    continue;
                std::string const key = first_failing(core_.modules[i].conditions, end.conditions);
                if (found.end == nullptr || key.empty())
                    found = {&end, i, key};
            }
        if (found.end == nullptr)
            throw InputError("nobody " + std::string(writes ? "writes" : "reads") + " the FIFO " + fifo +
                             ", expected a module that describes it by " + (writes ? "writes_to" : "reads_from") +
                             "(\"" + fifo + "\")");
        return found;
    }

    void add_fifo(std::string const& name) {
        PlacedEnd const written = find_end(name, true);
        PlacedEnd const read = find_end(name, false);
        FifoEnd const& end = *written.end;
        FifoSettings const settings = settings_.fifo(end.sized_as.empty() ? name : end.sized_as);
        MachineFifo fifo;
        fifo.name = name;
        decide(fifo, written.decided_by.empty() ? read.decided_by : written.decided_by);
        fifo.writer = written.module;
        fifo.reader = read.module;
        fifo.depth = settings.depth.value_or(end.depth);
        fifo.configured_kind = settings.kind.value_or(FifoKind::automatic);
        fifo.write_latency = settings.write_latency.value_or(written.end->write_latency.value_or(0));
        if (read.end->read_stage)
            fifo.read_stage = settings.read_stage.value_or(*read.end->read_stage);
        fifo.may_keep_tokens = written.end->may_keep_tokens;
        fifo.flushes = written.end->flushes;
        if (end.when != FifoEnd::When::within_call)
            fifo.depth = fifo.hands_over = end.sized_as.empty() ? 1 : fifo.depth;
        fifo.when_full = settings.when_full.value_or(WhenFull::freeze);
        fifo.bits = fifo.is_present ? written.end->bits : 0;
        fifo.generation = settings_.fifo_rules;
        fifo.kind = resolved_kind(fifo.configured_kind, fifo.depth, fifo.bits, fifo.generation);
        machine_.fifos.push_back(std::move(fifo));
    }

    void add_stream(std::size_t module, StreamDescription const& description) {
        MachineStream stream;
        stream.name = description.name;
        decide(stream, first_failing(core_.modules[module].conditions, description.conditions));
        if (stream.is_present && !machine_.external_memory)
            decide(stream, "accelerator.memory.model");
        stream.process = module;
        stream.loop = description.loop;
        stream.writes = description.writes;
        stream.prefetch = description.prefetch;
        stream.is_header = description.is_header;
        machine_.streams.push_back(std::move(stream));
    }

    void add_memory(std::size_t module, MemoryDescription const& description) {
        MemorySettings const settings = settings_.memory(description.name);
        BankPartition const partition(settings.partition, static_cast<std::int64_t>(description.rows),
                                      static_cast<std::int64_t>(description.cols));
        MachineMemory memory{description.name, true,           {}, module, module,   0,
                             description.cols, settings.ports, 1,  {},     partition};
        decide(memory, first_failing(core_.modules[module].conditions, description.conditions));
        if (!description.reader.empty())
            memory.reader = machine_.process(description.reader);
        memory.words = description.rows * description.cols;
        memory.shape.bits = memory.is_present ? description.bits : 0;
        memory.shape.words = memory.shape.bits > 0 ? memory.words : 0;
        memory.shape.ports = settings.ports * partition.banks();
        memory.shape.partition = partition.banks();
        memory.shape.bank_words = partition.bank_words();
        memory.shape.buffers = description.buffers;
        if (description.copies > 0) {
            memory.sharers = (settings_.cores + description.copies - 1) / description.copies;
            memory.shape.share = static_cast<double>(description.copies) / static_cast<double>(settings_.cores);
        }
        machine_.memories.push_back(std::move(memory));
    }

    void add_loop(std::size_t module, LoopDescription const& description) {
        MachineLoop loop;
        loop.name = description.name;
        decide(loop, first_failing(core_.modules[module].conditions, description.conditions));
        loop.process = module;
        loop.timed_by = keyed_loop(core_.modules[module], description);
        LoopSettings const settings = settings_.loop(loop.timed_by);
        std::vector<timing::BramDemand> demands;
        for (MachineMemory const& memory : machine_.memories)
            for (MemoryAccess const& access : description.accesses)
                if ((memory.is_present || !loop.is_present) && access.memory == memory.name)
                    demands.push_back({memory.name, memory.sharers * memory.partition.accesses_per_bank(access.pattern),
                                       memory.ports});
        Cycles const recurrence = std::max(settings.recurrence_ii.value_or(1), description.recurrence);
        loop.depth = settings.depth.value_or(description.depth) + description.extra_depth;
        loop.is_pipelined = description.is_pipelined;
        loop.rewinds = settings.rewind.value_or(description.is_rewinding);
        loop.interval = loop.is_pipelined
                            ? timing::schedule(settings.ii.value_or(description.interval), recurrence, demands)
                            : timing::schedule(loop.depth, 1, {});
        loop.entry_states = settings.entry_states.value_or(description.entry_states);
        loop.exit_states = settings.exit_states.value_or(description.exit_states);
        for (MemoryStages const& stages : description.memory_stages)
            add_dependence(loop, stages);
        loop.writes = numbers_of(fifos_of(core_.modules[module], description, true));
        loop.reads = numbers_of(fifos_of(core_.modules[module], description, false));
        machine_.loops.push_back(std::move(loop));
    }

    /// If the loop writes the memory in this configuration. Stages that nobody has asked for move into
    /// a shorter pipeline.
    void add_dependence(MachineLoop& loop, MemoryStages const& stages) const {
        MachineDependence dependence;
        dependence.memory = machine_.memory(stages.memory);
        dependence.reads = stages.reads;
        dependence.writes = stages.writes;
        if (dependence.writes == 0 || !machine_.memories[dependence.memory].is_present)
            return;
        DependenceSettings const settings = settings_.dependence(loop.timed_by + '.' + stages.memory);
        Cycles const asked = settings.write_stage.value_or(stages.write);
        dependence.write_stage = std::min(asked, loop.depth - 1);
        Cycles const earlier = asked - dependence.write_stage;
        Cycles const read = settings.read_stage.value_or(stages.read);
        dependence.read_stage = std::min(read - std::min(read, earlier), dependence.write_stage);
        dependence.handling = settings.hazards;
        dependence.longest_span = dependence.reads > 0 ? asked - std::min(read, asked) + 1 : 1;
        loop.dependences.push_back(dependence);
    }

    /// Those that the loop says it writes, or reads, and those of which an end says so.
    static std::vector<std::string> fifos_of(ModuleDescription const& module, LoopDescription const& loop,
                                             bool writes) {
        std::vector<std::string> fifos = writes ? loop.writes : loop.reads;
        for (FifoEnd const& end : module.ends)
            if (end.writes == writes && !end.loop.empty() && end.loop == loop.name &&
                std::count(fifos.begin(), fifos.end(), end.fifo) == 0)
                fifos.push_back(end.fifo);
        return fifos;
    }

    void add_numbers(std::size_t module) {
        MachineProcess& process = machine_.processes[module];
        for (NumberDescription const& number : core_.modules[module].numbers)
            process.numbers[number.name] = settings_.number(process.name + '.' + number.name).value_or(number.value);
    }

    void add_setup(std::size_t module) {
        std::optional<SetupDescription> const& setup = core_.modules[module].setup;
        if (!setup)
            return;
        MachineProcess& process = machine_.processes[module];
        process.setup_cycles = settings_.setup(process.name).value_or(setup->depth) + setup->extra;
        process.setup_activity = setup->activity;
        if (!setup->one_per_token_of.empty())
            process.setup_counter = machine_.fifo(setup->one_per_token_of);
    }

    /// A module may describe an end twice, under conditions of which one holds.
    void list_ends(std::size_t module) {
        MachineProcess& process = machine_.processes[module];
        for (FifoEnd const& end : core_.modules[module].ends) {
            std::size_t const fifo = machine_.fifo(end.fifo);
            bool const is_there = process.is_present && machine_.fifos[fifo].is_present;
            if (is_there && first_failing(end.conditions).empty())
                process.ends.push_back({fifo, end.writes, end.when, end.makes_attempts});
        }
    }

    void list_loops(std::size_t module) {
        for (std::size_t loop = 0; loop < machine_.loops.size(); ++loop)
            if (machine_.loops[loop].is_present && machine_.loops[loop].process == module) {
                machine_.processes[module].loops.push_back(loop);
                machine_.loops[loop].makes_attempts = attempts_in(machine_.loops[loop], machine_.processes[module]);
            }
    }

    static bool attempts_in(MachineLoop const& loop, MachineProcess const& process) {
        return std::any_of(process.ends.begin(), process.ends.end(), [&loop](MachineEnd const& end) {
            std::vector<std::size_t> const& fifos = end.writes ? loop.writes : loop.reads;
            return end.makes_attempts && std::count(fifos.begin(), fifos.end(), end.fifo) > 0;
        });
    }

    std::vector<std::size_t> numbers_of(std::vector<std::string> const& fifos) const {
        std::vector<std::size_t> numbers(fifos.size());
        std::transform(fifos.begin(), fifos.end(), numbers.begin(),
                       [&](std::string const& fifo) { return machine_.fifo(fifo); });
        return numbers;
    }

    CoreDescription const& core_;
    MachineSettings const& settings_;
    Machine machine_;
};

}  // namespace

std::string keyed_loop(ModuleDescription const& module, LoopDescription const& loop) {
    return loop.timed_by.empty() ? module.name + '.' + loop.name : loop.timed_by;
}

std::string keyed_loop(ModuleDescription const& module, std::string const& loop) {
    auto const found = std::find_if(module.loops.begin(), module.loops.end(),
                                    [&loop](LoopDescription const& one) { return one.name == loop; });
    if (found == module.loops.end())
        throw InputError("module " + module.name + " names a loop " + loop + ", which it does not describe, " +
                         "expected loop(\"" + loop + "\") in its describe()");
    return keyed_loop(module, *found);
}

Machine make_machine(CoreDescription const& core, MachineSettings const& settings) {
    return Maker(core, settings).machine();
}

}  // namespace dataflow
