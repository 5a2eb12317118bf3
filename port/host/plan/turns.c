/* SPDX-License-Identifier: MIT */
#include "plan/turns.h"
#include "text/parameter.h"
#include "text/unit.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/message.h"
#include "maths/eigen.h"

#define RANK_TOLERANCE 1e-9 /* of the largest eigenvalue */
#define IMPROVEMENT_MIN 1.1 /* sigma before over sigma after, to be listed */
#define TOKEN_MAX 32
#define DEGREES_MIN 1.0
#define DEGREES_MAX 720.0
#define NONE 1e-30 /* as 0 would be unknown to the library */

enum { ALL = INVCAL_IMU_PARAMETERS, NAMED = 2 };

/* ---- programs ----------------------------------------------------------------------------------- */

/* Nine quarter turns over all six faces, and a full turn about each axis. */
static const char faces[] = "+z,x:360,y:360,+x,z:360,+y,+z,-x,+y,-z,+x,-y,-z";

static int usage(const char *program, const char *what)
{
    return message_usage("plan", "--moves %s: %s", program, what);
}

static int append(turns_plan *p, const invcal_turn *turn)
{
    if (p->count == TURNS_MAX) {
        return message_usage("plan", "--moves %s: more than %u turns; a device stores %u rests",
                             p->program, TURNS_MAX, (unsigned)INVCAL_MAX_MOVES);
    }
    p->step[p->count++].turn = *turn;
    return EXIT_GOOD;
}

static int make_tour(turns_plan *p, unsigned turns)
{
    invcal_turn turn;

    for (unsigned i = 0; i < turns; i++) {
        (void)invcali_tour(i, &turn);
        (void)append(p, &turn);
    }
    return EXIT_GOOD;
}

/* The tour, and the same turns back. */
static int make_round_trip(turns_plan *p)
{
    (void)make_tour(p, INVCAL_TOUR);
    for (unsigned i = INVCAL_TOUR; i > 0; i--) {
        const invcal_real *to = i > 1 ? p->step[i - 2].turn.up : p->start;
        invcal_turn turn;
        (void)invcali_turn_to(p->step[i - 1].turn.up, to, &turn);
        (void)append(p, &turn);
    }
    return EXIT_GOOD;
}

static void begin_sums(const turns_plan *p, invcali_turns *turns)
{
    const turns_request *r = &p->request;
    const invcal_imu_settings settings = {.rate_noise = fmax(r->rate_noise, NONE),
                                          .instability = fmax(r->instability, NONE)};

    /* noise and direction are checked */
    (void)invcali_turns_begin(turns, p->start, &settings, r->noise);
    turns->seconds = r->turn;
}

/* greedyN: N turns, each the most informative one. */
static int make_greedy(turns_plan *p, const char *number)
{
    const size_t digits = strspn(number, "0123456789");
    const unsigned long turns = strtoul(number, NULL, 10);
    invcali_turns sums;
    invcal_turn turn;

    if (digits == 0 || digits > 2 || number[digits] != '\0' || turns < 1 || turns > TURNS_MAX) {
        return message_usage("plan", "--moves %s: greedy12 and the like, of 1 to %u turns",
                             p->program, TURNS_MAX);
    }
    begin_sums(p, &sums);
    for (unsigned long i = 0; i < turns; i++) {
        invcali_turns_next(&sums, &turn);
        (void)invcali_turns_add(&sums, &turn);
        (void)append(p, &turn);
    }
    return EXIT_GOOD;
}

/* ---- lists -------------------------------------------------------------------------------------- */

/* A direction: "+x", "+x-y", "-x-y+z". Returns 0 if the word is not one. */
static int read_up(const char *word, invcal_real up[3])
{
    double squares = 0;

    memset(up, 0, 3 * sizeof *up);
    while (*word != '\0') {
        if ((*word != '+' && *word != '-') || word[1] < 'x' || word[1] > 'z') {
            return 0;
        }
        const unsigned axis = (unsigned)(word[1] - 'x');
        if (up[axis] * up[axis] > 0) {
            return 0;
        }
        up[axis] = *word == '+' ? 1 : -1;
        squares++;
        word += 2;
    }
    for (unsigned i = 0; i < 3 && squares > 0; i++) {
        up[i] /= sqrt(squares);
    }
    return squares > 0;
}

/* A turn: "x:360", "-y:90". Returns 0 if the word is not one. */
static int read_turn(const char *word, invcal_turn *turn)
{
    const int is_back = *word == '-';
    char *end;

    *turn = (invcal_turn){{0, 0, 0}, 0, {0, 0, 0}};
    word += *word == '+' || *word == '-';
    if (*word < 'x' || *word > 'z' || word[1] != ':' || strchr("0123456789", word[2]) == NULL) {
        return 0;
    }
    turn->axis[*word - 'x'] = is_back ? -1 : 1;
    const double degrees = strtod(word + 2, &end);
    turn->angle = degrees * UNIT_DEGREE;
    return *end == '\0' && degrees >= DEGREES_MIN && degrees <= DEGREES_MAX;
}

static int add_word(turns_plan *p, const char *word, invcal_real up[3])
{
    invcal_real to[3];
    invcal_turn turn;

    if (read_up(word, to)) {
        if (invcali_turn_to(up, to, &turn) != INVCAL_OK) {
            return message_usage("plan",
                                 "--moves %s: '%s' points up or down already, so there is no "
                                 "shortest turn to it; name an axis, for example x:180",
                                 p->program, word);
        }
    } else if (read_turn(word, &turn)) {
        invcali_turns sums;
        (void)invcali_turns_begin(&sums, up, NULL, 0); /* to find the up direction after it */
        (void)invcali_turns_add(&sums, &turn);
        memcpy(turn.up, sums.up, sizeof turn.up);
    } else {
        return message_usage(
            "plan",
            "--moves %s: '%s' is not a program (" TURNS_PROGRAMS
            "), a direction (+x, +x-y, +x-y+z), or a turn (x:360, 1 to 720 degrees)",
            p->program, word);
    }
    memcpy(up, turn.up, sizeof turn.up);
    return append(p, &turn);
}

/* Words separated by commas. If the first one is a direction, it is up at the start; else z is. */
static int make_list(turns_plan *p, const char *list)
{
    invcal_real up[3] = {0, 0, 1};
    invcal_real first[3];
    char word[TOKEN_MAX];
    int failure = EXIT_GOOD;
    int is_first = 1;

    do {
        const size_t length = strcspn(list, ",");
        snprintf(word, sizeof word, "%.*s", (int)(length < TOKEN_MAX ? length : TOKEN_MAX - 1),
                 list);
        list += length;
        if (is_first && read_up(word, first)) {
            memcpy(up, first, sizeof up);
            memcpy(p->start, first, sizeof p->start);
        } else {
            failure = add_word(p, word, up);
        }
        is_first = 0;
    } while (!failure && *list++ == ',');
    if (!failure && p->count == 0) {
        return usage(p->program, "one rest without a turn does not calibrate a gyroscope");
    }
    return failure;
}

static int make(turns_plan *p, const char *word)
{
    if (strcmp(word, "tour12") == 0) {
        return make_tour(p, INVCAL_TOUR);
    }
    if (strcmp(word, "tour16") == 0) {
        return make_tour(p, INVCAL_TOUR_FULL);
    }
    if (strcmp(word, "tour24") == 0) {
        return make_round_trip(p);
    }
    if (strncmp(word, "greedy", 6) == 0) {
        return make_greedy(p, word + 6);
    }
    return make_list(p, strcmp(word, "faces") == 0 ? faces : word);
}

/* ---- evaluation --------------------------------------------------------------------------------- */

static unsigned bits_in(unsigned bits)
{
    unsigned count = 0;

    for (; bits; bits &= bits - 1) {
        count++;
    }
    return count;
}

/* The parameters whose sigma falls most, as bits. */
static unsigned find_most_improved(const double before[ALL], const double after[ALL])
{
    unsigned improved = 0;

    for (unsigned k = 0; k < NAMED; k++) {
        double best = IMPROVEMENT_MIN;
        unsigned which = ALL;
        for (unsigned i = 0; i < ALL; i++) {
            if (!(improved >> i & 1u) && before[i] > best * (1 + 1e-6) * after[i]) {
                best = before[i] / after[i];
                which = i;
            }
        }
        improved |= which < ALL ? 1u << which : 0;
    }
    return improved;
}

static double turn_seconds(const turns_plan *p, unsigned n)
{
    return p->request.turn * fmax(1, fabs(turns_degrees(&p->step[n].turn)) / 90);
}

static void find_spectrum(turns_plan *p, const invcali_turns *sums)
{
    double value[ALL];
    double max = 0;
    double min = HUGE_VAL;

    eigenvalues(sums->sum, ALL, value);
    for (unsigned i = 0; i < ALL; i++) {
        max = fmax(max, value[i]);
        min = fmin(min, value[i]);
    }
    for (unsigned i = 0; i < ALL; i++) {
        p->rank += value[i] > RANK_TOLERANCE * max;
    }
    p->condition = max / min;
}

static void write_refusal(turns_plan *p)
{
    char list[TURNS_LIST_MAX];
    char words[TURNS_WORDS_MAX];
    const invcal_real *up = p->count > 0 ? p->step[p->count - 1].turn.up : p->start;

    snprintf(p->refusal, sizeof p->refusal,
             "%u turn%s determine%s %u of 18 parameters; undetermined: %.700s. Turn next: %s",
             p->count, p->count == 1 ? "" : "s", p->count == 1 ? "s" : "", p->rank,
             parameter_list_imu(p->open, list, sizeof list), turns_words(&p->next, up, words));
}

static void evaluate(turns_plan *p)
{
    double sigma[2][ALL];
    uint32_t open;
    invcali_turns sums;
    invcal_status status = INVCAL_UNDETERMINED;

    begin_sums(p, &sums);
    (void)invcali_turns_sigma(&sums, NULL, sigma[0], &open);
    p->seconds = p->request.rest * (p->count + 1);
    for (unsigned i = 0; i < p->count; i++) {
        turns_step *step = &p->step[i];
        (void)invcali_turns_add(&sums, &step->turn); /* its axis and degrees are checked */
        status = invcali_turns_sigma(&sums, NULL, sigma[1], &open);
        step->open = status == INVCAL_OK ? 0 : bits_in(open);
        step->improves = find_most_improved(sigma[0], sigma[1]);
        memcpy(sigma[0], sigma[1], sizeof sigma[0]);
        p->seconds += turn_seconds(p, i);
    }
    p->is_determined = status == INVCAL_OK;
    p->open = open;
    memcpy(p->sigma, sigma[1], sizeof p->sigma);
    find_spectrum(p, &sums);
    invcali_turns_next(&sums, &p->next);
}

/* A calibration would refuse a move that is too long. */
static int check_time(const turns_plan *p)
{
    for (unsigned i = 0; i < p->count; i++) {
        if (turn_seconds(p, i) > TURNS_SECONDS_MAX) {
            return message_usage("plan",
                                 "--move %g: turn %u of %s would take %.3g s; the bias is known "
                                 "for %g s only: turn faster",
                                 p->request.turn, i + 1, p->program, turn_seconds(p, i),
                                 TURNS_SECONDS_MAX);
        }
    }
    return EXIT_GOOD;
}

int turns_make(turns_plan *p, const char *word, const turns_request *request)
{
    memset(p, 0, sizeof *p);
    p->program = word;
    p->request = *request;
    p->start[2] = 1;
    int failure = make(p, word);
    failure = failure ? failure : check_time(p);
    if (failure) {
        return failure;
    }
    evaluate(p);
    if (!p->is_determined) {
        write_refusal(p);
        return EXIT_DATA;
    }
    return EXIT_GOOD;
}
