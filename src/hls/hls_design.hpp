#pragma once
// Everything that a program for functions over hls::stream includes; docs/tutorial.md writes one.
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <hls_stream.h>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/as_mistake.hpp"
#include "dataflow/commands/simple_tool.hpp"
#include "hls/untimed_network.hpp"

namespace dataflow {

/// A design whose processes are functions over hls::stream, as they go through an HLS tool. The derived class has the
/// streams between them as members and says in its constructor which functions run:
///
///     struct Pair : HlsDesign {
///         hls::stream<int> number{"number"};
///         int sum = 0;
///         explicit Pair(Numbers const& numbers) {
///             auto const n = static_cast<int>(numbers["workload.numbers"]);
///             process("producer", [=] { producer(number, n); });
///             process("consumer", [=] { sum = consumer(number, n); });
///         }
///         Counters results() const override { return {static_cast<std::uint64_t>(sum)}; }
///         static SimpleFacts facts();
///     };
///
/// The functions are run without time. What they do in which loops is the design's description, once, with the
/// defaults of its numbers, and then decides what its modules tell their clocks, call by call. The first process begins
/// a call, the last one ends it; a call is a sample.
class HlsDesign {
  public:
    HlsDesign(HlsDesign const&) = delete;
    HlsDesign& operator=(HlsDesign const&) = delete;
    virtual ~HlsDesign() {
        if (untimed::streams_of_design == &streams_)  // its constructor has thrown
            untimed::streams_of_design = nullptr;
    }

    /// What came out of the call that has ended: the counters of facts().
    virtual Counters results() const { return {}; }

    std::vector<untimed::ProcessCall> const& processes() const { return processes_; }
    std::vector<untimed::StreamBase*> const& streams() const { return streams_; }
    bool may_keep_tokens(untimed::StreamBase const& stream) const { return keeping_.count(&stream) != 0; }
    void set_call(std::uint64_t number) { call_ = number; }
    /// Streams without a name get one, and all are made fit for keys. Once it is constructed. Errors: InputError
    void complete();

  protected:
    HlsDesign() { untimed::streams_of_design = &streams_; }
    void process(std::string name, std::function<void()> function) {
        processes_.push_back({std::move(name), std::move(function)});
    }
    /// Tokens may be left in the stream at the end of a run, which warns of them; otherwise they are an error.
    void keeps_tokens(untimed::StreamBase const& stream) { keeping_.insert(&stream); }
    /// The number of the call at hand, from 0 on.
    std::uint64_t call() const { return call_; }

  private:
    std::vector<untimed::ProcessCall> processes_;
    std::vector<untimed::StreamBase*> streams_;
    std::set<untimed::StreamBase const*> keeping_;
    std::uint64_t call_ = 0;
};

using MakeHlsDesign = std::function<std::unique_ptr<HlsDesign>(Numbers const& numbers)>;

template <class Design> std::unique_ptr<HlsDesign> make_hls_design(Numbers const& numbers) {
    try {
        auto design = std::make_unique<Design>(numbers);
        design->complete();
        return design;
    } catch (...) {
        std::rethrow_exception(thrown_by("the constructor of design " + Design::facts().name, "one that returns"));
    }
}

/// What the functions of a design do with the defaults of its numbers.
struct HlsDescription {
    CoreDescription core;
    /// By process: loops that only say where others end. `core` does not have them.
    std::vector<untimed::LoopNames> around;
};
HlsDescription describe_hls_functions(SimpleFacts const& facts, MakeHlsDesign const& make);
/// Its core alone.
CoreDescription describe_hls_design(SimpleFacts const& facts, MakeHlsDesign const& make);

/// What one process does in one call.
struct HlsScript {
    untimed::Events events;
    std::vector<std::vector<std::int64_t>> written;  ///< tokens, by stream
};

/// A core: the FIFOs of the design's streams, and a module for each of its functions.
class HlsCore : public SimpleCore {
  public:
    HlsCore(SimpleCoreParts const& parts, MakeHlsDesign const& make, HlsDescription const& description);
    ~HlsCore() override;

    HlsDesign const& design() const { return *design_; }
    untimed::LoopRecorder const& recorder(std::size_t process) const { return network_.recorder(process); }
    ClockedFifo<std::int64_t>& stream_fifo(std::size_t stream) const { return *fifos_[stream]; }
    /// Throws InputError if the description does not have it.
    void require_described(std::size_t process, untimed::LoopMark const& loop) const;
    /// `loop`: null outside loops
    void require_described(std::size_t process, char const* loop, untimed::Access const& access,
                           bool is_attempt = false) const;
    /// What a process does in its next call. All functions run for the first that asks.
    HlsScript next_script(std::size_t process);
    /// The results of the calls, in their order.
    Counters next_results();

    // Of functions that run beside their clocks.
    void begin_live_call(std::size_t call);
    /// Once all functions have returned from the call, its results: those when the design's last one did. Others may do
    /// so long after that; they count as long as none has begun another call.
    std::optional<Counters> end_live_call(std::size_t call, std::size_t process);

  private:
    void run_call();
    void require_described_attempts(std::size_t process) const;
    Counters results_of_design() const;
    bool is_described(MachineProcess const& process, char const* loop, std::size_t fifo, bool writes,
                      bool is_attempt) const;

    std::unique_ptr<HlsDesign> design_;
    untimed::UntimedNetwork network_;
    std::vector<std::unique_ptr<ClockedFifo<std::int64_t>>> fifos_;  // by stream
    std::vector<std::deque<HlsScript>> scripts_;                     // by process
    std::deque<Counters> results_;
    std::exception_ptr error_;  // of a call: modules that have not met it go on, and ask for theirs
    struct LiveCall {
        std::size_t functions_over = 0;
        std::optional<Counters> results;
    };
    std::map<std::size_t, LiveCall> live_calls_;
    std::size_t latest_call_ = 0;
    std::uint64_t next_call_ = 0;
};

template <class Design> class HlsCoreOf final : public HlsCore {
  public:
    static CoreDescription describe(Numbers const& /*numbers*/) { return described().core; }
    explicit HlsCoreOf(SimpleCoreParts const& parts) : HlsCore(parts, make_hls_design<Design>, described()) {}

  private:
    static HlsDescription const& described() {
        static HlsDescription const one = describe_hls_functions(Design::facts(), make_hls_design<Design>);
        return one;
    }
};

}  // namespace dataflow

/// The rest of a program for one design: its commands. Outside namespaces, once.
// NOLINTBEGIN(bugprone-macro-parentheses): a class
#define FASTER_HLS_PROGRAM(DesignClass, description)                                                                  \
    static ::dataflow::SimpleSimulation<::dataflow::HlsCoreOf<DesignClass>> const& faster_hls_program() {             \
        static ::dataflow::SimpleSimulation<::dataflow::HlsCoreOf<DesignClass>> const one(DesignClass::facts());      \
        return one;                                                                                                   \
    }                                                                                                                 \
    ::dataflow::Design const& dataflow::design() { return faster_hls_program(); }                                     \
    ::dataflow::SimulatedDesign const& dataflow::simulated_design() { return faster_hls_program(); }                  \
    int sc_main(int argc, char** argv) {                                                                              \
        return ::dataflow::run_tool({DesignClass::facts().name, description, "1.0"}, ::dataflow::standard_commands(), \
                                    argc, argv);                                                                      \
    }
// NOLINTEND(bugprone-macro-parentheses)
