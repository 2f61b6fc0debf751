#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "dataflow/phrases/phrase_core.hpp"
#include "dataflow/run/replay/path_sweep.hpp"
#include "faster/dataflow_names.hpp"

namespace read_stage_test {

// Loops whose reads sit in later stages, against a simulation of the same processes cycle by cycle that shares nothing
// with the timing but the description below.

using namespace faster;
using namespace dataflow::timing;

using PortList = std::vector<unsigned>;

struct Fifo {
    std::uint64_t capacity = 2;
    Cycles read_latency = 1;
};

struct PortOf {
    unsigned fifo = 0;
    bool writes = false;
};

/// `count` times: an iteration that accesses `ports`, then `gap` that access nothing.
struct Run {
    PortList ports;
    unsigned gap = 0;
    unsigned count = 1;
};

/// Some cycles, one step, or a loop.
struct Segment {
    enum class Kind { wait, step, loop } kind = Kind::wait;
    unsigned cycles = 0;
    PortList ports;
    Cycles ii = 1;
    Cycles depth = 1;
    std::map<unsigned, Cycles> stages;  ///< by port
    std::vector<Run> runs;
};

struct Program {
    std::string name;
    std::vector<PortOf> ports;
    std::vector<Segment> segments;
};

struct Design {
    std::vector<Fifo> fifos;
    std::vector<Program> programs;
};

struct FifoFigures {
    std::uint64_t writes = 0, reads = 0, max_occupancy = 0;
    Cycles full = 0, empty = 0;
    std::vector<Cycles> written, read;
};

struct Outcome {
    bool is_stuck = false;
    std::vector<Cycles> ends;  ///< by process: when it was done, or reached the step it is stuck at
    std::vector<FifoFigures> fifos;

    Cycles total() const { return *std::max_element(ends.begin(), ends.end()); }
};

// The simulation: all steps of a process in a list, one of them per cycle at most.

using Steps = std::vector<PortList>;

void append_loop(Segment const& loop, Steps& steps) {
    std::vector<PortList> iterations;
    for (Run const& run : loop.runs)
        for (unsigned k = 0; k < run.count; ++k) {
            iterations.push_back(run.ports);
            iterations.resize(iterations.size() + run.gap);
        }
    std::size_t const begin = steps.size();
    steps.resize(begin + (iterations.size() - 1) * loop.ii + loop.depth);
    for (std::size_t i = 0; i < iterations.size(); ++i)
        for (unsigned const port : iterations[i])
            steps.at(begin + i * loop.ii + loop.stages.at(port)).push_back(port);
}

Steps steps_of(Program const& program) {
    Steps steps;
    for (Segment const& segment : program.segments) {
        if (segment.kind == Segment::Kind::loop)
            append_loop(segment, steps);
        else if (segment.kind == Segment::Kind::step)
            steps.push_back(segment.ports);
        else
            steps.resize(steps.size() + segment.cycles);
    }
    for (PortList& step : steps)
        std::sort(step.begin(), step.end());
    return steps;
}

class Simulation {
  public:
    explicit Simulation(Design const& design) : design_(design), places_(design.programs.size()) {
        outcome_.ends.resize(places_.size());
        outcome_.fifos.resize(design.fifos.size());
        for (std::size_t i = 0; i < places_.size(); ++i)
            places_[i].steps = steps_of(design.programs[i]);
        for (Fifo const& fifo : design.fifos) {
            readable_.emplace_back();
            room_.emplace_back(fifo.capacity, 0);
        }
    }

    Outcome run() {
        for (; !is_done(); ++cycle_)
            if (!pass_cycle()) {
                outcome_.is_stuck = true;
                break;
            }
        return outcome_;
    }

  private:
    struct Place {
        Steps steps;
        std::size_t next = 0;
        bool is_done() const { return next == steps.size(); }
    };

    bool is_done() const {
        return std::all_of(places_.begin(), places_.end(), [](Place const& place) { return place.is_done(); });
    }

    /// Who may step is decided before anybody does. False: nothing moves now, nor will it.
    bool pass_cycle() {
        std::vector<std::size_t> movers;
        for (std::size_t i = 0; i < places_.size(); ++i)
            if (!places_[i].is_done() && may_step(i))
                movers.push_back(i);
        for (std::size_t const i : movers)
            step(i);
        for (std::size_t f = 0; f < readable_.size(); ++f)
            outcome_.fifos[f].max_occupancy =
                std::max<std::uint64_t>(outcome_.fifos[f].max_occupancy, readable_[f].size());
        return !movers.empty() || something_ripens();
    }

    bool may_step(std::size_t process) {
        Program const& program = design_.programs[process];
        for (unsigned const number : places_[process].steps[places_[process].next]) {
            PortOf const& port = program.ports[number];
            std::vector<Cycles> const& line = port.writes ? room_[port.fifo] : readable_[port.fifo];
            if (!line.empty() && line.front() <= cycle_)
                continue;
            ++(port.writes ? outcome_.fifos[port.fifo].full : outcome_.fifos[port.fifo].empty);
            return false;
        }
        return true;
    }

    void step(std::size_t process) {
        Program const& program = design_.programs[process];
        for (unsigned const number : places_[process].steps[places_[process].next++])
            access(program.ports[number]);
        outcome_.ends[process] = cycle_ + 1;
    }

    void access(PortOf const& port) {
        std::vector<Cycles>& from = port.writes ? room_[port.fifo] : readable_[port.fifo];
        std::vector<Cycles>& to = port.writes ? readable_[port.fifo] : room_[port.fifo];
        from.erase(from.begin());
        to.push_back(cycle_ + (port.writes ? design_.fifos[port.fifo].read_latency : 1));
        FifoFigures& figures = outcome_.fifos[port.fifo];
        ++(port.writes ? figures.writes : figures.reads);
        (port.writes ? figures.written : figures.read).push_back(cycle_);
    }

    bool something_ripens() const {
        auto const is_later = [this](Cycles from) { return from > cycle_; };
        for (auto const* lines : {&readable_, &room_})
            for (std::vector<Cycles> const& line : *lines)
                if (std::any_of(line.begin(), line.end(), is_later))
                    return true;
        return false;
    }

    Design const& design_;
    std::vector<Place> places_;
    std::vector<std::vector<Cycles>> readable_, room_;  ///< by FIFO: when its tokens, its free places can be used
    Cycles cycle_ = 0;
    Outcome outcome_;
};

// The programs as the timing sees them.

LoopShape shape_of(Program const& program, Segment const& loop) {
    LoopShape shape;
    shape.interval = schedule(loop.ii, 1, {});
    shape.depth = loop.depth;
    for (auto const& [port, stage] : loop.stages) {
        if (program.ports[port].writes)
            shape.writes.push_back({port, stage});
        else
            shape.reads.push_back({port, stage});
    }
    return shape;
}

void log_segment(Segment const& segment, unsigned& loop, OperationLog& log) {
    if (segment.kind == Segment::Kind::wait) {
        log.wait(segment.cycles);
    } else if (segment.kind == Segment::Kind::step) {
        log.step(Ports::of(segment.ports).number(), 1);
    } else {
        log.enter(loop++);
        for (Run const& run : segment.runs)
            log.iterate(Ports::of(run.ports).number(), run.gap, run.count);
        log.leave();
    }
}

/// Sees when each access happens.
class Accesses : public StepObserver {
  public:
    explicit Accesses(Design const& design) : design_(design), fifos(design.fifos.size()) {}
    void accessed(ProcessTiming const& process, Ports ports, Cycles cycle) override {
        ports.each([&](unsigned number) {
            PortOf const& port = design_.programs[process.index()].ports[number];
            (port.writes ? fifos[port.fifo].written : fifos[port.fifo].read).push_back(cycle);
        });
    }
    void entered_loop(ProcessTiming const&, unsigned, Cycles) override {}
    void left_loop(ProcessTiming const&, Cycles) override {}
    void iterated(ProcessTiming const&, Cycles, std::uint64_t, std::uint64_t, Cycles) override {}
    void stalled(ProcessTiming const&, unsigned, Cycles, Cycles) override {}
    void let_out(ProcessTiming const& /*process*/, unsigned /*port*/, Cycles /*due*/, Cycles /*cycle*/) override {}
    void stamped(ProcessTiming const&, Cycles) override {}

  private:
    Design const& design_;

  public:
    std::vector<FifoFigures> fifos;
};

class Timed {
  public:
    explicit Timed(Design const& design) : logs_(design.programs.size()) {
        for (std::size_t f = 0; f < design.fifos.size(); ++f) {
            FifoShape shape;
            shape.name = "f" + std::to_string(f);
            shape.capacity = design.fifos[f].capacity;
            shape.read_latency = design.fifos[f].read_latency;
            core_.add_fifo(shape);
        }
        for (std::size_t i = 0; i < logs_.size(); ++i)
            add(design.programs[i], logs_[i]);
    }

    CoreTiming& core() { return core_; }

    Outcome run_at_once() {
        for (std::size_t i = 0; i < logs_.size(); ++i)
            say(i, logs_[i].pending());
        core_.resolve();
        return outcome();
    }

    /// Any process says some of what it does, and so on.
    Outcome run_by_pieces(std::mt19937& random) {
        for (std::size_t left = logs_.size(); left > 0;) {
            std::size_t const i = random() % logs_.size();
            if (logs_[i].exhausted())
                continue;
            say(i, std::min<std::size_t>(logs_[i].pending(), 1 + random() % 4));
            left -= logs_[i].exhausted() ? 1U : 0U;
            core_.resolve(false);
        }
        core_.resolve();
        return outcome();
    }

    /// As the lockstep engine does: who has the earliest step takes it, and says no more than the operation at hand.
    Outcome run_in_lockstep() {
        core_.keep_logs();
        for (;;) {
            ProcessTiming* first = nullptr;
            bool has_said = false;
            for (std::size_t i = 0; i < logs_.size(); ++i) {
                ProcessTiming& process = core_.process(i);
                ProcessTiming::Status const status = process.front();
                if (status == ProcessTiming::Status::ready &&
                    (first == nullptr || process.front_cycle() < first->front_cycle()))
                    first = &process;
                if (status == ProcessTiming::Status::exhausted && !logs_[i].exhausted()) {
                    say(i, 1);
                    has_said = true;
                }
            }
            if (has_said)
                continue;
            if (first == nullptr)
                return outcome();
            first->commit_front();
        }
    }

  private:
    void add(Program const& program, OperationLog& log) {
        ProcessTiming& process = core_.add_process(program.name);
        for (PortOf const& port : program.ports)
            port.writes ? process.add_writes(core_.fifo(port.fifo)) : process.add_reads(core_.fifo(port.fifo));
        unsigned loop = 0;
        for (Segment const& segment : program.segments) {
            if (segment.kind == Segment::Kind::loop)
                process.add_loop(shape_of(program, segment));
            log_segment(segment, loop, log);
        }
    }

    void say(std::size_t process, std::size_t operations) {
        for (; operations > 0; --operations) {
            core_.process(process).log().append(*logs_[process].begin());
            logs_[process].consume();
        }
    }

    Outcome outcome() {
        Outcome outcome;
        outcome.is_stuck = !core_.blocked().empty();
        for (ProcessTiming const& process : core_.processes())
            outcome.ends.push_back(process.local_time());
        for (FifoTiming const& fifo : core_.fifos())
            outcome.fifos.push_back({fifo.writes(),
                                     fifo.reads(),
                                     fifo.max_occupancy(),
                                     fifo.full_stall_cycles(),
                                     fifo.empty_stall_cycles(),
                                     {},
                                     {}});
        return outcome;
    }

    std::unique_ptr<PhraseCore> const made_ = make_core();
    CoreTiming& core_ = *made_;
    std::vector<OperationLog> logs_;  ///< what the processes have yet to say
};

// Two processes that send each other tokens.

Segment wait(unsigned cycles) {
    Segment segment;
    segment.cycles = cycles;
    return segment;
}

Segment loop(unsigned iterations, Cycles depth, std::map<unsigned, Cycles> const& stages) {
    Segment segment;
    segment.kind = Segment::Kind::loop;
    segment.depth = depth;
    segment.stages = stages;
    Run run;
    for (auto const& access : stages)
        run.ports.push_back(access.first);
    run.count = iterations;
    segment.runs.push_back(run);
    return segment;
}

constexpr unsigned request = 0, response = 1;

struct Cyclic {
    Cycles controller_depth = 3, sends = 1, receives = 2;
    Cycles processor_depth = 2, reads = 1, writes = 1;
    unsigned waits_before = 0;
    std::uint64_t fifo_depth = 2;
    unsigned iterations = 2025;

    Design design() const {
        Design design;
        design.fifos.assign(2, {fifo_depth, 1});
        design.programs.push_back(
            {"controller",
             {{request, true}, {response, false}},
             {wait(waits_before), loop(iterations, controller_depth, {{0, sends}, {1, receives}})}});
        design.programs.push_back({"processor",
                                   {{request, false}, {response, true}},
                                   {wait(1), loop(iterations, processor_depth, {{0, reads}, {1, writes}})}});
        return design;
    }
};

void check_same(Outcome const& timed, Outcome const& simulated) {
    CHECK(timed.is_stuck == simulated.is_stuck);
    CHECK(timed.ends == simulated.ends);
    for (std::size_t f = 0; f < simulated.fifos.size(); ++f) {
        INFO("FIFO " << f);
        CHECK(timed.fifos[f].writes == simulated.fifos[f].writes);
        CHECK(timed.fifos[f].reads == simulated.fifos[f].reads);
        if (simulated.is_stuck)  // only waiting that has come to an end is charged, only tokens that are read count
            continue;
        CHECK(timed.fifos[f].max_occupancy == simulated.fifos[f].max_occupancy);
        CHECK(timed.fifos[f].full == simulated.fifos[f].full);
        CHECK(timed.fifos[f].empty == simulated.fifos[f].empty);
    }
}

Outcome check_all_ways(Design const& design, std::mt19937& random) {
    Outcome simulated = Simulation(design).run();
    {
        INFO("at once");
        check_same(Timed(design).run_at_once(), simulated);
    }
    {
        INFO("by pieces");
        check_same(Timed(design).run_by_pieces(random), simulated);
    }
    {
        INFO("in lockstep");
        check_same(Timed(design).run_in_lockstep(), simulated);
    }
    INFO("observed");
    Timed observed(design);
    Accesses accesses(design);
    for (std::size_t i = 0; i < design.programs.size(); ++i)
        observed.core().process(i).set_observer(&accesses);
    check_same(observed.run_at_once(), simulated);
    for (std::size_t f = 0; f < simulated.fifos.size(); ++f) {
        INFO("FIFO " << f);
        CHECK(accesses.fifos[f].written == simulated.fifos[f].written);
        CHECK(accesses.fifos[f].read == simulated.fifos[f].read);
    }
    return simulated;
}

Cycles total_of(Cyclic const& cyclic) {
    std::mt19937 random(1);
    Outcome const outcome = check_all_ways(cyclic.design(), random);
    CHECK_FALSE(outcome.is_stuck);
    return outcome.total();
}

/// The cycle from which on nothing moves.
Cycles stuck_from(Cyclic const& cyclic) {
    std::mt19937 random(1);
    Outcome const outcome = check_all_ways(cyclic.design(), random);
    CHECK(outcome.is_stuck);
    return outcome.total();
}

/// What a critical path is made of: cycles of processes, and those that tokens and free places take to be usable.
Cycles length_of(PathSums const& path, Design const& design, CoreTiming const& core) {
    Cycles cycles = 0;
    for (ProcessTiming const& process : core.processes())
        for (unsigned number = 0; number < Region::count(static_cast<unsigned>(process.loops().size())); ++number) {
            Region const region = Region::numbered(number);
            for (PathSums::Share const share :
                 {PathSums::Share::own, PathSums::Share::recurrence, PathSums::Share::port_conflict})
                cycles += path.of(process.index(), region, share);
            for (unsigned i = 0; i < process.port_count(); ++i) {
                PortOf const& port = design.programs[process.index()].ports[i];
                cycles +=
                    path.turns(process.index(), region, i) * (port.writes ? 1 : design.fifos[port.fifo].read_latency);
            }
        }
    return cycles;
}

/// The path to the last access of each FIFO explains all of its cycle.
void check_paths(Design const& design, Outcome const& simulated) {
    Timed timed(design);
    timed.core().leave_trail(forget_trunk);
    timed.run_at_once();
    for (unsigned i = 0; i < design.programs.size(); ++i)
        for (PortOf const& port : design.programs[i].ports) {
            FifoFigures const& figures = simulated.fifos[port.fifo];
            std::vector<Cycles> const& accesses = port.writes ? figures.written : figures.read;
            if (!accesses.empty())
                CHECK(length_of(critical_path(timed.core(), i, accesses.back()), design, timed.core()) ==
                      accesses.back());
        }
}

// Machines by chance.

class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    unsigned below(unsigned end) { return static_cast<unsigned>(random_() % end); }
    unsigned between(unsigned first, unsigned last) { return first + below(last - first + 1); }
    bool one_in(unsigned n) { return below(n) == 0; }

  private:
    std::mt19937 random_;
};

/// Iterations that access each port `count` times.
std::vector<Run> random_runs(Dice& dice, std::size_t ports, unsigned count) {
    std::vector<Run> runs;
    PortList all;
    for (unsigned port = 0; port < ports; ++port)
        all.push_back(port);
    if (all.empty()) {
        runs.push_back({{}, 0, count});
    } else if (dice.one_in(2)) {
        for (unsigned left = count; left > 0; left -= runs.back().count)
            runs.push_back({all, dice.one_in(3) ? dice.below(4) : 0, dice.one_in(2) ? left : 1 + dice.below(left)});
    } else {
        std::vector<unsigned> left(ports, count);
        while (std::any_of(left.begin(), left.end(), [](unsigned n) { return n > 0; })) {
            Run run;
            for (unsigned const port : all)
                if (left[port] > 0 && !dice.one_in(4)) {
                    run.ports.push_back(port);
                    --left[port];
                }
            run.gap = run.ports.empty() || !dice.one_in(6) ? 0 : dice.below(3);
            runs.push_back(run);
        }
    }
    return runs;
}

Segment random_loop(Dice& dice, std::size_t ports, unsigned count) {
    Segment segment;
    segment.kind = Segment::Kind::loop;
    segment.ii = dice.one_in(2) ? 1 : dice.between(1, 4);
    segment.depth = dice.between(1, 9);
    for (unsigned port = 0; port < ports; ++port)
        segment.stages[port] = dice.one_in(3) ? 0 : dice.below(static_cast<unsigned>(segment.depth));
    segment.runs = random_runs(dice, ports, count);
    return segment;
}

/// Every process accesses each of its FIFOs equally often, mostly in loops.
Design random_design(Dice& dice) {
    Design design;
    unsigned const processes = dice.between(2, 4);
    for (unsigned i = 0; i < processes; ++i)
        design.programs.push_back({"p" + std::to_string(i), {}, {wait(dice.below(6))}});
    unsigned const fifos = dice.between(1, 5);
    bool const may_be_cyclic = dice.one_in(3);
    for (unsigned f = 0; f < fifos; ++f) {
        design.fifos.push_back({dice.one_in(2) ? dice.between(5, 40) : dice.between(1, 4), dice.between(1, 2)});
        unsigned writer = dice.below(processes), reader = (writer + dice.between(1, processes - 1)) % processes;
        if (!may_be_cyclic && writer > reader)
            std::swap(writer, reader);
        design.programs[writer].ports.push_back({f, true});
        design.programs[reader].ports.push_back({f, false});
    }
    for (unsigned phase = dice.between(1, 3); phase > 0; --phase) {
        unsigned const count = dice.one_in(4) ? dice.between(1, 300) : dice.between(1, 20);
        for (Program& program : design.programs) {
            program.segments.push_back(random_loop(dice, program.ports.size(), count));
            program.segments.push_back(wait(dice.below(4)));
        }
    }
    return design;
}

TEST_CASE("a loop whose reads are all in the first step is laid out as if nobody had told of them", "[timing]") {
    LoopShape silent;
    silent.depth = 4;
    LoopShape told = silent;
    told.reads = {{0, 0}, {1, 0}};
    LoopPlan const one(silent), other(told);
    CHECK(one.aligned);
    CHECK(other.aligned);
    CHECK(one.fill == other.fill);
    CHECK(one.drain == other.drain);
    CHECK(one.longest_lag == other.longest_lag);
}

TEST_CASE("a loop that reads in one later stage needs no memory", "[timing]") {
    LoopShape shape;
    shape.depth = 5;
    shape.reads = {{0, 3}, {1, 3}};
    LoopPlan const plan(shape);
    CHECK(plan.aligned);
    CHECK(plan.fill == 3);
    CHECK(plan.drain == 1);
}

TEST_CASE("the plan of a loop treats reads as it does writes", "[timing]") {
    LoopShape shape;
    shape.interval = schedule(2, 1, {});
    shape.depth = 8;
    shape.writes = {{0, 2}};
    shape.reads = {{1, 7}, {2, 2}};
    LoopPlan const plan(shape);
    CHECK_FALSE(plan.aligned);
    CHECK(plan.fill == 2);
    CHECK(plan.longest_lag == 2);
    REQUIRE(plan.phases.size() == 2);
    CHECK(plan.phases[0].offset == 0);
    CHECK(plan.phases[1].offset == 1);
    CHECK(plan.phases[1].ports == std::vector<std::pair<unsigned, std::uint64_t>>{{1, 2}});
}

TEST_CASE("a controller that awaits each answer takes two cycles per iteration", "[timing]") {
    Cyclic cyclic;
    CHECK(total_of(cyclic) == 4052);
    cyclic.waits_before = 1;
    CHECK(total_of(cyclic) == 4053);
}

TEST_CASE("stages, depths and the number of iterations decide what a cycle of two processes takes", "[timing]") {
    Cyclic cyclic;
    cyclic.iterations = GENERATE(1U, 2U, 3U, 10U);
    CHECK(total_of(cyclic) == 2 * cyclic.iterations + 2);
    cyclic.iterations = 2025;
    cyclic.fifo_depth = GENERATE(1U, 2U, 16U);
    CHECK(total_of(cyclic) == 4052);
}

TEST_CASE("a longer pipeline keeps two requests on their way", "[timing]") {
    Cyclic cyclic;
    cyclic.controller_depth = 4;
    cyclic.receives = 3;
    CHECK(total_of(cyclic) == 2028);
    cyclic.fifo_depth = 1;
    CHECK(stuck_from(cyclic) == 4);
}

TEST_CASE("a processor that reads a stage before it writes freezes on its own answer", "[timing]") {
    Cyclic cyclic;
    cyclic.reads = 0;
    CHECK(stuck_from(cyclic) == 3);
}

TEST_CASE("a deadlock of loops that read in later stages says who waits for whom", "[timing]") {
    Cyclic cyclic;
    cyclic.controller_depth = 4;
    cyclic.receives = 3;
    cyclic.fifo_depth = 1;
    Timed timed(cyclic.design());
    timed.run_at_once();
    std::vector<BlockedProcess> const waits = timed.core().blocked();
    REQUIRE(waits.size() == 2);
    CHECK(waits[0].process == "controller");
    CHECK(waits[0].to_write);
    CHECK(waits[0].fifo == "f0");
    CHECK(waits[0].other == "processor");
    CHECK(waits[0].since == 4);
    CHECK(waits[1].process == "processor");
    CHECK(waits[1].to_write);
    CHECK(waits[1].fifo == "f1");
    CHECK(waits[1].other == "controller");
    CHECK(waits[1].since == 3);
}

TEST_CASE("random machines take the cycles that a simulation step by step takes", "[timing]") {
    unsigned const seeds = 2000;
    unsigned stuck = 0;
    for (unsigned seed = 0; seed < seeds; ++seed) {
        INFO("seed " << seed);
        Dice dice(seed);
        Design const design = random_design(dice);
        std::mt19937 random(seed);
        Outcome const simulated = check_all_ways(design, random);
        check_paths(design, simulated);
        stuck += simulated.is_stuck ? 1 : 0;
    }
    CHECK(stuck > 50);
    CHECK(stuck < 1000);  // most get to their ends
}

}  // namespace read_stage_test
