#include <catch2/catch.hpp>

#include "chance/pair.hpp"

namespace wait_site_test {

using namespace faster;
using namespace faster::chance;

/// The line at which the first process that is stuck waits.
std::string line_of_wait(Pair const& pair, Engine engine) {
    return testing::forked_bytes([&] {
        auto const machine = std::make_shared<Machine const>(make_machine(core_of({pair.writer, pair.reader}), {}));
        RunStatistics const run = simulate(*accelerator_of(pair, machine, 1, engine));
        std::string const source = run.stuck.empty() ? "nobody is stuck" : run.stuck.front().source;
        return source.substr(source.find(':') + 1);
    });
}

TEST_CASE("a deadlock names the line of the access that waits, however far ahead its module is") {
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    Pair pair = sound_pair();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        for (Token i = 0; i < 4; ++i) {
            clock.here({"writer.cpp", 100 + i});
            fifo.write(i);
            clock.advance(1);
        }
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>&) { clock.advance(1); };
    CHECK(line_of_wait(pair, engine) == "102");  // two tokens have room
}

TEST_CASE("an access whose line nobody says has none, whatever was said of others") {
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    Pair pair = sound_pair();
    pair.writes = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        Step const step(clock);
        fifo.write(1);
    };
    pair.reads = [](ProcessClock& clock, ClockedFifo<Token>& fifo) {
        {
            Step const step(clock);
            fifo.read();
        }
        clock.advance(1);
        fifo.read();
    };
    CHECK(line_of_wait(pair, engine) == "");
}

/// Does what a test says, with the FIFOs of its core.
class Reader final : public SampleModule {
  public:
    using Work = std::function<void(ProcessClock& clock, DataflowCore& core)>;
    Reader(char const* name, DataflowCore& core, Work work)
        : SampleModule(name, core), its_core_(core), work_(std::move(work)) {}

  private:
    void work(std::size_t /*sample*/) override { work_(clock_, its_core_); }

    DataflowCore& its_core_;
    Work work_;
};

/// A writer that is stuck before it writes what the reader waits for: tokens that its module has long told of.
class TwoWaits final : public DataflowCore {
  public:
    TwoWaits(char const* name, std::shared_ptr<Machine const> const& machine, CoreShare share,
             TimeBase const& time_base, Reader::Work const& reads)
        : DataflowCore(name, machine, share, time_base) {
        for (MachineFifo const& fifo : machine->fifos)
            make_fifo<Token>(fifo.name);
        writer_ = std::make_unique<Reader>("writer", *this, [](ProcessClock& clock, DataflowCore& core) {
            for (char const* const name : {"full", "full", "full", "one", "other"}) {
                core.fifo<Token>(name).write(1);
                clock.advance(1);
            }
        });
        reader_ = std::make_unique<Reader>("reader", *this, reads);
    }

  private:
    std::unique_ptr<Reader> writer_, reader_;
};

std::string awaited_by_reader(Engine engine, bool is_retimed, Reader::Work const& reads) {
    return testing::forked_bytes([&] {
        ModuleDescription writer("writer"), reader("reader");
        for (char const* const name : {"full", "one", "other"}) {
            writer.writes_to(name).of_bits(32);
            reader.reads_from(name).taken("both", 0);
        }
        reader.loop("both").of_depth(2);
        auto const machine = std::make_shared<Machine const>(make_machine(core_of({writer, reader}), {}));
        DataflowAccelerator accelerator(
            "accelerator", machine, 1, engine,
            [&](char const* name, std::shared_ptr<Machine const> const& of, CoreShare share,
                TimeBase const& time_base) { return std::make_unique<TwoWaits>(name, of, share, time_base, reads); });
        replay::RecordedRun recorded;
        SimulationOptions options;
        options.recorded = is_retimed ? &recorded : nullptr;
        RunStatistics run = simulate(accelerator, options);
        if (is_retimed)
            run = replay::retime(recorded, *machine);
        for (StuckProcess const& stuck : run.stuck)
            if (stuck.process == "reader")
                return stuck.fifo;
        return std::string("nobody");
    });
}

TEST_CASE("of several FIFOs that are read together the one is waited for that the module reads first") {
    Engine const engine = GENERATE(Engine::lockstep, Engine::decoupled);
    for (std::string const first : {"one", "other"}) {
        std::string const second = first == "one" ? "other" : "one";
        CAPTURE(engine == Engine::lockstep, first);
        auto const in_a_loop = [&](ProcessClock& clock, DataflowCore& core) {
            clock.pipeline("both", 1, [&](std::uint64_t) {
                core.fifo<Token>(first).read();
                core.fifo<Token>(second).read();
            });
        };
        auto const in_a_step = [&](ProcessClock& clock, DataflowCore& core) {
            Step const step(clock);
            core.fifo<Token>(first).read();
            core.fifo<Token>(second).read();
        };
        auto const with_tokens = [&](ProcessClock& clock, DataflowCore& core) {
            clock.pipeline("both", 1,
                           token_ports(std::tuple(&core.fifo<Token>(first), &core.fifo<Token>(second)), std::tuple()),
                           [](Token, Token) {});
        };
        for (Reader::Work const& reads :
             {Reader::Work(in_a_loop), Reader::Work(in_a_step), Reader::Work(with_tokens)}) {
            CHECK(awaited_by_reader(engine, false, reads) == first);
            CHECK(awaited_by_reader(engine, true, reads) == first);
        }
    }
}

}  // namespace wait_site_test
