#pragma once
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "dataflow/core/time/process_timing.hpp"
#include "dataflow/tools/recording/core_capture.hpp"
#include "dataflow/tools/recording/recorded_core.hpp"
#include "dataflow/tools/recording/recording_window.hpp"
#include "dataflow/tools/recording/running_core.hpp"

namespace dataflow::recording {

/// What a process has told of its loops, so that somebody can say in which iteration it stands: the process itself
/// keeps no more of that than decides its times.
class ToldLoops {
  public:
    /// The process has told more. To be called with all that it tells, in order.
    void take(timing::OperationLog const& told, timing::ProcessShape const& shape);
    /// Iterations that the process has done in the loop it is in, or was in last. It only goes on from there.
    std::uint64_t done_in_loop(timing::ProcessTiming const& process);

  private:
    timing::LoopEntries entries_;
    std::uint64_t iterations_ = 0;          ///< told, of all its loops
    std::deque<std::uint64_t> at_entries_;  ///< as many were told when a loop was entered
};

/// Records a window of one core's run, whatever the engine. The run itself goes on undisturbed: its processes'
/// operations are taped as well, and a copy of the core's timing, made at a sample's begin before the window, works
/// them out once more, step by step. Nothing before the last sample begin that is surely earlier than the window is
/// worked out twice.
class CoreRecorder {
  public:
    CoreRecorder(RunningCore& core, RecordingWindow const& window);

    /// False if the core scores none of the wanted samples.
    bool records() const { return phase_ != Phase::done; }
    /// The core is wired up, and nothing has happened yet.
    void before_start();
    /// The core is about to begin its i-th sample.
    void sample_begins(std::size_t i);
    /// The run is over.
    void finish();

    /// What it has recorded, as core 0, once the run is over. Core and recorder must outlive that.
    RecordedCore recorded();
    /// First and last cycle wanted; known after finish().
    Cycles from() const { return from_.value_or(~Cycles{0}); }
    Cycles to() const { return to_.value_or(~Cycles{0}); }
    /// At any time: from() is not before it.
    Cycles earliest_from() const;

  private:
    /// What the processes say, and what their streams are delivered.
    struct Tape {
        std::vector<timing::OperationLog> logs;        // by process
        std::vector<timing::DeliveryTape> deliveries;  // by stream
    };
    /// The core as it stood at a sample's begin, and what its processes have said since, up to the next.
    struct Checkpoint {
        std::unique_ptr<timing::CoreTiming> timing;
        Tape tape;
        Cycles settled_from = 0;  ///< nothing that happened before can be seen any more but as state
    };
    enum class Phase { waiting, recording, done };

    void make_checkpoint();
    void drop_checkpoints(std::size_t i);
    void learn_window();
    void start();
    void feed();
    void tell_detail(Tape& tape);
    void stop();
    void tape_to(Tape* tape);
    bool needs_checkpoint() const;
    Cycles settling_cycles() const;

    RunningCore& core_;
    std::optional<RecordingWindow::Samples> samples_;  ///< of the core, from 0
    std::optional<Cycles> from_;
    std::optional<Cycles> to_;
    Phase phase_ = Phase::waiting;
    std::deque<Checkpoint> checkpoints_;
    std::vector<ToldLoops> told_loops_;  // by process
    Tape* taped_to_ = nullptr;
    std::vector<TokenTap> taps_;  // by FIFO
    Spools spools_;
    std::unique_ptr<timing::CoreTiming> detail_;  ///< observed
    std::unique_ptr<CoreCapture> capture_;
};

}  // namespace dataflow::recording
