// examples/arbiter as functions, with every access that does not wait.
#include <array>
#include <faster_hls.h>
#include <hls_design.hpp>
#include <utility>

namespace {

using Message = std::uint32_t;
using Messages = hls::stream<Message>;

void producer(Messages& out, unsigned sender, unsigned messages) {
    for (unsigned i = 0; i < messages; ++i) {
        FASTER_PIPELINE(produce, 1);
        out.write(2 * i + sender);
    }
}

/// Messages of the second one are looked for before they are read.
void arbiter(Messages& first, Messages& second, Messages& granted, unsigned messages, bool takes_turns) {
    std::array<Messages*, 2> const in{&first, &second};
    unsigned preferred = 0;
    for (unsigned left = 2 * messages; left > 0;) {
        FASTER_PIPELINE(grant, 1);
        Message message = 0;
        for (unsigned const sender : {preferred, 1 - preferred}) {
            bool const is_there = sender == 0 ? in[sender]->read_nb(message) : !in[sender]->empty();
            if (!is_there)
                continue;
            if (sender == 1)
                message = in[sender]->read();
            granted.write(message);
            preferred = takes_turns ? 1 - sender : 0;
            --left;
            break;
        }
    }
}

void consumer(Messages& granted, unsigned messages, std::uint64_t& first_of_second, std::uint64_t& changes) {
    Message last = 0;
    changes = first_of_second = 0;
    for (unsigned i = 0; i < 2 * messages; ++i) {
        FASTER_PIPELINE(consume, 1, 3);
        Message const message = granted.read();
        if (message == 1)
            first_of_second = i;
        changes += message % 2 != std::exchange(last, message) % 2 ? 1U : 0U;
    }
}

struct Arbiter : dataflow::HlsDesign {
    Messages first_message{"first_message"}, second_message{"second_message"}, granted{"granted"};
    std::uint64_t first_of_second = 0, changes = 0;

    explicit Arbiter(dataflow::Numbers const& numbers) {
        auto const messages = static_cast<unsigned>(numbers["workload.messages"]);
        bool const takes_turns = numbers["accelerator.arbiter.round_robin"] != 0;
        process("first", [=] { producer(first_message, 0, messages); });
        process("second", [=] { producer(second_message, 1, messages); });
        process("arbiter", [=] { arbiter(first_message, second_message, granted, messages, takes_turns); });
        process("consumer", [=] { consumer(granted, messages, first_of_second, changes); });
    }
    dataflow::Counters results() const override { return {first_of_second, changes}; }
    static dataflow::SimpleFacts facts() {
        return {"hls_arbiter",
                {{"workload.messages", 100, "Messages of each producer in one sample."},
                 {"accelerator.arbiter.round_robin", 1, "1: both take turns; 0: the first has priority.", {0, 1}}},
                {{"second_waits", "messages", dataflow::Tells::result, "that pass before the second producer's first"},
                 {"changes", "-", dataflow::Tells::result, "from one producer's messages to the other's"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(Arbiter, "Two producers, an arbiter and a consumer, as functions")
