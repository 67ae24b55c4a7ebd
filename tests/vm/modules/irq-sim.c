// SPDX-License-Identifier: GPL-2.0+
/* irq-sim.c -- the kernel's simulated interrupts, which gpio-sim needs, as a loadable module.
 *
 * Debian's kernel does not enable CONFIG_IRQ_SIM. The module includes the kernel's own source file.
 * irq_to_desc(), which is not exported to modules, is replaced by two exported functions. On Linux
 * 6.1 an interrupt domain is never freed, for the reason given in gpio-sim-held.c. */
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
