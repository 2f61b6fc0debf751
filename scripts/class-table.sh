# Sourced by the scripts that print tables of docs: rows of how long the five classes take, in ms, as Markdown. Expects
# sim, the program, and the repository as the current folder.
classes=(potted_meat_can banana mustard_bottle cracker_box tomato_soup_can)
always=() # settings of every run
meshes=   # folder with a CLASS.obj each; empty: built-in models

milliseconds() { # CLASS SETTING...
    local words=() setting
    for setting in "${always[@]}" "${@:2}" ${meshes:+"workload.object=$meshes/$1.obj"}; do
        words+=(--set "$setting")
    done
    "$sim" run "configs/$1.yaml" "${words[@]}" | sed -n 's/^total .* = \([0-9.]*\) ms$/\1/p'
}

header() { # [TITLE]
    if (($# > 0)); then
        printf '\n%s\n\n' "$1"
    fi
    printf '| ms |'
    printf ' %s |' "${classes[@]}"
    printf '\n| --- | --- | --- | --- | --- | --- |\n'
}

row() { # TITLE SETTING...
    local class time
    printf '| %s |' "$1"
    for class in "${classes[@]}"; do
        time=$(milliseconds "$class" "${@:2}")
        printf ' %.2f |' "$time"
    done
    printf '\n'
}
