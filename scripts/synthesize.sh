#!/usr/bin/env bash
# Synthesizes every unit of the register-transfer core with Yosys, for UltraScale+, and writes what it takes and how
# long its paths are:
#   scripts/synthesize.sh            into rtl/resources.csv and rtl/timing.csv; two hours on one core
#   scripts/synthesize.sh FOLDER     into FOLDER; what it has of an earlier call (FOLDER/netlists) is not made again
# JOBS=2 runs two at once. A unit has its numbers as constants here, as in a design. `configuration` is `default`, or
# the keys that differ. Rows whose names begin with `check.` test the interpolation and take no part in it.
set -euo pipefail
cd "$(dirname "$0")/.."

folder="$(realpath -m "${1:-rtl}")"
command -v yosys >/dev/null || {
    echo "synthesize: no yosys; scripts/setup.sh --dev installs it" >&2
    exit 2
}
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
netlists="$work/netlists"
[[ $# -gt 0 ]] && netlists="$folder/netlists"
mkdir -p "$netlists"

shared="faster_pkg.sv shift_register.sv delay_line.sv pipelined_loop.sv block_ram.sv in_window.sv window_origin.sv"

# unit NAME CONFIGURATION TOP FILES PARAMETERS CONSTANTS: parameters as NAME=VALUE, constant inputs as PORT=WIDTH'VALUE.
unit() {
    local name="$1,$2" top="$3" files="$4" parameters="$5" constants="$6" item
    local netlist="$netlists/$name.json"
    printf '%s\n' "$name" >>"$work/order"
    [[ -s "$netlist" ]] && return
    {
        echo "read_verilog -sv $shared $files"
        for item in $parameters; do echo "chparam -set ${item%%=*} ${item#*=} $top"; done
        echo "hierarchy -check -top $top"
        echo "rename -top unit"
        echo "proc"
        for item in $constants; do
            echo "cd unit"
            echo "delete -input w:${item%%=*}"
            echo "connect -nounset -set ${item%%=*} ${item#*=}"
            echo "cd .."
        done
        echo "synth_xilinx -family xcup -flatten -top unit"
        echo "write_json \"$netlist.part\""
    } >"$work/$name.ys"
    printf '%s\n' "$name" >>"$work/jobs"
}
synthesize_one() {
    (cd rtl && timeout 1800 nice -n 10 yosys -q "$1/$3.ys" >"$1/$3.log" 2>&1) && mv "$2/$3.json.part" "$2/$3.json" || {
        echo "synthesize: $3 failed:" >&2
        tail -3 "$1/$3.log" >&2
        return 255
    }
    echo "$3"
}
export -f synthesize_one

# shellcheck source=scripts/synthesized_units.sh
source scripts/synthesized_units.sh

[[ -s "$work/jobs" ]] &&
    xargs -d '\n' -P "${JOBS:-1}" -I {} bash -c 'synthesize_one "$@"' _ "$work" "$netlists" {} <"$work/jobs"
python3 scripts/netlist_figures.py "$netlists" "$work/order" "$work/resources.csv" "$work/timing.csv"
mv "$work/resources.csv" "$work/timing.csv" "$folder/"
echo "written: $folder/resources.csv and timing.csv"
