/* SPDX-License-Identifier: MIT
 * A config header (INVCAL_CONFIG_HEADER) that reports programming errors to misuse.c. */
void misuse_assert(void);
#define INVCAL_ASSERT(condition) ((condition) ? (void)0 : misuse_assert())
