/* hid_names.c -- the table of usage names. */
#include "platform/ctl/devices/hid_names.h"

#include <stdio.h>

#define PAGE_KEYBOARD 0x07u
#define PAGE_BUTTON 0x09u

/* First vendor-defined page. All higher pages are vendor-defined too (HID Usage Tables 1.5, section
 * 3). */
#define PAGE_VENDOR 0xff00u

static const struct {
    hid_usage usage;
    const char *word;
} words[] = {
    /* Usages of the Generic Desktop page (HID Usage Tables 1.5, section 4). */
    { 0x00010001, "pointer" },
    { 0x00010002, "mouse" },
    { 0x00010004, "joystick" },
    { 0x00010005, "game pad" },
    { 0x00010006, "keyboard" },
    { 0x00010007, "keypad" },
    { 0x00010008, "multi-axis controller" },
    { 0x00010030, "X" },
    { 0x00010031, "Y" },
    { 0x00010032, "Z" },
    { 0x00010033, "Rx" },
    { 0x00010034, "Ry" },
    { 0x00010035, "Rz" },
    { 0x00010036, "slider" },
    { 0x00010037, "dial" },
    { 0x00010038, "wheel" },
    { 0x00010039, "hat" },
    { 0x0001003d, "start" },
    { 0x0001003e, "select" },
    { 0x00010040, "Vx" },
    { 0x00010041, "Vy" },
    { 0x00010042, "Vz" },
    { 0x00010080, "system control" },
    { 0x00010085, "system main menu" },
    { 0x00010090, "pad up" },
    { 0x00010091, "pad down" },
    { 0x00010092, "pad right" },
    { 0x00010093, "pad left" },
    /* Usages of the Simulation Controls page (section 5). */
    { 0x000200ba, "rudder" },
    { 0x000200bb, "throttle" },
    { 0x000200c4, "accelerator" },
    { 0x000200c5, "brake" },
    { 0x000200c8, "steering" },
    /* Usages of the Generic Device Controls page (section 9) and the Consumer page (section 15). */
    { 0x00060020, "battery" },
    { 0x000c0001, "consumer control" },
    { 0x000c0224, "back" },
    { 0x000c0238, "pan" },
    /* Usages of the Digitizers page (section 16). */
    { 0x000d0001, "digitizer" },
    { 0x000d0002, "pen" },
    { 0x000d0004, "touch screen" },
    { 0x000d0005, "touch pad" },
    { 0x000d0022, "finger" },
    { 0x000d0030, "pressure" },
    { 0x000d0032, "in range" },
    { 0x000d003c, "invert" },
    { 0x000d003d, "X tilt" },
    { 0x000d003e, "Y tilt" },
    { 0x000d0042, "tip" },
    { 0x000d0044, "barrel" },
    { 0x000d0045, "eraser" },
    { 0x000d0047, "confidence" },
    { 0x000d0051, "contact id" },
    { 0x000d0054, "contact count" },
    { 0x000d0056, "scan time" },
};

const char *hid_usage_name(hid_usage usage, char out[HID_NAME_SIZE])
{
    const uint32_t page = usage >> 16, id = usage & 0xffffu;
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        if (words[i].usage == usage) {
            return words[i].word;
        }
    }
    if (page == PAGE_BUTTON) {
        snprintf(out, HID_NAME_SIZE, "button %u", id);
    } else if (page == PAGE_KEYBOARD) {
        snprintf(out, HID_NAME_SIZE, "key %02x", id);
    } else {
        snprintf(out, HID_NAME_SIZE, "%s%04x:%04x", page >= PAGE_VENDOR ? "vendor's " : "", page,
                 id);
    }
    return out;
}
