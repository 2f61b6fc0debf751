#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace dataflow {

/// Number of insertions, deletions, substitutions and swaps of neighbouring letters that turn `a` into `b`
/// (Damerau-Levenshtein distance, restricted: no letter is edited twice).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> current(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) {
        current[j] = j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last.swap(last);
        last.swap(current);
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            std::size_t const substituted = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({substituted, last[j] + 1, current[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                current[j] = std::min(current[j], before_last[j - 2] + 1);
            }
        }
    }
    return current[b.size()];
}

/// The candidate that `name` was most likely meant to be, for "did you mean": the first of those with the fewest
/// edits. Empty if even that one takes more edits than a third of the name (at least one is always allowed). Lengths
/// that differ by more are not compared letter by letter, so a megabyte of a name costs no time.
template <class Candidates> std::string nearest_name(std::string_view name, Candidates const& candidates) {
    std::string nearest;
    std::size_t fewest_edits = std::max<std::size_t>(1, name.size() / 3) + 1;
    for (std::string_view const candidate : candidates) {
        std::size_t const lengths_differ =
            std::max(name.size(), candidate.size()) - std::min(name.size(), candidate.size());
        if (lengths_differ >= fewest_edits) {
            continue;
        }
        std::size_t const edits = edit_distance(name, candidate);
        if (edits < fewest_edits) {
            fewest_edits = edits;
            nearest = candidate;
        }
    }
    return nearest;
}

/// Ends an error message about an unknown name: ", did you mean window?", or nothing if no candidate is close.
template <class Candidates> std::string did_you_mean(std::string_view name, Candidates const& candidates) {
    std::string const nearest = nearest_name(name, candidates);
    return nearest.empty() ? std::string{} : ", did you mean " + nearest + "?";
}

}  // namespace dataflow
