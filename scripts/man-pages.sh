#!/usr/bin/env bash
# Man pages of the tool and of each of its commands, from their --help.
#   scripts/man-pages.sh PROGRAM FOLDER
set -euo pipefail
program="$1"
folder="$2"
mkdir -p "$folder"

# page NAME COMMAND...
page() {
    local name="$1"
    shift
    local summary
    summary="$("$@" --help | sed -n 1p)" # all of it is read: nobody is killed by a closed pipe
    help2man --no-info --no-discard-stderr --section 1 --name "$summary" --version-string "$name $("$program" --version)" \
        --manual "faster-sim" --output "$folder/$name.1" "$*"
    gzip -9nf "$folder/$name.1"
}

mapfile -t commands < <("$program" --help | awk '/^Subcommands:/ { within = 1; next } within && NF { print $1 }')
((${#commands[@]} > 0)) || {
    echo "man-pages: $program --help lists no subcommands" >&2
    exit 1
}
for command in "${commands[@]}"; do
    page "faster-sim-$command" "$program" "$command"
done
page faster-sim "$program"
