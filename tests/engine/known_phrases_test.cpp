#include "dataflow/run/replay/known_phrases.hpp"

#include <catch2/catch.hpp>
#include <memory>
#include <vector>

#include "dataflow/core/time/core_timing.hpp"
#include "faster/dataflow_names.hpp"

namespace dataflow::replay::known_phrases_test {

using timing::Operation;
using timing::Phrase;
using Kind = Operation::Kind;
using Codes = std::vector<Phrase::Code>;

/// A driver that writes what a follower reads, which also reads something from outside the group; both have a loop. If
/// asked for, the driver's writes and reads, beside which it may prepare.
LeadCore pair(bool prepares) {
    timing::CoreTiming core;
    timing::FifoTiming& fragments = core.add_fifo({"fragment"});
    timing::FifoTiming& observed = core.add_fifo({"observed"});
    core.add_process("driver").add_writes(fragments);
    core.add_process("follower").add_reads(fragments);
    core.process(1).add_reads(observed);
    core.add_process("reader").add_writes(observed);
    timing::LoopShape shape;
    if (prepares) {
        shape.reads = {{0}};
        shape.writes = {{0}};
    }
    core.process(0).add_loop(shape);
    core.process(1).add_loop({});
    return {core, timing::Lead{0, {{1, 0}}}};
}

struct Pair {
    explicit Pair(bool prepares = false) : known(pair(prepares)) {
        for (timing::ProcessTiming const& process : known.lead().core->processes())
            checks.emplace_back(process);
    }

    bool knows(Codes const& codes) { return known.number_of(codes.data(), codes.size()).has_value(); }
    /// Whether phrases can be done in that order, from where the processes are.
    bool can_do(std::vector<Codes> const& phrases) {
        PhraseCheck check(known.lead().group, checks);
        for (Codes const& codes : phrases)
            if (!check.accepts(known[known.number_of(codes.data(), codes.size()).value()]))
                return false;
        check.move_on(checks);
        return true;
    }

    KnownPhrases known;
    std::vector<OperationCheck> checks;
};

Phrase::Code operation(Kind kind, std::uint8_t ports = 0, std::uint32_t gap = 0, std::uint32_t count = 0) {
    return Operation(kind, ports, gap, count).code();
}

Phrase::Code const enter = operation(Kind::enter), leave = operation(Kind::leave);
Phrase::Code const silence = operation(Kind::iterate, 0, 0, 3), wait = operation(Kind::wait, 0, 0, 2);
Phrase::Code const iterate = operation(Kind::iterate, 1, 0, 3), step = operation(Kind::step, 1);
Phrase::Code const begin_setup = operation(Kind::wait, 0, Operation::setup_begin, 1);
Phrase::Code const await_setup = operation(Kind::wait, 0, Operation::setup_end, 1);

/// Of what a member does next, and the ports of the step after that.
Phrase::Code mark(unsigned member, std::uint8_t next_ports, bool frozen = false) {
    return (Phrase::Code{6} << 61) | (Phrase::Code{1} << 38) | (Phrase::Code{member} << 16) |
           (Phrase::Code{next_ports} << 8) | (frozen ? 1U : 0U);
}
/// `length` iterations of a member, of which there are more.
Phrase::Code part(unsigned member, std::uint8_t ports, unsigned length) {
    return Operation::mix(ports, length, 0).code() | (Phrase::Code{16 + member} << 39);
}

TEST_CASE("A phrase that no group could have written is not known", "[events]") {
    Pair pair;
    CHECK(pair.knows({wait, step, mark(1, 1), step}));
    CHECK(pair.knows({wait, step, mark(1, 1), enter, iterate - 2}));
    CHECK(pair.knows({silence, iterate, part(1, 1, 3)}));
    CHECK(pair.knows({enter, silence, leave}));
    CHECK_FALSE(pair.knows({}));
    CHECK_FALSE(pair.knows(Codes(100, iterate)));
    CHECK_FALSE(pair.knows(Codes(Phrase::longest, wait)));
    CHECK_FALSE(pair.knows({mark(1, 1), step}));                                     // without the driver
    CHECK_FALSE(pair.knows({operation(Kind::iterate, 2, 0, 3)}));                    // it has one port
    CHECK_FALSE(pair.knows({operation(Kind::enter, 0, 0, 1)}));                      // and one loop
    CHECK_FALSE(pair.knows({wait, operation(Kind::step, 1, 2), mark(1, 1), step}));  // a gap outside loops
    CHECK_FALSE(pair.knows({operation(Kind::stamp)}));
    CHECK_FALSE(pair.knows({leave, leave}));
    CHECK_FALSE(pair.knows({enter, wait}));
    CHECK_FALSE(pair.knows({silence, Operation::mix(1, 3, 0).code(), part(1, 1, 3)}));  // the driver mixes nothing
}

TEST_CASE("A phrase whose answers are not those that are asked for is not known", "[events]") {
    Pair pair;
    CHECK_FALSE(pair.knows({wait, step}));
    CHECK_FALSE(pair.knows({wait, step, mark(1, 1), step, step}));
    CHECK_FALSE(pair.knows({silence, iterate, part(1, 1, 2)}));
    CHECK_FALSE(pair.knows({wait, mark(1, 1), step}));
    CHECK_FALSE(pair.knows({wait, step, mark(2, 1), step}));        // one member too many
    CHECK_FALSE(pair.knows({wait, step, mark(1, 2), step}));        // goes on outside the group
    CHECK_FALSE(pair.knows({wait, step, mark(1, 0x80), step}));     // with a port that it does not have
    CHECK_FALSE(pair.knows({wait, step, mark(1, 1, true), step}));  // readers do not drop out
    CHECK_FALSE(pair.knows({silence, iterate, part(1, 2, 3)}));
    CHECK_FALSE(pair.knows({silence, iterate, part(1, 3, 3)}));
    CHECK_FALSE(pair.knows({wait, step, mark(1, 1) | (Phrase::Code{1} << 30), step}));
}

TEST_CASE("A phrase accesses no more than can be counted", "[events]") {
    Pair pair;
    auto const asks = [](Kind kind, std::uint32_t count) {
        Operation operation(kind, 1, 0, count);
        operation.add_tail(1, 1);
        return operation.code();
    };
    auto const answer = [](std::uint32_t count) { return operation(Kind::iterate, 1, 1, count); };
    CHECK(pair.knows({asks(Kind::iterate, 1000), mark(1, 1), answer(1001)}));
    CHECK(pair.knows({asks(Kind::flanked, 1000), mark(1, 1), answer(1002)}));
    CHECK_FALSE(pair.knows({asks(Kind::iterate, 100000), mark(1, 1), answer(100001)}));
    CHECK_FALSE(pair.knows({asks(Kind::flanked, 100000), mark(1, 1), answer(100002)}));
    CHECK_FALSE(pair.knows({asks(Kind::flanked, Operation::longest_count), mark(1, 1), answer(1)}));
}

TEST_CASE("A known phrase has one number", "[events]") {
    Pair pair;
    Codes const one{wait}, other{wait, step, mark(1, 1), step};
    auto const number = pair.known.number_of(one.data(), one.size());
    CHECK(pair.known.number_of(other.data(), other.size()) != number);
    CHECK(pair.known.number_of(one.data(), one.size()) == number);
    CHECK(pair.known.book().size() == 2);
}

TEST_CASE("A book with many phrases finds them all", "[events]") {
    Pair pair;
    for (std::uint32_t i = 1; i < 5000; ++i) {
        Codes const codes{operation(Kind::wait, 0, 0, i)};
        CHECK(pair.known.number_of(codes.data(), codes.size()) == i - 1);
    }
    Codes const early{operation(Kind::wait, 0, 0, 7)};
    CHECK(pair.known.number_of(early.data(), early.size()) == 6);
}

TEST_CASE("A phrase begins where the ones before it left the processes", "[events]") {
    Pair pair;
    CHECK(pair.can_do({{enter}, {silence}, {silence, leave}, {wait}}));
    CHECK_FALSE(pair.can_do({{silence}}));
    CHECK_FALSE(pair.can_do({{enter}, {enter}}));
    CHECK_FALSE(pair.can_do({{enter}, {wait}}));
    Codes const enters{wait, step, mark(1, 1), enter, operation(Kind::iterate, 1, 0, 1)};
    Codes const leaves{wait, step, mark(1, 1), operation(Kind::iterate, 1, 0, 1), leave};
    CHECK(pair.can_do({enters, {wait}}));
    CHECK(pair.checks[1].state().in_loop);
    CHECK_FALSE(pair.can_do({enters}));
    CHECK(pair.can_do({leaves}));
    CHECK_FALSE(pair.checks[1].state().in_loop);
}

TEST_CASE("A phrase awaits setups that were begun", "[events]") {
    Pair pair(true);
    CHECK_FALSE(pair.can_do({{enter}, {await_setup}}));
    CHECK_FALSE(pair.can_do({{enter}, {await_setup, begin_setup}}));
    CHECK(pair.can_do({{enter}, {begin_setup, begin_setup}, {await_setup}}));
    CHECK(pair.checks[0].state().setups == 1);
    CHECK(pair.can_do({{await_setup, leave}}));
    CHECK(pair.checks[0].is_done());
    CHECK_FALSE(Pair(false).knows({begin_setup}));  // none of its loops does that
}

}  // namespace dataflow::replay::known_phrases_test
