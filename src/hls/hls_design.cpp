#include "hls/hls_design.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "dataflow/base/input_error.hpp"
#include "hls/live_function.hpp"

namespace dataflow {

using untimed::Access;
using untimed::Accesses;
using untimed::Event;
using untimed::LoopMark;

void HlsDesign::complete() {
    untimed::streams_of_design = nullptr;
    if (std::count(streams_.begin(), streams_.end(), nullptr) > 0)
        throw InputError("a stream of the design is gone when its constructor ends, expected streams as members");
    for (untimed::StreamBase* const stream : streams_) {
        std::string name = stream->name().empty() ? "stream" + std::to_string(stream->number()) : stream->name();
        for (char& letter : name)
            if (std::isalnum(static_cast<unsigned char>(letter)) == 0)
                letter = '_';
        if (std::any_of(streams_.begin(), streams_.end(), [&](untimed::StreamBase const* other) {
                return other->number() < stream->number() && other->name() == name;
            }))
            throw InputError("two streams of the design have the name " + name + ", expected another for one of them");
        if (std::any_of(processes_.begin(), processes_.end(),
                        [&](untimed::ProcessCall const& process) { return process.name == name; }))
            throw InputError("a stream and a process of the design have the name " + name +
                             ", expected another for one of them");
        if (stream->bits() == 0)
            throw InputError("stream " + name + " carries a struct, whose memory is more than its wires, expected " +
                             "static constexpr unsigned bits = ... in it, which says how many those are");
        stream->rename(name);
    }
    if (processes_.empty())
        throw InputError("the design has no process, expected process(NAME, FUNCTION) in its constructor");
}

namespace {

constexpr char const* expected_defaults =
    " with the defaults of the design's numbers, expected defaults that make it use all of its loops and streams";

/// A token's value, as wide as the type of its stream says.
class HlsFifo final : public ClockedFifo<std::int64_t> {
  public:
    HlsFifo(untimed::StreamBase const& stream, timing::FifoTiming& timing)
        : ClockedFifo(stream.name().c_str(), timing),
          bits_(std::min(64U, stream.bits())),
          is_signed_(stream.is_signed()) {}
    std::vector<TokenField> token_fields() const override { return {{"value", bits_, is_signed_}}; }

  private:
    unsigned bits_;
    bool is_signed_;
};

/// What one function has shown of itself.
class DiscoveredProcess {
  public:
    DiscoveredProcess(untimed::LoopRecorder const& recorder, untimed::Events const& events)
        : recorder_(recorder), loops_(recorder.loops()) {
        used_in_.resize(loops_.size());
        is_run_.resize(loops_.size());
        begins_with_states_ =
            !events.empty() && events[0].what == Event::What::enter && is_entered(loops_[events[0].number]);
        std::size_t loop = 0;
        for (Event const& event : events) {
            if (event.what == Event::What::enter)
                is_run_[loop = event.number] = true;
            else if (event.what != Event::What::leave)
                for (Access const& access : recorder.groups()[event.number]) {
                    add(ends_, access);
                    if (event.what == Event::What::iterate)
                        add(used_in_[loop], access);
                }
        }
    }

    std::vector<LoopMark> const& loops() const { return loops_; }
    bool attempts(Access const& access) const { return recorder_.attempts(access); }
    /// A loop that is not pipelined has a state of its own before its first iteration.
    bool has_start() const { return !begins_with_states_; }
    /// Not one that is only around others.
    bool is_run(std::size_t loop) const { return is_run_[loop]; }
    Accesses const& ends() const { return ends_; }
    /// Of the loops that make an access, the shallowest, whose stages it has; or none.
    std::size_t stage_giver(Access const& access) const {
        std::size_t giver = loops_.size();
        for (std::size_t i = 0; i < loops_.size(); ++i)
            if (uses(i, access) && (giver == loops_.size() || loops_[i].depth < loops_[giver].depth))
                giver = i;
        return giver;
    }
    bool uses(untimed::StreamBase const& stream) const {
        return std::any_of(ends_.begin(), ends_.end(),
                           [&stream](Access const& access) { return access.stream == stream.number(); });
    }
    bool uses(std::size_t loop, Access const& access) const {
        return std::find(used_in_[loop].begin(), used_in_[loop].end(), access) != used_in_[loop].end();
    }

  private:
    /// In a state before its first iteration.
    static bool is_entered(LoopMark const& loop) { return !loop.is_pipelined && !loop.is_block(); }
    static void add(Accesses& accesses, Access const& access) {
        if (std::find(accesses.begin(), accesses.end(), access) == accesses.end())
            accesses.push_back(access);
    }

    untimed::LoopRecorder const& recorder_;
    std::vector<LoopMark> const& loops_;
    bool begins_with_states_ = false;
    std::vector<bool> is_run_;
    std::vector<Accesses> used_in_;  // by loop
    Accesses ends_;
};

class Describer {
  public:
    explicit Describer(HlsDesign& design) : design_(design), network_(design.processes()) {
        network_.run();
        for (std::size_t i = 0; i < design.processes().size(); ++i)
            processes_.emplace_back(network_.recorder(i), network_.events()[i]);
        for (untimed::StreamBase const* const stream : design.streams())
            if (std::none_of(processes_.begin(), processes_.end(),
                             [stream](DiscoveredProcess const& process) { return process.uses(*stream); }))
                throw InputError("stream " + stream->name() + " of the design is not used" + expected_defaults);
    }

    CoreDescription core() const {
        std::vector<ModuleDescription> modules;
        for (std::size_t i = 0; i < processes_.size(); ++i)
            modules.push_back(module(i));
        return core_of(std::move(modules));
    }

  private:
    std::string const& name(std::size_t process) const { return design_.processes()[process].name; }
    std::string const& fifo(Access const& access) const { return design_.streams()[access.stream]->name(); }

    ModuleDescription module(std::size_t number) const {
        DiscoveredProcess const& process = processes_[number];
        ModuleDescription module(name(number));
        for (Access const& access : process.ends())
            add_end(module, process, access);
        for (std::size_t i = 0; i < process.loops().size(); ++i)
            if (process.is_run(i))
                add_loop(module, process, i);
        if (process.has_start()) {
            SetupDescription start;
            start.meaning = "Cycles from the begin of a call to its first access or loop: in one it starts.";
            start.activity = "starting";
            if (!module.loops.empty())
                start.before_loop = module.loops.front().name;
            module.setup = start;
        }
        return module;
    }

    void add_end(ModuleDescription& module, DiscoveredProcess const& process, Access const& access) const {
        std::size_t const giver = process.stage_giver(access);
        bool const is_in_loop = giver < process.loops().size();
        if (!access.writes) {
            FifoEnd& end = module.reads_from(fifo(access));
            end.makes_attempts = process.attempts(access);
            if (is_in_loop)
                end.taken(process.loops()[giver].name, 0);
            return;
        }
        untimed::StreamBase const& stream = *design_.streams()[access.stream];
        FifoEnd& end = module.writes_to(stream.name()).of_bits(stream.bits());
        end.carries("tokens from " + module.name + " to " + reader_of(access.stream));
        if (stream.depth() > 0)
            end.of_depth(stream.depth());
        end.makes_attempts = process.attempts(access);
        if (is_in_loop)
            end.leaves(process.loops()[giver].name, write_stage(process, giver, access));
    }

    /// The last one; of a write that does not wait, one that is over when the next iteration begins to access anything.
    static unsigned write_stage(DiscoveredProcess const& process, std::size_t loop, Access const& access) {
        LoopMark const& mark = process.loops()[loop];
        bool const only_writes = std::none_of(process.ends().begin(), process.ends().end(), [&](Access const& end) {
            return !end.writes && process.uses(loop, end);
        });
        bool const is_early = process.attempts(access) && !only_writes && !mark.is_block();
        return std::min(mark.depth, is_early ? mark.ii : mark.depth) - 1;
    }

    std::string reader_of(std::size_t stream) const {
        for (std::size_t i = 0; i < processes_.size(); ++i)
            for (Access const& access : processes_[i].ends())
                if (access.stream == stream && !access.writes)
                    return name(i);
        return "nobody";
    }

    void add_loop(ModuleDescription& module, DiscoveredProcess const& process, std::size_t number) const {
        LoopMark const& mark = process.loops()[number];
        LoopDescription& loop = module.loop(mark.name);
        if (mark.is_pipelined)
            loop.does("is pipelined").of_depth(mark.depth).of_ii(mark.ii);
        else
            loop.does("is not pipelined").of_states(mark.depth);
        if (mark.is_block())
            loop.does("takes its states").enters_in(0).leaves_in(0);
        std::vector<std::string> writes;
        std::vector<std::string> reads;
        for (Access const& access : process.ends())
            if (process.uses(number, access) && process.stage_giver(access) != number)
                (access.writes ? writes : reads).push_back(fifo(access));
        loop.writes_to(writes).also_reads(reads);
    }

    HlsDesign& design_;
    untimed::UntimedNetwork network_;
    std::vector<DiscoveredProcess> processes_;
};

/// Of a design whose functions find something or nothing, as it comes: each runs beside its clock.
class LiveModule : public SimpleModule {
  public:
    LiveModule(sc_core::sc_module_name const& name, HlsCore& core, std::size_t number)
        : SimpleModule(name, core), core_(core), number_(number), function_(core, clock_, number) {
        set_stack_size(as_of_a_thread);
    }

  private:
    static constexpr std::size_t as_of_a_thread = std::size_t{8} << 20U;  ///< room for a function's arrays

    void work(std::size_t sample) override {
        if (!core_.machine().processes[number_].setup_activity.empty())
            clock_.set_up();
        core_.live_design().set_call(sample);
        function_.run();
        if (number_ + 1 == core_.design().processes().size())
            add_result(core_.design().results());
    }

    HlsCore& core_;
    std::size_t number_;
    LiveFunction function_;
};

/// Tells its clock what its function has done.
class HlsModule : public SimpleModule {
  public:
    HlsModule(sc_core::sc_module_name const& name, HlsCore& core, std::size_t number)
        : SimpleModule(name, core), core_(core), number_(number) {}

  private:
    untimed::LoopRecorder const& recorder() const { return core_.recorder(number_); }
    MachineProcess const& process() const { return core_.machine().processes[number_]; }

    void work(std::size_t /*sample*/) override {
        HlsScript const script = core_.next_script(number_);
        script_ = &script;
        written_.assign(script.written.size(), 0);
        if (!process().setup_activity.empty())
            clock_.set_up();
        for (std::size_t i = 0; i < script.events.size(); ++i) {
            Event const& event = script.events[i];
            if (event.what == Event::What::enter)
                i = run_loop(i);
            else
                do_step(event.number);
        }
        if (number_ + 1 == core_.design().processes().size())
            add_result(core_.next_results());
    }

    /// Returns the event that leaves it.
    std::size_t run_loop(std::size_t begin) {
        LoopMark const& loop = recorder().loops()[script_->events[begin].number];
        require_described(loop);
        std::uint64_t iterations = 0;
        std::size_t end = begin + 1;
        for (; script_->events[end].what == Event::What::iterate; ++end) {
            iterations += script_->events[end].count;
            require_described(loop.name, script_->events[end].number);
        }
        std::size_t at = begin + 1;
        std::uint64_t done = 0;  // of the event at hand
        clock_.pipeline(loop.name, iterations, [&](std::uint64_t) {
            for (Access const& access : recorder().groups()[script_->events[at].number])
                access.writes ? core_.stream_fifo(access.stream).write(next_token(access.stream)) : take(access.stream);
            if (++done == script_->events[at].count) {
                ++at;
                done = 0;
            }
        });
        return end;
    }
    void require_described(LoopMark const& loop) const {
        for (std::size_t const number : process().loops)
            if (core_.machine().loops[number].name == loop.name)
                return;
        throw InputError("process " + process().name + " runs its loop " + loop.name + ", which it does not" +
                         expected_defaults);
    }
    void require_described(char const* loop, std::size_t group) {
        if (described_.emplace(loop, group).second)
            for (Access const& access : recorder().groups()[group])
                core_.require_described(number_, loop, access);
    }
    void take(std::size_t stream) {
        clock_.take_later(core_.stream_fifo(stream), [](std::int64_t) {});
    }

    void do_step(std::size_t group) {
        require_described(nullptr, group);
        Access const& access = recorder().groups()[group].front();
        if (access.writes)
            core_.stream_fifo(access.stream).write(next_token(access.stream));
        else
            core_.stream_fifo(access.stream).read();
        clock_.advance(1);
    }

    std::int64_t next_token(std::size_t stream) { return script_->written[stream][written_[stream]++]; }

    HlsCore& core_;
    std::size_t number_;
    HlsScript const* script_ = nullptr;
    std::vector<std::size_t> written_;                         // of the call at hand, by stream
    std::set<std::pair<char const*, std::size_t>> described_;  // loops, or none, and groups of accesses in them
};

}  // namespace

CoreDescription describe_hls_design(SimpleFacts const& facts, MakeHlsDesign const& make) {
    Numbers defaults;
    for (DesignNumber const& number : facts.numbers)
        defaults.of(number.key) = number.otherwise;
    defaults.of("workload.samples") = 1;
    std::unique_ptr<HlsDesign> const design = make(defaults);
    return Describer(*design).core();
}

HlsCore::HlsCore(SimpleCoreParts const& parts, MakeHlsDesign const& make)
    : SimpleCore(parts), design_(make(parts.numbers)), network_(design_->processes()), next_call_(parts.share.first) {
    for (untimed::StreamBase const* const stream : design_->streams())
        fifos_.push_back(std::make_unique<HlsFifo>(*stream, fifo_timing(stream->name())));
    bool const is_live = makes_attempts(machine());
    for (std::size_t i = 0; i < design_->processes().size(); ++i) {
        char const* const name = design_->processes()[i].name.c_str();
        is_live ? void(make_module<LiveModule>(name, *this, i)) : void(make_module<HlsModule>(name, *this, i));
    }
    scripts_.resize(design_->processes().size());
}

HlsCore::~HlsCore() = default;

void HlsCore::require_described(std::size_t process, char const* loop, Access const& access) const {
    std::string const& stream = design_->streams()[access.stream]->name();
    if (!is_described(machine().processes[process], loop, machine().fifo(stream), access.writes))
        throw InputError("process " + machine().processes[process].name + (access.writes ? " writes" : " reads") +
                         " stream " + stream + (loop != nullptr ? " in its loop " + std::string(loop) : "") +
                         ", which it does not" + expected_defaults);
}

/// A loop that only reads, in the first stage, need not say what.
bool HlsCore::is_described(MachineProcess const& process, char const* loop, std::size_t fifo, bool writes) const {
    auto const is_end = [&](MachineEnd const& end) { return end.fifo == fifo && end.writes == writes; };
    if (std::none_of(process.ends.begin(), process.ends.end(), is_end))
        return false;
    if (loop == nullptr)
        return true;
    for (std::size_t const number : process.loops) {
        MachineLoop const& one = machine().loops[number];
        std::vector<std::size_t> const& fifos = writes ? one.writes : one.reads;
        if (one.name == loop)
            return std::find(fifos.begin(), fifos.end(), fifo) != fifos.end() ||
                   (!writes && one.writes.empty() && one.reads.empty());
    }
    return true;
}

void HlsCore::run_call() {
    design_->set_call(next_call_++);
    network_.run();
    network_.written().resize(fifos_.size());
    for (std::size_t i = 0; i < scripts_.size(); ++i) {
        HlsScript script{std::move(network_.events()[i]), std::vector<std::vector<std::int64_t>>(fifos_.size())};
        for (untimed::Accesses const& group : recorder(i).groups())
            for (Access const& access : group)
                if (access.writes)
                    script.written[access.stream] = network_.written()[access.stream];
        scripts_[i].push_back(std::move(script));
    }
    results_.push_back(design_->results());
}

HlsScript HlsCore::next_script(std::size_t process) {
    if (scripts_[process].empty())
        run_call();
    HlsScript script = std::move(scripts_[process].front());
    scripts_[process].pop_front();
    return script;
}

Counters HlsCore::next_results() {
    Counters results = std::move(results_.front());
    results_.pop_front();
    return results;
}

}  // namespace dataflow
