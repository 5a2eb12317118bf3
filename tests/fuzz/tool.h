/* SPDX-License-Identifier: MIT
 *
 * tool.h: the host tool run inside a fuzzer, with a memory file for each of its streams.
 */
#ifndef TOOL_H
#define TOOL_H

#include <stddef.h>
#include <stdint.h>

/* The entries that libFuzzer calls. */
int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Goes to its own folder, and makes the files there that arguments may name (tool.c). */
void tool_begin(void);

/* Runs the tool.
 *
 * argv   the arguments, argv[0] the tool's name, a null after the last. They must name nothing outside
 *        the folder.
 * input  its standard input.
 *
 * Checks what holds for every run: the exit code is 0 to 3; if it is not 0, there is one line on stderr
 * that says why, and nothing else (for watch: its last line); JSON is printed whole, or not at all.
 * Writing beyond a limit fails. */
void tool_run(int argc, char **argv, const uint8_t *input, size_t size);

#endif
