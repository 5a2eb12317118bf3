/* SPDX-License-Identifier: MIT
 *
 * cli/message.h: errors on stderr, one line each.
 */
#ifndef MESSAGE_H
#define MESSAGE_H

#if defined(__GNUC__)
#define MESSAGE_FORMAT(text, first) __attribute__((format(printf, text, first)))
#else
#define MESSAGE_FORMAT(text, first)
#endif

/* Longer messages are truncated. */
#define MESSAGE_MAX 8192

/* Prints `invcal: ` and the message on one line: control characters become '?'. */
void message(const char *format, ...) MESSAGE_FORMAT(1, 2);

/* The latest message, without its prefix and suffix; "" if there was none. */
const char *message_last(void);

/* The same, followed by a reference to the help of `command` (null: of the tool). Returns
 * EXIT_USAGE. */
int message_usage(const char *command, const char *format, ...) MESSAGE_FORMAT(2, 3);

#endif
