#pragma once

namespace dataflow {

/// A line of our source. As a default argument, the line of the call.
struct SourceSite {
    char const* file = "";
    unsigned line = 0;

    static constexpr SourceSite here(char const* file = __builtin_FILE(), unsigned line = __builtin_LINE()) {
        return {file, line};
    }
    /// Names of files are compared by where they stand in memory: a file has one.
    friend bool operator==(SourceSite const& one, SourceSite const& other) {
        return one.file == other.file && one.line == other.line;
    }
};

}  // namespace dataflow
