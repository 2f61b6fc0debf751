# Completion of bash for faster-sim, from what its --help and `faster-sim keys` say. `source` this file, or install it as
# /usr/share/bash-completion/completions/faster-sim.

_faster_sim() {
    local program="${COMP_WORDS[0]}" current="${COMP_WORDS[COMP_CWORD]}" previous="${COMP_WORDS[COMP_CWORD - 1]}"
    # The words that name the command so far, as `sweep merge`; `help` in front of them is left out.
    local word named=1 command=() commands
    commands="$(_faster_sim_commands "$program")"
    for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
        if [[ "$word" != help || "$named" != 1 ]]; then
            grep -qxF -e "$word" <<<"$commands" || break
            command+=("$word")
            commands="$(_faster_sim_commands "$program" "${command[@]}")"
        fi
        named=$((named + 1))
    done
    if [[ "$previous" == --set || "$previous" == --twin-set ]]; then
        mapfile -t COMPREPLY < <(compgen -S = -W "$(_faster_sim_keys "$program")" -- "$current")
        compopt -o nospace
    elif [[ "$current" == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_faster_sim_options "$program" "${command[@]}")" -- "$current")
    elif ((named == COMP_CWORD && ${#command[@]} == 0)); then
        ((named > 1)) || commands+=" help"
        mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current")
    elif ((named == COMP_CWORD)) && [[ -n "$commands" ]]; then # a file may follow as well
        mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current"; compgen -f -- "$current")
        compopt -o filenames
    else
        compopt -o default
    fi
}
# _faster_sim_commands PROGRAM COMMAND...
_faster_sim_commands() {
    "$@" --help 2>/dev/null | awk '/^Subcommands:/ { within = 1; next } within && NF { print $1 }'
}
# _faster_sim_options PROGRAM COMMAND...
_faster_sim_options() {
    "$@" --help 2>/dev/null | grep -oE '^ +(-[a-z],)?--[a-z0-9-]+' | grep -oE -- '--[a-z0-9-]+'
}
_faster_sim_keys() {
    "$1" keys 2>/dev/null | grep -oE '^\| `[a-z0-9_.]+`' | tr -d '|` '
}
complete -F _faster_sim faster-sim
