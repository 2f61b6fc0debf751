#pragma once
#include <string>

#include "kernel/sizing/size_fifos.hpp"

namespace faster::sizing {

/// A sizing for people: the answer, the certificate, the front.
std::string sizing_text(Sizing const& sizing);

}  // namespace faster::sizing
