#!/usr/bin/env bash
# Lines of code of each room of src/, as docs/architecture.md names them: C++ and SystemC sources, and the pages' scripts.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

for room in src/dataflow/{base,core,phrases,lookup,run,tools,commands} src/{dataflow,channels,hls,modules,faster,poses,tb} src; do
    printf '%-24s %6d\n' "$room" "$(find "$room" -type f \( -name '*.?pp' -o -name '*.h' -o -name '*.js' \) -exec cat {} + | wc -l)"
done
