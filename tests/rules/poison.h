/* SPDX-License-Identifier: MIT
 *
 * `make rules` includes this before every source of the library, after the libc headers that it may use:
 * the compiler rejects any of these names. tests/library.sh checks what the finished library calls,
 * tests/size.sh looks for recursion; this is for what leaves no trace there.
 */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* the heap, and unbounded stack */
#pragma GCC poison malloc calloc realloc free aligned_alloc strdup alloca __builtin_alloca
/* control flow that a reader cannot follow */
#pragma GCC poison setjmp longjmp sigsetjmp siglongjmp signal raise goto
#pragma GCC poison abort exit _Exit atexit system getenv
/* input and output */
#pragma GCC poison printf fprintf sprintf snprintf vprintf vfprintf vsprintf vsnprintf
#pragma GCC poison puts fputs putchar scanf fscanf sscanf fopen FILE stdin stdout stderr
/* text, and functions without a visible length */
#pragma GCC poison strcpy strncpy strcat strncat strtok gets atoi atof strtol strtod memmove
/* what costs too much, or differs between platforms */
#pragma GCC poison sin cos tan sinf cosf tanf sincos sincosf
#pragma GCC poison pow powf exp expf log logf asin acos atan atan2 asinf acosf atanf atan2f
#pragma GCC poison rand srand clock errno thread_local _Thread_local
#if !INVCAL_DOUBLE
/* the float build: no double, nor the functions that return one */
#pragma GCC poison double sqrt fabs
#endif
#pragma GCC poison asm __asm__ union
