#!/usr/bin/env bash
# Installs what is missing, builds faster-sim and the package for Python (preset release), and runs one configuration.
#   scripts/run.sh                     the main job, configs/faster_zcu102.yaml, into out/main
#   scripts/run.sh CONFIG [OPTIONS]    another configuration, into out/<its name>; OPTIONS go to faster-sim run
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
config=${1:-}
if [[ "$config" == -h || "$config" == --help ]]; then
    sed -n '2,4s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    exit 0
fi
if (($# > 0)); then
    shift
fi

if [[ -z "$config" ]]; then
    config=$root/configs/faster_zcu102.yaml
    out=$root/out/main
else
    if [[ ! -e "$config" && -e "$root/$config" ]]; then
        config=$root/$config
    fi
    if [[ ! -f "$config" ]]; then
        echo "run: no configuration $config; shipped are $(cd "$root" && ls configs/*.yaml | paste -sd ' ')" >&2
        exit 2
    fi
    name=$(basename "$config")
    out=$root/out/${name%.*}
fi

bash "$root/scripts/setup.sh"
cd "$root"
cmake --preset release
cmake --build --preset release --target faster-sim faster_python
cd - >/dev/null # paths among OPTIONS are the caller's
exec "$root/build/release/bin/faster-sim" run "$config" --out "$out" --report "$out/report.html" --images 6 "$@"
