#pragma once
#include <string>
#include <vector>

#include "faster/parts.hpp"

namespace faster::recording {

/// Which parts of a core are to be shown: those whose name matches one of some glob patterns, and the FIFOs at a
/// module's ends and the block RAMs inside it with the module. Without patterns: all.
class SignalFilter {
  public:
    /// Errors: InputError if a pattern matches nothing that the core has.
    explicit SignalFilter(std::vector<std::string> patterns = {}, Parts const& parts = {});

    bool shows(ModuleId module) const;
    bool shows(FifoId fifo) const;
    bool shows(BramId bram) const;

  private:
    bool matches(char const* name) const;

    std::vector<std::string> patterns_;
    Parts parts_;
};

/// Where a block RAM belongs.
inline ModuleId owner_of(BramId bram) {
    return bram == BramId::depth_buffer ? ModuleId::inlier_unit : ModuleId::edge_map_builder;
}
/// And who reads it out, where there are two of it.
inline ModuleId reader_of(BramId bram) {
    return bram == BramId::depth_buffer ? ModuleId::inlier_sweep : ModuleId::edge_map_output;
}

}  // namespace faster::recording
