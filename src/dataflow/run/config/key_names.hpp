#pragma once
#include <string>

namespace dataflow {

/// Names of the keys of a machine's parts; `field` is the last part, e.g. "depth". A loop's name is MODULE.LOOP.
inline std::string fifo_key_name(std::string const& fifo, std::string const& field) {
    return "accelerator.fifos." + fifo + '.' + field;
}
inline std::string loop_key_name(std::string const& loop, std::string const& field) {
    return "accelerator.loops." + loop + '.' + field;
}
/// What a loop does to a block RAM.
inline std::string dependence_key_name(std::string const& loop, std::string const& memory, std::string const& field) {
    return loop_key_name(loop, memory + '.' + field);
}
inline std::string bram_key_name(std::string const& memory, std::string const& field) {
    return "accelerator.brams." + memory + '.' + field;
}
/// A setup is no loop, but its key stands among those of its module's loops.
inline std::string setup_key_name(std::string const& module) { return loop_key_name(module + ".setup", "depth"); }
/// `field`: of a number of the module.
inline std::string module_key_name(std::string const& module, std::string const& field) {
    return "accelerator.modules." + module + '.' + field;
}

constexpr char const* architecture_key_name = "accelerator.architecture";

}  // namespace dataflow
