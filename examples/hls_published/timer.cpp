// Design 08_fig2_timer of the public omnisim-benchmarks as functions: a process that counts the iterations in which it
// waits for the answer of another.
#include <ap_fixed.h>
#include <faster_hls.h>
#include <hls_design.hpp>

namespace {

using Number = ap_fixed<32, 16>;

void divider(hls::stream<Number>& question, hls::stream<Number>& answer, unsigned numbers) {
    for (unsigned i = 0; i < numbers; ++i) {
        FASTER_LOOP(divide, 4);
        answer.write(question.read() / 3);
    }
}

void timer(hls::stream<Number>& question, hls::stream<Number>& answer, unsigned numbers, std::uint64_t& waits) {
    waits = 0;
    for (unsigned i = 0; i < numbers; ++i) {
        {
            FASTER_STATES(next,
                          1);  // the tool does not flatten this loop, and looks at its condition in a state of its own
        }
        question.write(i);
        while (answer.empty()) {
            FASTER_PIPELINE(wait, 1, 1);
            ++waits;
        }
        answer.read();
    }
}

struct Timer : dataflow::HlsDesign {
    hls::stream<Number> question{"question"}, answer{"answer"};
    std::uint64_t waits = 0;

    explicit Timer(dataflow::Numbers const& numbers) {
        auto const count = static_cast<unsigned>(numbers["workload.numbers"]);
        process("divider", [this, count] { divider(question, answer, count); });
        process("timer", [this, count] { timer(question, answer, count, waits); });
    }
    dataflow::Counters results() const override { return {waits}; }
    static dataflow::SimpleFacts facts() {
        return {"hls_timer",
                {{"workload.numbers", 2025, "Numbers that are divided."}},
                {{"waits", "-", dataflow::Tells::result, "iterations in which no answer was there"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(Timer, "A process that counts how long it waits for another")
