#pragma once
#include <algorithm>
#include <string>
#include <vector>

namespace dataflow::io {

/// What a folder of one kind (trace, results of a run) is made of: how an older one is recognised and replaced.
struct FolderKind {
    std::string name;                 ///< for messages, e.g. "stimulus trace"
    std::string marker;               ///< the file every folder of this kind has
    std::vector<std::string> others;  ///< further files and folders that a newer folder replaces or drops

    bool has(std::string const& file) const {
        return file == marker || std::find(others.begin(), others.end(), file) != others.end();
    }
};

}  // namespace dataflow::io
