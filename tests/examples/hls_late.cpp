// The last function returns before the others have done all that lies before its end: a sum is complete all the same.
#include <faster_hls.h>
#include <hls_design.hpp>

namespace {

void source(hls::stream<int>& start, hls::stream<int>& number) {
    start.write_nb(1);
    for (int i = 0; i < 10; ++i) {
        FASTER_PIPELINE(send, 1);
        number.write(i);
    }
}

void counter(hls::stream<int>& number, std::uint32_t& sum) {
    sum = 0;
    for (int i = 0; i < 10; ++i) {
        FASTER_PIPELINE(add, 1);
        sum += static_cast<std::uint32_t>(number.read());
    }
}

void waiter(hls::stream<int>& start) {
    start.read();
    FASTER_STATES(tail, 1000);
}

struct Late : dataflow::HlsDesign {
    hls::stream<int> start{"start"}, number{"number"};
    std::uint32_t sum = 0;

    explicit Late(dataflow::Numbers const& /*numbers*/) {
        process("source", [this] { source(start, number); });
        process("counter", [this] { counter(number, sum); });
        process("waiter", [this] { waiter(start); });
    }
    dataflow::Counters results() const override { return {sum}; }
    static dataflow::SimpleFacts facts() {
        return {"hls_late", {}, {{"sum", "-", dataflow::Tells::result, "of the numbers"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(Late, "A function that returns before others have done what lies before its end")
