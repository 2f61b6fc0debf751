#include <catch2/catch.hpp>

#include "dataflow/phrases/phrase_core.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::without_lookup_test {

TEST_CASE("These cores remember nothing", "[without_lookup]") {
    CHECK(timing::make_answers() == nullptr);
    CHECK_FALSE(timing::make_core()->follows_script());
}

}  // namespace faster::without_lookup_test
