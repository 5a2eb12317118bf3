/* SPDX-License-Identifier: MIT
 *
 * tool.h: the host tool run inside of a fuzzer, with a memory file for each of its streams.
 */
#ifndef TOOL_H
#define TOOL_H

#include <stddef.h>
#include <stdint.h>

/* The entries that libFuzzer calls. */
int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Goes to a folder of its own, and makes the files there that arguments may name (tool.c). */
void tool_begin(void);

/* Runs the tool.
 *
 * argv   the arguments, argv[0] the tool's name, behind the last a null. They must name nothing
 *        outside of the folder.
 * input  what it finds on its standard input.
 *
 * Checks what holds of every run: the exit code is 0 to 3; if it is not 0, there is one line on
 * stderr that says why, and nothing else (of watch: its last line); JSON is printed whole, or
 * not at all. What is printed beyond a limit cannot be written. */
void tool_run(int argc, char **argv, const uint8_t *input, size_t size);

#endif
