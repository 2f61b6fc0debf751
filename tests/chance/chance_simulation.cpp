#include "chance/chance_simulation.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <systemc>
#include <unistd.h>
#include <vector>

#include "chance/elaborated.hpp"
#include "channels/clocked_fifo.hpp"
#include "channels/sample_module.hpp"
#include "channels/simple_simulation.hpp"
#include "channels/simulate.hpp"
#include "dataflow/base/byte_stream.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/tools/report/summary.hpp"
#include "dataflow/tools/sizing/size_fifos.hpp"
#include "faster/dataflow_names.hpp"
#include "support/forked_bytes.hpp"
#include "support/fresh_kernel.hpp"
#include "support/shared_out.hpp"

namespace faster::chance {

namespace {

using Token = std::uint32_t;

/// What the program of this process simulates.
Design& design_at_hand() {
    static Design design;
    return design;
}

/// One process of a design, as a user would write it. Tokens are numbered, so that a reader knows what to expect.
class ChanceModule : public SampleModule {
  public:
    ChanceModule(sc_core::sc_module_name const& name, SimpleCore& core, std::size_t number)
        : SampleModule(name, core), core_of_it_(core), number_(number), next_(design().fifos.size()) {}

  private:
    static Design const& design() { return design_at_hand(); }
    Process const& process() const { return design().processes[number_]; }
    ClockedFifo<Token>& fifo(std::size_t number) const { return core_of_it_.fifo<Token>(design().fifos[number].name); }
    bool writes(std::size_t fifo) const { return design().writes(number_, fifo); }

    bool tries(std::size_t fifo) const { return design().tries(number_, fifo); }

    void work(std::size_t sample) override {
        if (design().is_idle(sample)) {
            enter_no_loop();
            return;
        }
        exchange_buffers(static_cast<Token>(sample));
        std::vector<Token> const before = next_;
        for (Segment const& segment : process().program) {
            tell_memory(sample, segment);
            if (segment.kind == Segment::Kind::wait)
                clock_.advance(segment.cycles);
            else if (segment.kind == Segment::Kind::step)
                do_step(segment);
            else if (segment.kind == Segment::Kind::rest)
                read_rest(segment.step.front(), before);
            else
                do_loop(segment);
        }
    }

    void enter_no_loop() {
        for (Loop const& loop : process().loops)
            if (loop.is_pipelined)
                clock_.pipeline(loop.name, 0, [](std::uint64_t) {});
    }

    void tell_memory(std::size_t sample, Segment const& segment) {
        if (segment.tokens() > 0)
            clock_.tell_ranges(
                {{process().port.address_of(sample, static_cast<std::size_t>(&segment - process().program.data())),
                  segment.tokens(), process().port.token_bytes}});
    }

    /// Each has the number of its sample.
    void exchange_buffers(Token sample) {
        for (std::size_t const buffer : process().buffers) {
            PingPong<Token>& of = core_of_it_.ping_pong<Token>(design().fifos[buffer].name);
            if (writes(buffer))
                of.put({sample});
            else if (of.take() != std::vector<Token>{sample})
                throw std::logic_error("a buffer is not what was put");
        }
    }

    void do_step(Segment const& segment) {
        Accesses const& accesses = segment.step;
        if (accesses.size() == 1 && !tries(accesses.front()) && !segment.is_at_memory(0)) {
            access(accesses.front());
        } else {
            Step const step(clock_);
            if (segment.is_at_memory(0))
                clock_.access_memory();
            for (std::size_t const fifo : accesses)
                if (!tries(fifo))
                    access(fifo);
            for (std::size_t const fifo : accesses)
                if (tries(fifo))
                    attempt(fifo);
        }
        clock_.advance(1);
    }

    void read_rest(std::size_t number, std::vector<Token> const& before) {
        auto const count = static_cast<Token>(accesses_of(design(), number_, number));
        while (next_[number] < before[number] + count) {
            access(number);
            clock_.advance(1);
        }
    }

    void do_loop(Segment const& segment) {
        if ((number_ + segment.iterations.size()) % 2 == 0 || !do_token_loop(segment))
            do_iterations(segment);
    }
    /// By tokens_of(), if every iteration accesses the same one or two FIFOs of each kind. False: it does not.
    bool do_token_loop(Segment const& segment) {
        Accesses const accesses = segment.iterations.empty() ? Accesses() : segment.iterations.front();
        bool const are_equal = std::all_of(segment.iterations.begin(), segment.iterations.end(),
                                           [&](Accesses const& other) { return other == accesses; });
        bool const are_plain = std::all_of(accesses.begin(), accesses.end(), [this](std::size_t one) {
            return !tries(one) && (writes(one) || is_first_stage(one));
        });
        Accesses order = accesses;
        auto const first_write =
            std::stable_partition(order.begin(), order.end(), [this](std::size_t one) { return !writes(one); });
        Accesses const reads(order.begin(), first_write);
        Accesses const writes(first_write, order.end());
        if (!are_equal || !are_plain || accesses.empty() || reads.size() > 2 || writes.size() > 2 ||
            segment.tokens() > 0)
            return false;
        auto const body = [&](std::uint64_t /*iteration*/, auto&... tokens) {
            std::size_t at = 0;
            (use(order[at++], tokens), ...);
        };
        with_fifos(reads, [&](auto const& in) {
            with_fifos(writes, [&](auto const& out) {
                clock_.pipeline(process().loops[segment.loop].name, segment.iterations.size(), token_ports(in, out),
                                body);
            });
        });
        return true;
    }
    template <class Call> void with_fifos(Accesses const& numbers, Call call) {
        if (numbers.empty())
            call(std::tuple<>());
        else if (numbers.size() == 1)
            call(std::tuple(&fifo(numbers[0])));
        else
            call(std::tuple(&fifo(numbers[0]), &fifo(numbers[1])));
    }
    void use(std::size_t number, Token const& token) { take(number, token); }
    void use(std::size_t number, Token& token) { token = next_[number]++; }
    void do_iterations(Segment const& segment) {
        unsigned const loop = clock_.loop(process().loops[segment.loop].name);
        auto const body = [&](std::uint64_t i) {
            if (segment.is_at_memory(i))
                clock_.access_memory();
            for (std::size_t const one : segment.iterations[i])
                if (tries(one))
                    continue;
                else if (writes(one) || (is_first_stage(one) && process().ends.size() % 2 == 0))
                    access(one);
                else
                    clock_.take_later(fifo(one), [this, one](Token token) { take(one, token); });
            make_attempts(segment.iterations[i], loop);
        };
        std::string const& name = process().loops[segment.loop].name;
        std::uint64_t const count = segment.iterations.size();
        if (count > 0 && process().decides_trip_counts())
            clock_.pipeline_while(name, [&](std::uint64_t i) {
                body(i);
                return i + 1 < count;
            });
        else
            clock_.pipeline(name, count, body);
    }
    void make_attempts(Accesses accesses, unsigned loop) {
        std::stable_sort(accesses.begin(), accesses.end(), [this](std::size_t one, std::size_t other) {
            return design().stage(number_, one) < design().stage(number_, other);
        });
        for (std::size_t const one : accesses)
            if (tries(one) && process().tries_early && is_before_next(one, loop))
                attempt(one);
            else if (tries(one))
                attempt_later(one);
    }
    bool is_before_next(std::size_t number, unsigned loop) const {
        ClockedFifo<Token> const& one = fifo(number);
        unsigned const port = (writes(number) ? one.write_port() : one.read_port()).first();
        timing::LoopPlan const& plan = clock_.timing().shape()->plans[loop];
        return plan.step_of(port).value() < plan.ii;
    }
    void attempt(std::size_t number) {
        if (writes(number)) {
            bool const is_room = !fifo(number).full();
            if (fifo(number).write_nb(next_[number]++) != is_room)
                throw std::logic_error("full() says something else than write_nb()");
            return;
        }
        Token token = 0;
        bool const is_there = !fifo(number).empty();
        if (fifo(number).read_nb(token) != is_there)
            throw std::logic_error("empty() says something else than read_nb()");
        if (is_there)
            take(number, token);
    }
    void attempt_later(std::size_t number) {
        if (writes(number))
            clock_.try_write_later(fifo(number), next_[number]++, [](bool) {});
        else
            clock_.try_read_later(fifo(number), [this, number](Token const* token) {
                if (token != nullptr)
                    take(number, *token);
            });
    }
    /// Read by a plain port.
    bool is_first_stage(std::size_t fifo) const {
        MemoryPort const& port = process().port;
        Cycles first = port.is_there && port.loop && !port.writes ? 0 : design().stage(number_, fifo);
        for (std::size_t const other : process().ends)
            first = std::min(first, design().stage(number_, other));
        return first == 0 ? design().stage(number_, fifo) == 0
                          : process().takes_early && design().stage(number_, fifo) == first;
    }

    void access(std::size_t number) {
        if (writes(number))
            fifo(number).write(next_[number]++);
        else
            take(number, fifo(number).read());
    }
    void take(std::size_t number, Token token) {
        bool const is_next = design().fifos[number].writer_tries ? token >= next_[number] : token == next_[number];
        if (!is_next)
            throw std::logic_error("a token is not what was written");
        next_[number] = token + 1;
    }

    SimpleCore& core_of_it_;
    std::size_t number_;
    std::vector<Token> next_;  ///< by FIFO
};

class ChanceCore : public SimpleCore {
  public:
    static CoreDescription describe(Numbers const& /*numbers*/) { return plain_description_of(design_at_hand()); }
    explicit ChanceCore(SimpleCoreParts const& parts) : SimpleCore(parts) {
        for (Fifo const& fifo : design_at_hand().fifos)
            if (fifo.is_ping_pong)
                buffers_.push_back(std::make_unique<PingPong<Token>>(fifo.name.c_str(), ping_pong_timing(fifo.name)));
            else
                make_fifo<Token>(fifo.name);
        for (std::size_t i = 0; i < design_at_hand().processes.size(); ++i)
            modules_.push_back(std::make_unique<ChanceModule>(design_at_hand().processes[i].name.c_str(), *this, i));
    }

  private:
    std::vector<std::unique_ptr<PingPong<Token>>> buffers_;
    std::vector<std::unique_ptr<ChanceModule>> modules_;
};

SimpleSimulation<ChanceCore> const& simulation() {
    static SimpleSimulation<ChanceCore> const one({"chance", {}, {}});
    return one;
}

/// Written and read back.
events::EventFile by_file(LoadedConfig const& loaded, replay::RecordedRun const& recorded, RunStatistics const& run) {
    auto const file =
        std::filesystem::temp_directory_path() / ("faster_chance_" + std::to_string(getpid()) + ".events");
    events::write_event_file(io::OutputFile(file), loaded.config, recorded, run,
                             report::summary_json(resolved_keys(loaded.config), run, {}));
    events::EventFile read = events::read_event_file(file);
    std::filesystem::remove(file);
    return read;
}

/// As if many more retimings were to come.
RunStatistics retime_ready(replay::RecordedRun const& recorded, Machine const& machine) {
    return replay::retime(replay::ScriptedRun(recorded), machine);
}

void retime_as(Design const& other, replay::RecordedRun const& recorded, Outcome& outcome) {
    try {
        outcome.other = figures_of(retime_ready(recorded, make_machine(description_of(other), settings_of(other))));
    } catch (InputError const& error) {
        outcome.refusal = error.what();
    }
}

/// Little is asked of the search: small designs have few combinations, and an answer without a proof is one, too.
std::optional<Outcome::Sized> size(Design const& design, replay::RecordedRun const& recorded, RunConfig const& config) {
    sizing::SizingOptions options;
    options.front_points = 0;
    options.most_retimings = 100;
    try {
        sizing::Sizing const sizing = sizing::size_fifos(recorded, config, options);
        Outcome::Sized sized;
        sized.bound = sizing.bound;
        for (Fifo const& fifo : design.fifos) {
            sizing::FifoChoice const& choice = sizing.answer.choice[sizing.machine.fifo(fifo.name)];
            sized.depths.push_back(choice.depth);
            sized.kinds.push_back(choice.kind);
        }
        RunStatistics const run = replay::retime(recorded, with_choice(sizing.machine, sizing.answer.choice));
        if (run.total_cycles != sizing.answer.total_cycles)
            throw std::logic_error("the answer takes other cycles than were found");
        if (run.deadlocked())
            throw std::logic_error("the answer gets stuck");
        sized.figures = figures_of(run);
        return sized;
    } catch (InputError const& error) {
        std::string const line = error.what();
        if (line.find("without waiting") == std::string::npos && line.find("hands over calls") == std::string::npos)
            throw;
        return std::nullopt;
    }
}

/// The outcome has its engine, and whether it is to be recorded.
void run_here(Design const& design, Design const& other, bool sizes, Outcome& outcome) {
    testing::FreshKernel const kernel;
    try {
        Elaborated const made(simulation(), design, outcome.engine);
        replay::RecordedRun recorded;
        SimulationOptions options = testing::shared_out(design.samples);
        options.recorded = outcome.is_recorded ? &recorded : nullptr;
        RunStatistics const run = simulate(*made.accelerator, options);
        outcome.run = figures_of(run);
        if (std::string const left = leftover_tokens(run); !run.deadlocked() && !left.empty())
            throw std::logic_error("tokens are left: " + left);
        if (outcome.is_recorded && !run.deadlocked()) {
            outcome.as_is = figures_of(retime_ready(recorded, *made.machine));
            events::EventFile const read = by_file(made.loaded, recorded, run);
            outcome.from_file = figures_of(replay::retime(read.run, machine_of(read.loaded.config)));
            retime_as(other, recorded, outcome);
            Outcome by_its_file;
            retime_as(other, read.run, by_its_file);
            if (by_its_file.refusal != outcome.refusal || by_its_file.other.lines != outcome.other.lines)
                throw std::logic_error("retimed from its event file it does something else");
            if (sizes)
                outcome.sized = size(design, recorded, made.loaded.config);
        }
    } catch (std::exception const& error) {
        outcome.error = error.what();
    }
}

void put(ValueWriter& writer, Outcome const& outcome) {
    writer.put(outcome.error);
    writer.put(outcome.refusal);
    for (Figures const* figures : {&outcome.run, &outcome.as_is, &outcome.from_file, &outcome.other})
        put(writer, *figures);
    writer.put(outcome.sized.has_value());
    if (outcome.sized) {
        writer.put(outcome.sized->depths, outcome.sized->kinds, outcome.sized->bound);
        put(writer, outcome.sized->figures);
    }
}

void get(ValueReader& reader, Outcome& outcome) {
    reader.get(outcome.error);
    reader.get(outcome.refusal);
    for (Figures* figures : {&outcome.run, &outcome.as_is, &outcome.from_file, &outcome.other})
        *figures = figures_from(reader);
    bool is_sized = false;
    reader.get(is_sized);
    if (is_sized) {
        outcome.sized = Outcome::Sized();
        reader.get(outcome.sized->depths);
        reader.get(outcome.sized->kinds);
        reader.get(outcome.sized->bound);
        outcome.sized->figures = figures_from(reader);
    }
}

}  // namespace

std::vector<Outcome> run_forked(Design const& design, Design const& other, bool sizes) {
    std::vector<Outcome> outcomes;
    for (faster::Engine const engine : {faster::Engine::lockstep, faster::Engine::decoupled})
        for (bool const is_recorded : {false, true}) {
            outcomes.emplace_back().engine = engine;
            outcomes.back().is_recorded = is_recorded;
        }
    try {
        ValueReader reader(testing::forked_bytes([&] {
            design_at_hand() = design;
            ValueWriter writer;
            for (Outcome& outcome : outcomes) {
                run_here(design, other, sizes, outcome);
                put(writer, outcome);
            }
            return writer.bytes();
        }));
        for (Outcome& outcome : outcomes)
            get(reader, outcome);
    } catch (std::runtime_error const& error) {
        outcomes.front().error = error.what();
    }
    return outcomes;
}

}  // namespace faster::chance

namespace dataflow {

Design const& design() { return faster::chance::simulation(); }
SimulatedDesign const& simulated_design() { return faster::chance::simulation(); }

}  // namespace dataflow
