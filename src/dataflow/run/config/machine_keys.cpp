#include "dataflow/run/config/machine_keys.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>
#include <utility>

#include "dataflow/base/input_error.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/config/key_ranges.hpp"

namespace dataflow {
namespace {

template <class Value> Value value_or(std::optional<Value> const& value, Value otherwise) {
    return value.value_or(otherwise);
}
template <class Value> Value value_or(Value const& value, Value /*otherwise*/) { return value; }

/// A setting of one part. `part` finds the part in MachineSettings; `field` is one of its members, which has the value
/// `otherwise` as long as it is not set.
template <class Part, class Field, class Value>
Key part_key(KeyText text, KeyKind kind, Part part, Field field, Value otherwise) {
    Key key;
    key.text = std::move(text);
    key.kind = kind;
    key.read = [part, field, otherwise](RunConfig const& config) {
        auto const settings = part(config.machine());
        return value_of(value_or(field(settings), otherwise));
    };
    key.write = [part, field](RunConfig& config, KeyValue const& value) {
        assign(field(part(config.machine())), value);
    };
    return of_time(std::move(key));
}

template <class Part, class Field>
Key step_key(KeyText text, IntegerRange range, Part part, Field field, std::uint64_t otherwise) {
    Key key = part_key(std::move(text), KeyKind::integer, part, field, otherwise);
    key.is_step = true;
    key.integers = range;
    return key;
}

template <class Choice, class Part, class Field>
Key choice_key(KeyText text, Part part, Field field, Choice otherwise) {
    Key key = part_key(std::move(text), KeyKind::choice, part, field, otherwise);
    key.choices = names_of_choices<Choice>();
    return key;
}

/// An end of a FIFO, and the module that has it.
struct EndOfModule {
    ModuleDescription const& module;
    FifoEnd const& end;

    std::string depth_key() const { return stages_key_name(module, end.loop); }
};

template <class Is> std::optional<EndOfModule> find_end(CoreDescription const& core, Is is) {
    for (ModuleDescription const& module : core.modules)
        for (FifoEnd const& end : module.ends)
            if (is(end))
                return EndOfModule{module, end};
    return std::nullopt;
}

/// The end that writes a FIFO. Of several, the first: all say the same of the tokens.
EndOfModule writing_end(CoreDescription const& core, std::string const& fifo) {
    auto const end = find_end(core, [&](FifoEnd const& one) { return one.writes && one.fifo == fifo; });
    if (!end)
        throw InputError("nobody writes the FIFO " + fifo + ", expected a module that describes it by writes_to(\"" +
                         fifo + "\")");
    return *end;
}

/// The end that says in which stage of its loop it reads a FIFO; mostly, none does.
std::optional<EndOfModule> taking_end(CoreDescription const& core, std::string const& fifo) {
    return find_end(core, [&](FifoEnd const& one) { return one.read_stage && one.fifo == fifo; });
}

std::string write_latency_meaning(EndOfModule const& written) {
    if (written.end.loop.empty())
        return written.end.latency_meaning;
    return fmt::format("Stage of the writing loop in which the token leaves, below {}.", written.depth_key());
}

void add_stage_keys(Keys& keys, CoreDescription const& core, std::string const& name) {
    EndOfModule const written = writing_end(core, name);
    std::optional<EndOfModule> const taken = taking_end(core, name);
    auto const fifo = [name](auto& settings) -> decltype(auto) { return settings.fifo(name); };
    if (written.end.write_latency)
        keys.push_back(step_key(
            {fifo_key_name(name, "write_latency"), "cycles", write_latency_meaning(written), "timing model"},
            stages_range, fifo, [](auto& settings) -> auto& { return settings.write_latency; },
            *written.end.write_latency));
    if (taken)
        keys.push_back(step_key(
            {fifo_key_name(name, "read_stage"), "cycles",
             fmt::format("Stage of the reading loop in which the token is taken, below {}.", taken->depth_key()),
             "timing model"},
            stages_range, fifo, [](auto& settings) -> auto& { return settings.read_stage; }, *taken->end.read_stage));
}

/// Of the module that has a flushing pipeline.
void add_flushing_keys(Keys& keys, ModuleDescription const& module) {
    for (FifoEnd const& end : module.ends)
        if (end.flushes)
            keys.push_back(choice_key(
                {"accelerator." + module.name + ".when_full", "",
                 "What the pipeline does while the FIFO behind it is full: freeze with its bubbles, or let its results "
                 "close up, which takes a FIFO as deep as the pipeline besides.",
                 "timing model"},
                [name = end.fifo](auto& settings) -> decltype(auto) { return settings.fifo(name); },
                [](auto& settings) -> auto& { return settings.when_full; }, WhenFull::freeze));
}

void add_buffers_key(Keys& keys, FifoEnd const& written) {
    keys.push_back(step_key(
        {fifo_key_name(written.fifo, "depth"), "buffers", fmt::format("Ping-pong buffers: {}.", written.tokens),
         "HLS default"},
        buffers_range, [name = written.fifo](auto& settings) -> decltype(auto) { return settings.fifo(name); },
        [](auto& settings) -> auto& { return settings.depth; }, written.depth));
}

void add_fifo_keys(Keys& keys, CoreDescription const& core, std::string const& name) {
    if (FifoEnd const& written = writing_end(core, name).end; written.buffer_words > 0) {
        add_buffers_key(keys, written);
        return;
    }
    auto const fifo = [name](auto& settings) -> decltype(auto) { return settings.fifo(name); };
    keys.push_back(step_key(
        {fifo_key_name(name, "depth"), "tokens",
         fmt::format("Depth of the FIFO: {}.", writing_end(core, name).end.tokens), "HLS default"},
        fifo_depth_range, fifo, [](auto& settings) -> auto& { return settings.depth; },
        writing_end(core, name).end.depth));
    keys.push_back(choice_key(
        {fifo_key_name(name, "kind"), "",
         "How the FIFO is built; auto is a shift register up to depth 2, or as far as fifo_rules says, else a memory.",
         "timing model"},
        fifo, [](auto& settings) -> auto& { return settings.kind; }, FifoKind::automatic));
    add_stage_keys(keys, core, name);
}

void add_setup_key(Keys& keys, std::string const& module, SetupDescription const& setup) {
    keys.push_back(step_key(
        {setup_key_name(module), "cycles", setup.meaning, "timing model"}, cycles_range,
        [module](auto& settings) -> decltype(auto) { return settings.setup(module); },
        [](auto& cycles) -> auto& { return cycles; }, setup.depth));
}

/// They say what hardware would read. When it does so they only decide with hazards interlock: see decides_waits().
void add_dependence_keys(Keys& keys, std::string const& loop, MemoryStages const& stages) {
    auto const dependence = [name = loop + '.' + stages.memory](auto& settings) -> decltype(auto) {
        return settings.dependence(name);
    };
    auto const name = [&](char const* field) { return dependence_key_name(loop, stages.memory, field); };
    auto const add_stage = [&](char const* field, char const* what, auto of, Cycles otherwise) {
        keys.push_back(part_key({name(field), "cycles",
                                 fmt::format("Stage of the loop in which an iteration {} {}, below {}.", what,
                                             stages.memory, loop_key_name(loop, "depth")),
                                 "timing model"},
                                KeyKind::integer, dependence, of, otherwise));
        keys.back().integers = {0, 1'000'000};
    };
    add_stage(
        "read_stage", "reads", [](auto& settings) -> auto& { return settings.read_stage; }, stages.read);
    add_stage(
        "write_stage", "writes", [](auto& settings) -> auto& { return settings.write_stage; }, stages.write);
    keys.push_back(choice_key(
        {name("hazards"), "",
         "What is done about iterations that read a word before one shortly before them has written it: they are "
         "reported (run --hazards), they wait until it is written, or the word is forwarded, which takes logic and no "
         "time.",
         "timing model"},
        dependence, [](auto& settings) -> auto& { return settings.hazards; }, HazardHandling::report));
}

void add_states_keys(Keys& keys, std::string const& name, LoopDescription const& description) {
    auto const loop = [name](auto& settings) -> decltype(auto) { return settings.loop(name); };
    keys.push_back(step_key(
        {loop_key_name(name, "states"), "cycles",
         fmt::format("States of an iteration, which are over before the next one begins; the loop {}.",
                     description.task),
         "HLS schedule"},
        cycles_range, loop, [](auto& settings) -> auto& { return settings.depth; }, description.depth));
    keys.push_back(step_key(
        {loop_key_name(name, "entry_states"), "cycles", "States before the loop's first iteration.", "HLS schedule"},
        stages_range, loop, [](auto& settings) -> auto& { return settings.entry_states; }, description.entry_states));
    keys.push_back(step_key(
        {loop_key_name(name, "exit_states"), "cycles", "States behind the loop's last iteration.", "HLS schedule"},
        stages_range, loop, [](auto& settings) -> auto& { return settings.exit_states; }, description.exit_states));
}

void add_loop_keys(Keys& keys, std::string const& name, LoopDescription const& description) {
    if (!description.is_pipelined) {
        add_states_keys(keys, name, description);
        return;
    }
    auto const loop = [name](auto& settings) -> decltype(auto) { return settings.loop(name); };
    keys.push_back(step_key(
        {loop_key_name(name, "ii"), "cycles",
         fmt::format("Initiation interval the pragma asks for; the loop {}.", description.task), "HLS pipeline"},
        cycles_range, loop, [](auto& settings) -> auto& { return settings.ii; }, description.interval));
    keys.push_back(step_key(
        {loop_key_name(name, "recurrence_ii"), "cycles",
         "Initiation interval that a dependence between iterations demands.", "HLS dependence"},
        cycles_range, loop, [](auto& settings) -> auto& { return settings.recurrence_ii; }, 1));
    keys.push_back(step_key(
        {loop_key_name(name, "depth"), "cycles", "Pipeline stages of one iteration.", "timing model"}, cycles_range,
        loop, [](auto& settings) -> auto& { return settings.depth; }, description.depth));
    if (description.is_rewinding)
        keys.push_back(part_key(
            {loop_key_name(name, "rewind"), "",
             "Whether iterations of the next call follow at once, before the pipeline has drained.",
             "HLS pipeline rewind"},
            KeyKind::boolean, loop, [](auto& settings) -> auto& { return settings.rewind; }, true));
    for (MemoryStages const& stages : description.memory_stages)
        add_dependence_keys(keys, name, stages);
}

/// The setup's key stands among those of the loops.
void add_loops_keys(Keys& keys, ModuleDescription const& module) {
    bool needs_setup = module.setup.has_value();
    for (LoopDescription const& loop : module.loops) {
        if (needs_setup && module.setup->before_loop == loop.name) {
            add_setup_key(keys, module.name, *module.setup);
            needs_setup = false;
        }
        if (loop.timed_by.empty())
            add_loop_keys(keys, keyed_loop(module, loop), loop);
    }
    if (needs_setup)
        add_setup_key(keys, module.name, *module.setup);
}

/// They decide which operations there are: no other value can be worked out from a recorded run.
void add_number_key(Keys& keys, std::string const& module, NumberDescription const& number) {
    keys.push_back(part_key(
        {module_key_name(module, number.name), number.unit, number.meaning, "this project"}, KeyKind::integer,
        [name = module + '.' + number.name](auto& settings) -> decltype(auto) { return settings.number(name); },
        [](auto& value) -> auto& { return value; }, number.value));
    keys.back().integers = {static_cast<std::int64_t>(number.least), static_cast<std::int64_t>(number.most)};
    keys.back().decides_time = false;
}

/// Of modules that tell when a call of theirs begins.
Key starts_key(std::string const& module) {
    return step_key(
        {module_key_name(module, "starts"), "cycles", "Cycles after the begin of a call of all in which it begins.",
         "HLS schedule"},
        {0, 1'000'000}, [module](auto& settings) -> decltype(auto) { return settings.start(module); },
        [](auto& cycles) -> auto& { return cycles; }, 0);
}

/// These decide about time, but are no steps of one quantity: a factor means nothing without a type.
void add_partition_keys(Keys& keys, MemoryDescription const& description) {
    std::string const name = description.name;
    auto const memory = [name](auto& settings) -> decltype(auto) { return settings.memory(name); };
    PartitionConfig const defaults;
    keys.push_back(choice_key(
        {bram_key_name(name, "partition.type"), "",
         "How " + name + " is split into banks, each with its own ports: cyclic parts neighbours, block does not.",
         description.partition_source},
        memory, [](auto& settings) -> auto& { return settings.partition.type; }, defaults.type));
    keys.push_back(part_key(
        {bram_key_name(name, "partition.factor"), "banks",
         "Banks along each dimension that is split; 1024 in all at most.", "HLS array_partition"},
        KeyKind::integer, memory, [](auto& settings) -> auto& { return settings.partition.factor; }, defaults.factor));
    keys.back().integers = {1, 1024};
    keys.push_back(part_key(
        {bram_key_name(name, "partition.dimension"), "", "What is split: 1 the rows, 2 the columns, 0 both.",
         "HLS array_partition"},
        KeyKind::integer, memory, [](auto& settings) -> auto& { return settings.partition.dimension; },
        defaults.dimension));
    keys.back().integers = {0, 2};
}

void add_memory_keys(Keys& keys, MemoryDescription const& description) {
    std::string const name = description.name;
    keys.push_back(step_key(
        {bram_key_name(name, "ports"), "accesses per cycle",
         fmt::format("Ports of the block RAM, of each bank if it is split: {}.", description.contents), "HLS default"},
        {1, 1024}, [name](auto& settings) -> decltype(auto) { return settings.memory(name); },
        [](auto& settings) -> auto& { return settings.ports; }, MemorySettings{}.ports));
    add_partition_keys(keys, description);
}

}  // namespace

std::string stages_key_name(ModuleDescription const& module, std::string const& loop) {
    auto const found = std::find_if(module.loops.begin(), module.loops.end(),
                                    [&loop](LoopDescription const& one) { return one.name == loop; });
    bool const is_pipelined = found == module.loops.end() || found->is_pipelined;
    return loop_key_name(keyed_loop(module, loop), is_pipelined ? "depth" : "states");
}

Keys machine_keys(CoreDescription const& core) {
    Keys keys;
    for (std::string const& fifo : core.fifos)
        add_fifo_keys(keys, core, fifo);
    for (ModuleDescription const& module : core.modules)
        add_flushing_keys(keys, module);
    for (ModuleDescription const& module : core.modules)
        add_loops_keys(keys, module);
    for (ModuleDescription const& module : core.modules)
        for (MemoryDescription const& memory : module.memories)
            add_memory_keys(keys, memory);
    for (ModuleDescription const& module : core.modules) {
        for (NumberDescription const& number : module.numbers)
            add_number_key(keys, module.name, number);
        if (core.has_calls)
            keys.push_back(starts_key(module.name));
    }
    return keys;
}

Key cores_key(std::string name, std::string meaning, std::string source) {
    return of_time(KeyMaker<MachineSettings>::integer_key(
        {std::move(name), "cores", std::move(meaning), std::move(source)}, {1, 1024},
        [](auto& settings) -> auto& { return settings.cores; }));
}

Key clock_key(std::string source) {
    return of_time(KeyMaker<MachineSettings>::number_key(
        {"accelerator.clock_mhz", "MHz", "Clock that turns cycles into milliseconds.", std::move(source)}, {1e-3, 1e6},
        [](auto& settings) -> auto& { return settings.clock_mhz; }));
}

Key calls_key() {
    return KeyMaker<MachineSettings>::choice_key(
        {"accelerator.calls", "",
         "How samples follow each other: overlapped, each module begins its next one as soon as it can; in_turn, all "
         "modules are done with one before any begins the next.",
         "timing model"},
        [](auto& settings) -> auto& { return settings.calls; });
}

Key fifo_rules_key() {
    Key key = of_time(KeyMaker<MachineSettings>::choice_key(
        {"accelerator.fifo_rules", "",
         "Whose FIFOs: those of Vivado HLS, of Vitis HLS, or spec, which no tool builds; decides what kind auto is and "
         "how many tokens a memory holds.",
         "timing model"},
        [](auto& settings) -> auto& { return settings.fifo_rules; }));
    key.is_alternative = true;
    return key;
}

}  // namespace dataflow
