# SPDX-License-Identifier: MIT
#
# Completion of invcal's command line for bash; for zsh after `autoload -U bashcompinit; bashcompinit`.
# Commands, options and their words are those that the tool's help names at this moment.
# shellcheck disable=SC2207 # old bash and zsh have no mapfile; IFS cuts at the ends of lines only

# What may follow the option $2 by the help $1, one on each line: of `a|b|C` a and b; of a SET, or
# `per-group:N`, words of the table in the help up to their colon; FILE for the name of a file.
# Fails if the option takes no value, or is none.
_invcal_values() {
    awk -v option="$2" '
        /^  --/ { here = index($0, "  " option " ") == 1 && substr($0, length(option) + 4, 1) != " " }
        here && /^  --/ { value = $2 }
        here && /^    [a-z]/ && value == "SET" { word[++n] = $1 }
        END {
            if (value ~ /^(FILE|LOG)$|\.(json|html|svg|csv)$/) print "FILE"
            if (value ~ /^[a-z].*[|:]/) n = split(value, word, "|")
            for (i = 1; i <= n; i++) {
                sub(/:.*/, ":", word[i])
                if (word[i] !~ /^[A-Z]/ && !seen[word[i]]++) print word[i]
            }
            exit value == ""
        }' <<< "$1"
}

_invcal() {
    local IFS=$'\n' # names of files may hold blanks
    local tool=${COMP_WORDS[0]} command=${COMP_WORDS[1]} word=${COMP_WORDS[COMP_CWORD]}
    local before=${COMP_WORDS[COMP_CWORD - 1]} choice help
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        choice=$("$tool" --help 2> /dev/null |
            awk '/^  [a-z]/ && $1 != "invcal" { print $1 } END { print "help\n--help\n--version" }')
        COMPREPLY=($(compgen -W "$choice" -- "$word"))
        return
    fi
    if [[ $command == help ]]; then
        choice=$("$tool" --help 2> /dev/null | awk '/^  [a-z]/ && $1 != "invcal" { print $1 }')
        COMPREPLY=($(compgen -W "$choice" -- "$word"))
        return
    fi
    help=$("$tool" "$command" --help all 2> /dev/null)
    # bash makes words of their own of = and :
    [[ $before == [=:] ]] && before=${COMP_WORDS[COMP_CWORD - 2]}
    [[ $word == [=:] ]] && word=
    if [[ $word == -* ]]; then
        choice=$(awk '/^  --/ { print $1 } END { print "--help" }' <<< "$help")
    elif [[ $before == directions || $before == angles ]]; then
        choice=FILE
    elif [[ $before == --sensor ]]; then
        choice=list$'\n'$("$tool" "$command" --sensor list 2> /dev/null | awk '/^[a-z0-9-]+  / { print $1 }')
    elif [[ $before == per-group || $before == optimal || $before == grid ]]; then
        return # a number
    elif ! choice=$(_invcal_values "$help" "$before"); then
        choice=$(_invcal_values "$help" --compare) || choice=FILE # an operand
    fi
    if [[ $choice == FILE ]]; then
        compopt -o filenames 2> /dev/null # zsh has none, nor has a test
        COMPREPLY=($(compgen -f -- "$word"))
    elif [[ $choice ]]; then
        COMPREPLY=($(compgen -W "$choice" -- "$word"))
        [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *: ]] && compopt -o nospace 2> /dev/null
    fi
    return 0
}

complete -F _invcal invcal
