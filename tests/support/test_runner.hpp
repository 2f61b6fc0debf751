#pragma once

namespace faster::test {

/// What main() of a test executable does. Catch2 itself is compiled with it, once for all of them.
int run_tests(int argc, char* argv[]);

}  // namespace faster::test
