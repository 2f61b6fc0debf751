#!/usr/bin/env bash
# Checks that each room of src/ includes only the rooms it may use, and that the kernel (dataflow, channels) knows no
# design: no word of FASTER stands in it. (raster_cores is what the file formats call cores.)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

found=0
# may ROOM OTHERS: what stands in src/ROOM includes only itself and OTHERS, which are separated by '|'.
may() {
    local room=$1 others=$2
    local allowed="^[^\"]*#include \"($room${others:+|$others})/"
    if grep -rnE '#include "[a-z_]+/' "src/$room" --include='*.?pp' | grep -vE "$allowed"; then
        echo "check-layers: $room may use ${others//|/, }, and nothing else" >&2
        found=1
    fi
}
base=dataflow/base
core=$base'|dataflow/core'
phrases=$core'|dataflow/phrases'
run=$phrases'|dataflow/run'
tools=$run'|dataflow/tools'
may dataflow/base ''
may dataflow/core "$base"
may dataflow/phrases "$core"
may dataflow/lookup "$phrases|dataflow/lookup"  # which nobody includes: a build may leave it out
may dataflow/run "$phrases"
may dataflow/tools "$run"
may channels "$tools"
may dataflow/commands "$tools|channels"
may hls "$tools|channels|dataflow/commands"
may faster dataflow
may modules 'dataflow|channels|faster'
may poses 'dataflow|channels|faster|modules'
may tb 'dataflow|channels|faster|modules|poses'

kernel=(src/dataflow src/channels)
words='raster(?!_cores| core)|triangle|edge_map|edge map|depth_buffer|depth buffer|inlier|\bposes?\b|fragment|\bthesis|fpga_grip|namespace faster|faster::'
words+='|area_reciprocal|vertex_transform|observation_reader|sample_dispatcher|result_collector|edge_token|object_map|dual_map'
words+='|edge_extractor|observed_|silhouette|\bmesh(es)?\b|\bycb\b|\bbop\b|\bgrip\b'
# How good edges are: as a field or a quoted name, for "closed" is a word of every day.
words+='|(double|float) (precision|recall|closed|thin)\b|"(precision|recall|closed|thin)"'
sources=(--include='*.?pp' --include='*.html' --include='*.js' --include='*.css' --include='CMakeLists.txt')
if grep -rniP "$words" "${kernel[@]}" "${sources[@]}" | grep -v 'pointStyle: "triangle"'; then
    echo "check-layers: the kernel knows something of the model" >&2
    found=1
fi
# The inside of processes and FIFOs is for the lookups alone.
if grep -rn 'core/time/lookup_view.hpp"' src --include='*.?pp' | grep -v '^src/dataflow/lookup/'; then
    echo "check-layers: lookup_view.hpp is for lookup" >&2
    found=1
fi
# Of the kernel, only channels and commands may use SystemC.
if grep -rnE '#include <systemc' src/dataflow/{base,core,phrases,lookup,run,tools}; then
    echo "check-layers: SystemC is for channels and commands" >&2
    found=1
fi
if ((found)); then
    exit 1
fi
echo "check-layers: every room includes what it may, and the kernel knows no design"
