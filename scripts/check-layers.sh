#!/usr/bin/env bash
# Checks that the kernel knows no design: it includes nothing of the model, and no word of FASTER stands in it.
# (raster_cores is what the file formats call cores.)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

kernel=(src/kernel src/channels src/tool)
model='common|faster|datapath|modules|workload|reference|tb'
words='raster(?!_cores| core)|triangle|edge_map|edge map|depth_buffer|depth buffer|inlier|\bposes?\b|fragment|\bthesis|fpga_grip'
found=0
grep -rnE "#include \"($model)/" "${kernel[@]}" && found=1
grep -rniP "$words" "${kernel[@]}" --include='*.?pp' --include='*.html' --include='*.js' |
    grep -v 'pointStyle: "triangle"' && found=1
# Within the kernel, only channels and tool may use SystemC.
grep -rnE '#include <systemc' src/kernel && found=1
if ((found)); then
    echo "check-layers: the kernel knows something of the model" >&2
    exit 1
fi
echo "check-layers: the kernel knows no design"
