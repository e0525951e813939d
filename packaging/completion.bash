# shellcheck shell=bash
# Completion of the programs of rockslope. The words come from the program itself: PROGRAM [SUBCOMMAND] --help-words.
_rockslope() {
    local word=${COMP_WORDS[COMP_CWORD]}
    local -a command=("${COMP_WORDS[0]}")
    local words
    words=$("${command[0]}" --help-words 2>/dev/null) || return 0
    # A first line without dashes is the name of a subcommand: this program has some.
    if [[ $words == [a-z]* ]]; then
        if ((COMP_CWORD > 1)); then
            command+=("${COMP_WORDS[1]}")
            words=$("${command[@]}" --help-words 2>/dev/null) || return 0
        else
            mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
            return 0
        fi
    fi
    if [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "${words//=/}" -- "$word")
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
    return 0
}
complete -o filenames -F _rockslope "${BASH_SOURCE[0]##*/}"
