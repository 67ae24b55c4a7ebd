// SPDX-License-Identifier: GPL-2.0+
/* irq-sim.c -- the kernel's simulated interrupts, which gpio-sim stands on, as a module.
 *
 * Debian leaves CONFIG_IRQ_SIM out, and irq_to_desc() is not for modules: the kernel's own file is
 * taken as it is, with that one call said by two that are. On 6.1 a domain is never given back:
 * gpio-sim-held.c says why. */
#include <linux/irq.h>
#include <linux/irqdesc.h>
#include <linux/irqdomain.h>
#include <linux/module.h>
#include <linux/version.h>

#define irq_to_desc(irq) irq_data_to_desc(irq_get_irq_data(irq))
#if LINUX_VERSION_CODE < KERNEL_VERSION(6, 12, 0)
#define irq_domain_remove(domain) ((void)(domain))
#endif
#include "irq_sim.c"

MODULE_LICENSE("GPL");
MODULE_DESCRIPTION("simulated interrupts for gpio-sim");
