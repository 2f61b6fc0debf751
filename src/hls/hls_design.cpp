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
                             "static constexpr unsigned bits = ... in it, which says how many those are, or " +
                             "template <> constexpr unsigned faster_bits<ITS TYPE> = ... behind it");
        if (stream->has_token())
            throw InputError("stream " + name + " holds a token before a process has begun, expected only processes " +
                             "to write it");
        stream->rename(name);
    }
    if (processes_.empty())
        throw InputError("the design has no process, expected process(NAME, FUNCTION) in its constructor");
}

namespace {

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
        core_.begin_live_call(sample);
        function_.run();
        if (auto const results = core_.end_live_call(sample, number_))
            add_result(*results);
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
        core_.require_described(number_, loop);
        std::uint64_t iterations = 0;
        std::size_t end = begin + 1;
        for (; script_->events[end].what == Event::What::iterate; ++end) {
            iterations += script_->events[end].count;
            require_described(loop.name, script_->events[end].number);
        }
        std::size_t at = begin + 1;
        std::uint64_t done = 0;  // of the event at hand
        auto const do_iteration = [&](std::uint64_t) {
            for (Access const& access : in_order_[script_->events[at].number])
                access.writes ? core_.stream_fifo(access.stream).write(next_token(access.stream)) : take(access.stream);
            if (++done == script_->events[at].count) {
                ++at;
                done = 0;
            }
        };
        clock_.pipeline(loop.name, iterations, do_iteration, {loop.file, loop.line});
        return end;
    }
    void require_described(char const* loop, std::size_t group) {
        if (!described_.emplace(loop, group).second)
            return;
        for (Access const& access : recorder().groups()[group])
            core_.require_described(number_, loop, access);
        put_in_order(group);
    }
    /// Of several streams that an iteration waits for, the description's order says which is named.
    void put_in_order(std::size_t group) {
        in_order_.resize(std::max(in_order_.size(), group + 1));
        in_order_[group] = recorder().groups()[group];
        std::sort(in_order_[group].begin(), in_order_[group].end(),
                  [this](Access const& one, Access const& other) { return port_of(one) < port_of(other); });
    }
    unsigned port_of(Access const& access) const {
        ClockedFifo<std::int64_t> const& fifo = core_.stream_fifo(access.stream);
        return (access.writes ? fifo.write_port() : fifo.read_port()).first();
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
    std::vector<Accesses> in_order_;                           // of those groups
};

}  // namespace

HlsCore::HlsCore(SimpleCoreParts const& parts, MakeHlsDesign const& make, HlsDescription const& description)
    : SimpleCore(parts),
      design_(make(parts.numbers)),
      network_(design_->processes(), description.around),
      next_call_(parts.share.first) {
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

void HlsCore::require_described(std::size_t process, LoopMark const& loop) const {
    for (std::size_t const number : machine().processes[process].loops)
        if (machine().loops[number].name == loop.name)
            return;
    throw InputError("process " + machine().processes[process].name + " runs its loop " + loop.name +
                     ", which it does not" + untimed::expected_defaults);
}

void HlsCore::require_described(std::size_t process, char const* loop, Access const& access, bool is_attempt) const {
    std::string const& stream = design_->streams()[access.stream]->name();
    if (!is_described(machine().processes[process], loop, machine().fifo(stream), access.writes, is_attempt))
        throw InputError("process " + machine().processes[process].name +
                         (is_attempt      ? " accesses"
                          : access.writes ? " writes"
                                          : " reads") +
                         " stream " + stream +
                         (!is_attempt     ? ""
                          : access.writes ? " by write_nb() or full()"
                                          : " by read_nb() or empty()") +
                         (loop != nullptr ? " in its loop " + std::string(loop) : "") + ", which it does not" +
                         untimed::expected_defaults);
}

bool HlsCore::is_described(MachineProcess const& process, char const* loop, std::size_t fifo, bool writes,
                           bool is_attempt) const {
    auto const is_end = [&](MachineEnd const& end) {
        return end.fifo == fifo && end.writes == writes && (!is_attempt || end.makes_attempts);
    };
    if (std::none_of(process.ends.begin(), process.ends.end(), is_end))
        return false;
    if (loop == nullptr)
        return true;
    for (std::size_t const number : process.loops) {
        MachineLoop const& one = machine().loops[number];
        std::vector<std::size_t> const& fifos = writes ? one.writes : one.reads;
        if (one.name == loop)
            return std::find(fifos.begin(), fifos.end(), fifo) != fifos.end();
    }
    return true;
}

/// Functions only run without time where the description has none that does not wait.
void HlsCore::require_described_attempts(std::size_t process) const {
    for (Access const& access : recorder(process).attempts())
        require_described(process, nullptr, access, true);
}

Counters HlsCore::results_of_design() const {
    try {
        return design_->results();
    } catch (...) {
        std::rethrow_exception(thrown_by("results() of the design", "its counters"));
    }
}

void HlsCore::run_call() {
    design_->set_call(next_call_++);
    network_.run();
    for (std::size_t i = 0; i < scripts_.size(); ++i)
        require_described_attempts(i);
    results_.push_back(results_of_design());
    network_.written().resize(fifos_.size());
    for (std::size_t i = 0; i < scripts_.size(); ++i) {
        HlsScript script{std::move(network_.events()[i]), std::vector<std::vector<std::int64_t>>(fifos_.size())};
        for (untimed::Accesses const& group : recorder(i).groups())
            for (Access const& access : group)
                if (access.writes)
                    script.written[access.stream] = network_.written()[access.stream];
        scripts_[i].push_back(std::move(script));
    }
}

HlsScript HlsCore::next_script(std::size_t process) {
    if (scripts_[process].empty()) {
        if (error_)
            std::rethrow_exception(error_);
        try {
            run_call();
        } catch (...) {
            error_ = std::current_exception();
            throw;
        }
    }
    HlsScript script = std::move(scripts_[process].front());
    scripts_[process].pop_front();
    return script;
}

void HlsCore::begin_live_call(std::size_t call) {
    design_->set_call(call);
    latest_call_ = std::max(latest_call_, call);
}

std::optional<Counters> HlsCore::end_live_call(std::size_t call, std::size_t process) {
    LiveCall& live = live_calls_[call];
    if (process + 1 == scripts_.size() || (live.results && latest_call_ == call))
        live.results = results_of_design();
    return ++live.functions_over == scripts_.size() ? live.results : std::nullopt;
}

Counters HlsCore::next_results() {
    Counters results = std::move(results_.front());
    results_.pop_front();
    return results;
}

}  // namespace dataflow
