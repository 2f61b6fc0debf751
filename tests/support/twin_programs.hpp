#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "support/memory_twin.hpp"
#include "support/parts.hpp"
#include "support/twin_function.hpp"

namespace faster::testing {

enum class AccessKind { Read, Write };

struct TwinAccess {
    AccessKind kind = AccessKind::Read;
    FifoId fifo = FifoId::vertex;
};

/// One line of the table of docs/timing-model.md#sources-of-time, in one of two shapes:
///  - a step (`loop` empty): `accesses` happen together, then `advance` cycles pass. A mere `T += n` has no accesses.
///  - a pipelined loop: iteration i makes accesses[k] if bit k of iterations[i] is set. At least one iteration.
struct TwinState {
    std::vector<TwinAccess> accesses;  ///< in program order
    Cycles advance = 1;
    std::optional<LoopId> loop;
    std::vector<std::uint8_t> iterations;
    /// Of a loop that prepares triangles: iteration `awaits` begins `setup_cycles` after the II cycles of iteration
    /// `since`, which read the last vertex, at the earliest.
    struct Setup {
        std::size_t since = 0;
        std::size_t awaits = 0;
    };
    std::vector<Setup> setups;  ///< ascending
    Cycles setup_cycles = 0;
    /// By iteration: the words that make it wait for those before it (hazards interlock). Empty: nothing does.
    TwinTouches touches;
    /// Of what moves data outside the chip: a step takes token 0, iteration i of a loop token i, before `accesses`; the
    /// result is written behind the step.
    std::optional<TwinMaster> master;
    TwinRanges ranges;
};

using TwinProgram = std::vector<TwinState>;

/// What every process of a core does for one sample. Data decide only which states there are, never when they happen,
/// so the whole function of docs/function.md is computed before the first cycle.
struct TwinSamplePrograms {
    std::array<TwinProgram, module_count> programs;  ///< [ModuleId]
    SampleCounters counters;
};

TwinSamplePrograms programs_of_sample(AcceleratorConfig const& config, Stimulus const& stimulus, std::size_t sample,
                                      TwinMemory const& memory);

}  // namespace faster::testing
