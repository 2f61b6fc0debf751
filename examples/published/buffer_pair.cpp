// Two processes with ping-pong buffers between them: 62_stream of the public hls-directives, as a PIPO.
#include "dataflow/commands/simple_tool.hpp"

using namespace dataflow;

namespace {

using Words = std::vector<std::int32_t>;

class Producer : public SimpleModule {
  public:
    static ModuleDescription describe() {
        ModuleDescription module("producer");
        module.writes_to("words").carries("words from the producer to the consumer").of_bits(32).hands_over(16);
        module.loop("fill").does("writes one word per iteration").of_states(2);
        return module;
    }
    Producer(char const* name, SimpleCore& core) : SimpleModule(name, core), core_(core) {}

  private:
    void work(std::size_t /*sample*/) override {
        Words words;
        clock_.repeat("fill", 16, [&](std::uint64_t i) { words.push_back(static_cast<std::int32_t>(i)); });
        core_.ping_pong<std::int32_t>("words").put(words);
    }
    SimpleCore& core_;
};

class Consumer : public SimpleModule {
  public:
    static ModuleDescription describe() {
        ModuleDescription module("consumer");
        module.reads_from("words");
        module.loop("use").does("multiplies one word per iteration").of_states(5);
        return module;
    }
    Consumer(char const* name, SimpleCore& core) : SimpleModule(name, core), core_(core) {}

  private:
    void work(std::size_t /*sample*/) override {
        Words const words = core_.ping_pong<std::int32_t>("words").take();
        std::uint64_t sum = 0;
        clock_.repeat("use", 16, [&](std::uint64_t i) { sum += static_cast<std::uint64_t>(3 * words.at(i)); });
        add_result({sum});
    }
    SimpleCore& core_;
};

class BufferPair : public SimpleCore {
  public:
    static CoreDescription describe(Numbers const& /*numbers*/) {
        return core_of({Producer::describe(), Consumer::describe()});
    }
    explicit BufferPair(SimpleCoreParts const& parts) : SimpleCore(parts) {}

  private:
    PingPong<std::int32_t> words_{"words", ping_pong_timing("words")};
    Producer producer_{"producer", *this};
    Consumer consumer_{"consumer", *this};
};

SimpleSimulation<BufferPair> const& buffer_pair() {
    static SimpleSimulation<BufferPair> const one(
        {"buffer_pair", {}, {{"sum", "-", Tells::result, "of all products"}}});
    return one;
}

}  // namespace

Design const& dataflow::design() { return buffer_pair(); }
SimulatedDesign const& dataflow::simulated_design() { return buffer_pair(); }

int sc_main(int argc, char** argv) {
    return run_tool({"buffer_pair", "Two processes and ping-pong buffers", "1.0"}, standard_commands(), argc, argv);
}
