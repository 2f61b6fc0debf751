#!/usr/bin/env bash
# What the action's inputs say is never run, and wildcards and several files of budgets are understood.
#   tests/package/action_test.sh PROGRAM SOURCE
set -euo pipefail
export FASTER_SIM=$1
source=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() {
    echo "action_test: $1" >&2
    exit 1
}

! grep -n 'run:.*\${{\|^ *[^#]*bash.*\${{' "$source/action.yml" || fail "an input is text of a command in action.yml"
awk '/^ *run: \|/ { within = 1; next } within && /\$\{\{/ { exit 1 } /^ *- name/ { within = 0 }' "$source/action.yml" || fail "an input is text of a script in action.yml"

cd "$scratch"
cat >small.yaml <<'YAML'
workload: {samples: {count: 2}}
accelerator: {raster_cores: 1, window: 64}
YAML
mkdir budgets
"$FASTER_SIM" check --init small.yaml --out budgets/one.yaml >log
cp budgets/one.yaml budgets/two.yaml
sed -i 's|"\.\./small.yaml"|../small.yaml|' budgets/*.yaml

BUDGETS='budgets/*.yaml' REPORT=small.yaml bash "$source/scripts/action.sh" check >log
[[ $(grep -c '<testsuite ' faster-sim.xml) == 2 ]] || fail "not two budgets in the JUnit file"
grep -q '<html' faster-sim.html || fail "no page of the run"
for budgets in '$(touch hacked)' 'budgets/one.yaml; touch hacked' '`touch hacked`' '--out=hacked' '"; touch hacked; "'; do
    code=0
    BUDGETS=$budgets REPORT='' bash "$source/scripts/action.sh" check >log 2>&1 || code=$?
    [[ "$code" == 2 ]] || fail "exit code $code for budgets '$budgets', expected 2"
    [[ ! -e hacked ]] || fail "'$budgets' was run"
done
code=0
RELEASE='1.0.0; touch hacked' RELEASES=nowhere bash "$source/scripts/action.sh" install >log 2>&1 || code=$?
[[ "$code" == 2 && ! -e hacked ]] || fail "a release that is no version was taken"
