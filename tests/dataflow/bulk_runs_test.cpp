#include "dataflow/core/time/bulk_runs.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <random>
#include <vector>

#include "dataflow/core/time/core_timing.hpp"

namespace dataflow::timing::bulk_runs_test {

// Many iterations at a time against one after the other, as ProcessRules has them, on random operations.

class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    unsigned between(unsigned least, unsigned most) {
        return least + static_cast<unsigned>(random_() % (most - least + 1));
    }
    bool chance(unsigned percent) { return random_() % 100 < percent; }

  private:
    std::mt19937 random_;
};

/// Who observes a process makes it go step by step.
struct Watch : StepObserver {
    void entered_loop(ProcessTiming const& /*process*/, unsigned /*loop*/, Cycles /*cycle*/) override {}
    void left_loop(ProcessTiming const& /*process*/, Cycles /*cycle*/) override {}
    void iterated(ProcessTiming const& /*process*/, Cycles /*cycle*/, std::uint64_t /*first*/, std::uint64_t /*count*/,
                  Cycles /*stride*/) override {}
    void stalled(ProcessTiming const& /*process*/, unsigned /*port*/, Cycles /*from*/, Cycles /*until*/) override {}
    void accessed(ProcessTiming const& /*process*/, Ports /*ports*/, Cycles /*cycle*/) override { ++accesses; }
    void let_out(ProcessTiming const& /*process*/, unsigned /*port*/, Cycles /*due*/, Cycles /*cycle*/) override {}
    void stamped(ProcessTiming const& /*process*/, Cycles /*cycle*/) override {}
    std::uint64_t accesses = 0;
};

enum Process : unsigned { source, middle, sink };
enum Fifo : unsigned { long_way, short_way, last_way };
// Ports. The source writes the long way and the short one, and takes from memory; the middle passes on what comes the
// long way; the sink reads what comes from the middle, and from the source.
constexpr Ports::Number to_middle = 1, to_sink = 2, from_memory = 4;
constexpr Ports::Number from_source = 1, passed_on = 2;
constexpr Ports::Number from_middle = 1, directly = 2;
// Loops.
constexpr unsigned writing = 0, loading = 1;
constexpr unsigned dropping = 0, passing = 1;

LoopShape loop_of(Dice& dice, Cycles depth) {
    LoopShape loop;
    loop.depth = depth;
    loop.interval.achieved = dice.between(1, 3);
    return loop;
}

class Chain {
  public:
    explicit Chain(unsigned seed) {
        Dice dice(seed);
        for (char const* const name : {"long", "short", "last"}) {
            FifoShape shape;
            shape.name = name;
            shape.capacity = dice.between(2, dice.chance(30) ? 90 : 5);
            shape.read_latency = dice.between(1, 2);
            core.add_fifo(shape);
        }
        ProcessTiming& first = core.add_process("source");
        first.add_writes(core.fifo(long_way));
        first.add_writes(core.fifo(short_way));
        first.add_stream(core.add_stream("memory", MemoryStream::EntersBy::loop));
        Cycles const late = dice.between(0, 4);
        LoopShape loop = loop_of(dice, 6);
        loop.writes = {{0, late}, {1, late}};
        first.add_loop(loop);
        loop = loop_of(dice, 6);
        loop.uses_stream = true;
        loop.writes = {{0, dice.chance(50) ? 0 : late}};
        loop.reads = {{2, 0}};
        first.add_loop(loop);

        ProcessTiming& second = core.add_process("middle");
        second.add_reads(core.fifo(long_way));
        second.add_writes(core.fifo(last_way));
        second.add_loop(loop_of(dice, 3));
        loop = loop_of(dice, 7);
        loop.reads = {{0, 0}};
        loop.writes = {{1, dice.between(0, 5)}};
        second.add_loop(loop);

        ProcessTiming& third = core.add_process("sink");
        third.add_reads(core.fifo(last_way));
        third.add_reads(core.fifo(short_way));
        third.add_loop(loop_of(dice, 2));
    }

    OperationLog& log(Process process) { return core.process(process).log(); }

    /// A loop in each of them, and what is between loops.
    void log_some(Dice& dice) {
        log(source).wait(dice.between(0, 9));
        log(source).step(to_middle, dice.between(0, 3));
        log(middle).step(from_source, dice.between(0, 3));
        dice.chance(40) ? load(dice) : write(dice);
    }

    std::vector<std::uint64_t> figures() const {
        std::vector<std::uint64_t> figures;
        for (ProcessTiming const& process : core.processes()) {
            figures.insert(figures.end(),
                           {process.local_time(), process.full_stall_cycles(), process.empty_stall_cycles(),
                            process.memory_stall_cycles(), process.all_iterations(), process.finished() ? 1U : 0U});
            for (unsigned loop = 0; loop < process.loops().size(); ++loop)
                figures.insert(figures.end(),
                               {process.loop_counters(loop).entries, process.loop_counters(loop).iterations});
        }
        for (FifoTiming const& fifo : core.fifos()) {
            figures.insert(figures.end(), {fifo.writes(), fifo.reads(), fifo.max_occupancy(), fifo.full_stall_cycles(),
                                           fifo.empty_stall_cycles()});
            for (std::uint64_t i = 0; i < fifo.known_reads(); ++i)
                figures.push_back(fifo.earliest_read(i));
        }
        return figures;
    }

    CoreTiming core;

  private:
    /// Pieces with the same accesses, and gaps of their own.
    static void iterate(OperationLog& log, Ports::Number ports, unsigned count, Dice& dice) {
        while (count > 0) {
            unsigned const piece = std::min(count, dice.chance(20) ? 200 : dice.between(1, 20));
            if (dice.chance(30) && piece <= Operation::longest_mix)
                log.iterate_mixed(ports, piece, Operation::gap_bits(1, piece) & dice.between(0, 1U << 20U));
            else
                log.iterate(ports, dice.chance(40) ? dice.between(1, 3) : 0, piece);
            if (dice.chance(10))
                log.iterate(0, 0, dice.between(1, 5));
            count -= piece;
        }
    }

    void write(Dice& dice) {
        bool const passes = dice.chance(50);
        unsigned whole = 0, tails = 0;
        log(source).enter(writing);
        log(sink).enter(0);
        for (unsigned lines = dice.between(1, 6); lines > 0; --lines) {
            unsigned const inside = dice.between(1, 30);
            unsigned const behind = dice.between(0, 9);
            bool const is_line = dice.chance(60);
            whole += inside;
            tails += is_line ? 1U : 0U;
            write_line(log(source), to_middle | to_sink, to_sink, inside, behind, is_line, dice);
            if (passes)
                write_line(log(sink), from_middle | directly, directly, inside, dice.between(0, 9), is_line, dice);
        }
        if (!passes)
            iterate(log(sink), directly, whole + tails, dice);
        log(source).leave();
        log(sink).leave();
        take(whole, passes, dice);
    }
    static void write_line(OperationLog& log, Ports::Number ports, Ports::Number tail, unsigned inside, unsigned behind,
                           bool is_line, Dice& dice) {
        if (is_line)
            log.iterate_with_tail(ports, inside, tail, behind);
        else
            iterate(log, ports, inside, dice);
    }

    void load(Dice& dice) {
        unsigned const tokens = dice.between(1, 150);
        log(source).enter(loading);
        log(source).iterate(to_middle | from_memory, 0, tokens);
        log(source).leave();
        for (unsigned left = tokens; left > 0;) {
            unsigned const burst = std::min(left, dice.between(1, 40));
            brought_ += dice.between(0, 60);
            core.stream(0).deliver(burst, brought_);
            left -= burst;
        }
        take(tokens, false, dice);
    }

    /// By the middle.
    void take(unsigned tokens, bool passes, Dice& dice) {
        log(middle).enter(passes ? passing : dropping);
        iterate(log(middle), passes ? from_source | passed_on : from_source, tokens, dice);
        log(middle).leave();
    }

    Cycles brought_ = 0;
};

TEST_CASE("Many iterations at a time come to what one after the other comes to", "[timing]") {
    std::uint64_t accesses = 0, loads = 0;
    for (unsigned seed = 1; seed <= 150; ++seed) {
        CAPTURE(seed);
        Chain bulk(seed), stepped(seed);
        Watch watch;
        for (Process const process : {source, middle, sink})
            stepped.core.process(process).set_observer(&watch);
        for (Chain* const chain : {&bulk, &stepped}) {
            Dice dice(1000 + seed);
            for (unsigned part = 0; part < 12; ++part) {
                chain->log_some(dice);
                if (dice.chance(50))
                    chain->core.resolve(false);
            }
            chain->core.resolve();
        }
        CHECK(bulk.figures() == stepped.figures());
        accesses += watch.accesses;
        loads += bulk.core.process(source).loop_counters(loading).iterations;
    }
    CHECK(accesses > 100000);  // hardly any of them is stuck
    CHECK(loads > 10000);
}

}  // namespace dataflow::timing::bulk_runs_test
