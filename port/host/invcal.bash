# SPDX-License-Identifier: MIT
#
# Completion of invcal's command line for bash; for zsh after `autoload -U bashcompinit; bashcompinit`.
# Commands, options and their words are those that the tool's help names at this moment.

# Words to choose from, one on each line, for the option $2 in the help $1: of `a|b|c` each; of SET
# and `per-group:N` those of the table in the help. FILE for the name of a file, nothing for else.
_invcal_values() {
    awk -v option="$2" '
        $1 == option { value = $2; here = 1; next }
        here && /^    [a-z][a-z-]*/ && value == "SET" { set[n++] = $1 }
        /^  --/ { here = 0 }
        END {
            if (value ~ /^(FILE|LOG)$|\.(json|html|svg|csv)$/) print "FILE"
            else if (value ~ /^[a-z].*:/) set[n++] = value
            else if (value ~ /^[a-z].*\|/) n = split(value, set, "|")
            for (i in set) { sub(/:.*/, ":", set[i]); if (!done[set[i]]++) print set[i] }
        }' <<< "$1"
}

_invcal() {
    local IFS=$'\n' # names of files may hold blanks
    local tool=${COMP_WORDS[0]} command=${COMP_WORDS[1]} word=${COMP_WORDS[COMP_CWORD]}
    local before=${COMP_WORDS[COMP_CWORD - 1]} choice help
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        choice=$("$tool" --help 2> /dev/null |
            awk '/^  [a-z]/ && $1 != "invcal" { print $1 } END { print "--help\n--version" }')
        COMPREPLY=($(compgen -W "$choice" -- "$word"))
        return
    fi
    # bash cuts words at = and at : too
    case $word in = | :) before=${COMP_WORDS[COMP_CWORD - 1]} word= ;; esac
    [[ $before == = ]] && before=${COMP_WORDS[COMP_CWORD - 2]}
    [[ $before == directions || ${COMP_WORDS[COMP_CWORD - 2]} == directions ]] && before=--directions
    help=$("$tool" "$command" --help 2> /dev/null)
    if [[ $word == -* ]]; then
        choice=$(awk '/^  --/ { print $1 } END { print "--help" }' <<< "$help")
    elif awk -v o="$before" '$1 == o && /^  --/ && substr($0, length(o) + 4, 1) != " " { n = 1 }
        END { exit !n }' <<< "$help"; then
        choice=$(_invcal_values "$help" "$before")
        [[ $choice == *: ]] && compopt -o nospace 2> /dev/null
        [[ $choice ]] || return
    else
        choice=FILE
    fi
    if [[ $choice == FILE ]]; then
        compopt -o filenames 2> /dev/null # outside of bash, or of a completion, there is none
        COMPREPLY=($(compgen -f -- "$word"))
    else
        COMPREPLY=($(compgen -W "$choice" -- "$word"))
    fi
}

complete -F _invcal invcal
