#include <algorithm>

#include "dataflow/base/input_error.hpp"
#include "hls/hls_design.hpp"

namespace dataflow {

using untimed::Access;
using untimed::Accesses;
using untimed::Event;
using untimed::LoopMark;

namespace {

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
    std::set<Access> const& attempts() const { return recorder_.attempts(); }
    /// A loop that is not pipelined has a state of its own before its first iteration.
    bool has_start() const { return !begins_with_states_; }
    /// Not one that is only around others.
    bool is_run(std::size_t loop) const { return is_run_[loop]; }
    Accesses const& ends() const { return ends_; }
    /// Of the loops that make an access, the shallowest, whose stages it has; or none.
    std::size_t stage_giver(Access const& access) const {
        std::size_t giver = loops_.size();
        for (std::size_t i = 0; i < loops_.size(); ++i)
            if (is_run(i) && uses(i, access) && (giver == loops_.size() || loops_[i].depth < loops_[giver].depth))
                giver = i;
        return giver;
    }
    bool accesses(Access const& access) const { return std::find(ends_.begin(), ends_.end(), access) != ends_.end(); }
    bool uses(std::size_t loop, Access const& access) const {
        return recorder_.attempts_in(loop, access) ||
               std::find(used_in_[loop].begin(), used_in_[loop].end(), access) != used_in_[loop].end();
    }
    bool attempts_before_reads(std::size_t loop, Access const& access) const {
        return recorder_.attempts_before_reads(loop, access);
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
        network_.run_apart();
        for (std::size_t i = 0; i < design.processes().size(); ++i)
            processes_.emplace_back(network_.recorder(i), network_.events()[i]);
        for (std::size_t i = 0; i < processes_.size(); ++i)
            require_askers_access(i);
        for (untimed::StreamBase const* const stream : design.streams())
            require_used(*stream);
    }

    HlsDescription description() const {
        std::vector<ModuleDescription> modules;
        std::vector<untimed::LoopNames> around;
        for (std::size_t i = 0; i < processes_.size(); ++i) {
            modules.push_back(module(i));
            around.push_back(network_.recorder(i).around());
        }
        return {core_of(std::move(modules)), std::move(around)};
    }

  private:
    std::string const& name(std::size_t process) const { return design_.processes()[process].name; }
    std::string const& fifo(Access const& access) const { return design_.streams()[access.stream]->name(); }

    /// Only the reader of a stream sees whether it is empty, and only its writer whether it is full. One that has not
    /// come to read it, as it has found nothing when it asked, is not known to be its reader.
    void require_askers_access(std::size_t process) const {
        for (Access const& access : processes_[process].attempts()) {
            if (processes_[process].accesses(access))
                continue;
            std::string const asks = "process " + name(process) + " asks stream " + fifo(access) + " by " +
                                     (access.writes ? "full()" : "empty()");
            for (std::size_t other = 0; other < processes_.size(); ++other)
                if (processes_[other].accesses(access))
                    throw InputError(asks + ", expected only process " + name(other) + " to, which " +
                                     (access.writes ? "writes it" : "reads it"));
            throw InputError(asks + " and does not come to " + (access.writes ? "write" : "read") +
                             " it, as the run for the description, without time, finds nothing there, expected " +
                             (access.writes ? "write_nb(), which is a write" : "read_nb(), which is a read") +
                             " also where it finds nothing, or a loop that asks until it finds something");
        }
    }

    void require_used(untimed::StreamBase const& stream) const {
        bool const is_read = is_accessed({stream.number(), false});
        bool const is_written = is_accessed({stream.number(), true});
        if (is_read && is_written)
            return;
        std::string const& waiting = network_.waiting();
        throw InputError("stream " + stream.name() + " of the design is not " +
                         (is_read      ? "written"
                          : is_written ? "read"
                                       : "used") +
                         (waiting.empty() ? "" : ", as without time " + waiting + " for ever,") +
                         untimed::expected_defaults);
    }
    bool is_accessed(Access const& access) const {
        return std::any_of(processes_.begin(), processes_.end(),
                           [&access](DiscoveredProcess const& process) { return process.accesses(access); });
    }

    ModuleDescription module(std::size_t number) const {
        DiscoveredProcess const& process = processes_[number];
        ModuleDescription module(name(number), SourceSite());  // not a line of ours
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
        end.may_keep_tokens = design_.may_keep_tokens(stream);
        end.makes_attempts = process.attempts(access);
        if (is_in_loop)
            end.leaves(process.loops()[giver].name, write_stage(process, giver, access));
    }

    /// The last one; of a write that does not wait, one that is over when the next iteration begins to access anything,
    /// and no later than what the body reads behind it.
    static unsigned write_stage(DiscoveredProcess const& process, std::size_t loop, Access const& access) {
        if (process.attempts_before_reads(loop, access))
            return 0;
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

}  // namespace

HlsDescription describe_hls_functions(SimpleFacts const& facts, MakeHlsDesign const& make) {
    Numbers defaults;
    for (DesignNumber const& number : facts.numbers)
        defaults.of(number.key) = number.otherwise;
    defaults.of("workload.samples") = 1;
    std::unique_ptr<HlsDesign> const design = make(defaults);
    return Describer(*design).description();
}

CoreDescription describe_hls_design(SimpleFacts const& facts, MakeHlsDesign const& make) {
    return describe_hls_functions(facts, make).core;
}

}  // namespace dataflow
