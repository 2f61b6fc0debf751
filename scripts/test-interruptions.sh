#!/usr/bin/env bash
# Interrupts all commands that write at random moments, 200 times, and looks for what is left, half-written or lost; prints
# the seed. A test of CI does it 20 times.
#   scripts/test-interruptions.sh [COUNT [PRESET]]    with the tests of PRESET (release)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
count=${1:-200}
preset=${2:-release}
cmake --preset "$preset" > /dev/null
cmake --build --preset "$preset" --target faster_cli_tests
FASTER_INTERRUPTIONS=$count exec "build/$preset/bin/faster_cli_tests" \
    "Interruptions at random moments leave the older results or the new ones*"
