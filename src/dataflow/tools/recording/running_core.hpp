#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "dataflow/base/core_share.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/tools/recording/memory_activity.hpp"
#include "dataflow/tools/recording/token_tap.hpp"

namespace dataflow::recording {

/// A core while it runs, as a recording needs to know it.
class RunningCore {
  public:
    /// Of most_samples_ahead().
    static constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();

    virtual ~RunningCore() = default;

    virtual Machine const& machine() const = 0;
    virtual CoreShare share() const = 0;
    virtual timing::CoreTiming& timing() = 0;
    /// Gives all operations told so far their cycles, where that does not happen anyway.
    virtual void catch_up() = 0;

    /// What the tokens of a FIFO consist of; nothing if the FIFO is not there.
    virtual std::vector<TokenField> token_fields(std::size_t fifo) const = 0;
    /// From now on, or no longer, shows all tokens that go into a FIFO.
    virtual void add_tap(std::size_t fifo, TokenTap& tap) = 0;
    virtual void remove_tap(std::size_t fifo, TokenTap& tap) = 0;

    /// Most samples that the process that begins samples can be ahead of any other, plus some to spare. The smaller,
    /// the less is kept and worked out twice when a sample in the middle of a run is recorded. `unknown`: a recording
    /// of some samples keeps everything from the start of the run.
    virtual std::size_t most_samples_ahead() const { return unknown; }
    /// How many of the tokens that a process has read last can still decide which words of its memories it accesses.
    virtual std::uint64_t tokens_in_use() const { return 1; }
    /// A new one, for a recording of its own. Null: no accesses to memories are shown.
    virtual std::unique_ptr<MemoryActivity> memory_activity() const { return nullptr; }
};

}  // namespace dataflow::recording
