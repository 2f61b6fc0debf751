#!/usr/bin/env bash
# Makes the .deb of a preset that is built, and tries it in a bare Debian 12 (scripts/try-package.sh), which has to mount.
# A minute. What lintian finds is for scripts/release.sh.
#   scripts/check-package.sh [PRESET]    preset ci by default
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

folder="build/${1:-ci}"
packages="$PWD/$folder/packages"
log="$PWD/$folder/package.log"
rm -rf "$packages"
(cd "$folder" && cpack -G DEB -B "$packages") >"$log" 2>&1 || {
    cat "$log" >&2
    exit 1
}
if ! unshare --mount true 2>/dev/null; then # not root, or a container that may not mount
    echo "check-package: nothing may be mounted here, so the package is not tried in a bare Debian"
    exit 0
fi
bash scripts/try-package.sh "$packages"/*.deb
