// Two modules that wait for each other: a controller sends a request and reads the answer before it goes on, a
// processor answers. After design 02_fig3_ex3 of the public omnisim-benchmarks; README.md counts its cycles.
#include "tool/simple_tool.hpp"

using namespace faster;

namespace {

using Message = std::uint32_t;

Message answer_to(Message request) { return 2 * request; }

class Processor : public SampleModule {
  public:
    sc_core::sc_fifo_in<Message> request_in{"request_in"};
    sc_core::sc_fifo_out<Message> response_out{"response_out"};

    static ModuleDescription describe() {
        ModuleDescription module("processor");
        module.reads_from("request").taken("double", 1);
        module.writes_to("response").carries("answers from the processor").of_bits(32).leaves("double", 1);
        module.loop("double").does("answers one request per iteration").of_depth(2);
        return module;
    }
    Processor(sc_core::sc_module_name const& name, SimpleCore& core)
        : SampleModule(name, core), messages_(core.numbers()["workload.messages"]) {}

  private:
    void work(std::size_t /*sample*/) override {
        auto& requests = channel_of(request_in);
        auto& responses = channel_of(response_out);
        clock_.advance(1);  // its start token
        clock_.pipeline(
            "double", messages_, [&](std::uint64_t) { clock_.access(responses.write_port()); }, requests,
            [&](std::uint64_t) { responses.put(answer_to(requests.take())); });
    }

    std::uint64_t messages_;
};

class Controller : public SampleModule {
  public:
    sc_core::sc_fifo_out<Message> request_out{"request_out"};
    sc_core::sc_fifo_in<Message> response_in{"response_in"};

    static ModuleDescription describe() {
        ModuleDescription module("controller");
        module.writes_to("request").carries("requests from the controller").of_bits(32).leaves("exchange", 1);
        module.reads_from("response").taken("exchange", 2);
        module.loop("exchange").does("sends one request and reads its answer per iteration").of_depth(3);
        return module;
    }
    Controller(sc_core::sc_module_name const& name, SimpleCore& core)
        : SampleModule(name, core),
          messages_(core.numbers()["workload.messages"]),
          entry_states_(core.numbers()["accelerator.controller.entry_states"]) {}
    /// By sample: the sum of all answers.
    std::vector<Counters> const& sums() const { return sums_; }

  private:
    void work(std::size_t /*sample*/) override {
        auto& responses = channel_of(response_in);
        std::uint64_t sum = 0;
        clock_.advance(entry_states_);
        clock_.pipeline(
            "exchange", messages_, [&](std::uint64_t i) { request_out.write(static_cast<Message>(i)); }, responses,
            [&](std::uint64_t) { sum += responses.take(); });
        sums_.push_back({sum});
    }

    std::uint64_t messages_;
    std::uint64_t entry_states_;
    std::vector<Counters> sums_;
};

class CyclicCore : public SimpleCore {
  public:
    static CoreDescription describe(Numbers const& /*numbers*/) {
        return core_of({Processor::describe(), Controller::describe()});
    }
    explicit CyclicCore(SimpleCoreParts const& parts) : SimpleCore(parts) {
        controller_.request_out(request_);
        controller_.response_in(response_);
        processor_.request_in(request_);
        processor_.response_out(response_);
    }
    std::size_t results() const override { return controller_.sums().size(); }
    Counters result(std::size_t i) const override { return controller_.sums()[i]; }

  private:
    ClockedFifo<Message> request_{"request", fifo_timing("request")};
    ClockedFifo<Message> response_{"response", fifo_timing("response")};
    Processor processor_{"processor", *this};
    Controller controller_{"controller", *this};
};

SimpleSimulation<CyclicCore> const& cyclic() {
    static SimpleSimulation<CyclicCore> const one(
        {"cyclic",
         {{"workload.messages", 2025, "Requests of one sample."},
          {"accelerator.controller.entry_states", 1, "Cycles before the controller's loop begins.", {0, 1000}}},
         {{"sum", "-", Tells::result, "of all answers"}}});
    return one;
}

}  // namespace

Design const& faster::design() { return cyclic(); }
SimulatedDesign const& faster::simulated_design() { return cyclic(); }

int sc_main(int argc, char** argv) {
    return run_tool({"cyclic", "A controller and a processor that wait for each other", "1.0"}, standard_commands(),
                    argc, argv);
}
