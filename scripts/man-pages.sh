#!/usr/bin/env bash
# Man pages of the tool, of each of its commands, and of commands in these such as `sweep merge`, from their --help.
#   scripts/man-pages.sh PROGRAM FOLDER
set -euo pipefail
program="$1"
folder="$2"
mkdir -p "$folder"
version="$("$program" --version)"
version="${version%% *}" # without the commit: the foot of a page has no room for it

# page WORD...: of the command that these words are, and of those in it
page() {
    local name="faster-sim" word
    for word in "$@"; do
        name+="-$word"
    done
    local help commands
    help="$("$program" "$@" --help)"
    help2man --no-info --no-discard-stderr --section 1 --name "${help%%$'\n'*}" --version-string "$name $version" \
        --source "faster-sim $version" --manual "faster-sim" --output "$folder/$name.1" "$program $*"
    gzip -9nf "$folder/$name.1"
    mapfile -t commands < <(awk '/^Subcommands:/ { within = 1; next } within && NF { print $1 }' <<<"$help")
    (($# > 0 || ${#commands[@]} > 0)) || {
        echo "man-pages: $program --help lists no subcommands" >&2
        exit 1
    }
    for word in "${commands[@]}"; do
        page "$@" "$word"
    done
}
page
