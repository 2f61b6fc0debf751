// Numbers from the external memory and back: one module loads them in bursts, another doubles them, a third stores
// them.
#include "dataflow/commands/simple_tool.hpp"

using namespace dataflow;

namespace {

constexpr std::uint64_t word_bytes = 4;

class Loader : public SimpleModule {
  public:
    sc_core::sc_fifo_out<std::uint32_t> loaded_out{"loaded_out"};

    static ModuleDescription describe() {
        ModuleDescription module("loader");
        module.writes_to("loaded").carries("numbers from the loader to the doubler").of_bits(32).leaves("load", 2);
        module.fetches("input").brings("numbers to be doubled").taken_by("load");
        module.loop("load").does("takes one number per iteration").of_depth(3);
        return module;
    }
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t sample) override {
        std::uint64_t const numbers = number("workload.numbers");
        std::uint64_t const address = number("accelerator.memory.input_address") + sample * numbers * word_bytes;
        clock_.tell_ranges({{address, numbers, word_bytes}});
        clock_.pipeline("load", numbers, [this](std::uint64_t i) {
            clock_.access_memory();
            loaded_out.write(static_cast<std::uint32_t>(i));
        });
    }
};

class Doubler : public SimpleModule {
  public:
    sc_core::sc_fifo_in<std::uint32_t> loaded_in{"loaded_in"};
    sc_core::sc_fifo_out<std::uint32_t> doubled_out{"doubled_out"};

    static ModuleDescription describe() {
        ModuleDescription module("doubler");
        module.reads_from("loaded").taken("double", 0);
        module.writes_to("doubled").carries("numbers from the doubler to the storer").of_bits(32).leaves("double", 1);
        module.loop("double").does("doubles one number per iteration").of_depth(2);
        return module;
    }
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t /*sample*/) override {
        clock_.pipeline("double", number("workload.numbers"), tokens_of(loaded_in, doubled_out),
                        [](std::uint32_t loaded, std::uint32_t& doubled) { doubled = 2 * loaded; });
    }
};

class Storer : public SimpleModule {
  public:
    sc_core::sc_fifo_in<std::uint32_t> doubled_in{"doubled_in"};

    static ModuleDescription describe() {
        ModuleDescription module("storer");
        module.reads_from("doubled").taken("store", 0);
        module.stores("output").brings("doubled numbers").given_by("store");
        module.loop("store").does("gives one number per iteration").of_depth(2);
        return module;
    }
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t sample) override {
        std::uint64_t const numbers = number("workload.numbers");
        std::uint64_t const address = number("accelerator.memory.output_address") + sample * numbers * word_bytes;
        std::uint64_t sum = 0;
        clock_.tell_ranges({{address, numbers, word_bytes}});
        clock_.pipeline("store", numbers, [&](std::uint64_t) {
            sum += doubled_in.read();
            clock_.access_memory();
        });
        add_result({sum});
    }
};

class ExternalDoubler : public SimpleCore {
  public:
    static CoreDescription describe(Numbers const& /*numbers*/) {
        return core_of({Loader::describe(), Doubler::describe(), Storer::describe()});
    }
    explicit ExternalDoubler(SimpleCoreParts const& parts) : SimpleCore(parts) {
        loader_.loaded_out(loaded_);
        doubler_.loaded_in(loaded_);
        doubler_.doubled_out(doubled_);
        storer_.doubled_in(doubled_);
    }

  private:
    ClockedFifo<std::uint32_t> loaded_{"loaded", fifo_timing("loaded")};
    ClockedFifo<std::uint32_t> doubled_{"doubled", fifo_timing("doubled")};
    Loader loader_{"loader", *this};
    Doubler doubler_{"doubler", *this};
    Storer storer_{"storer", *this};
};

SimpleSimulation<ExternalDoubler> const& memory() {
    static SimpleSimulation<ExternalDoubler> const one(
        {"memory",
         {{"workload.numbers", 1000, "Numbers of one sample."},
          {"accelerator.memory.input_address", 0x10000000, "Where the numbers are.", {0, 0xFFFFFFFF}},
          {"accelerator.memory.output_address", 0x20000000, "Where they go.", {0, 0xFFFFFFFF}}},
         {{"sum", "-", Tells::result, "of all doubled numbers"}}});
    return one;
}

}  // namespace

Design const& dataflow::design() { return memory(); }
SimulatedDesign const& dataflow::simulated_design() { return memory(); }

int sc_main(int argc, char** argv) {
    return run_tool({"memory", "A loader, a doubler and a storer at an external memory", "1.0"}, standard_commands(),
                    argc, argv);
}
