#!/usr/bin/env bash
# Makes the wheel of a build tree without network, installs it into a virtual environment that has nothing but NumPy, and
# uses it there. Without a tree, `pip install .` builds all that it needs, which takes minutes.
#   tests/python/wheel_test.sh BUILD|none PYTHON
set -euo pipefail
python=$2
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset PYTHONPATH FASTER_SIM FASTER_BUILD
if [[ "$1" != none ]]; then
    FASTER_BUILD=$(realpath "$1")
    export FASTER_BUILD
fi
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_NO_INPUT=1
fail() {
    echo "wheel_test: $1" >&2
    exit 1
}

# A copy of the sources: what setuptools leaves beside them is no part of them.
mkdir "$scratch/sources"
if [[ "$1" == none ]]; then
    tar -C "$source" --exclude=./build --exclude=./out --exclude=./.git -cf - . | tar -C "$scratch/sources" -xf -
else
    cp -r "$source"/{pyproject.toml,setup.py,CMakeLists.txt,LICENSE,NOTICE,docs,python} "$scratch/sources"
fi
"$python" -m venv --system-site-packages "$scratch/builder" # Debian's setuptools
"$scratch/builder/bin/pip" wheel --quiet --no-build-isolation --no-index --no-deps --wheel-dir "$scratch" "$scratch/sources"
wheel=$(echo "$scratch"/faster_sim-*-linux_*.whl)
[[ -f "$wheel" ]] || fail "no wheel, or one that is not of this platform: $(ls "$scratch")"
if [[ "$1" == none ]]; then
    (cd "$scratch/sources" && "$scratch/builder/bin/pip" install --quiet --no-build-isolation --no-index .)
fi

"$python" -m venv --without-pip "$scratch/fresh"
pip=("$scratch/builder/bin/pip" --python "$scratch/fresh/bin/python")
packages=$("$scratch/fresh/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
numpy=$("$python" -c 'import numpy, os; print(os.path.dirname(numpy.__file__))')
ln -s "$numpy" "$numpy"-*.*-info "$packages"
"${pip[@]}" install --quiet --no-index "$wheel"

cd "$scratch"
cat >small.yaml <<'YAML'
workload: {samples: {count: 2}}
accelerator: {raster_cores: 1, window: 64}
YAML
cat >use.py <<'PYTHON'
import sys
import faster_sim

assert faster_sim.__file__.startswith(sys.prefix), faster_sim.__file__
events = faster_sim.record("small.yaml", "small.events")
run = faster_sim.run("small.yaml", accelerator__fifos__edge_token__depth=16)
assert events.whatif(accelerator__fifos__edge_token__depth=16).total_cycles == run.total_cycles > 0
assert faster_sim.Program().path.startswith(sys.prefix), faster_sim.Program().path
print("total", run.total_cycles)
PYTHON
"$scratch/fresh/bin/python" -I use.py
"$scratch/fresh/bin/faster-sim" run small.yaml | grep '^total' || fail "the command faster-sim does not run"
[[ $("${pip[@]}" list 2>/dev/null | grep -c '^faster-sim ') == 1 ]] || fail "pip does not list faster-sim"
for file in py.typed _core.pyi; do
    [[ -e "$packages/faster_sim/$file" ]] || fail "no $file in the wheel"
done
"${pip[@]}" uninstall --quiet --yes faster-sim
[[ ! -e "$packages/faster_sim" ]] || fail "uninstalling left $(find "$packages/faster_sim" | head -3)"
