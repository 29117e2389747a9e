# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2207 # one word a line is what compgen gives
# Completion of abut in bash. Commands and options are asked of the program itself, so that they are always its own.

# The commands, or the options of one: the first words of the lines that are indented by two blanks.
_abut_words() {
    "$@" --help 2>/dev/null | sed -n 's/^  \(-\{0,2\}[a-z][a-z-]*\) .*/\1/p'
}

# What may follow an option. Fails where that is a file, or anything.
_abut_values() {
    case $1 in
        --accuracy) echo draft standard fine ;;
        --only) echo contacts ;;
        --parts-by) echo auto layer block loop color node ;;
        --units) echo mm cm m in ft um ;;
        --section) echo x y z ;;
        *) return 1 ;;
    esac
}

_abut() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} program=${COMP_WORDS[0]} values
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        COMPREPLY=($(compgen -W "$(_abut_words "$program") --help --version" -- "$word"))
    elif values=$(_abut_values "$before"); then
        COMPREPLY=($(compgen -W "$values" -- "$word"))
    elif [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$(_abut_words "$program" "${COMP_WORDS[1]}") --help" -- "$word"))
    elif [[ ${COMP_WORDS[1]} == verify && $before != -* ]]; then
        COMPREPLY=($(compgen -W "$("$program" verify --list 2>/dev/null | sed -n 's/^\([A-Za-z0-9][^ ]*\) .*/\1/p')" -- "$word"))
    elif [[ ${COMP_WORDS[1]} == help ]]; then
        COMPREPLY=($(compgen -W "$(_abut_words "$program") $("$program" help --keys 2>/dev/null)" -- "$word"))
    fi # else files, by the default of complete
}

complete -o default -F _abut abut
