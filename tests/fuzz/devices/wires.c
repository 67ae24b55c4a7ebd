/* wires.c -- fuzz target: arbitrary lines of two files: the GPIO wiring of a cabinet, and an
 * operator's choice of controllers. Each parser must either accept a line, or reject it with one
 * sentence and change nothing. */
#include <string.h>

#include "drivers/gpio/gpio_config.h"
#include "drivers/usb/usb_choice.h"
#include "tests/fuzz/trap.h"

static void hold_sentence(const char *why, size_t room)
{
    HOLD(strnlen(why, room) > 0 && strnlen(why, room) < room);
}

static void hold_wire(const char *line, struct gpio_wire wires[GPIO_ROLE_COUNT])
{
    static struct gpio_wire before[GPIO_ROLE_COUNT];
    char why[HAL_TEXT_SIZE] = "", text[GPIO_WIRE_TEXT_SIZE];
    memcpy(before, wires, sizeof before);
    if (!gpio_wire_read(line, wires, why)) {
        hold_sentence(why, sizeof why);
        HOLD(memcmp(before, wires, sizeof before) == 0);
        return;
    }
    HOLD(gpio_config_count(wires) >= gpio_config_count(before));
    for (uint32_t role = 0; role < GPIO_ROLE_COUNT; role++) {
        const struct gpio_wire *wire = &wires[role];
        if (wire->wired) {
            gpio_wire_text(wire, text);
            HOLD(memchr(wire->name, 0, sizeof wire->name));
            HOLD(memchr(wire->chip, 0, sizeof wire->chip));
            HOLD((wire->name[0] != 0) != (wire->chip[0] != 0) && strlen(text) > 0);
        }
    }
    if (!gpio_config_agrees(wires, why)) {
        hold_sentence(why, sizeof why);
    }
}

static void hold_choice(const char *line, struct usb_choice *choice)
{
    static struct usb_choice again;
    char error[USB_ERROR_SIZE] = "", written[USB_CHOICE_LINE_SIZE];
    if (usb_choice_read_line(choice, line, error)) {
        hold_sentence(error, sizeof error);
        return;
    }
    HOLD(choice->request_count <= USB_REQUEST_MAX);
    again.request_count = 0;
    for (uint32_t i = 0; usb_choice_line(choice, i, written); i++) {
        HOLD(usb_choice_read_line(&again, written, error) == 0);
    }
    HOLD(again.request_count <= choice->request_count);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct gpio_wire wires[GPIO_ROLE_COUNT];
    static struct usb_choice choice;
    static char text[4096];
    memset(wires, 0, sizeof wires);
    memset(&choice, 0, sizeof choice);
    size = size < sizeof text ? size : sizeof text - 1u;
    memcpy(text, bytes, size);
    text[size] = '\0';
    for (char *rest = text, *line; (line = strsep(&rest, "\n"));) {
        hold_wire(line, wires);
        hold_choice(line, &choice);
    }
    return 0;
}
