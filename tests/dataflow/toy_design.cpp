#include "dataflow/toy_design.hpp"

#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/machine_keys.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::test {
namespace {

using Make = KeyMaker<ToyConfig>;

ModuleDescription describe_source() {
    ModuleDescription module("source");
    module.writes_to("number").carries("numbers to be looked up").of_bits(16);
    return module;
}

ModuleDescription describe_worker(ToyConfig const& config) {
    ModuleDescription module("worker");
    module.reads_from("number").makes_attempts = config.polls;
    module.writes_to("answer").carries("what was found").of_bits(32).leaves("look_up", 3);
    module.loop("look_up")
        .does("looks at one row per iteration")
        .of_depth(5)
        .accesses_memory("table", {{{0, 0}, {-1, 0}, {1, 0}}, {{0, 0}}})
        .in_stages({"table", 1, 3, 3, 1})
        .writes_to({"answer"});
    if (config.polls)
        module.loops.front().also_reads({"number"});
    module.loop("repeat").does("says the last answer again").of_depth(5).writes_to({"answer"});
    module.memory("table").holds("rows of the table").of_words(config.rows, 4, 36).sized_by("toy.rows");
    SetupDescription setup;
    setup.depth = 5;
    setup.meaning = "Cycles to get ready for a number.";
    setup.before_loop = "look_up";
    setup.one_per_token_of = "number";
    module.setup = setup;
    return module;
}

ModuleDescription describe_sink(ToyConfig const& config) {
    ModuleDescription module("sink");
    module.only_if({config.answers, "toy.answers"});
    module.reads_from("answer");
    return module;
}

class ToyDesign final : public Design {
  public:
    std::string name() const override { return "toy"; }
    std::unique_ptr<DesignConfig> default_config() const override { return std::make_unique<ToyConfig>(); }
    std::vector<Key> keys() const override {
        Keys keys{cores_key("toy.units", "Cores.", "toy"),
                  Make::integer_key(
                      {"toy.rows", "", "Rows of the table.", "toy"}, {1, 1024},
                      [](auto& config) -> auto& { return config.rows; }),
                  Make::boolean_key(
                      {"toy.answers", "", "Whether anybody wants answers.", "toy"},
                      [](auto& config) -> auto& { return config.answers; }),
                  Make::boolean_key(
                      {"toy.polls", "", "Whether the worker looks for numbers while it is at one.", "toy"},
                      [](auto& config) -> auto& { return config.polls; }),
                  clock_key("toy")};
        for (Key& key : machine_keys(describe_toy({})))
            keys.push_back(std::move(key));
        return keys;
    }
    CoreDescription core(RunConfig const& config) const override { return describe_toy(config.as<ToyConfig>()); }
    void require_keys_of_parts(RunConfig const& config) const override {
        if (config.as<ToyConfig>().rows == 1000)
            throw InputError("the thousandth row has no keys");
    }
    std::vector<ColumnFacts> const& counters() const override {
        static std::vector<ColumnFacts> const one{{"found", "rows", Tells::result, "rows that were found"}};
        return one;
    }
};

}  // namespace

CoreDescription describe_toy(ToyConfig const& config) {
    CoreDescription core;
    core.modules = {describe_source(), describe_worker(config), describe_sink(config)};
    core.fifos = {"number", "answer"};
    core.begins = "source";
    core.ends = "worker";
    core.pace = {"worker", {{"source", "number"}, {"sink", "answer"}}};
    return core;
}

}  // namespace faster::test

dataflow::Design const& dataflow::design() {
    static faster::test::ToyDesign const toy;
    return toy;
}
