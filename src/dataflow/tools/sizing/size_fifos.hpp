#pragma once
#include <functional>
#include <optional>

#include "dataflow/run/config/run_config.hpp"
#include "dataflow/tools/sizing/certificate.hpp"
#include "dataflow/tools/sizing/front.hpp"

namespace dataflow::sizing {

constexpr double most_within_percent = 1e6;
constexpr double least_luts_of_ramb36 = 0.01, most_luts_of_ramb36 = 1e6;
constexpr unsigned most_front_points = 1000;

struct SizingOptions {
    double within_percent = 0;  ///< of what unbounded FIFOs take, more
    CostWeights weights;
    unsigned front_points = 12;          ///< bounds of the front; 0: no front
    unsigned jobs = 1;                   ///< threads
    std::size_t most_retimings = 20000;  ///< cores retimed before a search does without a proof
    CoreTimes::BeforeRetiming before_retiming;
};

/// A choice with its price and its time.
struct SizedChoice {
    Choice choice;
    Cycles total_cycles = 0;  ///< Cut::deadlock if it never ends
    Primitives primitives;    ///< of a core
    double cost = 0;          ///< of a core, in LUTs
};

/// The cheapest FIFOs for a recorded run, and all that shows it.
struct Sizing {
    SizingOptions options;
    RunConfig config;  ///< its FIFOs' depths as configured
    Machine machine;   ///< of that configuration
    SizedChoice configured;
    SizedChoice unbounded;
    Cycles bound = 0;
    SizedChoice answer;
    bool is_proven = false;    ///< nothing within the bound is cheaper
    bool is_given_up = false;  ///< not proven, as that would have taken too many retimings
    double least_cost = 0;     ///< of a core, in LUTs: nothing within the bound costs less
    Choice holds;              ///< the answer's kinds, as deep as its primitives allow
    /// What that takes, if it may be more than the answer: then times are not monotone.
    std::optional<Cycles> holds_cycles;
    std::vector<CertificateRow> certificate;
    std::vector<FrontPoint> front;  ///< cheapest first
    std::size_t retimed_cores = 0;
};

/// Throws InputError for bounds and weights with which a search would never end, or prove nonsense: whoever asks.
void require_sense(SizingOptions const& options);

/// Throws InputError for a machine whose FIFOs hand over calls: more room than those have would be another design.
void require_sizable(Machine const& machine);

/// How much `bound` is: percent of the cycles of unbounded FIFOs, more than those.
Cycles bound_within(double percent, Cycles unbounded_cycles);

/// `config`: of the recorded run, or with other retiming_keys(). Throws as the two above. `progress` is told how many
/// of how many steps are done.
Sizing size_fifos(replay::RecordedRun const& run, RunConfig const& config, SizingOptions const& options,
                  std::function<void(std::size_t done, std::size_t steps)> const& progress = {});

}  // namespace dataflow::sizing
