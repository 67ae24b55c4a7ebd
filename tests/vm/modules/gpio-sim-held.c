// SPDX-License-Identifier: GPL-2.0-or-later
/* gpio-sim-held.c -- the kernel module gpio-sim, changed so that a chip can be removed while a
 * program holds its lines.
 *
 * In Linux 6.1, the removal of a chip also frees the interrupts of its lines, even if a program
 * still waits for them. When that program closes the lines, the kernel writes into freed memory,
 * which causes a general protection fault. This module therefore never frees the interrupts. The
 * leak of a few kilobytes is harmless in a temporary machine. Linux 6.12 first detaches the
 * interrupts from the program and needs no change. All other code is the kernel's own. */
#include <linux/irqdomain.h>
#include <linux/module.h>
#include <linux/version.h>

#if LINUX_VERSION_CODE < KERNEL_VERSION(6, 12, 0)
#define irq_dispose_mapping(irq) ((void)(irq))
#endif
#undef pr_fmt
#include "gpio-sim.c"
