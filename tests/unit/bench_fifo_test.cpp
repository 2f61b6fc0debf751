#include "dataflow/lookup/bench_fifo.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "faster/dataflow_names.hpp"

namespace dataflow::timing::bench_fifo_test {

/// The cycles of all writes and reads of a FIFO, as close together as chance has it.
struct Accesses {
    std::vector<StateWord> writes, reads;

    /// `room`: writes that may be ahead of reads; `latency`: from a write to when its token can be read.
    Accesses(std::mt19937& random, unsigned room, StateWord latency, unsigned count) {
        auto const pause = [&random] { return static_cast<StateWord>(random() % 4 == 0 ? random() % 12 : 1); };
        StateWord write = 0, read = 0;
        for (unsigned n = 0; n < count; ++n) {
            write = std::max(write + pause(), n >= room ? reads[n - room] + 1 : 0);
            writes.push_back(write);
            read = std::max(read + pause(), write + latency);
            reads.push_back(read);
        }
    }

    /// Of all pairs of a write and a read, one of which is not among the first. A write takes effect so much later.
    std::uint64_t largest_occupancy(unsigned first_writes, unsigned first_reads, unsigned all_reads,
                                    StateWord later) const {
        std::uint64_t largest = writes.size() > first_writes ? 1 : 0;
        for (unsigned n = 0; n < writes.size(); ++n)
            for (unsigned k = 0; k < std::min(n + 1, all_reads); ++k)
                if ((n >= first_writes || k >= first_reads) && reads[k] > writes[n] + later)
                    largest = std::max<std::uint64_t>(largest, n - k + 1);
        return largest;
    }
};

StateWords words_of(Accesses const& accesses, unsigned room, StateWord latency, unsigned writes, unsigned reads) {
    StateWords words(FifoCounts::words);
    for (unsigned n = reads; n < writes; ++n)
        words.push_back(accesses.writes[n] + latency);
    unsigned const over = writes < room ? std::min(room - writes, room - (writes - reads)) : 0;
    for (unsigned n = std::max(writes, room) - room; n < reads; ++n)
        words.push_back(accesses.reads[n] + 1);
    FifoCounts counts;
    counts.tokens = writes - reads;
    counts.room_over = over;
    counts.put(words.data());
    return words;
}

TEST_CASE("What happens to a FIFO on the bench shows its largest occupancy", "[bench_fifo]") {
    for (unsigned seed = 1; seed <= 2000; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        auto const below = [&random](unsigned limit) { return static_cast<unsigned>(random() % limit); };
        unsigned const capacity = 1 + below(12), count = 2 + below(60);
        StateWord const read_latency = 1 + static_cast<StateWord>(below(2));
        StateWord const issue_latency = static_cast<StateWord>(below(4));
        unsigned const room = capacity + static_cast<unsigned>(issue_latency);
        StateWord const latency = issue_latency + read_latency;
        Accesses const accesses(random, room, latency, count);
        unsigned const first_reads = below(count);
        unsigned const first_writes = std::min(count, first_reads + below(room + 1));
        unsigned const all_reads = first_reads + below(count - first_reads + 1);
        if (all_reads + room < count)
            continue;
        FifoShape shape;
        shape.capacity = capacity;
        shape.issue_latency = static_cast<Cycles>(issue_latency);
        shape.read_latency = static_cast<Cycles>(read_latency);
        BenchFifo fifo(shape);
        StateWords const words = words_of(accesses, room, latency, first_writes, first_reads);
        REQUIRE(load_fifo(fifo, 0, 0, 0, words.data()) == words.data() + words.size());
        fifo.start();
        unsigned write = first_writes;
        for (unsigned read = first_reads; read < all_reads || write < count;) {
            if (write < count && fifo.free.known() > 0 && (read == all_reads || below(2) == 0))
                fifo.writer().access(accesses.writes[write++]);
            else if (read < all_reads && fifo.readable.known() > 0)
                fifo.reader().access(accesses.reads[read++]);
        }
        std::uint64_t const largest = accesses.largest_occupancy(first_writes, first_reads, all_reads, issue_latency);
        CHECK(fifo.largest_occupancy() == std::min<std::uint64_t>(largest, capacity));
    }
}

TEST_CASE("A line keeps its cycles however many go through it", "[bench_fifo]") {
    BenchLine line(5);
    StateWord const first[] = {10, 20};
    line.load_end(3, 0, 2, 0, first);
    CHECK(line.known() == 5);
    CHECK(line[2] == BenchLine::over);
    line.consume(3);
    for (StateWord cycle = 30; cycle < 50000; cycle += 10) {
        line.start();
        line.append(cycle);
        REQUIRE(line.known() == 3);
        REQUIRE(line[0] == cycle - 20);
        REQUIRE(line[2] == cycle);
        line.consume(1);
        REQUIRE(line.consumed() == 1);
        REQUIRE(line.appended() == 1);
    }
    line.writer(100000);
    CHECK(line[1] - line[0] == 10);
    CHECK(line.count_until(line[0]) == 1);
    CHECK(line.count_until(0) == 0);
}

}  // namespace dataflow::timing::bench_fifo_test
