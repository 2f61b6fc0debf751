#pragma once
#include <string>
#include <vector>

#include "reference/quality/pose_survey.hpp"

namespace faster::quality {

/// One row per algorithm and object: `algorithm,object,poses,precision,recall,thickness,closed,thin,closed_and_thin`,
/// means and shares over the poses.
std::string survey_csv(std::vector<PoseSurvey> const& rows);

/// The same per algorithm over all objects, every pose counting once, as a Markdown table.
std::string survey_markdown(std::vector<PoseSurvey> const& rows);

/// As in the configuration.
std::string name_of(EdgeMapAlgorithm algorithm);

}  // namespace faster::quality
