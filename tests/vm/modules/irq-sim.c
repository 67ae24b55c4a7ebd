// SPDX-License-Identifier: GPL-2.0+
/* irq-sim.c -- the kernel's simulated interrupts, which gpio-sim needs, as a module.
 *
 * Debian does not enable CONFIG_IRQ_SIM, and irq_to_desc() is not exported to modules. The kernel's
 * own file is used unchanged, with that call replaced by two exported calls. On 6.1 an interrupt
 * domain is never freed (gpio-sim-held.c gives the reason). */
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
