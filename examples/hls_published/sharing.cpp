// Design 07_fig3_ex5 of the public omnisim-benchmarks as functions: who has work offers it to a fast worker first, and
// to a slow one if that has no room.
#include <faster_hls.h>
#include <hls_design.hpp>

namespace {

using Number = std::uint32_t;

struct Shares {
    Number fast = 0, slow = 0;
};

void producer(hls::stream<Number>& fast, hls::stream<Number>& slow, unsigned numbers, Shares& shares) {
    shares = {};
    for (unsigned i = 0; i < numbers;) {
        FASTER_PIPELINE(offer, 2, 3);
        Number const number = 3 * (i + 1);
        if (fast.write_nb(number)) {
            ++shares.fast;
            ++i;
        } else if (slow.write_nb(number)) {
            ++shares.slow;
            ++i;
        }
    }
    fast.write(0);  // the last one, which waits
    slow.write(0);
}

void fast_worker(hls::stream<Number>& work, std::uint64_t& sum) {
    sum = 0;
    for (Number last = 1; last != 0;) {
        FASTER_PIPELINE(take, 3, 3);
        last = work.read();
        sum += last / 3;
    }
}

void slow_worker(hls::stream<Number>& work, std::uint64_t& sum) {
    sum = 0;
    for (Number last = 1; last != 0;) {
        FASTER_PIPELINE(take, 5, 5);
        last = work.read();
        sum += last / 3;
    }
}

struct Sharing : dataflow::HlsDesign {
    hls::stream<Number> fast{"fast"}, slow{"slow"};
    Shares shares;
    std::uint64_t fast_sum = 0, slow_sum = 0;

    explicit Sharing(dataflow::Numbers const& numbers) {
        auto const count = static_cast<unsigned>(numbers["workload.numbers"]);
        process("producer", [this, count] { producer(fast, slow, count, shares); });
        process("fast_worker", [this] { fast_worker(fast, fast_sum); });
        process("slow_worker", [this] { slow_worker(slow, slow_sum); });
    }
    dataflow::Counters results() const override { return {shares.fast, shares.slow, fast_sum, slow_sum}; }
    static dataflow::SimpleFacts facts() {
        return {"hls_sharing",
                {{"workload.numbers", 2025, "Numbers that are worked on."}},
                {{"fast", "-", dataflow::Tells::result, "numbers that the fast worker did"},
                 {"slow", "-", dataflow::Tells::result, "numbers that the slow worker did"},
                 {"fast_sum", "-", dataflow::Tells::result, "what the fast worker found"},
                 {"slow_sum", "-", dataflow::Tells::result, "what the slow worker found"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(Sharing, "Work that goes to whoever has room")
