/* SPDX-License-Identifier: MIT
 *
 * What is printed in columns. The width of a text is that of the characters in Unicode's tables
 * (EastAsianWidth, general category Mn); where lines end was counted by hand.
 */
#define _POSIX_C_SOURCE 200809L
#include "text/wrapped.h"

#include <stdlib.h>
#include <string.h>

#include "cli/help.h"
#include "text/tabular.h"
#include "text/utf8.h"
#include "unity.h"

static FILE *file;
static char printed[65536];

void setUp(void)
{
    file = tmpfile();
    TEST_ASSERT_NOT_NULL(file);
    setenv("COLUMNS", "60", 1);
}

void tearDown(void)
{
    fclose(file);
}

/* Returns everything printed so far, and forgets it. */
static const char *said(void)
{
    rewind(file);
    printed[fread(printed, 1, sizeof printed - 1, file)] = '\0';
    fclose(file);
    file = tmpfile();
    return printed;
}

static void columns_are_those_of_a_terminal(void)
{
    TEST_ASSERT_EQUAL_UINT(0, utf8_columns(""));
    TEST_ASSERT_EQUAL_UINT(6, utf8_columns("9.81 g"));
    TEST_ASSERT_EQUAL_UINT(9, utf8_columns("± µg m/s²"));
    TEST_ASSERT_EQUAL_UINT(4, utf8_columns("日本"));
    TEST_ASSERT_EQUAL_UINT(1, utf8_columns("e\xCC\x81")); /* a combining acute */
    TEST_ASSERT_EQUAL_UINT(2, utf8_columns("\xFF\xFE"));  /* not UTF-8: one column per byte */
    TEST_ASSERT_EQUAL_UINT(5, utf8_columns("\033[1;32mGood:\033[0m"));
    TEST_ASSERT_EQUAL_UINT(4, utf8_columns("\033[2J")); /* clears the screen: not a colour */
    TEST_ASSERT_EQUAL_UINT(1, utf8_columns_of("±12", 2));
}

static void the_width_is_stated_or_eighty(void)
{
    static const struct {
        const char *stated;
        size_t width;
    } cases[] = {{"60", 60},  {"132", 132}, {"59", 60},  {"1", 60}, {"0", 80},
                 {"-70", 80}, {"", 80},     {"70x", 80}, {"x", 80}, {"100000", 80}};

    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        setenv("COLUMNS", cases[i].stated, 1);
        TEST_ASSERT_EQUAL_UINT_MESSAGE(cases[i].width, wrapped_width(file), cases[i].stated);
    }
    unsetenv("COLUMNS");
    TEST_ASSERT_EQUAL_UINT(80, wrapped_width(file));
}

static void a_text_breaks_between_words(void)
{
    wrapped_printf(file, 4, "%s", "0123456789 0123456789 0123456789 0123456789 0123456789 01234");
    TEST_ASSERT_EQUAL_STRING("0123456789 0123456789 0123456789 0123456789 0123456789 01234\n",
                             said());
    wrapped_printf(file, 4, "%s",
                   "0123456789 0123456789 0123456789 0123456789 0123456789 012345 6");
    TEST_ASSERT_EQUAL_STRING(
        "0123456789 0123456789 0123456789 0123456789 0123456789\n    012345 6\n", said());
}

static void what_belongs_together_stays(void)
{
    /* 55 columns, and then a word that would fit, but not with what must stay with it. */
    static const char before[] = "0123456789 0123456789 0123456789 0123456789 0123456789 ";
    static const struct {
        const char *text;
        const char *broken;
    } cases[] = {{"--lsb 0.0006", "--lsb 0.0006"},
                 {"± 0.0006", "± 0.0006"},
                 {"0.006 %", "0.006 %"},
                 {"1\302\240second", "1\302\240second"}};
    char all[200];
    char wanted[200];

    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        snprintf(all, sizeof all, "%s%s", before, cases[i].text);
        snprintf(wanted, sizeof wanted, "%.*s\n%s\n", (int)strlen(before) - 1, before,
                 cases[i].broken);
        wrapped_line(file, 0, 0, all);
        TEST_ASSERT_EQUAL_STRING(wanted, said());
    }
}

static void a_word_that_is_too_long_stays_whole(void)
{
    char path[101];

    memset(path, '/', 100);
    path[100] = '\0';
    wrapped_printf(file, 0, "Saved in %s.", path);
    TEST_ASSERT_EQUAL_UINT(strlen("Saved in\n") + 100 + strlen(".\n"), strlen(said()));
    TEST_ASSERT_EQUAL_STRING_LEN("Saved in\n/", printed, 10);
}

static void a_command_is_whole_or_continues_after_a_backslash(void)
{
    wrapped_command(file, 5, 2, "invcal apply cal.json LOG");
    TEST_ASSERT_EQUAL_STRING(" invcal apply cal.json LOG\n", said());
    wrapped_command(file, 50, 2, "invcal apply cal.json LOG");
    TEST_ASSERT_EQUAL_STRING("\n  invcal apply cal.json LOG\n", said());
    wrapped_command(
        file, 50, 2,
        "invcal calibrate 'a log of the left unit.csv' --gravity 9.81744 --out cal.json");
    TEST_ASSERT_EQUAL_STRING("\n  invcal calibrate 'a log of the left unit.csv' \\\n"
                             "    --gravity 9.81744 --out cal.json\n",
                             said());
}

static void a_table_is_as_wide_as_its_cells(void)
{
    tabular_begin(file, "lrlr");
    tabular_heading("|by J1|± sigma|ratio");
    for (unsigned i = 0; i < 2; i++) {
        tabular_cell("offset %c", "xy"[i]);
        tabular_cell("%.2f", i == 0 ? 327.68 : -5.0);
        tabular_cell("± %.1f", 0.5);
        if (i == 0) {
            tabular_cell("1.00");
        }
        tabular_note("mg");
        tabular_row();
    }
    tabular_end();
    TEST_ASSERT_EQUAL_STRING("           by J1 ± sigma  ratio\n"
                             "offset x  327.68 ± 0.5     1.00  mg\n"
                             "offset y   -5.00 ± 0.5           mg\n",
                             said());
}

/* 20 columns, then 12, 12, 11 and 12; the third row has nothing in the last. */
static void a_table_that_is_too_wide_is_two(void)
{
    tabular_begin(file, "lrrlr");
    tabular_heading("|a|b|± sigma|c");
    for (unsigned i = 0; i < 3; i++) {
        tabular_cell("a name of twenty %u..", i);
        for (unsigned c = 0; c < (i < 2 ? 4u : 1u); c++) {
            tabular_cell("%u123456789", c);
        }
        tabular_note(i == 0 ? "mg" : "%%");
        tabular_row();
    }
    tabular_end();
    TEST_ASSERT_EQUAL_STRING("                               a           b ± sigma\n"
                             "in mg\n"
                             "a name of twenty 0..  0123456789  1123456789 2123456789\n"
                             "in %\n"
                             "a name of twenty 1..  0123456789  1123456789 2123456789\n"
                             "a name of twenty 2..  0123456789\n"
                             "\n"
                             "                               c\n"
                             "a name of twenty 0..  3123456789\n"
                             "a name of twenty 1..  3123456789\n",
                             said());
}

/* A heading, and then 127 rows of each part. */
static void no_row_of_a_long_table_is_lost(void)
{
    unsigned headings = 0;
    unsigned rows = 0;

    tabular_begin(file, "rr");
    tabular_heading("position|alpha");
    for (unsigned i = 1; i <= 3000; i++) {
        tabular_cell("%u", i);
        tabular_cell("%u", 3 * i);
        tabular_row();
    }
    tabular_end();
    (void)said();
    for (char *line = strtok(printed, "\n"); line; line = strtok(NULL, "\n")) {
        unsigned a;
        unsigned b;
        headings += strstr(line, "position") != NULL;
        if (sscanf(line, "%u %u", &a, &b) == 2) {
            TEST_ASSERT_EQUAL_UINT(++rows, a);
            TEST_ASSERT_EQUAL_UINT(3 * a, b);
        }
    }
    TEST_ASSERT_EQUAL_UINT(3000, rows);
    TEST_ASSERT_EQUAL_UINT((3000 + 126) / 127, headings);
}

static void a_heading_alone_is_not_a_table(void)
{
    tabular_begin(file, "rr");
    tabular_heading("a|b");
    tabular_end();
    TEST_ASSERT_EQUAL_STRING("", said());
}

static void a_help_is_laid_out_again(void)
{
    static const char *const help[] = {
        "usage: invcal polish LOG [options]\n"
        "       invcal polish --nothing [--with-a-long-name NAME] [options]\n"
        "\n"
        "Polishes readings. Lines of the source are of any\n"
        "length.\n"
        "\n"
        "  shine = polish (dust)\n"
        "\n"
        "  --positions         rows are the means of positions, each of many samples\n"
        "  --frame symmetric|triangular\n"
        "                      of the result;\n"
        "                      default symmetric\n",
        "    edges             a word in its place\n"
        "\n"
        "example:\n"
        "  invcal polish log.csv --positions \\\n"
        "      --frame triangular > polished.csv\n"
        "  invcal polish\n",
        NULL};

    help_print(file, help);
    TEST_ASSERT_EQUAL_STRING("usage: invcal polish LOG [options]\n"
                             "       invcal polish --nothing [--with-a-long-name NAME]\n"
                             "           [options]\n"
                             "\n"
                             "Polishes readings. Lines of the source are of any length.\n"
                             "\n"
                             "  shine = polish (dust)\n"
                             "\n"
                             "  --positions         rows are the means of positions, each\n"
                             "                      of many samples\n"
                             "  --frame symmetric|triangular\n"
                             "                      of the result; default symmetric\n"
                             "    edges             a word in its place\n"
                             "\n"
                             "example:\n"
                             "  invcal polish log.csv --positions --frame triangular \\\n"
                             "    > polished.csv\n"
                             "  invcal polish\n",
                             said());
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(columns_are_those_of_a_terminal);
    RUN_TEST(the_width_is_stated_or_eighty);
    RUN_TEST(a_text_breaks_between_words);
    RUN_TEST(what_belongs_together_stays);
    RUN_TEST(a_word_that_is_too_long_stays_whole);
    RUN_TEST(a_command_is_whole_or_continues_after_a_backslash);
    RUN_TEST(a_table_is_as_wide_as_its_cells);
    RUN_TEST(a_table_that_is_too_wide_is_two);
    RUN_TEST(no_row_of_a_long_table_is_lost);
    RUN_TEST(a_heading_alone_is_not_a_table);
    RUN_TEST(a_help_is_laid_out_again);
    return UNITY_END();
}
