#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "chance/pair.hpp"

namespace mistakes_test {

// Modules that do what they do not describe, or what cannot be timed: a line, and not a wrong figure.

using namespace faster;
using namespace faster::chance;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::Equals;
using Catch::Matchers::StartsWith;

void check_both(Pair const& pair, std::string const& expected) {
    CHECK_THAT(outcome_of(pair, Engine::lockstep), Equals(expected));
    CHECK_THAT(outcome_of(pair, Engine::decoupled), Equals(expected));
}

TEST_CASE("a sound pair of modules takes its time") { check_both(sound_pair(), "14"); }

TEST_CASE("a loop that a module runs and does not describe is told by name") {
    Pair pair = sound_pair();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& /*fifo*/) {
        clock.pipeline("sent", 10, [](std::uint64_t) {});
    };
    check_both(pair,
               "module writer runs a loop sent, which it does not describe, expected loop(\"sent\") in its describe(), "
               "did you mean send?");
}

TEST_CASE("a port that is bound to a FIFO which its module does not describe is told") {
    Pair pair = sound_pair();
    pair.bound_to = "f";
    check_both(pair, "14");
    pair.writer.writes_to("g").of_bits(1);
    pair.writer.reads_from("g");
    pair.bound_to = "g";
    check_both(pair,
               "module reader has a port bound to the FIFO g, which its describe() does not name, expected it bound to "
               "one that it names");
}

TEST_CASE("a mistake is told even if another module goes on asking for ever") {
    Pair pair = sound_pair();
    pair.reader.ends.front().non_blocking();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& /*fifo*/) {
        clock.pipeline("sent", 1, [](std::uint64_t) {});
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        for (Token token = 0; !fifo.read_nb(token);)
            clock.advance(1);
    };
    check_both(pair,
               "module writer runs a loop sent, which it does not describe, expected loop(\"sent\") in its describe(), "
               "did you mean send?");
}

TEST_CASE("a mistake behind a deadlock is not come to, in either engine") {
    Pair pair = sound_pair();
    auto const sends = pair.writes;
    pair.writes = [sends](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        sends(clock, fifo);
        clock.pipeline("sent", 1, [](std::uint64_t) {});
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>&) { clock.advance(1); };
    check_both(pair, "stuck 1");
}

TEST_CASE("what a module throws is told with its name and sample") {
    Pair pair = sound_pair();
    pair.writes = [](ProcessClock&, ClockedFifo<Token>&) { static_cast<void>(std::vector<int>().at(1)); };
    for (Engine const engine : {Engine::lockstep, Engine::decoupled})
        CHECK_THAT(outcome_of(pair, engine), StartsWith("module writer has thrown \"vector::_M_range_check") &&
                                                 EndsWith("\" in sample 0, expected work() to return"));
    pair.writes = [](ProcessClock&, ClockedFifo<Token>&) { throw 7; };
    check_both(pair, "module writer has thrown what is no std::exception in sample 0, expected work() to return");
    pair.writes = [](ProcessClock&, ClockedFifo<Token>&) { sc_core::sc_stop(); };
    check_both(pair, "a module has called sc_stop(), expected a run to end when all have done their samples");
}

TEST_CASE("a core has a result for each sample, unless it is stuck") {
    Pair pair = sound_pair();
    for (std::size_t const results : {0U, 2U}) {
        pair.results = results;
        check_both(pair, "accelerator.core_0 has " + std::to_string(results) +
                             " results of 1 samples, expected one add_result() for each");
    }
    pair.writes = [](ProcessClock&, ClockedFifo<Token>&) {};
    check_both(pair, "stuck 1");
}

TEST_CASE("a core makes all modules that are described, and a channel for each FIFO") {
    Pair pair = sound_pair();
    pair.has_reader = false;
    check_both(pair,
               "module reader is described, but the core has no such module, expected it made in the core's "
               "constructor");
    pair = sound_pair();
    pair.has_channels = false;
    check_both(pair,
               "the FIFO f of module writer has no channel, expected a ClockedFifo made with its fifo_timing() in the "
               "core");
}

TEST_CASE("an end of a FIFO that is another module's is refused in the name of who uses it") {
    std::string const writer_reads =
        "module writer reads f, which its describe() does not say, expected reads_from(\"f\")";
    auto const refused_in_loop = [&](std::function<void(ClockedFifo<Token>&)> const& access) {
        for (std::uint64_t const first : {0U, 3U}) {  // later, the reader waits in an iteration that may read
            CAPTURE(first);
            Pair pair = sound_pair();
            pair.writes = [&](ProcessClock& clock, ClockedFifo<Token>& fifo) {
                clock.pipeline("send", 10, [&](std::uint64_t i) {
                    fifo.write(1);
                    if (i >= first)
                        access(fifo);
                });
            };
            check_both(pair, writer_reads);
        }
    };
    refused_in_loop([](ClockedFifo<Token>& fifo) { fifo.read(); });
    refused_in_loop([](ClockedFifo<Token>& fifo) {
        Token token = 0;
        fifo.read_nb(token);
    });
    refused_in_loop([](ClockedFifo<Token>& fifo) { static_cast<void>(fifo.empty()); });
    Pair pair = sound_pair();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("send", 10, token_ports(std::tuple(&fifo), std::tuple(&fifo)), [](Token, Token&) {});
    };
    check_both(pair, writer_reads);
    pair = sound_pair();
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.advance(1);
        fifo.write(1);
    };
    check_both(pair, "module reader writes f, which its describe() does not say, expected writes_to(\"f\")");
}

TEST_CASE("of two modules that make mistakes, that is told which is described first, whichever comes first in time") {
    auto const waits_and_throws = [](Cycles cycles) {
        return [cycles](ProcessClock& clock, ClockedFifo<Token>&) {
            clock.advance(cycles);
            throw 7;
        };
    };
    for (Cycles const cycles : {1U, 10U}) {
        Pair pair = sound_pair();
        pair.writes = waits_and_throws(cycles);
        pair.reads = waits_and_throws(5);
        check_both(pair, "module writer has thrown what is no std::exception in sample 0, expected work() to return");
    }
}

TEST_CASE("a module without a port to the memory is told that it has none, whether or not there is a memory") {
    std::string const refused =
        "module writer accesses the memory, to which it has no port, expected fetches() or stores() in its describe()";
    Pair pair = sound_pair();
    auto const sends = pair.writes;
    pair.writes = [sends](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.tell_ranges({{64, 5, 4}});
        sends(clock, fifo);
    };
    check_both(pair, refused);
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("send", 10, [&](std::uint64_t) {
            fifo.write(1);
            clock.access_memory();
        });
    };
    check_both(pair, refused);
    pair.writer.stores("output").given_by("send");
    check_both(pair, "14");
}

TEST_CASE("a FIFO that an iteration accesses twice, or that its loop does not name, is told") {
    Pair pair = sound_pair();
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("receive", 5, [&](std::uint64_t) {
            fifo.read();
            fifo.read();
        });
    };
    check_both(pair, "module reader reads f twice in a step or an iteration of a loop, expected once");
    pair = sound_pair();
    pair.writer.loop("other").of_depth(2);
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("other", 10, [&](std::uint64_t) { fifo.write(1); });
    };
    std::string const unnamed =
        "loop writer.other writes f, which its describe() does not say, expected leaves() or writes_to()";
    check_both(pair, unnamed);
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("other", 10, token_ports(std::tuple(), std::tuple(&fifo)), [](Token& token) { token = 1; });
    };
    check_both(pair, unnamed);
    pair = sound_pair();
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("receive", 10, token_ports(std::tuple(&fifo, &fifo), std::tuple()), [](Token, Token) {});
    };
    check_both(pair, "module reader reads f twice in a step or an iteration of a loop, expected once");
}

TEST_CASE("no time passes inside of a step or an iteration, and no loop begins there") {
    auto const refused = [](std::string const& what, std::function<void(ProcessClock&)> const& inside) {
        std::string const expected =
            "module writer " + what + " inside of a step or an iteration of a loop, expected it before or behind that";
        Pair pair = sound_pair();
        pair.writer.loop("inner").of_depth(2);
        pair.writes = [&](ProcessClock& clock, ClockedFifo<Token>& fifo) {
            clock.pipeline("send", 10, [&](std::uint64_t i) {
                fifo.write(static_cast<Token>(i));
                inside(clock);
            });
        };
        check_both(pair, expected);
        pair.writes = [&](ProcessClock& clock, ClockedFifo<Token>& fifo) {
            clock.pipeline("send", 10, token_ports(std::tuple(), std::tuple(&fifo)), [&](Token&) { inside(clock); });
        };
        check_both(pair, expected);
        pair.writes = [&](ProcessClock& clock, ClockedFifo<Token>& fifo) {
            Step const step(clock);
            fifo.write(1);
            inside(clock);
        };
        check_both(pair, expected);
    };
    refused("lets time pass", [](ProcessClock& clock) { clock.advance(1); });
    refused("notes its time", [](ProcessClock& clock) { clock.stamp(); });
    refused("begins a step", [](ProcessClock& clock) { Step const step(clock); });
    refused("begins a loop", [](ProcessClock& clock) { clock.pipeline("inner", 3, [](std::uint64_t) {}); });
    refused("begins a loop", [](ProcessClock& clock) { clock.pipeline("inner", 3); });
    refused("begins a loop",
            [](ProcessClock& clock) { clock.pipeline_while("inner", [](std::uint64_t) { return false; }); });
}

TEST_CASE("a loop of no number, and a wait without end, are told") {
    Pair pair = sound_pair();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>&) { clock.enter_loop(99); };
    check_both(pair, "module writer begins its loop number 99, expected one of its 1, as clock_.loop(NAME) tells it");
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>&) { clock.advance(Cycles{0} - 1); };
    check_both(pair, "module writer lets 18446744073709551615 cycles pass, expected up to 1099511627776");
}

TEST_CASE("iterations and setups are told inside of a loop only, and a loop is left once") {
    auto const refused = [](std::string const& what, std::function<void(ProcessClock&)> const& outside) {
        Pair pair = sound_pair();
        pair.writes = [&](ProcessClock& clock, ClockedFifo<Token>& fifo) {
            clock.enter_loop(clock.loop("send"));
            clock.leave_loop();
            outside(clock);
            fifo.write(1);
        };
        check_both(pair, "module writer " + what + " outside of any loop, expected enter_loop() before it");
    };
    refused("leaves a loop", [](ProcessClock& clock) { clock.leave_loop(); });
    refused("does an iteration", [](ProcessClock& clock) { clock.iterate(timing::no_ports, 3); });
    refused("does an iteration", [](ProcessClock& clock) { clock.iterate_mixed(timing::no_ports, 3, 1); });
    refused("begins a setup", [](ProcessClock& clock) { clock.begin_setup(); });
    refused("awaits a setup", [](ProcessClock& clock) { clock.await_setup(); });

    Pair pair = sound_pair();
    pair.writer.loop("inner").of_depth(2);
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>&) {
        clock.enter_loop(clock.loop("send"));
        clock.enter_loop(clock.loop("inner"));
    };
    check_both(pair,
               "module writer begins a loop inside of a step or an iteration of a loop, expected it before or "
               "behind that");
}

TEST_CASE("a body that is called with tokens accesses nothing itself, whatever the loop") {
    auto const refused = [](std::string const& what) {
        return "module writer accesses " + what +
               " in a body that is called with tokens, expected it among tokens_of(), or a body that accesses all its "
               "ports itself";
    };
    Pair pair = sound_pair();
    pair.writer.writes_to("g").of_bits(1).leaves("send", 0);
    pair.reader.reads_from("g");
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("send", 10, token_ports(std::tuple(), std::tuple(&fifo)), [&](Token&) { fifo.write(1); });
    };
    check_both(pair, refused("f"));
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("send", 10, token_ports(std::tuple(), std::tuple(&fifo)),
                       [&](Token&) { clock.access_memory(); });
    };
    check_both(pair, refused("memory"));
    pair = sound_pair();
    pair.writer.reads_from("g").taken("send", 1);  // not read first of all: by plain accesses in both engines
    pair.reader.writes_to("g").of_bits(1);
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("send", 10, token_ports(std::tuple(), std::tuple(&fifo)),
                       [&](Token&) { clock.access_memory(); });
    };
    check_both(pair, refused("memory"));
}

TEST_CASE("a token that a loop reads behind other accesses is for take_later") {
    Pair pair = sound_pair();
    pair.reader.writes_to("g").of_bits(1).leaves("receive", 0);
    pair.reader.ends.front().read_stage = 2;
    pair.writer.reads_from("g").taken("send", 0);
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("receive", 10, [&](std::uint64_t) { fifo.read(); });
    };
    pair.writes = [](ProcessClock& /*clock*/, ClockedFifo<Token>& /*fifo*/) {};
    check_both(
        pair,
        "loop reader.receive reads f in stage 2, behind other accesses of an iteration (stage 0), but its module "
        "reads it first of all, expected accelerator.fifos.f.read_stage of at most 0, or take_later() in the "
        "module");
}

TEST_CASE("what is done with a token of a later stage takes no step of its own") {
    Pair pair = sound_pair();
    pair.reader.ends.front().read_stage = 2;
    using Use = std::function<void(ProcessClock & clock, ClockedFifo<Token> & fifo)>;
    auto const used = [&pair](Use const& use) {
        pair.reads = [use](ProcessClock& clock, ClockedFifo<Token>& fifo) {
            clock.pipeline("receive", 10,
                           [&](std::uint64_t) { clock.take_later(fifo, [&](Token) { use(clock, fifo); }); });
        };
        return pair;
    };
    std::string const refused =
        "module reader accesses f in what is done later in an iteration, expected clock_.access() of its port in the "
        "body, and no more than put() later";
    check_both(used([](auto&, auto& fifo) { fifo.read(); }), refused);
    check_both(used([](auto& clock, auto& fifo) { clock.take_later(fifo, [](Token) {}); }), refused);
    check_both(used([](auto& clock, auto&) { clock.advance(1); }),
               "module reader lets time pass inside of a step or an iteration of a loop, expected it before or behind "
               "that");
}

TEST_CASE("a loop of another module's clock is refused") {
    Pair pair = sound_pair();
    ProcessClock* other = nullptr;
    pair.writes = [&other, sends = pair.writes](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        other = &clock;
        sends(clock, fifo);
    };
    pair.reads = [&other, receives = pair.reads](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        receives(clock, fifo);
        clock.advance(20);  // the writer is done
        other->pipeline("send", 1, [](std::uint64_t) {});
    };
    check_both(pair,
               "a loop of module writer is begun outside of its thread, expected each module to use its own clock_");
}

TEST_CASE("what-if refuses a stage of a read as a run does, which the module's own code could not have") {
    Pair pair = sound_pair();
    pair.reader.writes_to("g").of_bits(1).leaves("receive", 1);
    pair.writer.reads_from("g").taken("send", 0);
    for (bool const takes_later : {false, true}) {
        pair.reads = [takes_later](ProcessClock& clock, ClockedFifo<Token>& fifo) {
            clock.pipeline("receive", 10, [&](std::uint64_t) {
                takes_later ? clock.take_later(fifo, [](Token) {}) : static_cast<void>(fifo.read());
            });
        };
        for (Engine const engine : {Engine::lockstep, Engine::decoupled})
            for (Cycles const stage : {0U, 1U, 2U}) {
                CAPTURE(takes_later, stage);
                MachineSettings changed;
                changed.fifo("f").read_stage = stage;
                std::string const run = outcome_of(pair, engine, changed);
                CHECK(outcome_of(pair, engine, {}, &changed) == run);
                CHECK((run.find("reads it first of all") != std::string::npos) == (stage == 2 && !takes_later));
            }
    }
}

TEST_CASE("how many tokens a FIFO holds, and events of FIFOs, are refused in one line") {
    Pair pair = sound_pair();
    pair.reads = [](ProcessClock& /*clock*/, ClockedFifo<Token>& fifo) { static_cast<void>(fifo.num_available()); };
    check_both(pair,
               "accelerator.core_0.f: num_available asks what a FIFO holds at the moment, which is not modelled, "
               "expected read_nb(), write_nb(), empty() or full()");
    pair.reads = [](ProcessClock& /*clock*/, ClockedFifo<Token>& fifo) { sc_core::wait(fifo.data_written_event()); };
    CHECK_THAT(outcome_of(pair, Engine::lockstep), Contains("data_written_event"));
    pair = sound_pair();
    pair.writes = [](ProcessClock& /*clock*/, ClockedFifo<Token>& fifo) { static_cast<void>(fifo.num_free()); };
    CHECK_THAT(outcome_of(pair, Engine::decoupled), Contains("num_free"));
}

TEST_CASE("a non-blocking access where it is not expected is told") {
    Pair pair = sound_pair();
    auto const tries = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("send", 10, [&](std::uint64_t i) { fifo.write_nb(static_cast<Token>(i)); });
    };
    pair.writes = tries;
    check_both(pair,
               "module writer writes f without waiting, which its describe() does not say, expected "
               "writes_to(\"f\").non_blocking()");
    pair.writer.ends.front().non_blocking().loop = "";
    check_both(pair,
               "module writer writes f without waiting in the loop send, which does not name that FIFO, expected "
               "leaves() or writes_to()");
    pair = sound_pair();
    pair.writer.ends.front().non_blocking();
    pair.writer.reads_from("g").taken("send", 0);
    pair.reader.writes_to("g").of_bits(1).leaves("receive", 0);
    pair.writes = tries;
    check_both(pair,
               "module writer accesses f without waiting in a stage in which the next iteration has begun to "
               "access FIFOs, expected a stage less than 1 behind the first that accesses any, or "
               "try_read_later() and try_write_later()");
}

TEST_CASE("tokens that nobody reads are counted") {
    Pair pair = sound_pair();
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("receive", 9, [&](std::uint64_t) { fifo.read(); });
    };
    check_both(pair, "13f of core 0 (1)");
}

/// Each of them told by a call.
using Told = std::vector<std::vector<ProcessClock::Range>>;

/// The reader takes a token of memory in each of five iterations, as far as it tells of it and does so.
Pair pair_at_memory(Told const& told, std::uint64_t taken) {
    Pair pair = sound_pair();
    pair.reader.fetches("input").taken_by("receive");
    pair.reads = [=](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        for (std::vector<ProcessClock::Range> const& ranges : told)
            clock.tell_ranges(ranges);
        clock.pipeline("receive", 10, [&](std::uint64_t i) {
            fifo.read();
            if (i < taken)
                clock.access_memory();
        });
    };
    return pair;
}
Pair pair_at_memory(std::uint64_t told, std::uint64_t taken) { return pair_at_memory(Told{{{64, told, 4}}}, taken); }

TEST_CASE("ranges that a module tells of before a loop are one entry, in however many calls") {
    MachineSettings settings;
    settings.external_memory.model = MemoryModel::axi;
    auto const total = [&](Told const& told, Engine engine) {
        return outcome_of(pair_at_memory(told, 5), engine, settings);
    };
    for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
        std::string const at_once = total({{{64, 2, 4}, {4096, 3, 4}}}, engine);
        CHECK(at_once.find_first_not_of("0123456789") == std::string::npos);
        CHECK(total({{{64, 2, 4}}, {{4096, 3, 4}}}, engine) == at_once);
    }
}

TEST_CASE("a module takes from memory what it has told of, where its description says so") {
    MachineSettings settings;
    settings.external_memory.model = MemoryModel::axi;
    for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
        auto const outcome = [&](Pair const& pair) { return outcome_of(pair, engine, settings); };
        CHECK(outcome(pair_at_memory(5, 5)) == "61");  // the first in cycle 49, the last in 58
        CHECK_THAT(
            outcome(pair_at_memory(6, 5)),
            Equals("module reader has told of 6 tokens of the memory for input, and accesses 5, expected all of them"));
        CHECK_THAT(outcome(pair_at_memory(4, 5)), Contains("more often than it has told of tokens, which are 4"));
        Pair other = pair_at_memory(5, 5);
        other.reader.loop("other");
        other.reader.streams.front().taken_by("other");
        CHECK_THAT(outcome(other),
                   Equals("module reader accesses the memory for input in the loop receive, expected it in "
                          "the loop other"));
        Pair step = pair_at_memory(1, 1);
        step.reader.streams.front().taken_by("");
        step.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
            clock.tell_ranges({{64, 1, 4}});
            Step const both(clock);
            clock.access_memory();
            fifo.read();
        };
        CHECK_THAT(outcome(step), Equals("module reader takes input from the memory in a step that reads f, expected a "
                                         "step for each"));
    }
}

}  // namespace mistakes_test
