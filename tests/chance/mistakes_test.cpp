#include <catch2/catch.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "channels/clocked_fifo.hpp"
#include "channels/sample_module.hpp"
#include "channels/simulate.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/core/machine/core_of.hpp"
#include "faster/dataflow_names.hpp"
#include "support/forked_bytes.hpp"

namespace mistakes_test {

// Modules that do what they do not describe, or what cannot be timed: a line, and not a wrong figure.

using namespace faster;
using Catch::Matchers::Contains;
using Catch::Matchers::Equals;
using Token = std::uint32_t;

/// What a module does for a sample.
using Work = std::function<void(ProcessClock& clock, ClockedFifo<Token>& fifo)>;

class Worker : public SampleModule {
  public:
    Worker(sc_core::sc_module_name const& name, DataflowCore& core, Work work)
        : SampleModule(name, core), its_core_(core), work_(std::move(work)) {}

  private:
    void work(std::size_t /*sample*/) override { work_(clock_, its_core_.fifo<Token>("f")); }

    DataflowCore& its_core_;
    Work work_;
};

struct Pair {
    ModuleDescription writer{"writer"}, reader{"reader"};
    Work writes, reads;
};

class PairCore : public DataflowCore {
  public:
    PairCore(sc_core::sc_module_name const& name, std::shared_ptr<Machine const> const& machine, CoreShare share,
             TimeBase const& time_base, Pair const& pair)
        : DataflowCore(name, machine, share, time_base) {
        for (MachineFifo const& fifo : machine->fifos)
            make_fifo<Token>(fifo.name);
        workers_.push_back(std::make_unique<Worker>("writer", *this, pair.writes));
        workers_.push_back(std::make_unique<Worker>("reader", *this, pair.reads));
    }

  private:
    std::vector<std::unique_ptr<Worker>> workers_;
};

/// Ten tokens, by loops.
Pair sound_pair() {
    Pair pair;
    pair.writer.writes_to("f").of_bits(32).leaves("send", 1);
    pair.writer.loop("send").of_depth(3);
    pair.reader.reads_from("f").taken("receive", 0);
    pair.reader.loop("receive").of_depth(3);
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("send", 10, [&](std::uint64_t i) { fifo.write(static_cast<Token>(i)); });
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("receive", 10, [&](std::uint64_t) { fifo.read(); });
    };
    return pair;
}

/// What is thrown; otherwise the total, or how many are stuck.
std::string outcome_of(Pair const& pair, Engine engine) {
    return testing::forked_bytes([&]() -> std::string {
        try {
            auto const machine = std::make_shared<Machine const>(make_machine(core_of({pair.writer, pair.reader}), {}));
            DataflowAccelerator accelerator("accelerator", machine, 1, engine,
                                            [&](char const* name, std::shared_ptr<Machine const> const& of,
                                                CoreShare share, TimeBase const& time_base) {
                                                return std::make_unique<PairCore>(name, of, share, time_base, pair);
                                            });
            RunStatistics const run = simulate(accelerator);
            return run.deadlocked() ? "stuck " + std::to_string(run.stuck.size())
                                    : std::to_string(run.total_cycles) + leftover_tokens(run);
        } catch (InputError const& error) {
            return error.what();
        }
    });
}

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
    check_both(pair, "loop writer.other writes f, which its describe() does not say, expected leaves() or writes_to()");
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

TEST_CASE("non-blocking accesses and events of FIFOs are refused in one line") {
    Pair pair = sound_pair();
    pair.reads = [](ProcessClock& /*clock*/, ClockedFifo<Token>& fifo) {
        Token token = 0;
        fifo.nb_read(token);
    };
    check_both(pair,
               "accelerator.core_0.f: nb_read asks what a FIFO holds at the moment, which is not modelled, expected "
               "read() and write(), which wait");
    pair.reads = [](ProcessClock& /*clock*/, ClockedFifo<Token>& fifo) { sc_core::wait(fifo.data_written_event()); };
    CHECK_THAT(outcome_of(pair, Engine::lockstep), Contains("data_written_event"));
    pair = sound_pair();
    pair.writes = [](ProcessClock& /*clock*/, ClockedFifo<Token>& fifo) { fifo.nb_write(1); };
    CHECK_THAT(outcome_of(pair, Engine::decoupled), Contains("nb_write"));
}

TEST_CASE("tokens that nobody reads are counted") {
    Pair pair = sound_pair();
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        clock.pipeline("receive", 9, [&](std::uint64_t) { fifo.read(); });
    };
    check_both(pair, "13f of core 0 (1)");
}

}  // namespace mistakes_test
