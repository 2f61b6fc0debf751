#pragma once
#include "faster/data/stimulus.hpp"

namespace faster {

/// A stimulus with its triangles as codes after the vertex transform, as a trace holds them.
Stimulus with_explicit_triangles(Stimulus stimulus);

}  // namespace faster
