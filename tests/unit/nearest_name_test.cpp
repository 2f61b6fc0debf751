#include "dataflow/base/nearest_name.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"

namespace nearest_name_test {

using namespace faster;

TEST_CASE("The edit distance counts insertions, deletions, substitutions and swaps", "[nearest_name]") {
    CHECK(edit_distance("window", "window") == 0);
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("abc", "") == 3);
    CHECK(edit_distance("window", "widow") == 1);
    CHECK(edit_distance("window", "windows") == 1);
    CHECK(edit_distance("window", "windew") == 1);
    CHECK(edit_distance("window", "windwo") == 1);
    CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("The nearest name is the first of those with the fewest edits", "[nearest_name]") {
    std::vector<std::string> const names{"depth", "width", "window", "wadth"};
    CHECK(nearest_name("widht", names) == "width");
    CHECK(nearest_name("wdth", names) == "width");
    CHECK(did_you_mean("windo", names) == ", did you mean window?");
}

TEST_CASE("A name far from all others has no nearest name", "[nearest_name]") {
    std::vector<std::string> const names{"depth", "width"};
    CHECK(nearest_name("seed", names).empty());
    CHECK(nearest_name("", names).empty());
    CHECK(nearest_name("width", std::vector<std::string>{}).empty());
    CHECK(did_you_mean("seed", names).empty());
}

}  // namespace nearest_name_test
