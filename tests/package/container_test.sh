#!/usr/bin/env bash
# The steps of the container file, without a container: sources that were built on the host are copied as .dockerignore
# says, and configured with the container file's own command.
#   tests/package/container_test.sh SOURCE
set -euo pipefail
source=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() {
    echo "container_test: $1" >&2
    exit 1
}

cmp "$source/.dockerignore" "$source/.containerignore"
mapfile -t ignored < <(grep -v '^#' "$source/.dockerignore")
exclude=()
for pattern in "${ignored[@]}"; do
    exclude+=("--exclude=./${pattern#\*\*/}")
done
mkdir "$scratch/host" "$scratch/copy"
tar -C "$source" -c --exclude=./.git --exclude=./build --exclude=./out . | tar -C "$scratch/host" -x
mkdir -p "$scratch/host/build/release" "$scratch/host/out/main"
printf 'CMAKE_HOME_DIRECTORY:INTERNAL=/somewhere/else\nCMAKE_CACHEFILE_DIR:INTERNAL=/somewhere/else/build/release\n' >"$scratch/host/build/release/CMakeCache.txt"
tar -C "$scratch/host" -c "${exclude[@]}" . | tar -C "$scratch/copy" -x
[[ ! -e "$scratch/copy/build" && ! -e "$scratch/copy/out" ]] || fail "the host's build or outputs get into the container"

configure=$(grep -o 'cmake --preset release [^\\]*' "$source/Containerfile")
[[ -n "$configure" ]] || fail "no command that configures in Containerfile"
cd "$scratch/copy"
$configure >log 2>&1 || fail "$configure: $(tail -5 log)"
grep -q 'package' <(cmake --build --preset release --target help) || fail "no target package"
