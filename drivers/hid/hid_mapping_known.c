/* hid_mapping_known.c -- mappings of known controllers whose descriptors are incomplete or unusual.
 *
 * The layouts of the reports are those of drivers/hid/hid-playstation.c in the Linux kernel: struct
 * dualshock4_input_report_common and struct dualsense_input_report. */
#include "drivers/hid/hid_mapping_auto.h"

#define SONY 0x054cu
/* Dead zone of a stick in counts; full deflection is 127 counts. A worn stick stops within the dead
 * zone when it is released. */
#define STICK_DEAD 12

struct known {
    uint16_t vendor, product;
    const struct hid_binding *bindings;
    uint32_t count;
};

/* clang-format off */
#define STICK(role_, bit)                                                                        \
    {                                                                                             \
        .role = role_, .manner = HID_BINDING_RATE, .report_id = 1, .bit_offset = bit,              \
        .bit_size = 8, .rest = 128, .full = 255, .dead = STICK_DEAD                               \
    }
#define TURN(role_, bit)                                                                         \
    {                                                                                             \
        .role = role_, .manner = HID_BINDING_POSITION, .report_id = 1,                             \
            .bit_offset = bit, \
        .bit_size = 8, .rest = 0, .full = 255, .dead = STICK_DEAD                                 \
    }
#define BUTTON(role_, bit)                                                                       \
    {                                                                                             \
        .role = role_, .manner = HID_BINDING_PRESS, .report_id = 1, .bit_offset = bit,             \
        .bit_size = 1, .rest = 0, .full = 1                                                       \
    }
#define TRIGGER(role_, bit)                                                                      \
    {                                                                                             \
        .role = role_, .manner = HID_BINDING_PRESS, .report_id = 1, .bit_offset = bit,             \
        .bit_size = 8, .rest = 0, .full = 255                                                     \
    }
#define HAT(bit)                                                                                 \
    {                                                                                             \
        .role = HID_ROLE_HAT, .manner = HID_BINDING_HAT, .report_id = 1, .bit_offset = bit,        \
        .bit_size = 4, .rest = 0, .full = 7                                                       \
    }

/* Bindings of a DualShock 4. The button bits start at 36: square, cross, circle, triangle, L1, R1,
 * L2, R2, share, options. */
static const struct hid_binding dualshock4[] = {
    STICK(HID_ROLE_X, 0),         STICK(HID_ROLE_Z, 8),       TURN(HID_ROLE_ROLL, 16),
    TURN(HID_ROLE_PITCH, 24),     HAT(32),                    BUTTON(HID_ROLE_DIP, 37),
    BUTTON(HID_ROLE_OK, 37),      BUTTON(HID_ROLE_LEVEL, 38), BUTTON(HID_ROLE_FAN, 39),
    BUTTON(HID_ROLE_DIP, 41),     TRIGGER(HID_ROLE_DIP, 64),  BUTTON(HID_ROLE_START, 45),
};

/* Bindings of a DualSense. The triggers come before the buttons, whose bits start at 60. */
static const struct hid_binding dualsense[] = {
    STICK(HID_ROLE_X, 0),         STICK(HID_ROLE_Z, 8),       TURN(HID_ROLE_ROLL, 16),
    TURN(HID_ROLE_PITCH, 24),     HAT(56),                    BUTTON(HID_ROLE_DIP, 61),
    BUTTON(HID_ROLE_OK, 61),      BUTTON(HID_ROLE_LEVEL, 62), BUTTON(HID_ROLE_FAN, 63),
    BUTTON(HID_ROLE_DIP, 65),     TRIGGER(HID_ROLE_DIP, 40),  BUTTON(HID_ROLE_START, 69),
};
/* clang-format on */

#define ROW(product, table) { SONY, product, table, sizeof table / sizeof table[0] }

static const struct known knowns[] = {
    ROW(0x05c4, dualshock4), /* DualShock 4 */
    ROW(0x09cc, dualshock4), /* DualShock 4, second edition */
    ROW(0x0ba0, dualshock4), /* DualShock 4 wireless adapter */
    ROW(0x0ce6, dualsense),  /* DualSense */
    ROW(0x0df2, dualsense),  /* DualSense Edge */
};

int hid_mapping_known(struct hid_mapping *out, const struct hid_identity *identity,
                      const struct hid_descriptor *descriptor)
{
    for (uint32_t i = 0; i < sizeof knowns / sizeof knowns[0]; i++) {
        const struct known *known = &knowns[i];
        if (known->vendor == identity->vendor && known->product == identity->product) {
            struct hid_mapping map = { .source = HID_MAPPING_KNOWN, .style = HID_STYLE_FLY };
            for (uint32_t j = 0; j < known->count; j++) {
                hid_mapping_auto_bits(&map, known->bindings[j]);
            }
            if (hid_mapping_is_sound(&map, descriptor)) {
                *out = map;
                return 1;
            }
        }
    }
    return 0;
}
