#pragma once
#include <cstddef>

#include "dataflow/core/time/core_timing.hpp"

namespace dataflow::replay {

/// Goes along with the cores of a retiming.
class CoreWatch {
  public:
    virtual ~CoreWatch() = default;
    /// A core is there, and nothing has happened in it. It stays where it is until after end().
    virtual void start(std::size_t core, timing::CoreTiming& timing) = 0;
    /// A core is about to be told its i-th sample. False: the rest does not matter; figures are empty then, and there
    /// is no end().
    virtual bool sample_begins(std::size_t core, std::size_t i) = 0;
    /// All operations have their cycles.
    virtual void end() = 0;
};

}  // namespace dataflow::replay
