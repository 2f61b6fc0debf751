// What waveforms and timelines show of designs of any shape, signal by signal.
#include <catch2/catch.hpp>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "channels/clocked_fifo.hpp"
#include "channels/sample_module.hpp"
#include "channels/simulate.hpp"
#include "dataflow/core/machine/core_of.hpp"
#include "dataflow/run/config/calls.hpp"
#include "dataflow/tools/recording/core_timeline.hpp"
#include "dataflow/tools/recording/write_waveform.hpp"
#include "faster/dataflow_names.hpp"
#include "support/fresh_kernel.hpp"

namespace recordings_test {

using namespace faster;
using Catch::Matchers::Contains;
using faster::Engine;
using Token = std::uint32_t;

struct Part {
    ModuleDescription module;
    std::function<void(ProcessClock& clock, DataflowCore& core)> work;
};
using Parts = std::vector<Part>;

class PartModule : public SampleModule {
  public:
    PartModule(DataflowCore& core, Part const& part)
        : SampleModule(part.module.name.c_str(), core), core_(core), work_(part.work) {}

  private:
    void work(std::size_t /*sample*/) override { work_(clock_, core_); }

    DataflowCore& core_;
    decltype(Part::work) work_;
};

class PartsCore : public DataflowCore {
  public:
    PartsCore(sc_core::sc_module_name const& name, std::shared_ptr<Machine const> const& machine, CoreShare share,
              TimeBase const& time_base, Parts const& parts)
        : DataflowCore(name, machine, share, time_base) {
        for (MachineFifo const& fifo : machine->fifos)
            make_fifo<Token>(fifo.name);
        for (Part const& part : parts)
            modules_.push_back(std::make_unique<PartModule>(*this, part));
    }

  private:
    std::vector<std::unique_ptr<PartModule>> modules_;
};

/// A waveform as text: a line for each signal, with the cycles of a stretch in which it changes, and its first value.
class TextFile : public recording::WaveformFile {
  public:
    TextFile(Cycles from, Cycles to, std::string& text) : from_(from), to_(to), text_(text) {}

    void open_scope(std::string const& name) override { scopes_.push_back(name); }
    void close_scope() override { scopes_.pop_back(); }
    void declare(recording::SignalShape const& shape) override {
        names_.push_back(scopes_.back() + "." + shape.name);
        values_.emplace_back();
    }
    void end_declarations() override {}
    void go_to(std::uint64_t ticks) override { cycle_ = ticks / 5; }
    void change(std::size_t signal, std::optional<std::uint64_t> value) override {
        values_[signal][cycle_] = value ? std::to_string(*value) : "x";
    }
    void finish() override {
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (names_[i] != "accelerator.clock")
                text_ += names_[i] + line_of(values_[i]) + "\n";
    }
    std::uint64_t bytes() const override { return 0; }

  private:
    std::string line_of(std::map<Cycles, std::string> const& values) const {
        std::string line, last;
        for (Cycles cycle = from_; cycle <= to_; ++cycle) {
            auto const after = values.upper_bound(cycle);
            std::string const value = after == values.begin() ? "?" : std::prev(after)->second;
            if (value != std::exchange(last, value))
                line += " " + std::to_string(cycle) + ":" + value;
        }
        return line;
    }

    Cycles from_, to_;
    std::string& text_;
    std::vector<std::string> scopes_, names_;
    std::vector<std::map<Cycles, std::string>> values_;
    Cycles cycle_ = 0;
};

struct Stretch {
    Cycles from = 0, to = 0;
};

/// Samples by the table and by a timeline, how many iterations that has of each loop, and a stretch of the waveform.
/// With `window`, only that is recorded.
std::string shown(Parts const& parts, Engine engine, std::size_t samples, Stretch stretch,
                  std::optional<Stretch> window, MachineSettings const& settings) {
    testing::FreshKernel const kernel;
    std::vector<ModuleDescription> modules;
    for (Part const& part : parts)
        modules.push_back(part.module);
    auto const machine =
        std::make_shared<Machine const>(make_machine(with_calls(core_of(modules), settings), settings));
    DataflowAccelerator accelerator(
        "accelerator", machine, samples, engine,
        [&parts](char const* name, std::shared_ptr<Machine const> const& of, CoreShare share,
                 TimeBase const& time_base) { return std::make_unique<PartsCore>(name, of, share, time_base, parts); });
    std::string waveform, timeline = "timeline", table = "table";
    Recording whole, waves;
    whole.done = [&](recording::RecordedWindow const& of) {
        recording::CoreTimeline const made = recording::make_timeline(of.cores.front(), {});
        for (recording::CoreTimeline::Sample const& sample : made.samples)
            timeline += " " + std::to_string(sample.begin) + "-" + std::to_string(sample.end - 1);
        for (TimelineSpan const& span : made.spans)
            if (span.kind == TimelineSpan::Kind::loop)
                timeline += " " + machine->loops[span.item].name + " " + std::to_string(span.count);
    };
    if (window) {
        waves.window.from = window->from;
        waves.window.to = window->to;
    }
    waves.done = [&](recording::RecordedWindow const& of) {
        recording::WaveformFiles files;
        files.push_back(std::make_unique<TextFile>(stretch.from, stretch.to, waveform));
        recording::write_waveform(files, *machine, of, recording::SignalFilter({}, *machine), {});
    };
    SimulationOptions options;
    options.recordings = {whole, waves};
    RunStatistics const run = simulate(accelerator, options);
    for (SampleStatistics const& sample : run.samples)
        table += " " + std::to_string(sample.start_cycle) + "-" + std::to_string(sample.end_cycle);
    return table + "\n" + timeline + "\n" + waveform;
}

/// In both engines.
std::string shown(Parts const& parts, std::size_t samples, Stretch stretch, std::optional<Stretch> window = {},
                  MachineSettings const& settings = {}) {
    std::string const text = shown(parts, Engine::lockstep, samples, stretch, window, settings);
    CHECK(shown(parts, Engine::decoupled, samples, stretch, window, settings) == text);
    return text;
}
std::string shown_in_turn(Parts const& parts, std::size_t samples, Stretch stretch) {
    MachineSettings settings;
    settings.calls = CallOrder::in_turn;
    return shown(parts, samples, stretch, {}, settings);
}

/// Of one module, with two iterations a call, which access nothing.
Parts lone_loop(Cycles interval, Cycles depth, bool rewinds) {
    Part part{ModuleDescription("lone"), {}};
    LoopDescription& loop = part.module.loop("run").of_ii(interval).of_depth(depth);
    if (rewinds)
        loop.rewinds();
    part.work = [](ProcessClock& clock, DataflowCore&) { clock.pipeline("run", 2); };
    return {part};
}

/// With as many iterations in each call as are said; for one run.
Parts lone_loop(Cycles interval, Cycles depth, bool rewinds, std::vector<std::uint64_t> iterations) {
    Parts parts = lone_loop(interval, depth, rewinds);
    parts.front().work = [iterations = std::move(iterations), call = std::size_t{0}](ProcessClock& clock,
                                                                                     DataflowCore&) mutable {
        clock.pipeline("run", iterations.at(call++));
    };
    return parts;
}

/// Two modules that do ten iterations a call, with a token each.
Parts pair_of_loops(Cycles interval, Cycles depth, bool rewinds) {
    Part writer{ModuleDescription("writer"), {}}, reader{ModuleDescription("reader"), {}};
    writer.module.writes_to("f").of_bits(32).leaves("send", 0);
    reader.module.reads_from("f").taken("receive", 0);
    for (LoopDescription* loop : {&writer.module.loop("send"), &reader.module.loop("receive")}) {
        loop->of_ii(interval).of_depth(depth);
        if (rewinds)
            loop->rewinds();
    }
    writer.work = [](ProcessClock& clock, DataflowCore& core) {
        clock.pipeline("send", 10, [&](std::uint64_t i) { core.fifo<Token>("f").write(static_cast<Token>(i)); });
    };
    reader.work = [](ProcessClock& clock, DataflowCore& core) {
        clock.pipeline("receive", 10, [&](std::uint64_t) { core.fifo<Token>("f").read(); });
    };
    return {writer, reader};
}

TEST_CASE("A waveform and a timeline show a sample's end in the cycle that the table has") {
    // The tenth token is read in cycle 10, and done with in 12. The writer, drained, begins again in 12, not in 10.
    std::string const text = shown(pair_of_loops(1, 3, false), 2, {0, 40});
    CHECK_THAT(text, Contains("table 0-12 12-24\ntimeline 0-12 12-24 "));
    CHECK_THAT(text, Contains("sample.start 0:1 1:0 12:1 13:0") && Contains("sample.ended 0:0 24:1 "));
    CHECK_THAT(text, Contains("sample.end 0:0 12:1 13:0 24:1 "));
}

TEST_CASE("One module begins a sample with its next call") {
    // Iterations begin in 0, 4, 8, ...: a call of two ends in 4, and where it rewinds, the next begins in 8.
    std::string const rewinds = shown(lone_loop(4, 1, true), 3, {0, 20});
    CHECK_THAT(rewinds, Contains("table 0-4 8-12 16-20\ntimeline 0-4 8-12 16-20 run 6\n"));
    CHECK_THAT(rewinds, Contains("sample.start 0:1 1:0 8:1 9:0 16:1 17:0\n"));
    CHECK_THAT(rewinds, Contains("sample.end 0:0 4:1 5:0 12:1 13:0 20:1\n"));
    // Calls that are longer than two intervals overlap.
    CHECK_THAT(shown(lone_loop(2, 9, true), 3, {0, 20}), Contains("table 0-10 4-14 8-18\ntimeline 0-10 4-14 8-18 "));
    std::string const drains = shown(lone_loop(4, 1, false), 3, {0, 14});
    CHECK_THAT(drains, Contains("table 0-4 5-9 10-14\ntimeline 0-4 5-9 10-14 run 2 run 2 run 2\n"));
    CHECK_THAT(drains, Contains("sample.start 0:1 1:0 5:1 6:0 10:1 11:0\n"));
}

TEST_CASE("A loop that rewinds drains where no call follows at once") {
    // As if it did not rewind.
    CHECK_THAT(shown_in_turn(lone_loop(4, 1, true), 3, {0, 14}),
               Contains("table 0-4 5-9 10-14\ntimeline 0-4 5-9 10-14 run 2 run 2 run 2\n") &&
                   Contains("sample.start 0:1 1:0 5:1 6:0 10:1 11:0\n"));
    CHECK_THAT(shown_in_turn(lone_loop(2, 9, true), 3, {0, 40}),
               Contains("table 0-10 11-21 22-32\ntimeline 0-10 11-21 22-32 "));
    // It does something else in front of the loop.
    Parts lone = lone_loop(2, 9, true);
    lone.front().work = [](ProcessClock& clock, DataflowCore&) {
        clock.advance(1);
        clock.pipeline("run", 2);
    };
    CHECK_THAT(shown(lone, 3, {0, 40}), Contains("table 0-11 12-23 24-35\ntimeline 0-11 12-23 24-35 "));
    // So does the first of two modules: a call of it takes 1 + 9 + 3 cycles.
    Parts pair = pair_of_loops(1, 3, true);
    pair.front().work = [send = pair.front().work](ProcessClock& clock, DataflowCore& core) {
        clock.advance(1);
        send(clock, core);
    };
    CHECK_THAT(shown(pair, 3, {0, 60}), Contains("sample.start 0:1 1:0 13:1 14:0 26:1 27:0 "));
}

TEST_CASE("A call in which no cycle passes begins where the next one does") {
    CHECK_THAT(shown(lone_loop(4, 1, false, {0, 2, 0, 2}), 4, {0, 20}),
               Contains("table 0-0 0-4 5-4 5-9\ntimeline 0-0 0-4 5-4 5-9 run 2 run 2\n"));
    CHECK_THAT(shown(lone_loop(4, 1, true, {0, 2, 0, 2}), 4, {0, 20}), Contains("table 0-0 0-4 8-4 8-12\n"));
    // It ends in the last cycle of a window, behind which the one before it is over.
    Parts const parts = lone_loop(4, 1, false, {2, 0, 2});
    CHECK(shown(parts, 3, {1, 4}, Stretch{1, 4}) == shown(parts, 3, {1, 4}));
}

TEST_CASE("A window shows a loop that rewinds as the whole waveform does") {
    for (Parts const& parts : {lone_loop(4, 1, true), lone_loop(2, 9, true), pair_of_loops(4, 1, true),
                               pair_of_loops(1, 3, true), pair_of_loops(3, 20, true)})
        for (Stretch const window : {Stretch{1, 14}, Stretch{23, 26}, Stretch{30, 43}}) {
            CAPTURE(parts.front().module.name, window.from);
            CHECK(shown(parts, 6, window, window) == shown(parts, 6, window));
        }
}

TEST_CASE("An iteration that waits in its first step for ever has not begun") {
    // The writer gets stuck at its third token of `a`, for the reader waits for `b` first. In decoupled, its module has
    // got that.
    Part writer{ModuleDescription("writer"), {}}, reader{ModuleDescription("reader"), {}};
    writer.module.writes_to("a").of_bits(32);
    writer.module.writes_to("b").of_bits(32);
    writer.module.reads_from("c");
    reader.module.reads_from("a");
    reader.module.reads_from("b").taken("answer", 0);
    reader.module.writes_to("c").of_bits(32).leaves("answer", 1);
    reader.module.loop("answer").of_depth(2);
    writer.work = [](ProcessClock& clock, DataflowCore& core) {
        for (Token i = 0; i < 3; ++i, clock.advance(1))
            core.fifo<Token>("a").write(i);
        core.fifo<Token>("b").write(0);
        clock.advance(1);
        core.fifo<Token>("c").read();
        clock.advance(1);
    };
    reader.work = [](ProcessClock& clock, DataflowCore& core) {
        clock.pipeline("answer", 1, [&](std::uint64_t) { core.fifo<Token>("c").write(core.fifo<Token>("b").read()); });
        for (int i = 0; i < 3; ++i, clock.advance(1))
            core.fifo<Token>("a").read();
    };
    CHECK_THAT(shown({writer, reader}, 1, {0, 2}), Contains(" answer 0\n") && Contains("reader.state 0:1\n"));
}

TEST_CASE("Spans of the same cycles have an order, whoever is recorded first, and a loop is before its stalls") {
    using Kind = TimelineSpan::Kind;
    std::vector<TimelineSpan> spans{{1, Kind::empty_stall, 0, 63, 82},
                                    {1, Kind::loop, 2, 63, 82},
                                    {0, Kind::loop, 1, 63, 82},
                                    {1, Kind::loop, 2, 63, 90}};
    std::stable_sort(spans.begin(), spans.end(), recording::outermost_first);
    std::string order;
    for (TimelineSpan const& span : spans)
        order += std::to_string(span.module) + (span.kind == Kind::loop ? "l " : "s ");
    CHECK(order == "1l 0l 1l 1s ");
}

}  // namespace recordings_test
