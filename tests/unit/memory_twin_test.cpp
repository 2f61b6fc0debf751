#include "support/memory_twin.hpp"

#include <catch2/catch.hpp>
#include <iostream>

#include "support/cycle_twin.hpp"

namespace faster::testing {
namespace {

/// A loop of II 1 that takes one token per iteration as soon as it can, entered in a cycle; and a master for it.
struct Stream {
    std::size_t master = 0;
    Cycles entered = 0;
    std::size_t next = 0;
    std::vector<Cycles> taken;
};

struct Bench {
    explicit Bench(TwinMemory const& memory, double clock_mhz = 200) : model(memory, clock_mhz) {}

    Stream& add(std::size_t port, TwinRanges const& ranges, Cycles entered) {
        Stream stream;
        stream.master = model.add_master(port, false);
        stream.entered = entered;
        model.master(stream.master).add_entry(ranges);
        streams.push_back(stream);
        return streams.back();
    }

    void run(Cycles cycles) {
        for (Cycles cycle = 0; cycle < cycles; ++cycle) {
            for (Stream& stream : streams)
                run(stream, cycle);
            model.end_cycle(cycle);
        }
    }

    void run(Stream& stream, Cycles cycle) {
        TwinMasterModel& master = model.master(stream.master);
        if (cycle == stream.entered)
            master.begin_entry(0, cycle);
        if (cycle < stream.entered || stream.next == master.tokens(0))
            return;
        if (master.token_legal_from(0, stream.next) <= cycle) {
            master.take(0, stream.next++, cycle);
            stream.taken.push_back(cycle);
        }
    }

    TwinMemoryModel model;
    std::vector<Stream> streams;
};

}  // namespace
TEST_CASE("smoke") {
    Bench bench{TwinMemory{}};
    bench.add(0, mesh_ranges({}, 11), 10);
    bench.run(1000);
    for (Cycles c : bench.streams[0].taken) std::cout << c << ' ';
    std::cout << '\n';
}
}  // namespace faster::testing
