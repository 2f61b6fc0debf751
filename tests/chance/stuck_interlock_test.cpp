#include <catch2/catch.hpp>

#include "chance/pair.hpp"
#include "dataflow/base/write_distances.hpp"

namespace stuck_interlock_test {

using namespace faster;
using namespace faster::chance;

class Writer : public SampleModule {
  public:
    Writer(char const* name, DataflowCore& core) : SampleModule(name, core), its_core_(core) {}

  private:
    /// The second token of g is behind a write that waits for ever.
    void work(std::size_t /*sample*/) override {
        for (char const* fifo : {"f", "g", "f", "h", "h", "h", "g"}) {
            its_core_.fifo<Token>(fifo).write(1);
            clock_.advance(1);
        }
    }

    DataflowCore& its_core_;
};

/// Its second iteration accesses the word that the first one writes.
class Reader : public SampleModule {
  public:
    Reader(char const* name, DataflowCore& core) : SampleModule(name, core), its_core_(core) {}

  private:
    void start_of_simulation() override { distances_ = clock_.write_distances("receive", "m"); }
    void work(std::size_t /*sample*/) override {
        clock_.pipeline("receive", 2, [this](std::uint64_t) {
            distances_->next_iteration();
            distances_->write(0);
            its_core_.fifo<Token>("f").read();
            its_core_.fifo<Token>("g").read();
        });
        for (int i = 0; i < 3; ++i) {
            its_core_.fifo<Token>("h").read();
            clock_.advance(1);
        }
    }

    DataflowCore& its_core_;
    WriteDistances* distances_ = nullptr;
};

class Core : public DataflowCore {
  public:
    Core(sc_core::sc_module_name const& name, std::shared_ptr<Machine const> const& machine, CoreShare share,
         TimeBase const& time_base)
        : DataflowCore(name, machine, share, time_base) {
        for (MachineFifo const& fifo : machine->fifos)
            make_fifo<Token>(fifo.name);
        writer_.emplace("writer", *this);
        reader_.emplace("reader", *this);
    }

  private:
    std::optional<Writer> writer_;
    std::optional<Reader> reader_;
};

std::string stuck(Engine engine) {
    testing::FreshKernel const kernel;
    ModuleDescription writer("writer"), reader("reader");
    constexpr PixelOffset own{0, 0};
    for (char const* fifo : {"f", "g", "h"}) {
        writer.writes_to(fifo).of_bits(32);
        reader.reads_from(fifo);
    }
    reader.loop("receive").of_depth(9).accesses_memory("m", {{own}, {own}}).in_stages({"m", 0, 7, 1, 1});
    reader.memory("m").of_words(1, 2, 8);
    MachineSettings settings;
    settings.dependence("reader.receive.m").hazards = HazardHandling::interlock;
    auto const machine = std::make_shared<Machine const>(make_machine(core_of({writer, reader}), settings));
    DataflowAccelerator accelerator("accelerator", machine, 1, engine,
                                    [](char const* name, std::shared_ptr<Machine const> const& of, CoreShare share,
                                       TimeBase const& base) { return std::make_unique<Core>(name, of, share, base); });
    RunStatistics const run = simulate(accelerator, {});
    std::string text;
    for (StuckProcess const& process : run.stuck)
        text += process.process + " waits for " + process.fifo + " since " + std::to_string(process.since_cycle) + ", ";
    return text + std::to_string(run.cores.at(0).loops.at(0).interlock_cycles) + " cycles of waits for writes";
}

TEST_CASE("what an iteration that never begins would wait for a write does not count") {
    // Both tokens of the first iteration are there in cycle 2; the second one waits from cycle 3 on, and would for the
    // write of the first until cycle 10.
    std::string const expected = "writer waits for h since 5, reader waits for g since 3, 0 cycles of waits for writes";
    CHECK(stuck(Engine::lockstep) == expected);
    CHECK(stuck(Engine::decoupled) == expected);
}

}  // namespace stuck_interlock_test
