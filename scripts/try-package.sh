#!/usr/bin/env bash
# Installs a .deb of faster-sim in a bare Debian 12 and runs it there: the main job, a what-if, the package for Python, the
# man page, and the kernel's libraries. As root; takes minutes, most of them for Debian's packages.
#   scripts/try-package.sh FILE.deb [MIRROR]
set -euo pipefail
package="$(realpath "$1")"
mirror="${2:-}"
work="$(mktemp -d)" # only root may enter: what is written by the names below is nobody else's
root="$work/root" log="$work/log"
mkdir -m 755 "$root"
trap 'umount "$root/proc" 2>/dev/null || true; rm -rf --one-file-system "$work"' EXIT
trap 'tail -n 20 "$log" >&2' ERR

debootstrap --variant=minbase bookworm "$root" $mirror >"$log"
# What the host's apt was told of proxies and mirrors holds here too.
cp /etc/resolv.conf "$root/etc/" 2>/dev/null || true
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
mount -t proc proc "$root/proc"
cp "$package" "$root/faster-sim.deb"
inside() {
    chroot "$root" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"
}
inside apt-get update -q >>"$log"
inside apt-get install -q -y -o Dir::Log::Terminal= --no-install-recommends /faster-sim.deb python3 python3-numpy man-db >>"$log"

start=$SECONDS
inside faster-sim run /usr/share/faster-sim/configs/faster_zcu102.yaml --out /tmp/main --events /tmp/main.events | sed -n 1,2p
echo "try-package: main job after $((SECONDS - start)) s"
inside faster-sim whatif /tmp/main.events --set accelerator.raster_cores=8 | sed -n 1,2p
inside python3 -c 'import faster_sim; print(faster_sim.load_events("/tmp/main.events").whatif(accelerator__raster_cores=8).total_cycles)'
inside python3 -c 'import importlib.metadata as installed; print("faster-sim", installed.version("faster-sim"), "for pip")'
inside man faster-sim-run | grep 'faster-sim-run - Simulate'
inside test -e /usr/include/faster-sim/dataflow/core/machine/machine.hpp
inside apt-get purge -q -y -o Dir::Log::Terminal= faster-sim >>"$log"
inside test ! -e /usr/share/faster-sim
echo "try-package: installed, ran, removed without a trace"
