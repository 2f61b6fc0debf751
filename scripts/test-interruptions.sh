#!/usr/bin/env bash
# Interrupts all commands that write at random moments, 200 times, and lets the disk fill up under each of them 20 times;
# looks for what is left, half-written or lost, and repeats each in surroundings of any kind, whose bytes have to be the
# same. One signal in eight is sent twice. Prints the seeds, and for each command how often it was stopped. Tests of CI do
# it 20 times, and once for each command. Whatever count: it goes through all commands in turn.
#   scripts/test-interruptions.sh [COUNT [PRESET]]    with the tests of PRESET (release)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
count=${1:-200}
preset=${2:-release}
cmake --preset "$preset" > /dev/null
cmake --build --preset "$preset" --target faster_cli_tests
FASTER_INTERRUPTIONS=$count FASTER_DISKS=20 exec "build/$preset/bin/faster_cli_tests" \
    "Interruptions at random moments leave the older results or the new ones*","A disk that fills up at any moment*"
