// SPDX-License-Identifier: GPL-2.0-or-later
/* gpio-sim-held.c -- the kernel module gpio-sim, changed so that a chip can be removed while a
 * program holds its lines.
 *
 * Linux 6.1 frees the interrupts of the lines with the chip, even if a program still waits for
 * them. When that program closes the lines, the kernel writes into freed memory, and a general
 * protection fault follows. This module therefore never frees the interrupts. The leak of a few
 * kilobytes is harmless in a temporary machine. Linux 6.12 detaches the interrupts from the program
 * first and needs no change. All other code is the kernel's own. */
#include <linux/irqdomain.h>
#include <linux/module.h>
#include <linux/version.h>

#if LINUX_VERSION_CODE < KERNEL_VERSION(6, 12, 0)
#define irq_dispose_mapping(irq) ((void)(irq))
#endif
#undef pr_fmt
#include "gpio-sim.c"
