/* doctor_rules.c -- the USB vendor and product ids that board/udev/70-kingyo.rules contains.
 *
 * The table is a copy, so that doctor runs without the rules file. A test in tests/ctl compares the
 * table with the rules file. */
#include "platform/ctl/doctor/doctor_rules.h"

#include <stdio.h>

/* clang-format off */
static const struct {
    uint16_t vendor, product;
} listed[] = {
    { 0x1209, 0x0001 }, /* Kingyo's own poi controller (a paper scoop with sensors), with its
                           development id. */
    { 0x054c, 0x05c4 }, { 0x054c, 0x09cc }, { 0x054c, 0x0ba0 }, { 0x054c, 0x0ce6 },
    { 0x054c, 0x0df2 },
    /* 3Dconnexion controllers, first with the vendor id of 3Dconnexion and then with Logitech's. */
    { 0x256f, 0xc62e }, { 0x256f, 0xc62f }, { 0x256f, 0xc631 }, { 0x256f, 0xc632 },
    { 0x256f, 0xc633 }, { 0x256f, 0xc635 }, { 0x256f, 0xc636 }, { 0x256f, 0xc652 },
    { 0x046d, 0xc626 }, { 0x046d, 0xc627 }, { 0x046d, 0xc628 }, { 0x046d, 0xc629 },
    { 0x046d, 0xc62b },
};
/* clang-format on */

static bool is_listed(uint16_t vendor, uint16_t product)
{
    for (uint32_t i = 0; i < sizeof listed / sizeof listed[0]; i++) {
        if (listed[i].vendor == vendor && listed[i].product == product) {
            return true;
        }
    }
    return false;
}

void doctor_rules_todo(char *out, size_t size, uint16_t vendor, uint16_t product)
{
    if (is_listed(vendor, product)) {
        snprintf(out, size, "sudo cp board/udev/*.rules /etc/udev/rules.d/ and replug it");
    } else {
        snprintf(out, size,
                 "put into /etc/udev/rules.d/71-kingyo-local.rules and replug it: "
                 "SUBSYSTEM==\"usb\", ATTR{idVendor}==\"%04x\", ATTR{idProduct}==\"%04x\", "
                 "GROUP=\"kingyo\", MODE=\"0660\", ATTR{power/control}=\"on\"",
                 vendor, product);
    }
}
