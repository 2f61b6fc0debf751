#include "support/test_runner.hpp"

#include "faster/dataflow_names.hpp"

#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

namespace faster::test {

int run_tests(int argc, char* argv[]) { return Catch::Session().run(argc, argv); }

}  // namespace faster::test
