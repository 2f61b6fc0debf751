// A producer that drops what finds no room, and a consumer three times as slow: 03_fig3_ex4a of the public
// omnisim-benchmarks.
#include "dataflow/commands/simple_tool.hpp"

using namespace dataflow;

namespace {

class Producer : public SimpleModule {
  public:
    sc_core::sc_fifo_out<std::uint32_t> number_out{"number_out"};

    static ModuleDescription describe() {
        ModuleDescription module("producer");
        module.writes_to("number")
            .carries("numbers from the producer to the consumer")
            .of_bits(32)
            .leaves("offer", 1)
            .non_blocking();
        module.loop("offer").does("offers one number per iteration").of_depth(2);
        return module;
    }
    Producer(sc_core::sc_module_name const& name, SimpleCore& core, std::uint64_t& dropped)
        : SimpleModule(name, core), dropped_(dropped) {}

  private:
    void work(std::size_t /*sample*/) override {
        auto& fifo = channel_of(number_out);
        dropped_ = 0;
        clock_.advance(1);
        clock_.pipeline("offer", number("workload.numbers"), [&](std::uint64_t i) {
            dropped_ += fifo.write_nb(static_cast<std::uint32_t>(i + 1)) ? 0U : 1U;
        });
        clock_.advance(1);
        number_out.write(0);  // the last one, which waits
    }

    std::uint64_t& dropped_;
};

class Consumer : public SimpleModule {
  public:
    sc_core::sc_fifo_in<std::uint32_t> number_in{"number_in"};

    static ModuleDescription describe() {
        ModuleDescription module("consumer");
        module.reads_from("number").taken("take", 0);
        module.loop("take").does("adds up one number per iteration").of_depth(3).recurs_every(3);
        return module;
    }
    Consumer(sc_core::sc_module_name const& name, SimpleCore& core, std::uint64_t const& dropped)
        : SimpleModule(name, core), dropped_(dropped) {}

  private:
    void work(std::size_t /*sample*/) override {
        std::uint64_t sum = 0;
        clock_.advance(1);
        clock_.pipeline_while("take", [&](std::uint64_t) {
            std::uint32_t const number = number_in.read();
            sum += number;
            return number != 0;
        });
        add_result({sum, dropped_});
    }

    std::uint64_t const& dropped_;
};

class Dropping : public SimpleCore {
  public:
    static CoreDescription describe(Numbers const& /*numbers*/) {
        return core_of({Producer::describe(), Consumer::describe()});
    }
    explicit Dropping(SimpleCoreParts const& parts) : SimpleCore(parts) {
        producer_.number_out(number_);
        consumer_.number_in(number_);
    }

  private:
    std::uint64_t dropped_ = 0;
    ClockedFifo<std::uint32_t> number_{"number", fifo_timing("number")};
    Producer producer_{"producer", *this, dropped_};
    Consumer consumer_{"consumer", *this, dropped_};
};

SimpleSimulation<Dropping> const& dropping() {
    static SimpleSimulation<Dropping> const one({"dropping",
                                                 {{"workload.numbers", 2025, "Numbers that are offered."}},
                                                 {{"sum", "-", Tells::result, "of the numbers that passed"},
                                                  {"dropped", "-", Tells::result, "numbers that found no room"}}});
    return one;
}

}  // namespace

Design const& dataflow::design() { return dropping(); }
SimulatedDesign const& dataflow::simulated_design() { return dropping(); }

int sc_main(int argc, char** argv) {
    return run_tool({"dropping", "A producer that drops what finds no room", "1.0"}, standard_commands(), argc, argv);
}
