#!/usr/bin/env bash
# Makes a release of a clean clone, in out/release/VERSION: .deb, wheel, source archive, SHA256SUMS, and NOTES.md from
# CHANGELOG.md; then the tag vVERSION. Nothing is pushed.
#   scripts/release.sh VERSION [PRESET]    builds PRESET (release), or what of it has changed
# CHANGELOG.md has a section "## VERSION (unreleased)", which gets today's date, and CMakeLists.txt gets the version: one
# commit, if there is anything to change.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version=${1:-}
preset=${2:-release}
fail() {
    echo "release: $1" >&2
    exit 2
}

[[ "$version" =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || fail "version '$version', expected one such as 0.2.0"
[[ -z "$(git status --porcelain)" ]] || fail "the clone has changes, expected all of them committed"
! git rev-parse -q --verify "refs/tags/v$version" >/dev/null || fail "there is a tag v$version already, expected a new version"
number=${version//./\\.}
grep -Eq "^## $number \((unreleased|[0-9-]{10})\)$" CHANGELOG.md || fail "CHANGELOG.md has no section '## $version (unreleased)'"
for tool in lintian help2man dpkg-shlibdeps; do
    command -v "$tool" >/dev/null || fail "no $tool, expected what scripts/setup.sh --release installs"
done

sed -i "s/^## $number (unreleased)$/## $version ($(date -u +%F))/" CHANGELOG.md
sed -i "s/^project(faster-sim VERSION [0-9.]*/project(faster-sim VERSION $version/" CMakeLists.txt
sed -i "s/^version: .*/version: $version/" CITATION.cff
sed -i "s/faster-sim_[0-9.]*_amd64/faster-sim_${version}_amd64/" docs/installing.md
if [[ -n "$(git status --porcelain)" ]]; then
    git commit -q -m "Release $version" CHANGELOG.md CMakeLists.txt CITATION.cff docs/installing.md
fi

out=out/release/$version
rm -rf "$out"
mkdir -p "$out"
cmake --preset "$preset"
cmake --build --preset "$preset" --target faster-sim faster_python
(cd "build/$preset" && cpack -G DEB -B "$PWD/packages")
cp "build/$preset/packages/faster-sim_${version}_"*.deb "$out"
lintian --fail-on error "$out"/*.deb || fail "lintian found errors in the package"
FASTER_BUILD="build/$preset" "${PYTHON:-/usr/bin/python3}" -m pip wheel --quiet --no-build-isolation --no-index --no-deps --wheel-dir "$out" .
git archive --format=tar.gz --prefix="faster-sim-$version/" -o "$out/faster-sim-$version.tar.gz" HEAD
awk -v head="## $version " 'index($0, "## ") == 1 { within = index($0, head) == 1; next } within' CHANGELOG.md >"$out/NOTES.md"
(cd "$out" && sha256sum -- *.deb *.whl *.tar.gz >SHA256SUMS)
git tag -a "v$version" -F "$out/NOTES.md" --cleanup=verbatim
echo "release: $out has package, wheel, archive, SHA256SUMS and NOTES.md; tag v$version on $(git rev-parse --short HEAD); to publish: git push origin HEAD v$version"
