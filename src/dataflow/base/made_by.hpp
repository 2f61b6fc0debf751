#pragma once
#include <string>

namespace dataflow {

/// Which program writes the outputs at hand, and what it was asked for. run_tool() says it.
struct MadeBy {
    std::string version;
    std::string commit;       ///< of its sources; empty: they were no git clone
    std::string commit_date;  ///< yyyy-mm-dd
    std::string command;      ///< behind the program's name, without what changes no output; empty: not a command line
};

inline MadeBy& made_by() {
    static MadeBy maker;
    return maker;
}

}  // namespace dataflow
