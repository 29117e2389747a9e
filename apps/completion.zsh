#compdef abut
# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of abut in zsh. Commands and options are asked of the program itself, so that they are always its own.

# The commands, or the options of one: the first words of the lines that are indented by two blanks.
_abut_words() {
    "$@" --help 2>/dev/null | sed -n 's/^  \(-\{0,2\}[a-z][a-z-]*\) .*/\1/p'
}

_abut() {
    local word=$words[CURRENT] before=$words[CURRENT-1] program=$words[1] command=$words[2]
    if ((CURRENT == 2)); then
        compadd -- $(_abut_words $program) --help --version
        return
    fi
    case $before in
        --accuracy) compadd draft standard fine ;;
        --only) compadd contacts ;;
        --parts-by) compadd auto layer block loop color node ;;
        --units) compadd mm cm m in ft um ;;
        --section) compadd x y z ;;
        *)
            if [[ $word == -* ]]; then
                compadd -- $(_abut_words $program $command) --help
            elif [[ $command == help ]]; then
                compadd -- $(_abut_words $program) $($program help --keys 2>/dev/null)
            else
                [[ $command == verify ]] && compadd -- $($program verify --list 2>/dev/null | sed -n 's/^\([A-Za-z0-9][^ ]*\) .*/\1/p')
                _files
            fi
            ;;
    esac
}

_abut "$@"
