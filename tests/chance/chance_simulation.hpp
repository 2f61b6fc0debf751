#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "chance/chance_design.hpp"
#include "chance/figures.hpp"
#include "dataflow/run/config/run_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::chance {

/// What came of a design in one engine.
struct Outcome {
    Engine engine = Engine::lockstep;
    bool is_recorded = false;
    std::string error;  ///< what was thrown; empty: nothing
    Figures run;
    // Of a run that was recorded and did not get stuck.
    Figures as_is;        ///< the recording retimed as it is, ...
    Figures from_file;    ///< ... and likewise from its event file
    Figures other;        ///< retimed as another design, unless
    std::string refusal;  ///< an attempt would come out otherwise
    /// The cheapest FIFOs that cost no time, and the recording retimed with them; unless attempts keep from looking.
    struct Sized {
        std::vector<std::uint64_t> depths;  ///< by FIFO
        std::vector<FifoKind> kinds;
        Cycles bound = 0;
        Figures figures;
    };
    std::optional<Sized> sized;
};

/// In both engines, recorded and not, by a process of its own: a program has one design and its keys. With `sizes`, the
/// FIFOs of those that are recorded are sized; `other` is the same design with other timing keys.
std::vector<Outcome> run_forked(Design const& design, Design const& other, bool sizes);

}  // namespace faster::chance
