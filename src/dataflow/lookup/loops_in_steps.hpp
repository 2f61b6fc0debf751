#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "dataflow/core/time/lookup_view.hpp"

namespace dataflow::timing {

/// Speed: tells loops that read and write step by step (docs/how-it-is-fast.md#loops-of-steps), as loops without a
/// delay line, whose steps access all their ports at once. Cycles and figures are the same. Rewrites what one process
/// is told of such loops.
class LoopsInSteps {
  public:
    /// Null: the process has no such loop, or may do what needs its loops as they are. Otherwise the process has loops
    /// of steps from here on, and its log is rewritten each time before it goes on. Before it has done anything.
    /// `in_two`: also where an iteration accesses ports in two of its steps, which pays where phrases are looked up.
    static std::unique_ptr<LoopsInSteps> of(ProcessTiming& process, bool in_two);

    ProcessTiming const& process() const { return process_; }
    /// What has been told since the last time.
    void rewrite();
    /// What has been told since then is in steps already.
    void pass_over();
    /// Operations that begin outside of loops, of a process that is told nothing. False: they end in a loop, or become
    /// too many.
    bool rewrite(std::vector<Operation>& operations);
    /// All that decides what is made of operations.
    void add_form(std::vector<std::uint64_t>& form) const;

  private:
    /// Of a loop.
    struct Steps {
        std::uint32_t lag = 0;              ///< iterations
        std::uint32_t offset = 0;           ///< steps more
        Ports::Number early = 0, late = 0;  ///< masks
    };

    LoopsInSteps(ProcessTiming& process, std::vector<std::optional<Steps>> loops)
        : process_(process), loops_(std::move(loops)) {}
    static std::optional<Steps> steps_of(ProcessTiming& process, LoopShape const& loop, LoopPlan const& plan);

    bool is_told_in_two() const;
    void take(Operation const& operation);
    void enter(std::size_t loop);
    void iterate(Operation const& operation);
    void iterate_in_both(Operation const& operation);
    void leave();
    void pass_whole();
    void pass_due();
    void put(Ports::Number early, Ports::Number late, std::uint32_t iterations);
    void put_in_two(Ports::Number early, Ports::Number late, std::uint32_t iterations);
    void put_drained(Ports::Number late);
    void put(Ports::Number ports, std::uint32_t steps);
    void put(Operation const& operation);
    void end_run();

    ProcessTiming& process_;
    std::vector<std::optional<Steps>> loops_;  ///< none: told as it is
    Steps const* steps_ = nullptr;             ///< of the loop that it is in
    std::uint32_t interval_ = 1;               ///< of that loop, achieved
    OperationLog late_;                        ///< what iterations do late that no step does yet
    std::uint64_t due_ = 0;                    ///< steps of those that have begun
    OperationLog at_hand_;                     ///< iterations that are split up
    Ports::Number run_ports_ = 0;              ///< of steps to be put down
    std::uint32_t run_ = 0;
    std::vector<Operation> told_;
};

}  // namespace dataflow::timing
