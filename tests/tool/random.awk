# SPDX-License-Identifier: MIT
#
# Random numbers, the same with every awk: awk -f random.awk -f PROGRAM; or in front of a program,
# awk "$random_awk"'PROGRAM', as support.sh says. rand() and srand() give each awk other numbers.
# Park and Miller's generator: all its products are below 2^53, so they are exact.
function uniform() { # between 0 and 1, never either
    random_state = 16807 * random_state % 2147483647
    return random_state / 2147483647
}
function normal() { return sqrt(-2 * log(uniform())) * cos(6.283185307179586 * uniform()) }
function begin_random(seed,    i) {
    random_state = 1 + seed
    for (i = 0; i < 20; i++) uniform()
}
