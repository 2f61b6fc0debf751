#include "dataflow/lookup/automaton.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "dataflow/lookup/followed_core.hpp"
#include "faster/dataflow_names.hpp"

namespace dataflow::timing::automaton_test {

/// Draws small numbers; the same with every compiler.
class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    unsigned below(unsigned limit) { return static_cast<unsigned>(random_() % limit); }
    unsigned between(unsigned low, unsigned high) { return low + below(high - low + 1); }
    bool chance(unsigned percent) { return below(100) < percent; }

  private:
    std::mt19937 random_;
};

enum Fifo : unsigned { vertex, area, area_reciprocal, command, fragment, edge, result };
enum Process : unsigned { source, driver, divider, builder, drawer, collector };

/// A core in the manner of the machine's: a source of vertices, a driver that scans, a divider, a builder that takes
/// one or two iterations per edge token, a drawer that reads commands one ahead, and a collector.
struct Machine {
    FollowedCore core;

    Machine(unsigned seed, bool irregular) {
        Dice dice(seed);
        std::vector<Cycles> latencies(7, 0);
        latencies[vertex] = dice.below(5);
        for (unsigned const written : {command, fragment, edge})
            latencies[written] = irregular ? dice.below(7) : 3;
        for (unsigned fifo = 0; fifo < 7; ++fifo) {
            FifoShape shape;
            shape.name = std::to_string(fifo);
            shape.capacity = dice.between(2, dice.chance(20) ? 40 : 4);
            if (irregular && (fifo == command || fifo == fragment))
                shape.capacity += 8;  // or read ahead and written behind, it would lock
            shape.read_latency = dice.between(1, 2);
            shape.write_latency = latencies[fifo];
            if (fifo == area_reciprocal)
                (dice.chance(30) ? shape.issue_latency : shape.flushing_stages) = dice.below(12);
            core.add_fifo(shape);
        }
        for (char const* name : {"source", "driver", "divider", "builder", "drawer", "collector"})
            core.add_process(name);
        core.process(source).add_writes(core.fifo(vertex));
        core.process(driver).add_reads(core.fifo(vertex));
        for (unsigned const written : {area, command, fragment, edge})
            core.process(driver).add_writes(core.fifo(written));
        core.process(divider).add_reads(core.fifo(area));
        core.process(divider).add_writes(core.fifo(area_reciprocal));
        core.process(builder).add_reads(core.fifo(edge));
        for (unsigned const read : {area_reciprocal, fragment, command})
            core.process(drawer).add_reads(core.fifo(read));
        core.process(drawer).add_writes(core.fifo(result));
        core.process(collector).add_reads(core.fifo(result));
        core.process(source).add_loop(loop(dice, 8, {{0, latencies[vertex]}}));
        core.process(driver).add_loop(
            loop(dice, 8, {{2, latencies[command]}, {3, latencies[fragment]}, {4, latencies[edge]}}));
        core.process(builder).add_loop(loop(dice, 4, {}));
        core.process(drawer).add_loop(loop(dice, 9, {}));
    }

    /// The drawer writes to as many sinks at the end of a sample.
    void add_sinks(unsigned count) {
        for (unsigned i = 0; i < count; ++i) {
            FifoTiming& fifo = core.add_fifo({"sink"});
            core.process(drawer).add_writes(fifo);
            core.add_process("sink").add_reads(fifo);
        }
    }

    static LoopShape loop(Dice& dice, Cycles depth, std::vector<LoopAccess> writes) {
        LoopShape shape;
        shape.interval.achieved = shape.interval.target = dice.chance(70) ? 1 : dice.between(2, 3);
        shape.depth = depth;
        shape.writes = std::move(writes);
        return shape;
    }

    static Lead lead() { return {driver, {{source, vertex}, {divider, area}, {builder, edge}, {drawer, command}}}; }
};

void begin_sample(CoreTiming& core, Dice& dice) {
    core.process(driver).log().stamp();
    core.process(driver).log().wait(1);
    core.process(builder).log().wait(dice.between(1, 400));
    core.process(builder).log().step(1, 1);  // the first token
    core.process(builder).log().enter(0);
    core.process(drawer).log().wait(dice.between(1, 400));
    core.process(drawer).log().step(0b100, 1);  // the first command
}

/// With few shapes of lines, as in a real scan.
void log_triangles(CoreTiming& core, Dice& dice, unsigned triangles, bool varied, unsigned pauses = 0) {
    auto const log = [&core](Process process) -> OperationLog& { return core.process(process).log(); };
    constexpr std::uint8_t fragment_ports = 0b11100;
    constexpr std::uint8_t edge_port = 0b10000;
    log(source).enter(0);
    log(source).iterate(1, 0, 3 * triangles);
    log(source).leave();
    std::vector<unsigned> gaps;  // of the builder, by token
    for (unsigned triangle = 0; triangle < triangles; ++triangle) {
        for (int corner = 0; corner < 3; ++corner)
            log(driver).step(1, 1);
        log(driver).wait(5);
        bool const drawn = dice.chance(60);
        log(driver).step(drawn ? 0b110 : 0b10, 1);
        log(divider).step(1, 0);
        if (drawn)
            log(divider).step(2, 0);
        log(divider).wait(1);
        if (!drawn)
            continue;
        unsigned fragments = 0;
        log(driver).enter(0);
        for (unsigned left = dice.chance(10) ? pauses : 0; left > 0; --left)
            log(driver).append(
                Operation(Operation::Kind::iterate, 0, Operation::longest_gap, Operation::longest_count));
        for (unsigned line = dice.between(1, 3); line > 0; --line) {
            log(driver).iterate(0, 0, dice.below(2));
            unsigned const inside = varied || dice.chance(5) ? dice.below(60) : 2 * dice.below(2);
            bool const leaves = inside > 0 && dice.chance(80);
            bool const flanked = leaves && inside > 1 && dice.chance(50);
            unsigned const silent = dice.below(varied ? 60 : 2);
            if (flanked) {
                log(driver).iterate_flanked(fragment_ports, inside, edge_port, silent);
            } else {
                log(driver).iterate(fragment_ports, 0, inside);
                log(driver).iterate(edge_port, 0, leaves ? 1 : 0);
                log(driver).iterate(0, 0, silent);
            }
            gaps.insert(gaps.end(), inside, dice.chance(95) ? 1 : 0);
            if (flanked)
                gaps.insert(gaps.end() - inside + 1, 0);
            if (leaves)
                gaps.push_back(0);
            fragments += inside;
        }
        log(driver).leave();
        log(drawer).step(0b101, 1);
        if (fragments == 0) {
            log(drawer).wait(1);
            continue;
        }
        log(drawer).enter(0);
        log(drawer).iterate(0b110, 0, fragments);
        log(drawer).leave();
    }
    for (unsigned const gap : gaps)
        log(builder).iterate(1, gap, 1);
}

void end_sample(CoreTiming& core, Dice& dice) {
    core.process(driver).log().wait(1);
    core.process(driver).log().step(0b10100, 1);  // the end, for drawer and builder
    core.process(builder).log().leave();
    core.process(builder).log().wait(dice.between(1, 300));
    core.process(drawer).log().wait(dice.between(1, 500));
    core.process(drawer).log().step(0b1000, 1);
    core.process(collector).log().step(1, 0);
    core.process(collector).log().stamp();
    core.process(collector).log().wait(1);
}

/// What all processes of a machine do in some samples.
void log_samples(CoreTiming& core, unsigned seed, unsigned samples, bool varied) {
    Dice dice(seed);
    for (unsigned sample = 0; sample < samples; ++sample) {
        begin_sample(core, dice);
        log_triangles(core, dice, dice.between(1, 100), varied);
        end_sample(core, dice);
    }
}

std::vector<std::uint64_t> figures_of(CoreTiming& core) {
    std::vector<std::uint64_t> figures;
    for (ProcessTiming const& process : core.processes()) {
        figures.insert(figures.end(), {process.local_time(), process.empty_stall_cycles(), process.full_stall_cycles(),
                                       process.idle_before_cycles(), process.finished() ? 1U : 0U});
        figures.insert(figures.end(), process.stamps().begin(), process.stamps().end());
        for (unsigned loop = 0; loop < process.loops().size(); ++loop)
            figures.insert(figures.end(),
                           {process.loop_counters(loop).entries, process.loop_counters(loop).iterations});
    }
    for (FifoTiming const& fifo : core.fifos())
        figures.insert(figures.end(), {fifo.writes(), fifo.reads(), fifo.full_stall_cycles(), fifo.empty_stall_cycles(),
                                       fifo.max_occupancy()});
    for (BlockedProcess const& wait : core.blocked())
        figures.insert(figures.end(),
                       {wait.since, wait.occupancy, std::hash<std::string>{}(wait.position + wait.fifo)});
    return figures;
}

/// With and without an automaton, which it returns; logs come in portions, as from a run.
std::shared_ptr<Automaton> compare(unsigned seed, bool irregular, unsigned portions, bool varied = false) {
    auto automaton = std::make_shared<Automaton>();
    Machine followed(seed, irregular);
    Machine plain(seed, irregular);
    followed.core.let_follow(Machine::lead(), automaton);
    for (unsigned portion = 0; portion < portions; ++portion)
        for (Machine* const machine : {&followed, &plain}) {
            log_samples(machine->core, 1000 * seed + portion, 4, varied);
            machine->core.resolve(false);
        }
    followed.core.resolve();
    plain.core.resolve();
    CHECK(figures_of(followed.core) == figures_of(plain.core));
    return automaton;
}

TEST_CASE("The automaton gives every figure that working out every operation gives", "[automaton]") {
    std::uint64_t phrases = 0;
    std::uint64_t transitions = 0;
    for (unsigned seed = 1; seed <= 150; ++seed) {
        CAPTURE(seed);
        auto const automaton = compare(seed, false, 3);
        CHECK_FALSE(automaton->gave_up());
        phrases += automaton->phrases();
        transitions += automaton->transitions();
    }
    CHECK(phrases > transitions + transitions / 3);  // or hardly anything was ever looked up
}

TEST_CASE("The automaton follows loops whose tokens leave in different stages", "[automaton]") {
    for (unsigned seed = 500; seed <= 600; ++seed) {
        CAPTURE(seed);
        compare(seed, true, 2);
    }
}

TEST_CASE("How often the loops were iterated that a core is in is known whenever it is asked", "[automaton]") {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        auto automaton = std::make_shared<Automaton>();
        bool const irregular = seed % 2 == 1;
        Machine followed(seed, irregular);
        Machine plain(seed, irregular);
        followed.core.let_follow(Machine::lead(), automaton);
        for (Machine* const machine : {&followed, &plain}) {
            Dice dice(seed);
            log_samples(machine->core, seed, 2, false);
            begin_sample(machine->core, dice);
            for (unsigned part = 0; part < 6; ++part) {
                // So far ahead that its states are not worth remembering; regular drivers are not followed then.
                machine->core.process(builder).log().iterate(0, 0, irregular ? 5000 : 0);
                log_triangles(machine->core, dice, 20, part % 2 == 1);
                machine->core.resolve(false);
            }
            machine->core.process(builder).log().iterate(1, 0, 1);  // a token that never comes
            machine->core.resolve();
        }
        CHECK(figures_of(followed.core) == figures_of(plain.core));
        CHECK(followed.core.process(builder).iterations() == plain.core.process(builder).iterations());
        CHECK(followed.core.process(builder).iterations() > 100);
    }
}

TEST_CASE("Times too far apart for a state are none of the automaton's business", "[automaton]") {
    constexpr unsigned pauses = 5;
    constexpr std::int64_t longest = std::int64_t{pauses} * Operation::longest_count * (Operation::longest_gap + 1);
    static_assert(longest > furthest_apart && longest > std::numeric_limits<StateWord>::max(), "or it is not");
    for (unsigned seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        auto automaton = std::make_shared<Automaton>();
        Machine followed(seed, false);
        Machine plain(seed, false);
        followed.core.let_follow(Machine::lead(), automaton);
        for (Machine* const machine : {&followed, &plain}) {
            Dice dice(seed);
            for (unsigned sample = 0; sample < 3; ++sample) {
                begin_sample(machine->core, dice);
                log_triangles(machine->core, dice, 60, false, pauses);
                end_sample(machine->core, dice);
            }
            machine->core.resolve();
        }
        CHECK(figures_of(followed.core) == figures_of(plain.core));
        CHECK(followed.core.process(driver).local_time() > static_cast<Cycles>(furthest_apart));
        CHECK(automaton->phrases() > 0);
    }
}

TEST_CASE("An automaton that hardly ever finds what it looks for is given up, and nothing is lost", "[automaton]") {
    CHECK_FALSE(compare(77, false, 50, true)->gave_up());  // at first, much is new anyway
    CHECK(compare(77, false, 500, true)->gave_up());
}

TEST_CASE("A process with ports that no mask has is followed where it does not access them", "[automaton][ports]") {
    constexpr unsigned sinks = 30;
    std::vector<unsigned> written;
    for (unsigned port = 4; port < 4 + sinks; ++port)
        written.push_back(port);
    for (unsigned seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        auto automaton = std::make_shared<Automaton>();
        Machine followed(seed, seed % 2 == 1);
        Machine plain(seed, seed % 2 == 1);
        followed.core.let_follow(Machine::lead(), automaton);
        for (Machine* const machine : {&followed, &plain}) {
            machine->add_sinks(sinks);
            Dice dice(seed);
            for (unsigned sample = 0; sample < 4; ++sample) {
                begin_sample(machine->core, dice);
                log_triangles(machine->core, dice, 40, false);
                end_sample(machine->core, dice);
                machine->core.process(drawer).log().step(Ports::of(written).number(), 2);
                for (unsigned sink = 0; sink < sinks; ++sink)
                    machine->core.process(collector + 1 + sink).log().step(1, 3 + sink);
                machine->core.resolve(false);
            }
            machine->core.resolve();
        }
        CHECK(figures_of(followed.core) == figures_of(plain.core));
        CHECK(automaton->phrases() > 0);
        CHECK(followed.core.process(drawer).finished());
    }
}

TEST_CASE("An unlimited FIFO beside a group that is followed keeps what its writer is ahead", "[automaton]") {
    constexpr unsigned tokens = 3000, late = collector + 1, ahead_port = 4, go_port = 5;
    auto automaton = std::make_shared<Automaton>();
    Machine followed(1, false);
    Machine plain(1, false);
    followed.core.let_follow(Machine::lead(), automaton);
    for (Machine* const machine : {&followed, &plain}) {
        CoreTiming& core = machine->core;
        FifoTiming& ahead = core.add_fifo({"ahead", FifoShape::unlimited});
        FifoTiming& go = core.add_fifo({"go"});
        core.process(drawer).add_writes(ahead);
        core.process(drawer).add_writes(go);
        core.add_process("late").add_reads(ahead);
        core.process(late).add_reads(go);
        Dice dice(1);
        begin_sample(core, dice);
        log_triangles(core, dice, 40, false);
        end_sample(core, dice);
        for (unsigned i = 0; i < tokens; ++i)
            core.process(drawer).log().step(Ports::of(ahead_port).number(), 1);
        core.process(drawer).log().step(Ports::of(go_port).number(), 1);
        core.process(late).log().step(0b10, 1);
        for (unsigned i = 0; i < tokens; ++i)
            core.process(late).log().step(0b1, 1);
        core.resolve();
    }
    CHECK(figures_of(followed.core) == figures_of(plain.core));
    CHECK(automaton->phrases() > 0);
    CHECK(followed.core.process(late).finished());
}

TEST_CASE("A lead of more followers than an automaton takes is worked out without", "[automaton]") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        CAPTURE(seed);
        auto automaton = std::make_shared<Automaton>();
        Machine followed(seed, false);
        Machine plain(seed, false);
        Lead lead = Machine::lead();
        lead.followers.push_back({collector, result});
        followed.core.let_follow(lead, automaton);
        for (Machine* const machine : {&followed, &plain}) {
            log_samples(machine->core, seed, 2, false);
            machine->core.resolve();
        }
        CHECK(figures_of(followed.core) == figures_of(plain.core));
        CHECK(automaton->phrases() == 0);
    }
}

TEST_CASE("Joined operations mean what they were joined of", "[operation]") {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        Dice dice(seed);
        OperationLog log;
        std::vector<unsigned> expected;  // ports of every iteration
        for (int i = 0; i < 60; ++i) {
            auto const ports = static_cast<std::uint8_t>(dice.below(3));
            unsigned const gap = dice.chance(50) ? 0 : dice.below(3);
            unsigned const count = dice.below(dice.chance(10) ? 60 : 4);
            if (ports != 0 && count > 1 && dice.chance(20)) {
                log.iterate_flanked(ports, count, 4, gap);
                expected.insert(expected.end(), {ports, 4});
                expected.insert(expected.end(), count - 1, ports);
                expected.push_back(4);
                expected.insert(expected.end(), gap, 0);
                continue;
            }
            log.iterate(ports, gap, count);
            for (unsigned k = 0; k < count; ++k) {
                expected.push_back(ports);
                expected.insert(expected.end(), gap, 0);
            }
        }
        CHECK(log.pending() < 60);
        std::vector<unsigned> found;
        while (!log.exhausted()) {
            Operation const operation = log.front();
            REQUIRE(operation.kind() == Operation::Kind::iterate);
            for (unsigned k = 0; k < operation.count(); ++k) {
                found.push_back(operation.ports());
                found.insert(found.end(), operation.gap(), 0);
            }
            if (operation.tail_ports() != 0)
                log.consume(0, operation.count());
            else
                log.consume();
        }
        CHECK(found == expected);
    }
}

}  // namespace dataflow::timing::automaton_test
