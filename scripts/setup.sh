#!/usr/bin/env bash
# Installs the Debian packages that faster-sim needs, and only those that are missing.
#   scripts/setup.sh             what building, testing and running need
#   scripts/setup.sh --package   also what makes a .deb with man pages
#   scripts/setup.sh --dev       also clang-format, clang-tidy, Chromium for tests of pages, strace for tests of faults,
#                                Valgrind to count instructions, Yosys for what the register-transfer twin takes,
#                                matplotlib and pandas for tests of the package for Python, what makes the .deb and
#                                tries it in a bare root
#   scripts/setup.sh --release   also what scripts/release.sh needs: --package, lintian and pip
set -euo pipefail

packages=(
    g++ cmake ninja-build ccache pkg-config git
    libsystemc-dev libeigen3-dev libopencv-core-dev libopencv-imgproc-dev libopencv-imgcodecs-dev catch2 libyaml-cpp-dev libcli11-dev libfmt-dev
    nlohmann-json3-dev libbenchmark-dev libmeshoptimizer-dev libnanoflann-dev libjs-chart.js libzstd-dev libpng-dev libtiff-dev zlib1g-dev
    python3-dev python3-numpy python3-venv python3-setuptools python3-wheel pybind11-dev libboost-dev libcpp-httplib-dev libutfcpp-dev libpugixml-dev graphviz verilator
)

for argument in "$@"; do
    case "$argument" in
        --package) packages+=(dpkg-dev help2man) ;;
        --dev) packages+=(clang-format clang-tidy chromium-headless-shell strace valgrind yosys python3-matplotlib python3-pandas
            debootstrap dpkg-dev help2man) ;;
        --release) packages+=(dpkg-dev help2man lintian python3-pip) ;;
        -h | --help)
            echo "usage: setup.sh [--package] [--dev] [--release]"
            exit 0
            ;;
        *)
            echo "setup: unknown argument '$argument'; expected --package, --dev or --release" >&2
            exit 2
            ;;
    esac
done

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "setup: not a Debian system; nothing installed. faster-sim needs the equivalents of: ${packages[*]}" >&2
    exit 0
fi

is_installed() {
    [[ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null || true)" == installed ]]
}

missing=()
for package in "${packages[@]}"; do
    is_installed "$package" || missing+=("$package")
done

if ((${#missing[@]} == 0)); then
    echo "setup: all ${#packages[@]} packages are installed"
    exit 0
fi

as_root=()
if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
        echo "setup: neither root nor sudo; please have these packages installed: ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi

echo "setup: installing ${#missing[@]} of ${#packages[@]} packages: ${missing[*]}"
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q </dev/null
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
echo "setup: done"
