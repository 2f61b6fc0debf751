#include "dataflow/run/config/design_check.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/core/machine/core_of.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/simple_design.hpp"
#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"

namespace design_check_test {

using namespace faster;
using Catch::Matchers::Contains;
using faster::test::input_error_text;

/// first -f-> second -g-> third, first -h-> fourth, fourth -i-> third, fourth -k-> first.
CoreDescription row_of_four() {
    auto const module = [](char const* name, std::vector<std::string> const& writes,
                           std::vector<std::string> const& reads) {
        ModuleDescription described(name);
        for (std::string const& fifo : writes)
            described.writes_to(fifo).of_bits(32).leaves("loop", 1);
        for (std::string const& fifo : reads)
            described.reads_from(fifo).taken("loop", 0);
        described.loop("loop").of_depth(2);
        return described;
    };
    return core_of({module("first", {"f", "h"}, {"k"}), module("second", {"g"}, {"f"}), module("third", {}, {"g", "i"}),
                    module("fourth", {"i", "k"}, {"h"})});
}

/// A writer and a reader, with whatever is changed.
std::string complaint_about(std::function<void(ModuleDescription& writer, ModuleDescription& reader)> const& change) {
    ModuleDescription writer("writer"), reader("reader");
    writer.writes_to("f").of_bits(32).leaves("send", 1);
    writer.loop("send").of_depth(2);
    writer.memory("table").of_words(4, 4, 8);
    reader.reads_from("f").taken("receive", 0);
    reader.loop("receive").of_depth(2);
    change(writer, reader);
    return input_error_text([&] {
        CoreDescription const core = core_of({writer, reader});
        check_design(core);
        make_machine(core, {});
    });
}

/// Three in a row and a fourth that reads from the first, with a pace.
std::string complaint_about_pace(CoreDescription::Pace const& pace) {
    CoreDescription core = row_of_four();
    core.pace = pace;
    return input_error_text([&] { check_design(core); });
}

TEST_CASE("a pace is of the design's modules, each by a FIFO to the driver", "[machine]") {
    CHECK(complaint_about_pace({"second", {{"first", "f"}, {"third", "g"}}}) == "(no error)");
    CHECK(complaint_about_pace({"secnd", {{"first", "f"}}}) ==
          "the pace names a module secnd, which there is not, expected one of the design, did you mean second?");
    CHECK(complaint_about_pace({"second", {{"frist", "f"}}}) ==
          "the pace names a module frist, which there is not, expected one of the design, did you mean first?");
    CHECK(complaint_about_pace({"second", {{"first", "g"}}}) ==
          "module first follows by the FIFO g in the pace, expected a FIFO between it and second");
    CHECK(complaint_about_pace({"second", {{"first", "f"}, {"first", "f"}}}) ==
          "the pace names first twice, expected each module once");
}

TEST_CASE("one follower is ahead of the driver, and is told nothing by the group", "[machine]") {
    auto const followers_of = [](CoreDescription::Pace const& pace) {
        CoreDescription core = row_of_four();
        core.pace = pace;
        Machine const machine = make_machine(core, {});
        std::vector<std::string> names;
        for (timing::Lead::Follower const& follower : machine.lead.followers)
            names.push_back(machine.processes[follower.process].name);
        return names;
    };
    using Names = std::vector<std::string>;
    CHECK(followers_of({"second", {{"first", "f"}, {"third", "g"}}}) == Names{"first", "third"});
    CHECK(followers_of({"third", {{"second", "g"}, {"fourth", "i"}}}) == Names{"second"});  // two ahead
    CHECK(followers_of({"third", {{"fourth", "i"}, {"second", "g"}}}) == Names{"fourth"});
    CHECK(followers_of({"first", {{"second", "f"}, {"fourth", "h"}}}) == Names{"second", "fourth"});
    CHECK(followers_of({"first", {{"fourth", "k"}, {"second", "f"}}}) == Names{"second"});  // it reads h
}

TEST_CASE("a sound design has no complaints", "[machine]") {
    CHECK(complaint_about([](auto&, auto&) {}) == "(no error)");
}

TEST_CASE("a name that two parts of a kind have is told", "[machine]") {
    CHECK(complaint_about([](auto&, auto& reader) { reader.name = "writer"; }) ==
          "in the design two modules have the name writer, expected another name for one of them");
    CHECK(complaint_about([](auto&, auto& reader) { reader.loop("receive"); }) ==
          "in module reader two loops have the name receive, expected another name for one of them");
    CHECK(complaint_about([](auto&, auto& reader) { reader.memory("table").of_words(1, 1, 1); }) ==
          "in the design two memories have the name table, expected another name for one of them");
}

TEST_CASE("a FIFO with one end only, or with two of a kind, is told by name", "[machine]") {
    CHECK(complaint_about([](auto& writer, auto&) { writer.writes_to("g"); }) ==
          "nobody reads the FIFO g, expected a module that describes it by reads_from(\"g\")");
    CHECK(complaint_about([](auto&, auto& reader) { reader.reads_from("g"); }) ==
          "module reader reads the FIFO g, which nobody writes, expected another module's writes_to(\"g\"), did you "
          "mean f?");
    CHECK(complaint_about([](auto&, auto& reader) { reader.writes_to("f"); }) ==
          "the FIFO f is written by writer and by reader, expected one writer, and a FIFO for each other");
    CoreDescription core;
    core.modules = {ModuleDescription("writer"), ModuleDescription("reader")};
    core.modules.front().writes_to("f").of_bits(1);
    core.modules.back().reads_from("f");
    core.begins = "writer";
    core.ends = "reader";
    CHECK(input_error_text([&] { check_design(core); }) ==
          "module writer writes the FIFO f, which the core's description does not list, expected it among its fifos");
}

TEST_CASE("a loop or a memory that is named and not described is told by name", "[machine]") {
    CHECK(complaint_about([](auto& writer, auto&) { writer.ends.front().loop = "sent"; }) ==
          "module writer names a loop sent, which it does not describe, expected loop(\"sent\") in its describe()");
    CHECK(complaint_about([](auto& writer, auto&) {
              writer.loops.front().accesses_memory("tabel", {{{0, 0}}, {}});
          }) ==
          "loop writer.send accesses the memory tabel, which no module describes, expected memory(\"tabel\"), did you "
          "mean table?");
    CHECK(complaint_about([](auto&, auto& reader) { reader.loops.front().also_reads({"g"}); }) ==
          "loop reader.receive reads the FIFO g, which its module does not, expected reads_from(\"g\") in its "
          "describe()");
}

class Storing : public SimpleDesign {
  public:
    explicit Storing(std::vector<std::string> ports, std::vector<DesignNumber> numbers = {})
        : SimpleDesign({"storing", std::move(numbers), {}}), ports_(std::move(ports)) {}

  private:
    CoreDescription describe(Numbers const& /*numbers*/) const override {
        ModuleDescription module("writer");
        module.loop("send").of_depth(1);
        for (std::string const& port : ports_)
            module.stores(port);
        return core_of({module});
    }

    std::vector<std::string> ports_;
};

TEST_CASE("a design with a port to the external memory has the keys of the memory", "[machine]") {
    std::vector<Key> const keys = Storing({"out"}).keys();
    auto const has = [&keys](char const* name) {
        return std::any_of(keys.begin(), keys.end(), [name](Key const& key) { return key.name() == name; });
    };
    CHECK(has("accelerator.memory.model"));
    CHECK(has("accelerator.memory.outstanding"));
    CHECK_FALSE(has("accelerator.memory.prefetch"));  // no module works ahead
    CHECK(
        input_error_text([] {
            Storing({"out", "log"}).keys();
        }) ==
        "module writer stores log by a port to the memory, and has another one for out, expected one, and a module for "
        "each other");
}

TEST_CASE("the default of a number of a design is one that its key could say", "[machine]") {
    auto const complaint = [](std::uint64_t otherwise) {
        return input_error_text([=] { Storing({}, {{"workload.rows", otherwise, "Rows.", {1, 100}}}).keys(); });
    };
    CHECK(complaint(0) == "number workload.rows: its default is 0, expected one of its range, 1..100");
    CHECK(complaint(101) == "number workload.rows: its default is 101, expected one of its range, 1..100");
    CHECK(complaint(100) == "(no error)");
}

/// A module whose parts depend on a number.
class Growing : public SimpleDesign {
  public:
    using Describe = std::function<void(ModuleDescription& module, std::uint64_t stages)>;
    explicit Growing(Describe describe, std::vector<ColumnFacts> results = {})
        : SimpleDesign({"growing", {{"workload.stages", 2, "Two or three."}}, std::move(results)}),
          describe_(std::move(describe)) {}

    std::string complaint_with(std::uint64_t stages) const {
        Numbers numbers;
        numbers.of("workload.samples") = 1;
        numbers.of("workload.stages") = stages;
        return input_error_text([&] { require_keys(numbers); });
    }

  private:
    CoreDescription describe(Numbers const& numbers) const override {
        ModuleDescription module("writer");
        module.loop("send").of_depth(2);
        describe_(module, numbers["workload.stages"]);
        return core_of({module});
    }

    Describe describe_;
};

TEST_CASE("a part that only some numbers add has no keys", "[machine]") {
    auto const complaint = [](char const* key) {
        return std::string("with workload.stages = 3 the design has a part with the key ") + key +
               ", which it does not have with the defaults of its numbers, expected describe() to have all parts "
               "always, with only_if() where a number decides whether one is there";
    };
    Growing const loop([](ModuleDescription& module, std::uint64_t stages) {
        if (stages == 3)
            module.loop("late").of_depth(2);
    });
    CHECK(loop.complaint_with(2) == "(no error)");
    CHECK(loop.complaint_with(3) == complaint("accelerator.loops.writer.late.ii"));
    Growing const port([](ModuleDescription& module, std::uint64_t stages) {
        if (stages == 3)
            module.stores("out");
    });
    CHECK(port.complaint_with(3) == complaint("accelerator.memory.model"));
    Growing const conditional([](ModuleDescription& module, std::uint64_t stages) {
        module.loop("late").of_depth(2).only_if({stages == 3, "workload.stages"});
    });
    CHECK(conditional.complaint_with(3) == "(no error)");
    Growing const deeper(
        [](ModuleDescription& module, std::uint64_t stages) { module.loops.front().of_depth(stages); });
    CHECK(deeper.complaint_with(3) == "(no error)");
}

TEST_CASE("a number of a design has no name of another key", "[machine]") {
    for (char const* const name : {"workload.samples", "accelerator.cores", "accelerator.clock_mhz"})
        CHECK_THAT(input_error_text([name] {
                       require_named_once(Storing({}, {{name, 1, "One."}}).keys());
                   }),
                   Contains(std::string("in the design two keys have the name ") + name + ", expected another name"));
    CHECK_NOTHROW(require_named_once(Storing({}, {{"workload.rows", 1, "One."}}).keys()));
}

TEST_CASE("names are words that keys can have", "[machine]") {
    for (char const* const name : {"", "a.b", "a b", "a:b", "a*", "~", "&x", "null"}) {
        std::string const expected = std::string("has the name \"") + name + "\", expected a word";
        CHECK_THAT(complaint_about([&](auto& writer, auto&) { writer.name = name; }), Contains(expected));
        CHECK_THAT(complaint_about([&](auto& writer, auto&) { writer.loop(name).of_depth(1); }), Contains(expected));
        CHECK_THAT(complaint_about([&](auto& writer, auto&) { writer.memory(name).of_words(1, 1, 1); }),
                   Contains(expected));
    }
    CHECK(input_error_text([] { core_of({}); }) == "the design has no module, expected at least one");
    CoreDescription core = row_of_four();
    core.begins = "frist";
    CHECK(input_error_text([&] { check_design(core); }) ==
          "the core begins with a module frist, which there is not, expected one of the design, did you mean first?");
}

TEST_CASE("defaults are what keys may say", "[machine]") {
    CHECK(complaint_about([](auto& writer, auto&) { writer.ends[0].of_depth(0); }) ==
          "the depth of the FIFO f is 0, expected 1 to 1048576");
    CHECK(complaint_about([](auto& writer, auto&) { writer.loops[0].of_ii(0); }) ==
          "the initiation interval of loop writer.send is 0, expected 1 to 1000000");
    CHECK(complaint_about([](auto& writer, auto&) { writer.loops[0].of_depth(0); }) ==
          "the pipeline depth of loop writer.send is 0, expected 1 to 1000000");
    CHECK(complaint_about([](auto& writer, auto&) { writer.loops[0].of_states(0); }) ==
          "the number of states of loop writer.send is 0, expected 1 to 1000000");
    CHECK(complaint_about([](auto& writer, auto&) { writer.number("tries").is(5).within(6, 10); }) ==
          "the number tries of module writer is 5, expected 6 to 10");
}

TEST_CASE("stages and states that no cycle has are told", "[machine]") {
    constexpr Cycles less_than_none = ~Cycles{0};
    CHECK(complaint_about([](auto& writer, auto&) { writer.ends[0].leaves("send", less_than_none); }) ==
          "the stage in which module writer writes the FIFO f is 18446744073709551615, expected 0 to 1000000");
    CHECK_THAT(complaint_about([](auto&, auto& reader) { reader.ends[0].taken("receive", less_than_none); }),
               Contains("the stage in which module reader reads the FIFO f is"));
    CHECK_THAT(complaint_about([](auto& writer, auto&) { writer.loops[0].of_depth(2, less_than_none); }),
               Contains("what other keys add to the depth of loop writer.send is"));
    CHECK_THAT(complaint_about([](auto& writer, auto&) { writer.loops[0].enters_in(less_than_none); }),
               Contains("the states before loop writer.send is"));
    CHECK_THAT(complaint_about([](auto& writer, auto&) { writer.loops[0].leaves_in(less_than_none); }),
               Contains("the states behind loop writer.send is"));
}

TEST_CASE("what a description cannot mean is told", "[machine]") {
    CHECK(complaint_about([](auto& writer, auto&) { writer.loops[0].of_states(2).rewinds(); }) ==
          "loop writer.send rewinds and is not pipelined, expected of_depth() instead of of_states()");
    CHECK(complaint_about([](auto& writer, auto&) { writer.ends[0].hands_over(16); }) ==
          "module writer writes the ping-pong buffer f in a loop, expected that it changes hands as a whole, between "
          "calls");
    CHECK(complaint_about([](auto& writer, auto& reader) {
              writer.ends[0].hands_over(16).loop = "";
              reader.ends[0].non_blocking();
          }) ==
          "module reader reads the ping-pong buffer f without waiting, expected that it changes hands as a whole, "
          "between calls");
}

TEST_CASE("keys and results of a design have names that files can have", "[machine]") {
    auto const with_key = [](char const* key) {
        return input_error_text([key] { Storing({}, {{key, 1, "One."}, {"workload.rows", 1, "Rows."}}).keys(); });
    };
    for (char const* const key : {"", "rows", "workload..rows", "workload.", ".rows", "workload.a b"})
        CHECK(with_key(key) == "a number of the design has the key \"" + std::string(key) +
                                   "\", expected words and dots between them, such as workload.rows");
    CHECK(with_key("workload.rows.first") ==
          "numbers of the design have the keys workload.rows and workload.rows.first, expected none that begins with "
          "another and a dot");
    CHECK(input_error_text([] {
              Storing({}, {{"workload.rows", 1, "Rows.", {-5, 5}}}).keys();
          }) == "number workload.rows: its range begins with -5, expected 0 or more");
    auto const with_results = [](std::vector<ColumnFacts> const& results) {
        return input_error_text([&] { Growing([](auto&, auto) {}, results).keys(); });
    };
    CHECK(with_results({{"sum", "-", Tells::result, "all"}}) == "(no error)");
    CHECK(with_results({{"a,b", "-", Tells::result, "all"}}) ==
          "a result of the design has the name \"a,b\", expected a word, such as sum, which tables can have");
    for (char const* const taken : {"sum", "latency_cycles"})
        CHECK(with_results({{"sum", "-", Tells::result, "all"}, {taken, "-", Tells::result, "all"}}) ==
              "a result of the design has the name " + std::string(taken) +
                  ", which another column of its table has, expected another");
}

TEST_CASE("a loop with the keys of another is as that one is", "[machine]") {
    auto const complaint = [](char const* loop, Cycles depth) {
        return complaint_about([=](auto&, auto& reader) { reader.loop("again").of_depth(depth).with_keys_of(loop); });
    };
    CHECK(complaint("writer.send", 2) == "(no error)");
    CHECK_THAT(complaint("writer.send", 3), Contains("has the keys of writer.send and another depth"));
    CHECK_THAT(complaint("writer.sent", 2),
               Contains("expected a loop of the design that has keys of its own, did you mean writer.send?"));
    CHECK_THAT(complaint("reader.again", 2), Contains("expected a loop of the design that has keys of its own"));
}

}  // namespace design_check_test
