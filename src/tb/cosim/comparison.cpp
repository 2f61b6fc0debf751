#include "tb/cosim/comparison.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <utility>

#include "dataflow/base/host_clock.hpp"
#include "dataflow/tools/recording/event_merge.hpp"
#include "dataflow/tools/recording/vcd_file.hpp"
#include "dataflow/tools/recording/write_waveform.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::rtl {

namespace {

using Kind = recording::Event::Kind;

/// Longer than any pipeline of the twin.
constexpr Cycles quiet_cycles = 1000;
constexpr Cycles told_cycles = 0x10000;
constexpr std::size_t history_cycles = 8;
/// Of a waveform around a difference.
constexpr Cycles cycles_before = 100;
constexpr Cycles cycles_after = 100;

/// What one side does in a cycle: accesses and, of writes, the tokens.
struct Accesses {
    std::uint32_t writes = 0;
    std::uint32_t reads = 0;
    std::array<recording::TokenValues, twin_fifos.size()> tokens;
};

std::string token_text(std::vector<TokenField> const& layout, recording::TokenValues const& values) {
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i)
        text += fmt::format("{}{} {}", i == 0 ? "" : ", ", layout[i].name, values[i]);
    return text;
}

class Comparison {
  public:
    Comparison(recording::RecordedCore const& model, KeptMaps const& maps, TwinSettings const& settings,
               Stimulus const& stimulus, CoreShare share, std::function<void(Cycles)> const& progress)
        : model_(model),
          progress_(progress),
          maps_(maps),
          settings_(settings),
          twin_(make_twin(settings, stimulus, share.first, share.count)),
          built_(share.first),
          drawn_(share.first),
          model_tokens_(model.machine->fifos.size()),
          twin_tokens_(model.machine->fifos.size()) {
        number_of_.assign(model.machine->fifos.size(), twin_fifos.size());
        for (std::size_t i = 0; i < twin_fifos.size(); ++i) {
            machine_number_of_.push_back(model.machine->fifo(twin_fifos[i]));
            number_of_[machine_number_of_.back()] = i;
            layouts_.push_back(model.token_layouts[machine_number_of_.back()]);
        }
    }

    Compared run() {
        recording::for_each_event({{model_.core, model_.spools}},
                                  [this](recording::CoreEvent const& event) { take(event); });
        for (Cycles i = 0; i <= quiet_cycles && !is_over(); ++i)
            take_cycle();
        keep_waveforms();
        return std::move(compared_);
    }

  private:
    void take(recording::CoreEvent const& event) {
        bool const writes = event.event.kind == Kind::write;
        if (!writes && event.event.kind != Kind::read)
            return;
        while (compared_.cycles < event.event.cycle && !is_over())
            take_cycle();
        if (is_over())
            return;
        std::size_t const fifo = number_of_[event.event.item];
        (writes ? expected_.writes : expected_.reads) |= 1U << fifo;
        if (writes)
            expected_.tokens[fifo] = *event.fields;
    }

    /// Both have gone far enough behind a difference.
    bool is_over() const {
        return compared_.difference && compared_.cycles > compared_.difference->cycle + cycles_after;
    }

    void take_cycle() {
        std::uint32_t const writes = twin_->writes();
        std::uint32_t const reads = twin_->reads();
        if ((writes | reads | expected_.writes | expected_.reads) != 0)
            take_accesses(writes, reads);
        if (!compared_.difference)
            compare_maps();
        expected_.writes = expected_.reads = 0;
        auto const start = HostClock::now();
        twin_->step();
        compared_.twin_seconds += seconds_since(start);
        ++compared_.cycles;
        if (progress_ && compared_.cycles % told_cycles == 0)
            progress_(compared_.cycles);
    }

    void take_accesses(std::uint32_t writes, std::uint32_t reads) {
        for (std::size_t fifo = 0; fifo < twin_fifos.size(); ++fifo) {
            keep(model_tokens_, fifo, expected_.writes, expected_.reads, expected_.tokens[fifo]);
            keep(twin_tokens_, fifo, writes, reads,
                 (writes >> fifo & 1U) != 0 ? written(fifo) : recording::TokenValues{});
        }
        if (!compared_.difference)
            compare_accesses(writes, reads);
    }

    void keep(RecentTokens& tokens, std::size_t fifo, std::uint32_t writes, std::uint32_t reads,
              recording::TokenValues const& token) const {
        if ((reads >> fifo & 1U) != 0)
            tokens.read(machine_number_of_[fifo], compared_.cycles);
        if ((writes >> fifo & 1U) != 0)
            tokens.write(machine_number_of_[fifo], compared_.cycles, token);
    }

    void keep_waveforms() {
        if (!compared_.difference)
            return;
        Cycles const cycle = compared_.difference->cycle;
        compared_.difference->from = cycle - std::min(cycle, cycles_before);
        compared_.difference->to = cycle + cycles_after;
        compared_.difference->model = std::move(model_tokens_);
        compared_.difference->twin = std::move(twin_tokens_);
    }

    void compare_accesses(std::uint32_t writes, std::uint32_t reads) {
        remember(writes, reads);
        for (std::size_t fifo = 0; fifo < twin_fifos.size() && !compared_.difference; ++fifo) {
            std::uint32_t const bit = 1U << fifo;
            if (((writes ^ expected_.writes) & bit) != 0)
                differs(fifo, "writes", (expected_.writes & bit) != 0 ? expected_.tokens[fifo] : written(fifo),
                        (writes & bit) != 0);
            else if (((reads ^ expected_.reads) & bit) != 0)
                differs(fifo, "reads", {}, (reads & bit) != 0);
            else if ((writes & bit) != 0 && written(fifo) != expected_.tokens[fifo])
                differ(fmt::format("FIFO {}: the model writes ({}), the twin ({})", twin_fifos[fifo],
                                   token_text(layouts_[fifo], expected_.tokens[fifo]),
                                   token_text(layouts_[fifo], written(fifo))));
            compared_.writes += (writes & bit) != 0 ? 1 : 0;
            compared_.reads += (reads & bit) != 0 ? 1 : 0;
        }
    }

    void differs(std::size_t fifo, char const* accesses, recording::TokenValues const& token, bool by_twin) {
        std::string const what =
            token.empty() ? accesses : fmt::format("{} ({})", accesses, token_text(layouts_[fifo], token));
        differ(fmt::format("FIFO {}: the {} {}, the {} does not", twin_fifos[fifo], by_twin ? "twin" : "model", what,
                           by_twin ? "model" : "twin"));
    }

    recording::TokenValues written(std::size_t fifo) const {
        recording::TokenValues values(layouts_[fifo].size());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = twin_->field(fifo, i);
        return values;
    }

    void differ(std::string what) {
        compared_.difference.emplace();
        compared_.difference->cycle = compared_.cycles;
        compared_.difference->what = std::move(what);
        compared_.difference->history.assign(history_.begin(), history_.end());
    }

    void remember(std::uint32_t writes, std::uint32_t reads) {
        if (history_.size() == history_cycles)
            history_.pop_front();
        history_.push_back(fmt::format("cycle {}: model {}; twin {}", compared_.cycles,
                                       names(expected_.writes, expected_.reads), names(writes, reads)));
    }

    static std::string names(std::uint32_t writes, std::uint32_t reads) {
        std::string text;
        for (std::size_t fifo = 0; fifo < twin_fifos.size(); ++fifo) {
            if ((reads >> fifo & 1U) != 0)
                text += fmt::format("{}reads {}", text.empty() ? "" : ", ", twin_fifos[fifo]);
            if ((writes >> fifo & 1U) != 0)
                text += fmt::format("{}writes {}", text.empty() ? "" : ", ", twin_fifos[fifo]);
        }
        return text.empty() ? "-" : text;
    }

    void compare_maps() {
        if (twin_->maps_are_built()) {
            SampleMaps const* const maps = maps_.of(built_++);
            if (!settings_.is_inner_border)  // else there is no such memory
                compare_map("edge_map", maps ? maps->edge_map.pixels() : std::vector<std::uint8_t>{},
                            twin_->edge_map());
            compare_map("object_map", maps ? maps->object_map.pixels() : std::vector<std::uint8_t>{},
                        twin_->object_map());
        }
        if (twin_->depth_buffer_is_drawn()) {
            SampleMaps const* const maps = maps_.of(drawn_++);
            compare_map("depth_buffer", maps ? maps->depth_buffer.pixels() : std::vector<std::uint16_t>{},
                        twin_->depth_buffer());
        }
    }

    template <class Word>
    void compare_map(char const* name, std::vector<Word> const& expected, std::vector<Word> const& found) {
        if (compared_.difference || expected.empty())  // the model did not get there: its tokens will tell
            return;
        ++compared_.maps;
        auto const at = std::mismatch(expected.begin(), expected.end(), found.begin(), found.end());
        if (at.first == expected.end())
            return;
        auto const pixel = static_cast<std::size_t>(at.first - expected.begin());
        differ(fmt::format("memory {}, row {}, column {}: the model has {}, the twin {}", name,
                           pixel / settings_.window, pixel % settings_.window, *at.first, *at.second));
    }

    recording::RecordedCore const& model_;
    std::function<void(Cycles)> const& progress_;
    KeptMaps const& maps_;
    TwinSettings const& settings_;
    std::unique_ptr<TwinCore> twin_;
    std::size_t built_;  ///< the sample whose maps come next
    std::size_t drawn_;
    std::vector<std::size_t> number_of_;          ///< in the twin, by the machine's number
    std::vector<std::size_t> machine_number_of_;  ///< by the twin's
    std::vector<std::vector<TokenField>> layouts_;
    Accesses expected_;
    std::deque<std::string> history_;
    RecentTokens model_tokens_;
    RecentTokens twin_tokens_;
    Compared compared_;
};

}  // namespace

/// A token that was read stays for a while, as what was read last can be seen until the next is.
void RecentTokens::read(std::size_t fifo, Cycles cycle) {
    std::deque<Token>& tokens = tokens_[fifo];
    auto const oldest = std::find_if(tokens.begin(), tokens.end(), [](Token const& token) { return !token.read; });
    if (oldest == tokens.end())
        throw std::logic_error("a read of an empty FIFO");
    oldest->read = cycle;
    while (tokens.size() > 1 && tokens[1].read && *tokens[1].read + kept_cycles < cycle)
        tokens.pop_front();
}

recording::Spools RecentTokens::spools_of(Machine const& machine) const {
    std::vector<std::vector<recording::Event>> events(machine.processes.size());
    for (std::size_t fifo = 0; fifo < tokens_.size(); ++fifo)
        for (Token const& token : tokens_[fifo]) {
            auto const number = static_cast<std::uint32_t>(fifo);
            std::vector<recording::Event>& writes = events[machine.fifos[fifo].writer];
            for (std::size_t i = 0; i < token.values.size(); ++i)
                writes.push_back(
                    recording::event_at(token.written, i == 0 ? Kind::write : Kind::field, number, token.values[i]));
            if (token.read)
                events[machine.fifos[fifo].reader].push_back(recording::event_at(*token.read, Kind::read, number));
        }
    recording::Spools spools;
    spools.processes.resize(events.size());
    for (std::size_t process = 0; process < events.size(); ++process) {
        std::stable_sort(events[process].begin(), events[process].end(),
                         [](auto const& a, auto const& b) { return a.cycle < b.cycle; });
        for (recording::Event const& event : events[process])
            spools.processes[process].put(event);
        spools.processes[process].rewind();
    }
    return spools;
}

void RecentTokens::write_vcd(std::filesystem::path const& file, recording::RecordedCore const& core, Cycles from,
                             Cycles to) const {
    recording::Spools spools = spools_of(*core.machine);
    recording::RecordedCore shown = core;
    shown.from = from;
    shown.to = to;
    shown.memory_activity = nullptr;
    shown.spools = &spools;
    recording::RecordedWindow window;
    window.cores.push_back(shown);
    recording::WaveformFiles files;
    files.push_back(std::make_unique<recording::VcdFile>(file, core.machine->clock_mhz));
    recording::write_waveform(files, *core.machine, window, recording::SignalFilter::fifos(*core.machine));
}

Compared compare(recording::RecordedCore const& model, KeptMaps const& maps, TwinSettings const& settings,
                 Stimulus const& stimulus, CoreShare share, std::function<void(Cycles)> const& progress) {
    return Comparison(model, maps, settings, stimulus, share, progress).run();
}

}  // namespace faster::rtl
