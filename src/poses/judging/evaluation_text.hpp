#pragma once
#include <string>

#include "poses/judging/evaluation.hpp"

namespace faster::poses {

/// Tables for people: the brief scores of each object, of all and their mean, methods below each other; then, if there
/// are several methods, what each is better than the first in all and in the mean.
std::string evaluation_markdown(Evaluation const& evaluation);

/// Tables for programs; docs/formats.md has their columns.
std::string scores_csv(Evaluation const& evaluation);  ///< a row per method and object
std::string errors_csv(Evaluation const& evaluation);  ///< a row per method and instance
std::string curves_csv(Evaluation const& evaluation);  ///< a row per step of a curve of accuracy

}  // namespace faster::poses
