#!/bin/sh
# SPDX-License-Identifier: MIT
#
# One fuzzer, for tests/fuzz.sh: sh tests/fuzz/run.sh OUT SECONDS NAME
here=$(cd "$(dirname "$0")" && pwd)
out=$(cd "$1" && pwd)
seconds=$2
name=$3
work=$out/$name
[ -n "$KEEP" ] || rm -rf "$work"
rm -rf "$work/seeds" "$work/folder"
mkdir -p "$work/seeds" "$work/corpus" "$work/folder"

# Seeds are plain text, or bytes as hexadecimal digits with comments.
unhex() {
    # shellcheck disable=SC2059 # the format is what is to be printed
    printf "$(sed 's/#.*//' "$1" | tr -d ' \n' | awk '
        function digit(i) { return index("0123456789abcdef", substr($0, i, 1)) - 1 }
        { for (i = 1; i < length($0); i += 2) printf "\\%03o", 16 * digit(i) + digit(i + 1) }')"
}
for seed in "$here/seeds/$name"/*; do
    case $seed in
    *.hex) unhex "$seed" > "$work/seeds/$(basename "$seed" .hex)" ;;
    *) cp "$seed" "$work/seeds" ;;
    esac
done

set -- "$work/corpus" "$work/seeds"
[ ! -e "$here/$name.dict" ] || set -- -dict="$here/$name.dict" "$@"
least=$(sed -n 's/.*fuzz: more than \([0-9]*\) inputs per second.*/\1/p' "$here/$name.c")
most=$(sed -n 's/.*fuzz: of at most \([0-9]*\) bytes.*/\1/p' "$here/$name.c")
FUZZ_FOLDER=$work/folder "$out/fuzz-$name" -seed=1 -max_total_time="$seconds" \
    -max_len="${most:-2000}" -timeout=60 -print_final_stats=1 \
    -artifact_prefix="$work/found-" "$@" > "$work/log" 2>&1
status=$?
rm -rf "$work/folder"
# Seconds of CPU time, not of the clock: a busy machine is no fault. (In a substitution `times` would be 0.)
times > "$work/times"
used=$(awk -F '[ms ]+' 'NR == 2 { print int(60 * ($1 + $3) + $2 + $4) }' "$work/times")

# Its last word: #number ... cov: edges ft: features corp: inputs/bytes
edges() { sed -n "s/^#[0-9]*[[:blank:]]*$1 *cov: \([0-9]*\).*/\1/p" "$work/log"; }
tried=$(sed -n 's/^stat::number_of_executed_units: *//p' "$work/log")
reached=$(sed -n 's/^#[0-9]*[[:blank:]]*DONE *\(cov: [0-9]*\).*corp: \([0-9]*\).*/\1, \2 kept/p' "$work/log")
result=PASS
if [ $status -ne 0 ]; then
    grep -aE 'does not hold|runtime error|ERROR|^SUMMARY|Test unit' "$work/log"
    result=FAIL
elif [ "${tried:-0}" -le $((least * used)) ]; then
    echo "$name: at most $least inputs per second"
    result=FAIL
elif [ "$FLOORS" = update ]; then # three quarters of what the seeds alone reach: code may become shorter
    sh "$here/../floor.sh" $(($(edges INITED) * 3 / 4))+ "edges-$name"
else
    reaches=$(edges DONE)
    said=$(WHAT=edges sh "$here/../floor.sh" "${reaches:-0}" "edges-$name") || result=FAIL
    [ -z "$said" ] || echo "${said%: FAIL}" # that is what the next line says
fi
echo "$name: ${tried:-0} inputs, ${reached:-nothing reached}: $result"
