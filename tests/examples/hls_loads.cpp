// Two processes whose names begin alike, one that reads and writes, and, as workload.mistake says, what a design must
// not do. With WAITS all accesses wait, and the functions run without time.
#include <ap_int.h>
#include <faster_hls.h>
#include <hls_design.hpp>
#include <stdexcept>

namespace {

struct Pair {
    static constexpr unsigned bits = 16;
    ap_uint<8> first, second;
};
enum Mistake : unsigned {
    none,
    throws,
    throws_number,
    reads_late,
    never_ends,
    asks_late,
    writes_early,
    constructor_throws,
    results_throw
};

void load(hls::stream<Pair, 8>& pair, unsigned numbers, unsigned mistake) {
    for (unsigned i = 0; i < numbers; ++i) {
        FASTER_PIPELINE(fetch, 1);
        if (i == 3 && mistake == throws)
            throw std::runtime_error("no row 3");
        if (i == 3 && mistake == throws_number)
            throw 5;
        if (mistake == asks_late && pair.full())
            continue;
        pair.write({ap_uint<8>(i), ap_uint<8>(2 * i)});
    }
    for (unsigned i = 0; mistake == never_ends; ++i) {  // NOLINT(bugprone-infinite-loop): on purpose
        FASTER_PIPELINE(fetch, 1);
    }
}

void load_w(hls::stream<ap_uint<16>, 8>& weight, hls::stream<int>& last, unsigned numbers) {
    for (unsigned i = 0; i < numbers; ++i) {
        FASTER_PIPELINE(fetch, 1);
        weight.write(i);
    }
    last.write(1);
}

std::uint32_t sum(hls::stream<Pair, 8>& pair, hls::stream<ap_uint<16>, 8>& weight, hls::stream<int>& last,
                  hls::stream<int>& sums, unsigned numbers, unsigned mistake) {
    std::uint32_t total = 0;
    for (unsigned i = 0; i < numbers; ++i) {
        FASTER_PIPELINE(add, 2, 2);
        total += pair.read().first.to_uint() + weight.read().to_uint();
        if (mistake == reads_late && i == 1)
            last.read();
#ifdef WAITS
        sums.write(static_cast<int>(total));
#else
        sums.write_nb(static_cast<int>(total));
#endif
    }
    last.read();
    return total;
}

void sink(hls::stream<int>& sums, unsigned numbers) {
    for (unsigned i = 0; i < numbers; ++i) {
        FASTER_PIPELINE(poll, 9);
#ifdef WAITS
        sums.read();
#else
        int sum = 0;
        sums.read_nb(sum);
#endif
    }
}

struct Loads : dataflow::HlsDesign {
    hls::stream<Pair, 8> pair{"pair"};
    hls::stream<ap_uint<16>, 8> weight{"weight"};
    hls::stream<int> last{"last"};
    hls::stream<int> sums{"sums"};
    std::uint32_t total = 0;
    unsigned mistake;
    explicit Loads(dataflow::Numbers const& keys) : mistake(static_cast<unsigned>(keys["workload.mistake"])) {
        auto const numbers = static_cast<unsigned>(keys["workload.numbers"]);
        if (mistake == writes_early)
            last.write(1);
        if (mistake == constructor_throws)
            throw std::runtime_error("no numbers");
        process("load", [=] { load(pair, numbers, mistake); });
        process("load_w", [=] { load_w(weight, last, numbers); });
        process("sum", [=] { total = sum(pair, weight, last, sums, numbers, mistake); });
        process("sink", [=] { sink(sums, numbers); });
    }
    dataflow::Counters results() const override {
        if (mistake == results_throw)
            throw std::runtime_error("no total");
        return {total};
    }
    static dataflow::SimpleFacts facts() {
        return {"loads",
                {{"workload.numbers", 30, "Numbers."}, {"workload.mistake", 0, "What is done wrong.", {0, 8}}},
                {{"total", "-", dataflow::Tells::result, "all together"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(Loads, "adds up")
