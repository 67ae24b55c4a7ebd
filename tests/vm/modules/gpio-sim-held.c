// SPDX-License-Identifier: GPL-2.0-or-later
/* gpio-sim-held.c -- gpio-sim, whose chip can be pulled out while a program holds its lines.
 *
 * Linux 6.1 frees the lines' interrupts with the chip, also those that a program still waits on:
 * the kernel then writes into freed memory when that program lets go ("removing non-empty
 * directory 'irq/32', leaking at least ..."; a general protection fault soon after). There they
 * are kept for good: a few kilobytes each time, in a machine that is thrown away. Linux 6.12 takes
 * them from the program first. All else is the kernel's own. */
#include <linux/irqdomain.h>
#include <linux/module.h>
#include <linux/version.h>

#if LINUX_VERSION_CODE < KERNEL_VERSION(6, 12, 0)
#define irq_dispose_mapping(irq) ((void)(irq))
#endif
#undef pr_fmt
#include "gpio-sim.c"
