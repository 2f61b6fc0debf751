// Two modules that wait for each other: a controller sends a request and reads the answer before it goes on, a
// processor answers. After design 02_fig3_ex3 of the public omnisim-benchmarks; README.md counts its cycles.
#include "dataflow/commands/simple_tool.hpp"

using namespace dataflow;

namespace {

using Message = std::uint32_t;

Message answer_to(Message request) { return 2 * request; }

class Processor : public SimpleModule {
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
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t /*sample*/) override {
        auto& requests = channel_of(request_in);
        auto& responses = channel_of(response_out);
        clock_.advance(1);  // its start token
        clock_.pipeline(
            "double", number("workload.messages"), [&](std::uint64_t) { clock_.access(responses.write_port()); },
            requests, [&](std::uint64_t) { responses.put(answer_to(requests.take())); });
    }
};

class Controller : public SimpleModule {
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
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t /*sample*/) override {
        auto& responses = channel_of(response_in);
        std::uint64_t sum = 0;
        clock_.advance(number("accelerator.controller.entry_states"));
        clock_.pipeline(
            "exchange", number("workload.messages"),
            [&](std::uint64_t i) { request_out.write(static_cast<Message>(i)); }, responses,
            [&](std::uint64_t) { sum += responses.take(); });
        add_result({sum});
    }
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

Design const& dataflow::design() { return cyclic(); }
SimulatedDesign const& dataflow::simulated_design() { return cyclic(); }

int sc_main(int argc, char** argv) {
    return run_tool({"cyclic", "A controller and a processor that wait for each other", "1.0"}, standard_commands(),
                    argc, argv);
}
