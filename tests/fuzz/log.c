/* SPDX-License-Identifier: MIT
 *
 * Files with any content, for every command that reads one: logs and positions with any heading,
 * calibrations, noise, directions. The first byte chooses the command line, the rest is the file.
 * fuzz: more than 20 inputs per second of CPU time
 * fuzz: of at most 16000 bytes
 */
#include <string.h>

#include "tool.h"

enum { WORDS_MOST = 16 };

/* `-` is the file; the others are those of tool.c. From 'a' on. */
static const char *const lines[] = {
    "calibrate - --json --report /dev/null",
    "calibrate - --positions --json",
    "calibrate - --positions --report /dev/null",
    "calibrate - --zero 20,-7,3 --lsb 0.0098 --report /dev/null",
    "calibrate - --positions --thermal 2 --json",
    "calibrate - --thermal 1 --report /dev/null",
    "calibrate - --positions --zero 20,-7,3 --lsb 0.0098 --noise 0.01 --prior 0.1,0.1,0.1 --json",
    "calibrate - --unit g --tolerance 0.1,0.1,0.1 --frame triangular",
    "calibrate - --rate 50 --clip -2000,2000 --keep-all",
    "calibrate positions.csv --positions --nominal - --json",
    "apply cal.json -",
    "apply slopes.json -",
    "apply - log.csv",
    "apply - thermal.csv --temperature 20",
    "watch - --json",
    "watch - --plan per-group:5 --mean-sigma 0.1 --target 0.1,0.1,0.1",
    "watch - --unit counts --thermal 1 --rate 25",
    "allan - --json --report /dev/null",
    "allan - --apart --tau 1,2,4 --rate 8 --report /dev/null",
    "plan --directions - --json",
    "plan --directions - --svg /dev/null --report /dev/null",
    "plan --limits 0.001,0.001,0.002 --allan - --json",
    "export - --format c",
    "export - --format px4 --zero 0,0,0 --lsb 0.01",
    "export - --format ros --lsb 0.01 --zero 0",
    "simulate --plan directions:- --rate 8 --dwell 1 --move 1",
    "calibrate - --columns 2,3,4 --json",
    "apply cal.json - --columns time=t,x=ax,y=2,z=az,temperature=5",
};

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    tool_begin();
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char words[256] = "invcal";
    char *argv[WORDS_MOST + 1] = {words};
    int argc = 1;

    if (size == 0) {
        return 0;
    }
    const char *line = lines[(data[0] + 256u - 'a') % 256u % (sizeof lines / sizeof lines[0])];
    memcpy(words + 7, line, strlen(line) + 1);
    for (char *word = strtok(words + 7, " "); word && argc < WORDS_MOST; word = strtok(NULL, " ")) {
        argv[argc++] = word;
    }
    tool_run(argc, argv, data + 1, size - 1);
    return 0;
}
