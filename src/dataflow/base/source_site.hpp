#pragma once

namespace dataflow {

/// A line of our source. As a default argument, the line of the call.
struct SourceSite {
    char const* file = "";
    unsigned line = 0;

    static constexpr SourceSite here(char const* file = __builtin_FILE(), unsigned line = __builtin_LINE()) {
        return {file, line};
    }
};

}  // namespace dataflow
