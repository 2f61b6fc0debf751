# Completion of bash for faster-sim, from what its --help and `faster-sim keys` say. `source` this file, or install it as
# /usr/share/bash-completion/completions/faster-sim.

_faster_sim() {
    local program="${COMP_WORDS[0]}" current="${COMP_WORDS[COMP_CWORD]}" previous="${COMP_WORDS[COMP_CWORD - 1]}"
    local command="${COMP_WORDS[1]}"
    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W "$(_faster_sim_commands "$program")" -- "$current")
    elif [[ "$previous" == --set ]]; then
        mapfile -t COMPREPLY < <(compgen -S = -W "$(_faster_sim_keys "$program")" -- "$current")
        compopt -o nospace
    elif [[ "$current" == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_faster_sim_options "$program" "$command")" -- "$current")
    else
        compopt -o default
    fi
}
_faster_sim_commands() {
    "$1" --help 2>/dev/null | awk '/^Subcommands:/ { within = 1; next } within && NF { print $1 }'
}
_faster_sim_options() {
    "$1" "$2" --help 2>/dev/null | grep -oE '^ +(-[a-z],)?--[a-z0-9-]+' | grep -oE -- '--[a-z0-9-]+'
}
_faster_sim_keys() {
    "$1" keys 2>/dev/null | grep -oE '^\| `[a-z0-9_.]+`' | tr -d '|` '
}
complete -F _faster_sim faster-sim
