#!/usr/bin/env bash
# The steps of action.yml. What they are about comes in variables, and is never text of the shell.
#   RELEASE=0.2.0 RELEASES=URL scripts/action.sh install    the .deb of a release; RELEASE empty: builds these sources
#   BUDGETS="a.yaml b/*.yaml" REPORT=c.yaml scripts/action.sh check    into faster-sim.xml and, of REPORT, faster-sim.html
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

install_release() {
    if [[ ! "$RELEASE" =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]]; then
        echo "action: release = $RELEASE, expected a version such as 0.2.0" >&2
        exit 2
    fi
    local folder
    folder=$(mktemp -d)
    local package="faster-sim_${RELEASE}_amd64.deb"
    apt-get update -q
    apt-get install -q -y --no-install-recommends ca-certificates curl
    curl -fsSL --output-dir "$folder" -O "$RELEASES/v$RELEASE/$package" -O "$RELEASES/v$RELEASE/SHA256SUMS"
    (cd "$folder" && grep -F " $package" SHA256SUMS | sha256sum --check --strict)
    chmod 755 "$folder"
    apt-get install -q -y --no-install-recommends "$folder/$package"
}

build() {
    bash "$root/scripts/setup.sh"
    cd "$root"
    cmake --preset release -DFASTER_BUILD_TESTS=OFF -DFASTER_BUILD_BENCHMARKS=OFF -DFASTER_BUILD_EXAMPLES=OFF -DFASTER_BUILD_PYTHON=OFF
    cmake --build --preset release --target faster-sim
}

check() {
    local program=${FASTER_SIM:-$root/build/release/bin/faster-sim}
    [[ -x "$program" ]] || program=faster-sim
    # Unquoted: words and wildcards, which is all that the shell makes of a variable's value.
    # shellcheck disable=SC2206
    local budgets=($BUDGETS)
    local code=0
    "$program" check --junit faster-sim.xml -- "${budgets[@]}" || code=$?
    if [[ -n "${REPORT:-}" ]]; then
        "$program" run --report faster-sim.html -- "$REPORT" || code=$?
    fi
    exit "$code"
}

case "${1:-}" in
    install) if [[ -n "${RELEASE:-}" ]]; then install_release; else build; fi ;;
    check) check ;;
    *)
        echo "action: ${1:-nothing to do}, expected install or check" >&2
        exit 2
        ;;
esac
