// Design 03_fig3_ex4a of the public omnisim-benchmarks as functions: a producer that drops what finds no room, and a
// consumer three times as slow.
#include <faster_hls.h>
#include <hls_design.hpp>

namespace {

using Number = std::uint32_t;

void producer(hls::stream<Number>& number, Number& dropped, unsigned numbers) {
    dropped = 0;
    for (unsigned i = 0; i < numbers; ++i) {
        FASTER_PIPELINE(offer, 1);
        if (!number.write_nb(i + 1))
            ++dropped;
    }
    number.write(0);  // the last one, which waits
}

void consumer(hls::stream<Number>& number, Number& sum) {
    sum = 0;
    for (Number last = 1; last != 0;) {
        FASTER_PIPELINE(take, 3, 3);
        last = number.read();
        sum += last;
    }
}

struct Dropping : dataflow::HlsDesign {
    hls::stream<Number> number{"number"};
    Number dropped = 0, sum = 0;

    explicit Dropping(dataflow::Numbers const& numbers) {
        auto const count = static_cast<unsigned>(numbers["workload.numbers"]);
        process("producer", [this, count] { producer(number, dropped, count); });
        process("consumer", [this] { consumer(number, sum); });
    }
    dataflow::Counters results() const override { return {sum, dropped}; }
    static dataflow::SimpleFacts facts() {
        return {"hls_dropping",
                {{"workload.numbers", 2025, "Numbers that are offered."}},
                {{"sum", "-", dataflow::Tells::result, "of the numbers that passed"},
                 {"dropped", "-", dataflow::Tells::result, "numbers that found no room"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(Dropping, "A producer that drops what finds no room")
