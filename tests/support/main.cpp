#include "faster/dataflow_names.hpp"
#include "support/test_runner.hpp"

int main(int argc, char* argv[]) { return faster::test::run_tests(argc, argv); }
