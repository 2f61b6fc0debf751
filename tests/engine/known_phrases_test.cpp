#include "retiming/known_phrases.hpp"

#include <catch2/catch.hpp>
#include <memory>
#include <vector>

#include "timing/core_timing.hpp"

namespace faster::retiming {
namespace {

using timing::Operation;
using timing::Phrase;
using Kind = Operation::Kind;
using Codes = std::vector<Phrase::Code>;

/// A driver that writes what a follower reads; both have a loop.
struct Pair {
    Pair() {
        timing::FifoTiming& fifo = core->add_fifo({"fragment"});
        core->add_process("driver").add_writes(fifo);
        core->add_process("follower").add_reads(fifo);
        core->process(0).add_loop({});
        core->process(1).add_loop({});
        group = std::make_unique<timing::Group>(*core, timing::Lead{0, {{1, 0}}});
        checks = {OperationCheck(core->processes()[0]), OperationCheck(core->processes()[1])};
        known = std::make_unique<KnownPhrases>(*group);
    }

    bool knows(Codes const& codes) { return known->number_of(codes.data(), codes.size()).has_value(); }
    /// Whether phrases can be done in that order, from outside loops.
    bool can_do(std::vector<Codes> const& phrases) {
        PhraseCheck check(*group, checks);
        for (Codes const& codes : phrases)
            if (!check.accepts((*known)[known->number_of(codes.data(), codes.size()).value()]))
                return false;
        check.move_on(checks);
        return true;
    }

    std::unique_ptr<timing::CoreTiming> core = std::make_unique<timing::CoreTiming>();
    std::unique_ptr<timing::Group> group;
    std::vector<OperationCheck> checks;
    std::unique_ptr<KnownPhrases> known;
};

Phrase::Code operation(Kind kind, std::uint8_t ports = 0, std::uint32_t gap = 0, std::uint32_t count = 0) {
    return Operation(kind, ports, gap, count).code();
}

Phrase::Code const enter = operation(Kind::enter), leave = operation(Kind::leave);
Phrase::Code const iterate = operation(Kind::iterate, 1, 0, 3), step = operation(Kind::step, 1);
Phrase::Code const begin_setup = operation(Kind::wait, 0, Operation::setup_begin, 1);
Phrase::Code const await_setup = operation(Kind::wait, 0, Operation::setup_end, 1);
constexpr Phrase::Code follower = (Phrase::Code{6} << 61) | (Phrase::Code{1} << 39) | (Phrase::Code{1} << 16);

}  // namespace

TEST_CASE("A phrase that no group could do is not known", "[events]") {
    Pair pair;
    CHECK(pair.knows({enter, iterate, leave, follower, step}));
    CHECK_FALSE(pair.knows({}));
    CHECK_FALSE(pair.knows(Codes(100, iterate)));
    CHECK_FALSE(pair.knows({follower, step}));                     // without the driver
    CHECK_FALSE(pair.knows({operation(Kind::iterate, 2, 0, 3)}));  // it has one port
    CHECK_FALSE(pair.knows({operation(Kind::iterate, 1, 0, 1U << 24)}));
    CHECK_FALSE(pair.knows({operation(Kind::enter, 0, 0, 1)}));  // it has one loop
    CHECK_FALSE(pair.knows({operation(Kind::stamp)}));
    CHECK_FALSE(pair.knows({operation(Kind::step, 1, 2)}));  // a gap outside loops
    CHECK_FALSE(pair.knows({leave, leave}));
    CHECK_FALSE(pair.knows({enter, step}));
    CHECK_FALSE(pair.knows({step, follower + (1U << 16), step}));  // one member too many
    CHECK_FALSE(pair.knows({step, follower | (Phrase::Code{1} << 30), step}));
    CHECK_FALSE(pair.knows({step, follower, begin_setup}));
}

TEST_CASE("A known phrase has one number", "[events]") {
    Pair pair;
    Codes const one{step}, other{step, follower, step};
    auto const number = pair.known->number_of(one.data(), one.size());
    CHECK(pair.known->number_of(other.data(), other.size()) != number);
    CHECK(pair.known->number_of(one.data(), one.size()) == number);
    CHECK(pair.known->book().size() == 2);
}

TEST_CASE("A phrase begins where the ones before it left the processes", "[events]") {
    Pair pair;
    CHECK(pair.can_do({{enter}, {iterate}, {iterate, leave}, {step}}));
    CHECK_FALSE(pair.can_do({{iterate}}));
    CHECK_FALSE(pair.can_do({{enter}, {enter}}));
    CHECK_FALSE(pair.can_do({{enter}, {step}}));
    CHECK(pair.can_do({{step, follower, enter}, {step}, {step, follower, iterate}}));
    CHECK(pair.checks[1].in_loop);
    CHECK_FALSE(pair.can_do({{step, follower, enter}}));
    CHECK(pair.can_do({{step, follower, leave}}));
}

TEST_CASE("A phrase awaits setups that were begun", "[events]") {
    Pair pair;
    CHECK_FALSE(pair.can_do({{enter}, {await_setup}}));
    CHECK_FALSE(pair.can_do({{enter}, {await_setup, begin_setup}}));
    CHECK(pair.can_do({{enter}, {begin_setup, begin_setup}, {await_setup}}));
    CHECK(pair.checks[0].setups == 1);
    CHECK(pair.can_do({{await_setup, leave}}));
    CHECK(pair.checks[0].is_done());
}

}  // namespace faster::retiming
