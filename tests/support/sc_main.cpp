#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#include <cstdlib>
#include <systemc>

namespace {
// Before libsystemc's main() can print its banner.
[[maybe_unused]] int const banner_off = setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
}  // namespace

int sc_main(int argc, char* argv[]) { return Catch::Session().run(argc, argv); }
