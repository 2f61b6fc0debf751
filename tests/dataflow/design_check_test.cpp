#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/core/machine/core_of.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/config/simple_design.hpp"
#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"

namespace design_check_test {

using namespace faster;
using faster::test::input_error_text;

/// A writer and a reader, with whatever is changed.
std::string complaint_about(std::function<void(ModuleDescription& writer, ModuleDescription& reader)> const& change) {
    ModuleDescription writer("writer"), reader("reader");
    writer.writes_to("f").of_bits(32).leaves("send", 1);
    writer.loop("send").of_depth(2);
    writer.memory("table").of_words(4, 4, 8);
    reader.reads_from("f").taken("receive", 0);
    reader.loop("receive").of_depth(2);
    change(writer, reader);
    return input_error_text([&] { make_machine(core_of({writer, reader}), {}); });
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
    explicit Storing(std::vector<std::string> ports) : SimpleDesign({"storing", {}, {}}), ports_(std::move(ports)) {}

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

}  // namespace design_check_test
