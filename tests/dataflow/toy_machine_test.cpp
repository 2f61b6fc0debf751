#include <algorithm>
#include <catch2/catch.hpp>
#include <stdexcept>

#include "dataflow/run/config/key_names.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/config/machine_keys.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/toy_design.hpp"
#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace toy_machine_test {

using namespace faster;
using namespace faster::test;
using Numbers = std::vector<std::size_t>;
using Names = std::vector<std::string>;

constexpr std::size_t source = 0, worker = 1, sink = 2;
constexpr std::size_t number = 0, answer = 1;

Machine machine_with(ToyConfig const& config) { return make_machine(describe_toy(config), config.settings); }

timing::InitiationInterval interval_with(ToyConfig const& config) { return machine_with(config).loops.at(0).interval; }

LoadedConfig loaded(std::string const& text, std::vector<std::string> const& overrides = {}) {
    TempFolder const folder;
    folder.write("toy.yaml", text);
    return load_config(folder / "toy.yaml", overrides);
}

std::string set_error(std::string const& setting) {
    return input_error_text([&] { loaded("", {setting}); });
}

std::string values_of(RunConfig const& config) {
    std::string values;
    for (ResolvedKey const& entry : resolved_keys(config))
        values += entry.key + '=' + json_text(entry.value) + '\n';
    return values;
}

Names names_of(Keys const& keys) {
    Names names;
    for (Key const& key : keys)
        names.push_back(key.name());
    return names;
}

Key const& key_named(Keys const& keys, std::string const& name) {
    for (Key const& key : keys)
        if (key.name() == name)
            return key;
    throw std::out_of_range(name);
}

TEST_CASE("A machine has the parts of its description, by number and by name", "[machine]") {
    Machine const machine = machine_with({});
    CHECK(machine.cores == 2);
    CHECK(machine.process("sink") == sink);
    CHECK(machine.fifo("answer") == answer);
    CHECK(machine.memory("table") == 0);
    CHECK(machine.loop(worker, "look_up") == 0);
    CHECK(machine.loop_name(0) == "worker.look_up");
    CHECK_THROWS_AS(machine.process("worker.look_up"), InputError);
    CHECK_THROWS_AS(machine.fifo("question"), InputError);
    CHECK_THROWS_AS(machine.loop(source, "look_up"), InputError);

    CHECK(machine.fifos[answer].writer == worker);
    CHECK(machine.fifos[answer].reader == sink);
    CHECK(machine.fifos[answer].bits == 32);
    REQUIRE(machine.processes[worker].ends.size() == 2);
    CHECK(machine.processes[worker].ends[0].fifo == number);
    CHECK_FALSE(machine.processes[worker].ends[0].writes);
    CHECK(machine.processes[worker].ends[1].writes);
    CHECK(machine.processes[worker].loops == Numbers{0, 1});
    CHECK(machine.processes[source].loops.empty());
    CHECK(machine.processes[worker].setup_cycles == 5);
    CHECK(machine.processes[worker].setup_counter == number);
    CHECK(machine.loops[0].process == worker);
    CHECK(machine.loops[0].timed_by == "worker.look_up");
    CHECK(machine.loops[0].writes == Numbers{answer});
    CHECK(machine.memories[0].owner == worker);
    CHECK(machine.memories[0].reader == worker);
    CHECK(machine.begins == source);
    CHECK(machine.ends == worker);
    CHECK(machine.lead.driver == worker);
    REQUIRE(machine.lead.followers.size() == 2);
    CHECK(machine.lead.followers[1].process == sink);
    CHECK(machine.lead.followers[1].anchor == answer);
}

TEST_CASE("A FIFO that nobody writes is a mistake of the design", "[machine]") {
    CoreDescription core = describe_toy({});
    core.fifos.emplace_back("question");
    CHECK(input_error_text([&] { make_machine(core, {}); }) ==
          "nobody writes the FIFO question, expected a module that describes it by writes_to(\"question\")");
}

TEST_CASE("Kinds of FIFOs are resolved, with what they mean for room and latency", "[machine]") {
    ToyConfig config;
    auto const fifo = [&config] { return machine_with(config).fifos[answer]; };
    CHECK(fifo().kind == FifoKind::shift_register);
    CHECK(fifo().configured_kind == FifoKind::automatic);
    CHECK(fifo().depth == 2);
    CHECK(fifo().write_latency == 3);
    CHECK(fifo().shape().capacity == 2);
    CHECK(fifo().shape().read_latency == 1);
    config.settings.fifo("answer").depth = 32;  // of 32 bits
    CHECK(fifo().kind == FifoKind::shift_register);
    config.settings.fifo("answer").depth = 33;
    CHECK(fifo().kind == FifoKind::memory);
    CHECK(fifo().configured_kind == FifoKind::automatic);
    CHECK(fifo().shape().capacity == 33);
    CHECK(fifo().shape().read_latency == 2);
    config.settings.fifo_rules = FifoGeneration::vivado_hls;
    CHECK(fifo().shape().capacity == 34);
    config.settings.fifo_rules = FifoGeneration::spec;
    config.settings.fifo("answer").depth = 3;
    CHECK(fifo().kind == FifoKind::memory);
    CHECK(fifo().shape().capacity == 4);
    config.settings.fifo("answer").kind = FifoKind::shift_register;
    config.settings.fifo("answer").write_latency = 1;
    CHECK(fifo().kind == FifoKind::shift_register);
    CHECK(fifo().shape().capacity == 3);
    CHECK(fifo().shape().write_latency == 1);
    CHECK(machine_with(config).fifos[number].depth == 2);  // has settings of its own
    CHECK(machine_with(config).fifos[number].write_latency == 0);
}

TEST_CASE("A loop's interval follows from its pragma, its dependences and the ports of every bank", "[machine]") {
    ToyConfig config;
    CHECK(interval_with(config).achieved == 2);  // three reads and a write on two ports
    CHECK(interval_with(config).limited_by == "table");
    CHECK(interval_with(config).bram_accesses == 4);
    CHECK(interval_with(config).port_conflict_per_iteration == 1);
    config.settings.memory("table").ports = 1;
    CHECK(interval_with(config).achieved == 4);
    config.settings.memory("table").partition = {PartitionType::cyclic, 2, 1};  // above and below are one bank's
    CHECK(interval_with(config).achieved == 2);
    config.settings.memory("table").ports = 2;
    CHECK(interval_with(config).achieved == 1);
    CHECK(interval_with(config).limited_by.empty());
    config.settings.loop("worker.look_up").recurrence_ii = 3;
    CHECK(interval_with(config).achieved == 3);
    CHECK(interval_with(config).limited_by == "recurrence");
    config.settings.loop("worker.look_up").ii = 6;
    CHECK(interval_with(config).achieved == 6);
    CHECK(interval_with(config).limited_by.empty());
    CHECK(machine_with(config).loops[0].depth == 5);
    config.settings.loop("worker.look_up").depth = 9;
    CHECK(machine_with(config).loops[0].shape().depth == 9);
    config.settings.setup("worker") = 7;
    CHECK(machine_with(config).processes[worker].setup_cycles == 7);
}

TEST_CASE("A memory has the size and the banks that its configuration says", "[machine]") {
    ToyConfig config;
    config.rows = 100;
    config.settings.memory("table").ports = 3;
    config.settings.memory("table").partition = {PartitionType::block, 8, 1};
    MachineMemory const memory = machine_with(config).memories[0];
    CHECK(memory.words == 400);
    CHECK(memory.cols == 4);
    CHECK(memory.ports == 3);
    CHECK(memory.shape.bits == 36);
    CHECK(memory.shape.partition == 8);
    CHECK(memory.shape.bank_words == 13 * 4);
    CHECK(memory.shape.ports == 24);
    CHECK(ramb36_of_core(machine_with(config)) == ramb36_count(memory.shape));
}

TEST_CASE("A part that is not there keeps its number, and says which key takes it away", "[machine]") {
    ToyConfig config;
    CHECK(modules_of(machine_with(config)) == Numbers{source, worker, sink});
    config.answers = false;
    Machine const machine = machine_with(config);
    CHECK(modules_of(machine) == Numbers{source, worker});
    CHECK(fifos_of(machine) == Numbers{number});
    CHECK(loops_of(machine) == Numbers{0, 1});
    CHECK(brams_of(machine) == Numbers{0});
    CHECK(machine.process_places() == 2);
    CHECK(machine.process("sink") == sink);
    CHECK_FALSE(machine.processes[sink].is_present);
    CHECK(machine.processes[sink].decided_by == "toy.answers");
    CHECK_FALSE(machine.fifos[answer].is_present);
    CHECK(machine.fifos[answer].decided_by == "toy.answers");
    CHECK(machine.fifos[answer].bits == 0);
    CHECK(machine.fifos[number].decided_by.empty());
    CHECK(machine.processes[worker].ends.size() == 1);
    CHECK(machine.lead.followers.size() == 1);
}

TEST_CASE("The description makes the keys of a machine, with their defaults", "[machine][config]") {
    Keys const keys = machine_keys(describe_toy({}));
    CHECK(names_of(keys) ==
          Names{"accelerator.fifos.number.depth", "accelerator.fifos.number.kind", "accelerator.fifos.answer.depth",
                "accelerator.fifos.answer.kind", "accelerator.fifos.answer.write_latency",
                "accelerator.loops.worker.setup.depth", "accelerator.loops.worker.look_up.ii",
                "accelerator.loops.worker.look_up.recurrence_ii", "accelerator.loops.worker.look_up.depth",
                "accelerator.loops.worker.look_up.table.read_stage",
                "accelerator.loops.worker.look_up.table.write_stage", "accelerator.loops.worker.look_up.table.hazards",
                "accelerator.loops.worker.repeat.ii", "accelerator.loops.worker.repeat.recurrence_ii",
                "accelerator.loops.worker.repeat.depth", "accelerator.brams.table.ports",
                "accelerator.brams.table.partition.type", "accelerator.brams.table.partition.factor",
                "accelerator.brams.table.partition.dimension"});
    RunConfig config;
    auto const value = [&](std::string const& name) { return json_text(key_named(keys, name).read(config)); };
    CHECK(value("accelerator.fifos.answer.depth") == "2");
    CHECK(value("accelerator.fifos.answer.kind") == "\"auto\"");
    CHECK(value("accelerator.fifos.answer.write_latency") == "3");
    CHECK(value("accelerator.loops.worker.setup.depth") == "5");
    CHECK(value("accelerator.loops.worker.look_up.depth") == "5");
    CHECK(value("accelerator.brams.table.ports") == "2");
    key_named(keys, "accelerator.fifos.answer.write_latency").write(config, KeyValue{std::int64_t{1}});
    CHECK(value("accelerator.fifos.answer.write_latency") == "1");
    CHECK(config.machine().fifo("answer").write_latency == 1);
    CHECK(machine_of(config).fifos[answer].write_latency == 1);
    CHECK(machine_of(RunConfig{}).fifos[answer].write_latency == 3);  // copies are independent
    for (Key const& key : keys)
        CHECK(key.decides_time);
}

TEST_CASE("Timing keys are the steps of the parts that are there", "[machine][config]") {
    auto const has = [](RunConfig const& config, std::string const& name) {
        Names const names = names_of(timing_keys(config));
        return std::count(names.begin(), names.end(), name) == 1;
    };
    RunConfig config;
    CHECK(has(config, "accelerator.fifos.answer.depth"));
    CHECK(has(config, "accelerator.loops.worker.setup.depth"));
    CHECK_FALSE(has(config, "accelerator.fifos.answer.kind"));
    CHECK_FALSE(has(config, "toy.rows"));
    config.as<ToyConfig>().answers = false;
    CHECK_FALSE(has(config, "accelerator.fifos.answer.depth"));
    CHECK(has(config, "accelerator.fifos.number.depth"));
    IdleKeys const idle = idle_keys(config);
    std::string const* const decider = idle.decider_of("accelerator.fifos.answer.depth");
    REQUIRE(decider != nullptr);
    CHECK(*decider == "toy.answers");
}

TEST_CASE("A file and overrides configure the toy", "[config]") {
    RunConfig const config = loaded(
                                 "toy: {units: 3, rows: 16}\n"
                                 "accelerator:\n"
                                 "  clock_mhz: 100\n"
                                 "  fifos: {answer: {depth: 9, kind: shift_register}}\n"
                                 "  loops: {worker: {look_up: {ii: 2}, setup: {depth: 8}}}\n"
                                 "  brams: {table: {ports: 4}}\n",
                                 {"toy.rows=32", "accelerator.fifos.answer.write_latency=4"})
                                 .config;
    CHECK(config.as<ToyConfig>().rows == 32);
    Machine const machine = machine_of(config);
    CHECK(machine.cores == 3);
    CHECK(machine.clock_mhz == 100);
    CHECK(machine.milliseconds(100'000) == 1);
    CHECK(machine.fifos[answer].depth == 9);
    CHECK(machine.fifos[answer].kind == FifoKind::shift_register);
    CHECK(machine.fifos[answer].write_latency == 4);
    CHECK(machine.loops[0].interval.target == 2);
    CHECK(machine.processes[worker].setup_cycles == 8);
    CHECK(machine.memories[0].ports == 4);
    CHECK(machine.memories[0].words == 32 * 4);
}

TEST_CASE("A design looks for parts without keys when a configuration has been read, before other checks",
          "[machine]") {
    std::string const refusal = "the thousandth row has no keys";
    CHECK(set_error("toy.rows=1000") == refusal);
    CHECK(input_error_text([] { loaded("toy: {rows: 1000}\naccelerator: {fifos: {answer: {write_latency: 9}}}\n"); }) ==
          refusal);
    CHECK(set_error("toy.rows=999") == "(no error)");
}

TEST_CASE("What contradicts itself in any machine is refused", "[config][errors]") {
    CHECK(set_error("accelerator.fifos.answer.write_latency=5") ==
          "--set accelerator.fifos.answer.write_latency=5: expected at most 4, one less than "
          "accelerator.loops.worker.look_up.depth = 5 (default) (and 1 more)");
    CHECK(set_error("accelerator.loops.worker.repeat.depth=3") ==  // which names the FIFO
          "--set accelerator.loops.worker.repeat.depth=3: expected at least 4 because of "
          "accelerator.fifos.answer.write_latency = 3 (default): set that too, to at most 2");
    CHECK(set_error("accelerator.loops.worker.look_up.depth=3") ==
          "--set accelerator.loops.worker.look_up.depth=3: expected at least 4 because of "
          "accelerator.fifos.answer.write_latency = 3 (default): set that too, to at most 2");
    CHECK(set_error("accelerator.brams.table.partition.factor=2") ==
          "--set accelerator.brams.table.partition.factor=2: expected 1, or "
          "accelerator.brams.table.partition.type = \"none\" (default) to be cyclic or block");
    CHECK(input_error_text([] {
              loaded("", {"accelerator.brams.table.partition.type=cyclic", "accelerator.brams.table.partition.factor=9",
                          "accelerator.brams.table.partition.dimension=1"});
          }) == "--set accelerator.brams.table.partition.factor=9: expected at most toy.rows = 8 (default)");
    CHECK(input_error_text([] {
              loaded("", {"toy.answers=false", "accelerator.fifos.answer.depth=3"});
          }) == "--set accelerator.fifos.answer.depth=3: expected a key of the parts that toy.answers = false has");
    CHECK(set_error("accelerator.loops.worker.look_up.table.hazards=interlock") ==
          "--set accelerator.loops.worker.look_up.table.hazards=interlock: expected report or forward: the loop writes "
          "FIFOs, reads one in a later stage than its first, or without waiting, or gives to the memory behind what it "
          "reads");
    for (bool const polls : {false, true}) {
        std::vector<std::string> const settings{"toy.answers=false", polls ? "toy.polls=true" : "toy.polls=false",
                                                "accelerator.loops.worker.look_up.table.hazards=interlock"};
        CHECK((input_error_text([&] { loaded("", settings); }) == "(no error)") == !polls);
    }
    CHECK(set_error("accelerator.fifos.anser.depth=3") ==
          "--set accelerator.fifos.anser.depth=3: unknown key, did you mean accelerator.fifos.answer.depth?");
    CHECK(set_error("toy.rows=0") == "--set toy.rows=0: expected an integer from 1 to 1024");
}

TEST_CASE("The resolved configuration of the toy loads to the same values", "[config]") {
    RunConfig const config = loaded("", {"accelerator.fifos.answer.depth=7", "accelerator.loops.worker.look_up.ii=3",
                                         "accelerator.brams.table.partition.type=block", "toy.rows=9",
                                         "accelerator.clock_mhz=199.99999999999997"})
                                 .config;
    std::string const text = to_yaml(config);
    CHECK(text.find("      depth: 7  # default 2\n") != std::string::npos);
    RunConfig const again = loaded(text).config;
    CHECK(values_of(again) == values_of(config));
    CHECK(machine_of(again).fifos[answer].depth == 7);
    CHECK(values_of(loaded(to_yaml(RunConfig{})).config) == values_of(RunConfig{}));
}

TEST_CASE("a number of a module is a key, has its default, and decides about more than time") {
    CoreDescription core = describe_toy(ToyConfig());
    core.modules[worker].number("tries").means("How often it tries.").is(3).within(1, 9);
    std::string const module = core.modules[worker].name;
    Key const key = key_named(machine_keys(core), module_key_name(module, "tries"));
    CHECK(key.text.meaning == "How often it tries.");
    CHECK(range_text(key) == "1..9");
    CHECK_FALSE(key.decides_time);

    RunConfig config;
    CHECK(json_text(key.read(config)) == "3");
    CHECK(make_machine(core, config.machine()).processes[worker].numbers.at("tries") == 3);
    key.write(config, KeyValue(std::int64_t{7}));
    CHECK(json_text(key.read(config)) == "7");
    CHECK(make_machine(core, config.machine()).processes[worker].numbers.at("tries") == 7);
}

}  // namespace toy_machine_test
