// A reader that looks for tokens: before its loop, and in the condition of the loop that takes them.
#include <faster_hls.h>
#include <hls_design.hpp>

namespace {

using Number = std::uint32_t;

void producer(hls::stream<Number>& out, unsigned numbers) {
    for (unsigned i = 0; i < numbers; ++i) {
        FASTER_PIPELINE(produce, 4);
        out.write(i);
    }
}

void poller(hls::stream<Number>& in, unsigned numbers, Number& sum, bool asks_size) {
    sum = 0;
    for (unsigned left = asks_size ? static_cast<unsigned>(in.size()) : numbers; left > 0;)
        while (!in.empty()) {
            FASTER_PIPELINE(take, 1);
            sum += in.read();
            --left;
        }
}

struct Poller : dataflow::HlsDesign {
    hls::stream<Number> number{"number"};
    Number sum = 0;

    explicit Poller(dataflow::Numbers const& numbers) {
        auto const count = static_cast<unsigned>(numbers["workload.numbers"]);
        bool const asks_size = numbers["workload.asks_size"] != 0;
        process("producer", [=] { producer(number, count); });
        process("poller", [=] { poller(number, count, sum, asks_size); });
    }
    dataflow::Counters results() const override { return {sum}; }
    static dataflow::SimpleFacts facts() {
        return {
            "hls_poller",
            {{"workload.numbers", 10, "Numbers of one sample."}, {"workload.asks_size", 0, "1: by size().", {0, 1}}},
            {{"sum", "-", dataflow::Tells::result, "of all numbers"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(Poller, "A producer and a reader that looks for tokens")
