#include "channels/ping_pong.hpp"

#include <catch2/catch.hpp>

#include "chance/pair.hpp"
#include "dataflow/run/config/calls.hpp"

namespace ping_pong_test {

using namespace faster;
using namespace faster::chance;

/// Three modules: the writer fills buffers b for the reader, and writes f for the gate, which lets the reader go.
struct Gated {
    unsigned puts = 1, takes = 1;  ///< in each call
    unsigned awaited = 1;          ///< calls of the writer that the gate waits for
    std::uint64_t buffers = 2, samples = 100;
};

class Member : public SampleModule {
  public:
    using Does = std::function<void(ProcessClock&, std::size_t sample)>;
    Member(char const* name, DataflowCore& core, Does does) : SampleModule(name, core), does_(std::move(does)) {}

  private:
    void work(std::size_t sample) override {
        does_(clock_, sample);
        clock_.advance(1);
    }

    Does does_;
};

class GatedCore : public DataflowCore {
  public:
    GatedCore(sc_core::sc_module_name const& name, std::shared_ptr<Machine const> const& machine, CoreShare share,
              TimeBase const& time_base, Gated const& gated)
        : DataflowCore(name, machine, share, time_base),
          writer_("writer", *this,
                  [this, gated](ProcessClock&, std::size_t) {
                      for (unsigned i = 0; i < gated.puts; ++i)
                          buffers_.put({1});
                      f_.write(1);
                  }),
          gate_("gate", *this,
                [this, gated](ProcessClock& clock, std::size_t sample) {
                    std::size_t const late = gated.awaited - 1;
                    std::size_t const tokens = sample == 0 ? gated.awaited : sample + late < gated.samples ? 1 : 0;
                    for (std::size_t i = 0; i < tokens; ++i) {
                        f_.read();
                        clock.advance(1);
                    }
                    if (sample == 0)
                        go_.write(1);
                }),
          reader_("reader", *this, [this, gated](ProcessClock&, std::size_t sample) {
              for (unsigned i = 0; i < gated.takes; ++i)
                  buffers_.take();
              if (sample == 0)
                  go_.read();
          }) {}

  private:
    PingPong<Token> buffers_{"b", ping_pong_timing("b")};
    ClockedFifo<Token> f_{"f", fifo_timing("f")};
    ClockedFifo<Token> go_{"go", fifo_timing("go")};
    Member writer_, gate_, reader_;
};

std::string outcome_of(Gated const& gated, Engine engine) {
    testing::FreshKernel const kernel;
    try {
        ModuleDescription writer("writer"), gate("gate"), reader("reader");
        writer.writes_to("b").of_bits(32).hands_over(16);
        writer.writes_to("f").of_bits(32).of_depth(gated.samples);
        gate.reads_from("f");
        gate.writes_to("go").of_bits(1);
        reader.reads_from("b");
        reader.reads_from("go");
        MachineSettings settings;
        settings.fifo("b").depth = gated.buffers;
        auto const machine = std::make_shared<Machine const>(
            make_machine(with_calls(core_of({writer, gate, reader}), settings), settings));
        DataflowAccelerator accelerator(
            "accelerator", machine, gated.samples, engine,
            [&](char const* name, std::shared_ptr<Machine const> const& of, CoreShare share,
                TimeBase const& time_base) { return std::make_unique<GatedCore>(name, of, share, time_base, gated); });
        RunStatistics const run = simulate(accelerator, {});
        return run.deadlocked() ? "stuck " + std::to_string(run.stuck.size()) : std::to_string(run.total_cycles);
    } catch (InputError const& error) {
        return error.what();
    }
}

TEST_CASE("a writer of ping-pong buffers is ahead of their reader by as many as there are", "[ping_pong]") {
    for (Engine const engine : {Engine::lockstep, Engine::decoupled})
        for (unsigned const awaited : {1U, 60U, 80U, 100U}) {
            CAPTURE(awaited);
            // The reader begins behind the last token that the gate waits for, and takes a cycle for each call.
            std::string const all_there = outcome_of({1, 1, awaited, 200}, engine);
            CHECK(all_there == outcome_of({1, 1, awaited, 1000}, engine));
            CHECK_FALSE(all_there.rfind("stuck", 0) == 0);
            CHECK(outcome_of({1, 1, awaited, awaited}, engine).rfind("stuck", 0) != 0);
            if (awaited > 1)
                CHECK(outcome_of({1, 1, awaited, awaited - 1}, engine).rfind("stuck", 0) == 0);
        }
}

TEST_CASE("a reader waits for a ping-pong buffer in the order of its description", "[ping_pong]") {
    ModuleDescription first("first"), second("second"), third("third");
    first.writes_to("x").of_bits(32).hands_over(16);
    second.reads_from("x");
    second.writes_to("y").of_bits(32).hands_over(16);
    third.reads_from("y");
    CoreDescription const core = with_calls(core_of({first, second, third}), {});
    std::vector<std::string> ends;
    for (FifoEnd const& end : core.modules[1].ends)
        ends.push_back(end.fifo);
    CHECK(ends == std::vector<std::string>{"x_filled", "x", "y", "y_filled"});
}

TEST_CASE("a call fills a ping-pong buffer, or empties one, once", "[ping_pong]") {
    for (Engine const engine : {Engine::lockstep, Engine::decoupled}) {
        CHECK(outcome_of({2, 1}, engine) ==
              "module writer fills the ping-pong buffer b twice in a call, expected put() once");
        CHECK(outcome_of({0, 1}, engine) ==
              "module writer ends a call without filling the ping-pong buffer b, expected put() once");
        CHECK(outcome_of({1, 2}, engine) ==
              "module reader empties the ping-pong buffer b twice in a call, expected take() once");
        CHECK(outcome_of({1, 0}, engine) ==
              "module reader ends a call without emptying the ping-pong buffer b, expected take() once");
    }
}

}  // namespace ping_pong_test
