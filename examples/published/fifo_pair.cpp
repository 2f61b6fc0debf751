// Two processes with a FIFO between them, by loops that are not pipelined: 61_dataflow and 62_stream of the public
// hls-directives.
#include "dataflow/commands/simple_tool.hpp"

using namespace dataflow;

namespace {

class Producer : public SimpleModule {
  public:
    sc_core::sc_fifo_out<std::int32_t> word_out{"word_out"};

    static ModuleDescription describe() {
        ModuleDescription module("producer");
        module.writes_to("word").carries("words from the producer to the consumer").of_bits(32).leaves("send", 2);
        module.loop("send").does("sends one word per iteration").of_states(3);
        return module;
    }
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t /*sample*/) override {
        clock_.repeat("send", number("workload.words"),
                      [this](std::uint64_t i) { word_out.write(static_cast<std::int32_t>(i)); });
    }
};

class Consumer : public SimpleModule {
  public:
    sc_core::sc_fifo_in<std::int32_t> word_in{"word_in"};

    static ModuleDescription describe() {
        ModuleDescription module("consumer");
        module.reads_from("word").taken("receive", 0);
        module.loop("receive").does("receives one word per iteration").of_states(2);
        return module;
    }
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t /*sample*/) override {
        std::uint64_t sum = 0;
        clock_.repeat("receive", number("workload.words"),
                      [&](std::uint64_t) { sum += static_cast<std::uint64_t>(word_in.read()); });
        add_result({sum});
    }
};

class FifoPair : public SimpleCore {
  public:
    static CoreDescription describe(Numbers const& /*numbers*/) {
        return core_of({Producer::describe(), Consumer::describe()});
    }
    explicit FifoPair(SimpleCoreParts const& parts) : SimpleCore(parts) {
        producer_.word_out(word_);
        consumer_.word_in(word_);
    }

  private:
    ClockedFifo<std::int32_t> word_{"word", fifo_timing("word")};
    Producer producer_{"producer", *this};
    Consumer consumer_{"consumer", *this};
};

SimpleSimulation<FifoPair> const& fifo_pair() {
    static SimpleSimulation<FifoPair> const one(
        {"fifo_pair", {{"workload.words", 16, "Words of one call."}}, {{"sum", "-", Tells::result, "of all words"}}});
    return one;
}

}  // namespace

Design const& dataflow::design() { return fifo_pair(); }
SimulatedDesign const& dataflow::simulated_design() { return fifo_pair(); }

int sc_main(int argc, char** argv) {
    return run_tool({"fifo_pair", "Two loops that are not pipelined, and a FIFO", "1.0"}, standard_commands(), argc,
                    argv);
}
