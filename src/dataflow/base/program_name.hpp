#pragma once
#include <string>

namespace dataflow {

/// How the program at hand is called, for messages that tell what to do next. run_tool() sets it.
inline std::string& program_name() {
    static std::string name = "faster-sim";
    return name;
}

}  // namespace dataflow
