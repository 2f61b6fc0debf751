#include "dataflow/phrases/phrase_cutter.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <vector>

#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/lookup/cut_trial.hpp"
#include "dataflow/lookup/transition_store.hpp"
#include "faster/dataflow_names.hpp"
#include "support/spelled_out.hpp"

namespace dataflow::timing::phrase_cutter_test {

/// A driver that writes fragments and edge tokens, and a reader of each.
enum Process : unsigned { driver, drawer, builder };
constexpr std::uint8_t fragment = 1, edge = 2;  // ports of the driver
constexpr std::uint8_t read = 1;                // of a reader

std::unique_ptr<CoreTiming> scanner() {
    auto core = std::make_unique<CoreTiming>();
    FifoTiming& fragments = core->add_fifo({"fragment"});
    FifoTiming& edges = core->add_fifo({"edge"});
    for (char const* name : {"driver", "drawer", "builder"})
        core->add_process(name);
    core->process(driver).add_writes(fragments);
    core->process(driver).add_writes(edges);
    core->process(drawer).add_reads(fragments);
    core->process(builder).add_reads(edges);
    for (Process const process : {driver, drawer, builder})
        core->process(process).add_loop({});
    return core;
}

Lead lead() { return {driver, {{drawer, 0}, {builder, 1}}}; }

/// Triangles of a few lines, each with two edge tokens, and what the readers answer to them.
void log_triangles(CoreTiming& core, std::mt19937& random) {
    auto const below = [&random](unsigned limit) { return static_cast<unsigned>(random() % limit); };
    OperationLog& scan = core.process(driver).log();
    for (int triangle = 0; triangle < 20; ++triangle) {
        scan.wait(3);
        scan.step(fragment, 1 + below(3));
        core.process(drawer).log().step(read, below(2));
        core.process(drawer).log().wait(1);
        scan.enter(0);
        core.process(drawer).log().enter(0);
        for (unsigned line = 1 + below(3); line > 0; --line) {
            unsigned const inside = 2 + below(6);
            unsigned const silent = below(9);
            scan.iterate(0, 0, below(3));
            if (below(2) == 0) {
                scan.iterate_flanked(fragment | edge, inside, edge, silent);
                core.process(builder).log().iterate(read, 0, inside + 2);
            } else {
                scan.iterate_with_tail(fragment | edge, inside, edge, silent);
                core.process(builder).log().iterate(read, 0, inside + 1);
            }
            core.process(drawer).log().iterate(read, below(2), inside);
        }
        scan.leave();
        core.process(drawer).log().leave();
    }
}

/// A core of which triangles are logged, and its group.
struct Scan {
    explicit Scan(unsigned seed) {
        std::mt19937 random(seed);
        log_triangles(*core, random);
    }

    std::unique_ptr<CoreTiming> core = scanner();
    Group group{*core, lead()};
};

/// By process, and at the end what each goes on with.
std::vector<std::vector<Operation::Code>> said_by(PhraseBook const& book, std::vector<PhraseBook::Number> numbers) {
    auto const core = scanner();
    Group const group(*core, lead());
    std::vector<Operation::Code> next_ports(3);
    for (PhraseBook::Number const number : numbers)
        Phrase::write(book.codes(number), book[number].size, group,
                      [&](unsigned member, Ports::Number ports, bool) { next_ports[member] = ports; });
    std::vector<std::vector<Operation::Code>> said;
    for (Process const process : {driver, drawer, builder})
        said.push_back(faster::testing::spelled_out(core->process(process).log()));
    said.push_back(next_ports);
    return said;
}

Transition transition_of(Cycles cycles, std::uint32_t entered, std::uint64_t iterations) {
    Transition transition;
    transition.cycles = cycles;
    transition.entered = entered;
    transition.iterations[1] = iterations;
    return transition;
}

TEST_CASE("The pieces of a phrase say what the phrase says", "[phrases]") {
    std::size_t cut = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        Scan const scan(seed);
        PhraseCutter cutter(*scan.core, lead());
        PhraseBook book;
        std::set<PhraseBook::Number> phrases, pieces;
        for (Phrase phrase; phrase.read(scan.group, 0, Phrase::most_in_run) == Phrase::Reading::complete;
             phrase.consume()) {
            PhraseBook::Number const number = book.number_of(phrase, scan.group);
            if (!phrases.insert(number).second)
                continue;
            cutter.cut(book, number);
            std::vector<PhraseBook::Number> const own(book.pieces(number), book.pieces(number) + book[number].pieces);
            if (own.empty())
                continue;
            CHECK(said_by(book, own) == said_by(book, {number}));
            pieces.insert(own.begin(), own.end());
            ++cut;
        }
        CHECK(pieces.size() < phrases.size());  // that is what they are good for
    }
    CHECK(cut > 1000);
}

/// All that is in the logs, in phrases of a book.
std::vector<PhraseBook::Number> read_all(Scan const& scan, unsigned most_that_iterate, PhraseBook& book) {
    std::vector<PhraseBook::Number> numbers;
    for (Phrase phrase; phrase.read(scan.group, 0, most_that_iterate) == Phrase::Reading::complete; phrase.consume())
        numbers.push_back(book.number_of(phrase, scan.group));
    return numbers;
}

TEST_CASE(
    "Short phrases say what long ones say, and end with the first operation of the driver that iterates with accesses",
    "[phrases]") {
    std::size_t more = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        PhraseBook long_ones, short_ones;
        auto const of_run = read_all(Scan(seed), Phrase::most_in_run, long_ones);
        auto const of_recording = read_all(Scan(seed), Phrase::most_in_recording, short_ones);
        CHECK(said_by(short_ones, of_recording) == said_by(long_ones, of_run));
        CHECK(of_recording.size() >= of_run.size());
        more += of_recording.size() - of_run.size();
        for (PhraseBook::Number number = 0; number < short_ones.size(); ++number) {
            bool iterated = false, goes_on = false;
            Phrase::each(
                short_ones.codes(number), short_ones[number].size,
                [&](unsigned member, Operation const& operation) {
                    goes_on = goes_on || (member == 0 && iterated);
                    iterated = iterated || (member == 0 && operation.iterations() > 0 && operation.ports() != 0);
                },
                [](unsigned, Ports::Number, bool) {});
            CHECK_FALSE(goes_on);
        }
    }
    CHECK(more > 20);
}

TEST_CASE("Phrases are cut as long as their pieces are known", "[phrases]") {
    CutTrial trial;
    auto const cut = [&trial](unsigned phrases, unsigned new_pieces_each) {
        unsigned done = 0;
        for (unsigned i = 0; i < phrases; ++i)
            if (trial.decide()) {
                ++done;
                for (unsigned k = 0; k < new_pieces_each; ++k)
                    trial.worked_out_piece();
            }
        return done;
    };
    CHECK(cut(1000, 1) == 1000);
    CHECK(cut(300, 3) < 120);  // given up within a trial, for four of them
    CHECK(cut(CutTrial::most_patience * CutTrial::length, 0) > 0);
    CHECK(cut(1000, 0) == 1000);
}

TEST_CASE("A sequence of transitions is the sum of its pieces", "[phrases]") {
    TransitionStore store;
    std::vector<TransitionStore::Number> const pieces{
        store.add(transition_of(10, 0, 4)), store.add(transition_of(5, 0b10, 3)), store.add(transition_of(7, 0, 2))};
    REQUIRE(store.accepts_sequence(pieces));
    TransitionStore::Number const sequence = store.add_sequence(pieces);
    CHECK(store.brief(sequence).cycles() == 22);
    CHECK(store.brief(sequence).entered() == 0b10);
    CHECK(store.tally(sequence).iterations[1] == 5);  // of the loop that the second entered
    CHECK(store.is_sequence(sequence));
    CHECK_FALSE(store.is_sequence(pieces.front()));
    CHECK(std::vector<TransitionStore::Number>(store.pieces(sequence).begin(), store.pieces(sequence).end()) == pieces);

    TransitionStore::Number const long_one = store.add(transition_of(0xFFFFFFFF, 0, 0));
    CHECK_FALSE(store.accepts_sequence({long_one, pieces.front()}));
    TransitionStore::Number const busy_one = store.add(transition_of(1, 0, 0xFFFF));
    CHECK_FALSE(store.accepts_sequence({busy_one, pieces.front()}));
}

TEST_CASE("Phrases of equal prints are told from each other by their codes", "[phrases]") {
    // The first code is what a print begins with: then the second does not show in it.
    std::vector<Phrase::Code> const codes[] = {{0x9E3779B97F4A7C15U, 1}, {0x9E3779B97F4A7C15U, 2}};
    auto const core = scanner();
    Group const group(*core, lead());
    std::vector<Phrase> phrases(2);
    for (std::size_t i = 0; i < 2; ++i)
        phrases[i].assign(codes[i].data(), 2, 1);
    REQUIRE(phrases[0].print(1).first == phrases[1].print(1).first);
    REQUIRE(phrases[0].print(1).second == phrases[1].print(1).second);

    PhraseBook book, other, all;
    CHECK(book.number_of(phrases[0], group) == 0);
    CHECK_FALSE(book.find(phrases[1]).has_value());
    CHECK(book.number_of(phrases[1], group) == 1);
    CHECK(book.find(phrases[1]) == PhraseBook::Number{1});
    CHECK(other.number_of(phrases[1], group) == 0);
    CHECK(all.number_of(book, 0) == 0);
    CHECK(all.number_of(other, 0) == 1);
}

TEST_CASE("A phrase of very many pieces is left whole", "[phrases]") {
    for (unsigned const inside : {40U, 200U}) {
        auto const core = scanner();
        Group const group(*core, lead());
        core->process(driver).log().enter(0);
        core->process(drawer).log().enter(0);
        core->process(driver).log().iterate(fragment, 0, inside);
        core->process(driver).log().iterate(0, 0, 3);
        core->process(driver).log().leave();
        core->process(drawer).log().iterate(read, 0, inside + 1);
        PhraseCutter cutter(*core, lead());
        PhraseBook book;
        Phrase phrase;
        REQUIRE(phrase.read(group, 0, Phrase::most_in_run) == Phrase::Reading::complete);
        PhraseBook::Number const number = book.number_of(phrase, group);
        cutter.cut(book, number);
        CHECK((book[number].pieces > 0) == (inside < PhraseCutter::most_pieces));
    }
}

TEST_CASE("All that is known of a phrase follows from its codes", "[phrases]") {
    std::size_t phrases = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        Scan const scan(seed);
        auto const bench = scanner();
        Group const bench_group(*bench, lead());
        for (Phrase phrase; phrase.read(scan.group, 0, Phrase::most_in_recording) == Phrase::Reading::complete;
             phrase.consume(), ++phrases) {
            Phrase recalled;
            recalled.recall(phrase.codes(), phrase.size(), scan.group);
            CHECK(recalled.due() == phrase.due());
            CHECK(recalled.active() == phrase.active());
            CHECK(Phrase::is_readable(phrase.codes(), phrase.size(), bench_group));
        }
    }
    CHECK(phrases > 1000);
}

/// The columns of docs/formats.md, "A sample's content": who changes them changes the page, and the version of event
/// files.
TEST_CASE("The bits of a code are those that the page of the formats states") {
    Operation operation(Operation::Kind::iterate, 5, 7, 11);
    operation.add_tail(3, 2);
    CHECK(operation.code() == ((Operation::Code{3} << 61U) | (Operation::Code{5} << 50U) | (Operation::Code{3} << 39U) |
                               (Operation::Code{7} << 29U) | (Operation::Code{2} << 19U) | 11U));
    CHECK(Operation::mix(5, 6, 0x2AU).code() ==
          ((Operation::Code{6} << 61U) | (Operation::Code{5} << 50U) | (Operation::Code{6} << 44U) | 0x2AU));
}

}  // namespace dataflow::timing::phrase_cutter_test
