/* SPDX-License-Identifier: MIT
 *
 * The sin and cos of glibc use mffscrni, an instruction that a PowerPC before 2017 executes as
 * mffs; glibc relies on that. In qemu 7.2 it is illegal: the handler replaces it by mffs.
 */
#define _POSIX_C_SOURCE 200809L
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#define MFFSCRNI UINT32_C(0xFC17048E)
#define MFFS UINT32_C(0xFC00048E)
#define REGISTER UINT32_C(0x03E00000) /* of the result */
#define MODE UINT32_C(0x00001800)     /* of rounding; mffs ignores it, glibc then sets it itself */

static void replace(int number, siginfo_t *info, void *context)
{
    uint32_t *const at = info->si_addr;
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    void *const begin = (char *)at - (uintptr_t)at % page;

    (void)context;
    if ((*at & ~(REGISTER | MODE)) != MFFSCRNI ||
        mprotect(begin, page, PROT_READ | PROT_WRITE | PROT_EXEC) != 0) {
        signal(number, SIG_DFL); /* executed again, the instruction ends the program */
        return;
    }
    *at = MFFS | (*at & REGISTER);
    __builtin___clear_cache((char *)at, (char *)(at + 1));
}

__attribute__((constructor)) static void install_handler(void)
{
    const struct sigaction action = {.sa_sigaction = replace, .sa_flags = SA_SIGINFO};

    if (sigaction(SIGILL, &action, NULL) != 0) {
        abort();
    }
}
