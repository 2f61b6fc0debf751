#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "dataflow/base/enumerators.hpp"
#include "faster/data/image.hpp"
#include "faster/workload/pictures/colour.hpp"
#include "poses/commands/estimate_report.hpp"
#include "poses/commands/experiment_estimates.hpp"
#include "poses/judging/judge.hpp"

namespace faster {

/// Why an estimate is not where the object is. docs/poses.md says which is given where several hold.
enum class FailureReason {
    box,       ///< no box of the first stage, or none that has a tenth in common with the object's
    size,      ///< more than a tenth of the object's box lies outside of the accelerator's window
    hidden,    ///< less than a tenth of the object can be seen, says the annotation
    symmetry,  ///< right but for a symmetry of the object: MSSD is below 2 cm
    turned,    ///< the points lie right, though by none of its symmetries: ADD-S is below 2 cm
    score,     ///< the estimate weighs no less than the true pose
    search,    ///< the true pose weighs more, and no sample found it
};

/// An estimate with an ADD of 2 cm or more.
struct Failure {
    WantedEstimate const* wanted = nullptr;
    experiments::EstimateResult const* result = nullptr;
    double add_mm = 0;
    double adds_mm = 0;
    double mssd_mm = 0;
    std::optional<double> visible_share;  ///< of the nearest true pose
    FailureReason reason = FailureReason::search;
};

/// How far off estimates are, each from the nearest true pose: as `evaluate` says, by the meshes that it judges with.
class JudgedErrors {
  public:
    /// Of the judged estimates of a method in a setting, which results_of() wrote.
    void add(SettingData const& setting, MethodData const& method, std::vector<WantedEstimate> const& wanted,
             experiments::EstimateJournal const& journal, poses::Judgement const& judgement);
    /// Nothing if the truth is not known.
    std::optional<poses::EstimateErrors> of(WantedEstimate const& wanted) const;

  private:
    std::map<WantedEstimate const*, poses::EstimateErrors> errors_;
};

/// Of all estimates that are there, in their order. Those whose truth is not known are none.
std::vector<Failure> failures_among(std::vector<WantedEstimate> const& wanted,
                                    experiments::EstimateJournal const& journal, JudgedErrors const& errors);

/// A row per failure.
std::string failures_csv(std::vector<Failure> const& failures);

/// How many of each reason, a line per setting and method; Markdown.
std::string failures_table(std::vector<Failure> const& failures, std::vector<SettingData> const& settings,
                           std::vector<MethodData> const& methods);

/// The worst failures of a setting by ADD-S, `most` at most, one of each reason in turn, so that all reasons show.
std::vector<Failure> worst_of(std::vector<Failure> const& failures, SettingData const& setting, std::size_t most);

/// They side by side: the depth image grey, near is light, observed edges blue, the outline of the true pose green,
/// that of the estimated one red. Each below its method, image and object, error, reason, and weight against the true
/// pose's.
Image<Colour> failure_sheet(std::vector<Failure> const& failures);

}  // namespace faster
