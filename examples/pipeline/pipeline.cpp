// Three modules in a row: a reader fetches numbers, a scaler multiplies them, a writer adds up what arrives.
// docs/tutorial.md explains every line.
#include "dataflow/commands/simple_tool.hpp"

using namespace dataflow;

namespace {

class Reader : public SimpleModule {
  public:
    sc_core::sc_fifo_out<std::uint32_t> number_out{"number_out"};

    static ModuleDescription describe() {
        ModuleDescription module("reader");
        module.writes_to("number").carries("numbers from the reader to the scaler").of_bits(32).leaves("fetch", 2);
        module.loop("fetch").does("fetches one number per iteration").of_depth(3);
        return module;
    }
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t /*sample*/) override {
        clock_.advance(1);
        clock_.pipeline("fetch", number("workload.numbers"), tokens_of(number_out),
                        [](std::uint64_t i, std::uint32_t& number) { number = static_cast<std::uint32_t>(i); });
    }
};

class Scaler : public SimpleModule {
  public:
    sc_core::sc_fifo_in<std::uint32_t> number_in{"number_in"};
    sc_core::sc_fifo_out<std::uint32_t> product_out{"product_out"};

    static ModuleDescription describe() {
        ModuleDescription module("scaler");
        module.reads_from("number").taken("scale", 0);
        module.writes_to("product").carries("products from the scaler to the writer").of_bits(32).leaves("scale", 3);
        module.loop("scale").does("multiplies one number per iteration").of_depth(4);
        return module;
    }
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t /*sample*/) override {
        clock_.advance(1);
        clock_.pipeline("scale", number("workload.numbers"), tokens_of(number_in, product_out),
                        [](std::uint32_t number, std::uint32_t& product) { product = 3 * number; });
    }
};

class Writer : public SimpleModule {
  public:
    sc_core::sc_fifo_in<std::uint32_t> product_in{"product_in"};

    static ModuleDescription describe() {
        ModuleDescription module("writer");
        module.reads_from("product").taken("store", 0);
        module.loop("store").does("adds up one product per iteration").of_depth(2);
        return module;
    }
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t /*sample*/) override {
        std::uint64_t sum = 0;
        clock_.advance(1);
        clock_.pipeline("store", number("workload.numbers"), tokens_of(product_in),
                        [&](std::uint32_t product) { sum += product; });
        add_result({sum});
    }
};

class Pipeline : public SimpleCore {
  public:
    static CoreDescription describe(Numbers const& /*numbers*/) {
        return core_of({Reader::describe(), Scaler::describe(), Writer::describe()});
    }
    explicit Pipeline(SimpleCoreParts const& parts) : SimpleCore(parts) {
        reader_.number_out(number_);
        scaler_.number_in(number_);
        scaler_.product_out(product_);
        writer_.product_in(product_);
    }

  private:
    ClockedFifo<std::uint32_t> number_{"number", fifo_timing("number")};
    ClockedFifo<std::uint32_t> product_{"product", fifo_timing("product")};
    Reader reader_{"reader", *this};
    Scaler scaler_{"scaler", *this};
    Writer writer_{"writer", *this};
};

SimpleSimulation<Pipeline> const& pipeline() {
    static SimpleSimulation<Pipeline> const one({"pipeline",
                                                 {{"workload.numbers", 1000, "Numbers of one sample."}},
                                                 {{"sum", "-", Tells::result, "of all products"}}});
    return one;
}

}  // namespace

Design const& dataflow::design() { return pipeline(); }
SimulatedDesign const& dataflow::simulated_design() { return pipeline(); }

int sc_main(int argc, char** argv) {
    return run_tool({"pipeline", "A reader, a scaler and a writer", "1.0"}, standard_commands(), argc, argv);
}
