/* SPDX-License-Identifier: MIT
 *
 * In place of Zephyr's header of this name: what the sample uses of it, as its documentation says.
 */
#ifndef MOCK_PRINTK_H
#define MOCK_PRINTK_H

__attribute__((format(printf, 1, 2))) void printk(const char *format, ...);

#endif
