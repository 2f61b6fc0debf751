#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <string>

#include "dataflow/core/machine/build_core.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/config/machine_keys.hpp"
#include "dataflow/run/replay/core_variant.hpp"
#include "faster/dataflow_names.hpp"

namespace read_stage_machine_test {

using namespace faster;

constexpr unsigned iterations = 100;

/// A controller that sends requests and takes the responses two stages later, and the processor that answers.
CoreDescription describe_cycle() {
    ModuleDescription controller("controller");
    controller.writes_to("request").carries("requests").of_bits(32).leaves("ask", 1);
    controller.reads_from("response").taken("ask", 3);
    controller.loop("ask").does("asks").of_depth(4).writes_to({"request"});
    ModuleDescription processor("processor");
    processor.reads_from("request").taken("answer", 1);
    processor.writes_to("response").carries("responses").of_bits(32).leaves("answer", 1);
    processor.loop("answer").does("answers").of_depth(2).writes_to({"response"}).also_reads({"request"});
    CoreDescription core;
    core.modules = {controller, processor};
    core.fifos = {"request", "response"};
    core.begins = "controller";
    core.ends = "controller";
    return core;
}

/// Of a machine with these settings, by the blueprint of the one without any.
Cycles retimed_cycles(MachineSettings const& settings) {
    timing::CoreTiming blueprint;
    build_core(blueprint, make_machine(describe_cycle(), {}));
    auto const core = replay::core_variant(blueprint, make_machine(describe_cycle(), settings));
    core->process(1).log().wait(1);
    for (std::size_t i = 0; i < 2; ++i) {
        timing::OperationLog& log = core->process(i).log();
        log.enter(0);
        log.iterate((timing::Ports::of(0U) | timing::Ports::of(1U)).number(), 0, iterations);
        log.leave();
    }
    core->resolve();
    REQUIRE(core->blocked().empty());
    return std::max(core->process(0).local_time(), core->process(1).local_time());
}

Keys keys_named(std::string const& field) {
    Keys keys = machine_keys(describe_cycle());
    auto const is_other = [&field](Key const& key) {
        std::string const& name = key.name();
        return name.size() < field.size() || name.compare(name.size() - field.size(), field.size(), field) != 0;
    };
    keys.erase(std::remove_if(keys.begin(), keys.end(), is_other), keys.end());
    return keys;
}

TEST_CASE("A machine knows in which stage a loop reads", "[machine]") {
    MachineSettings settings;
    Machine const machine = make_machine(describe_cycle(), settings);
    CHECK(machine.fifos[0].read_stage == 1);
    CHECK(machine.fifos[1].read_stage == 3);
    CHECK(machine.fifos[1].shape().read_stage == 3);
    CHECK(machine.loops[0].reads == std::vector<std::size_t>{1});
    CHECK(machine.loops[1].reads == std::vector<std::size_t>{0});
    settings.fifo("response").read_stage = 2;
    CHECK(make_machine(describe_cycle(), settings).fifos[1].read_stage == 2);
}

TEST_CASE("Only FIFOs that a loop takes in a stage have a key for it", "[machine][config]") {
    Keys const keys = keys_named(".read_stage");
    REQUIRE(keys.size() == 2);
    CHECK(keys[1].name() == "accelerator.fifos.response.read_stage");
    CHECK(keys[1].text.meaning ==
          "Stage of the reading loop in which the token is taken, below accelerator.loops.controller.ask.depth.");
    CHECK(keys[1].is_step);
    CHECK(keys[1].decides_time);
    CoreDescription plain = describe_cycle();
    for (ModuleDescription& module : plain.modules)
        for (FifoEnd& end : module.ends)
            end.read_stage.reset();
    CHECK(machine_keys(plain).size() == machine_keys(describe_cycle()).size() - 2);
}

TEST_CASE("A recorded run is timed again with other stages of reads", "[machine][retiming]") {
    MachineSettings settings;
    CHECK(retimed_cycles(settings) == iterations + 3);
    settings.fifo("response").read_stage = 2;
    CHECK(retimed_cycles(settings) == 2 * iterations + 3);
    settings.loop("controller.ask").depth = 3;
    CHECK(retimed_cycles(settings) == 2 * iterations + 2);
    settings.fifo("request").read_stage = 0;
    settings.fifo("response").write_latency = 0;
    CHECK(retimed_cycles(settings) == 2 * iterations + 2);
}

}  // namespace read_stage_machine_test
