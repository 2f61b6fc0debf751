// Two producers share a FIFO: an arbiter takes what is there, a token a cycle, by turns or by priority. Who is first
// depends on when tokens come, so it looks without waiting.
#include <array>
#include <utility>

#include "dataflow/commands/simple_tool.hpp"

using namespace dataflow;

namespace {

/// The sender's number of it, twice, and who sent it: 0 or 1.
using Message = std::uint32_t;

Message message_of(std::uint32_t sender, std::uint64_t number) { return static_cast<Message>(2 * number) + sender; }
std::uint32_t sender_of(Message message) { return message % 2; }

class Producer : public SimpleModule {
  public:
    sc_core::sc_fifo_out<Message> message_out{"message_out"};

    static ModuleDescription describe(std::string const& name) {
        ModuleDescription module(name);
        module.writes_to(name + "_message")
            .carries("messages from the " + name + " producer")
            .of_bits(32)
            .leaves("produce", 1);
        module.loop("produce").does("sends one message per iteration").of_depth(2);
        return module;
    }
    Producer(sc_core::sc_module_name const& name, SimpleCore& core, std::uint32_t sender)
        : SimpleModule(name, core), sender_(sender) {}

  private:
    void work(std::size_t /*sample*/) override {
        clock_.advance(1);
        clock_.pipeline("produce", number("workload.messages"),
                        [&](std::uint64_t i) { message_out.write(message_of(sender_, i)); });
    }

    std::uint32_t sender_;
};

class Arbiter : public SimpleModule {
  public:
    sc_core::sc_fifo_in<Message> first_in{"first_in"};
    sc_core::sc_fifo_in<Message> second_in{"second_in"};
    sc_core::sc_fifo_out<Message> granted_out{"granted_out"};

    static ModuleDescription describe() {
        ModuleDescription module("arbiter");
        module.reads_from("first_message").taken("grant", 0).non_blocking();
        module.reads_from("second_message").taken("grant", 0).non_blocking();
        module.writes_to("granted").carries("messages that the arbiter lets pass").of_bits(32).leaves("grant", 1);
        module.loop("grant").does("lets at most one message pass per iteration").of_depth(2);
        return module;
    }
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t /*sample*/) override {
        bool const takes_turns = number("accelerator.arbiter.round_robin") != 0;
        std::uint64_t left = 2 * number("workload.messages");
        std::array<ClockedFifo<Message>*, 2> const fifos{&channel_of(first_in), &channel_of(second_in)};
        unsigned preferred = 0;
        clock_.advance(1);
        clock_.pipeline_while("grant", [&](std::uint64_t) {
            Message message = 0;
            for (unsigned const sender : {preferred, 1 - preferred})
                if (fifos[sender]->read_nb(message)) {
                    granted_out.write(message);
                    preferred = takes_turns ? 1 - sender : 0;
                    --left;
                    break;
                }
            return left > 0;
        });
    }
};

class Consumer : public SimpleModule {
  public:
    sc_core::sc_fifo_in<Message> granted_in{"granted_in"};

    static ModuleDescription describe() {
        ModuleDescription module("consumer");
        module.reads_from("granted").taken("consume", 0);
        module.loop("consume").does("takes one message per iteration").of_depth(3);
        return module;
    }
    using SimpleModule::SimpleModule;

  private:
    void work(std::size_t /*sample*/) override {
        std::uint64_t first_of_second = 0, changes = 0;
        std::uint32_t last = 0;
        std::uint64_t const messages = 2 * number("workload.messages");
        clock_.advance(1);
        clock_.pipeline("consume", messages, [&](std::uint64_t i) {
            Message const message = granted_in.read();
            if (message == message_of(1, 0))
                first_of_second = i;
            changes += sender_of(message) != std::exchange(last, sender_of(message)) ? 1U : 0U;
        });
        add_result({first_of_second, changes});
    }
};

class ArbiterCore : public SimpleCore {
  public:
    static CoreDescription describe(Numbers const& /*numbers*/) {
        return core_of(
            {Producer::describe("first"), Producer::describe("second"), Arbiter::describe(), Consumer::describe()});
    }
    explicit ArbiterCore(SimpleCoreParts const& parts) : SimpleCore(parts) {
        first_.message_out(first_message_);
        second_.message_out(second_message_);
        arbiter_.first_in(first_message_);
        arbiter_.second_in(second_message_);
        arbiter_.granted_out(granted_);
        consumer_.granted_in(granted_);
    }

  private:
    ClockedFifo<Message> first_message_{"first_message", fifo_timing("first_message")};
    ClockedFifo<Message> second_message_{"second_message", fifo_timing("second_message")};
    ClockedFifo<Message> granted_{"granted", fifo_timing("granted")};
    Producer first_{"first", *this, 0};
    Producer second_{"second", *this, 1};
    Arbiter arbiter_{"arbiter", *this};
    Consumer consumer_{"consumer", *this};
};

SimpleSimulation<ArbiterCore> const& arbiter() {
    static SimpleSimulation<ArbiterCore> const one(
        {"arbiter",
         {{"workload.messages", 100, "Messages of each producer in one sample."},
          {"accelerator.arbiter.round_robin", 1, "1: both take turns; 0: the first has priority.", {0, 1}}},
         {{"second_waits", "messages", Tells::result, "that pass before the second producer's first"},
          {"changes", "-", Tells::result, "from one producer's messages to the other's"}}});
    return one;
}

}  // namespace

Design const& dataflow::design() { return arbiter(); }
SimulatedDesign const& dataflow::simulated_design() { return arbiter(); }

int sc_main(int argc, char** argv) {
    return run_tool({"arbiter", "Two producers, an arbiter and a consumer", "1.0"}, standard_commands(), argc, argv);
}
