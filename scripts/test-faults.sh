#!/usr/bin/env bash
# Lets every call of the system that writes, renames, removes, forks or reads fail, and kills the program before it, one
# after the other, in every command that writes (those whose name contains PART); looks for what is left, half-written or
# lost, and repeats the command. Takes hours: a run of the command and a repeat for each. A test of CI takes 20 at random.
#   scripts/test-faults.sh [PRESET [PART]]    with the tests of PRESET (release)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=${1:-release}
cmake --preset "$preset" > /dev/null
cmake --build --preset "$preset" --target faster_cli_tests
FASTER_FAULTS=all FASTER_COMMANDS=${2:-} exec "build/$preset/bin/faster_cli_tests" \
    "A call of the system that fails leaves the older results or the new ones*"
