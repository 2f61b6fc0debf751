#!/usr/bin/env bash
# What scripts/release.sh does around its builds, with stand-ins for what takes minutes: refusals, the commit, notes,
# checksums, and the tag, which comes last.
#   tests/package/release_test.sh SOURCE
set -euo pipefail
source=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() {
    echo "release_test: $1" >&2
    exit 1
}

mkdir "$scratch/bin" "$scratch/clone"
for tool in help2man dpkg-shlibdeps cmake; do
    printf '#!/bin/sh\n' >"$scratch/bin/$tool"
done
cat >"$scratch/bin/lintian" <<'SH'
#!/bin/sh
[ ! -e ../bad-package ]
SH
cat >"$scratch/bin/cpack" <<'SH'
#!/bin/sh
mkdir -p packages && echo package >packages/faster-sim_0.9.0_amd64.deb
SH
cat >"$scratch/bin/python" <<'SH'
#!/bin/sh
while [ "$1" != --wheel-dir ]; do shift; done
echo wheel >"$2/faster_sim-0.9.0-py3-none-any.whl"
SH
chmod +x "$scratch/bin/"*
export PATH="$scratch/bin:$PATH" PYTHON="$scratch/bin/python"
export GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@a.invalid GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@a.invalid GIT_CONFIG_GLOBAL=/dev/null

cd "$scratch/clone"
mkdir -p scripts build/release
cp "$source/scripts/release.sh" scripts
printf 'project(faster-sim VERSION 0.8.1 LANGUAGES CXX)\n' >CMakeLists.txt
printf '# Changelog\n\n## 0.9.0 (unreleased)\n\n- New.\n\n## 0.8.1 (2026-01-01)\n\n- Old.\n' >CHANGELOG.md
printf 'version: 0.8.1\n' >CITATION.cff
mkdir docs
printf 'apt install ./faster-sim_0.8.1_amd64.deb\n' >docs/installing.md
printf 'build\nout\n' >.gitignore
git init -q .
git add .
git commit -qm first

refused() { # WHY VERSION
    local code=0
    bash scripts/release.sh "$2" >../log 2>&1 || code=$?
    [[ "$code" == 2 ]] && grep -q "$1" ../log || fail "version '$2': exit code $code, expected 2 and '$1', but: $(cat ../log)"
    [[ -z "$(git tag)" ]] || fail "a tag after a refusal"
}
refused "expected one such as" ''
refused "expected one such as" 'v0.9'
refused "no section '## 0.9.1 (unreleased)'" 0.9.1
touch more && refused "expected all of them committed" 0.9.0 && rm more
touch ../bad-package && refused "lintian found errors" 0.9.0 && rm ../bad-package

bash scripts/release.sh 0.9.0 >../log
out=out/release/0.9.0
grep -q "VERSION 0.9.0 " CMakeLists.txt || fail "CMakeLists.txt keeps the old version"
grep -q 0.9.0 CITATION.cff && grep -q _0.9.0_ docs/installing.md || fail "CITATION.cff or docs/installing.md keeps it"
grep -Eq '^## 0.9.0 \([0-9]{4}-[0-9]{2}-[0-9]{2}\)$' CHANGELOG.md || fail "CHANGELOG.md has no date"
[[ "$(grep . "$out/NOTES.md")" == "- New." ]] || fail "notes are not those of the version: $(cat "$out/NOTES.md")"
(cd "$out" && sha256sum --check --quiet SHA256SUMS && [[ $(wc -l <SHA256SUMS) == 3 ]]) || fail "checksums"
tar -tzf "$out/faster-sim-0.9.0.tar.gz" | grep -x 'faster-sim-0.9.0/CHANGELOG.md' >/dev/null || fail "no CHANGELOG.md in the archive"
[[ "$(git rev-parse 'v0.9.0^{commit}')" == "$(git rev-parse HEAD)" ]] || fail "the tag is not on the release's commit"
code=0
bash scripts/release.sh 0.9.0 >../log 2>&1 || code=$?
[[ "$code" == 2 ]] && grep -q "there is a tag v0.9.0 already" ../log || fail "the same version twice"
