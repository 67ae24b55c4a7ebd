/* usb_seats.c -- starts and stops the USB transport of this process. */
#include "drivers/usb_seats.h"

#include <stdio.h>
#include <string.h>

#include "drivers/usb_choice_file.h"
#include "drivers/usb_pump.h"

#define PATH_SIZE 1100u /* Fits a data folder and a file name. */

struct usb_seats {
    struct usb_pump pump;
    uint8_t is_running;
    char choices[PATH_SIZE], sysfs[PATH_SIZE];
};

static struct usb_seats one;

/* Publishes an empty device list with the reason why there is no USB. */
static void be_dead(struct usb_seats *seats, const char *why)
{
    struct usb_rows *rows = &seats->pump.rows;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        seats->pump.seat[i].is_never = 1;
    }
    snprintf(rows->text, sizeof rows->text, "%s", why);
    rows->wanted_count = 0; /* Other drivers may use these controllers. */
    usb_roster_post(&seats->pump.roster, rows);
}

struct usb_seats *usb_seats_start(const struct usb_seats_config *config, char why[HAL_TEXT_SIZE])
{
    struct usb_pump *pump = &one.pump;
    memset(&one, 0, sizeof one);
    why[0] = '\0';
    snprintf(one.choices, sizeof one.choices, "%s", config->choices ? config->choices : "");
    snprintf(one.sysfs, sizeof one.sysfs, "%s", config->sysfs ? config->sysfs : "/sys");
    pump->clock = config->clock;
    pump->choices_path = one.choices;
    pump->sysfs = one.sysfs;
    pump->tell = config->tell;
    pump->tell_self = config->tell_self;
    pump->is_unread = usb_choice_load(&pump->choice, one.choices, why) < 0;
    for (uint32_t i = 0; i < config->listed_count; i++) {
        usb_choice_wish(&pump->choice, &config->listed[i], 1, 0);
    }
    one.is_running = usb_pump_begin(pump, why) == 0;
    if (!one.is_running) {
        be_dead(&one, why);
    }
    return &one;
}

struct hid_port usb_seats_port(struct usb_seats *seats, uint32_t index)
{
    return usb_seat_port(&seats->pump.seat[index]);
}

struct hid_roster usb_seats_roster(struct usb_seats *seats)
{
    return usb_roster_face(&seats->pump.roster);
}

uint32_t usb_seats_wanted(struct usb_seats *seats, struct usb_key out[USB_WISH_MAX])
{
    return usb_roster_wanted(&seats->pump.roster, out);
}

void usb_seats_stop(struct usb_seats *seats)
{
    if (seats->is_running) {
        usb_pump_end(&seats->pump);
        seats->is_running = 0;
    }
}
