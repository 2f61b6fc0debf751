#pragma once
#include <string>

#include "dataflow/tools/sizing/size_fifos.hpp"

namespace dataflow::sizing {

/// A sizing for people: the answer, the certificate, the front.
std::string sizing_text(Sizing const& sizing);

/// The files of a sizing (docs/formats.md, "Sizes of FIFOs"). Equal for equal runs, whatever the number of threads.
std::string sizing_json(Sizing const& sizing);
std::string pareto_csv(Sizing const& sizing);
/// The answer as a configuration of `accelerator.fifos`. `title`: what it is the answer to, for a comment.
std::string depths_yaml(Sizing const& sizing, std::string const& title);

}  // namespace dataflow::sizing
