#include <cstdlib>
#include <systemc>

#include "faster/dataflow_names.hpp"
#include "support/test_runner.hpp"

namespace {
// Before libsystemc's main() can print its banner.
[[maybe_unused]] int const banner_off = setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
}  // namespace

int sc_main(int argc, char* argv[]) { return faster::test::run_tests(argc, argv); }
