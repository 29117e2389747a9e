# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of abut in fish. Commands and options are asked of the program itself, so that they are always its own.

# The commands, or the options of one: the first words of the lines that are indented by two blanks.
function __abut_words
    $argv --help 2>/dev/null | string replace -rf '^  (-{0,2}[a-z][a-z-]*) .*' '$1'
end

function __abut_complete
    set -l words (commandline -opc)
    set -l word (commandline -ct)
    set -l program $words[1]
    if test (count $words) -eq 1
        __abut_words $program
        printf '%s\n' --help --version
        return
    end
    switch $words[-1]
        case --accuracy
            printf '%s\n' draft standard fine
        case --only
            echo contacts
        case --parts-by
            printf '%s\n' auto layer block loop color node
        case --units
            printf '%s\n' mm cm m in ft um
        case --section
            printf '%s\n' x y z
        case '*'
            if string match -q -- '-*' $word
                __abut_words $program $words[2]
                echo --help
            else if test $words[2] = help
                __abut_words $program
                $program help --keys 2>/dev/null
            else
                test $words[2] = verify; and $program verify --list 2>/dev/null | string replace -rf '^([A-Za-z0-9]\S*) .*' '$1'
                __fish_complete_path $word
            end
    end
end

complete -c abut -f -a '(__abut_complete)'
