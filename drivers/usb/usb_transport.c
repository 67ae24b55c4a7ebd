/* usb_transport.c -- starts and stops the USB transport. */
#include "drivers/usb/usb_transport.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "drivers/usb/usb_choice.h"
#include "drivers/usb/usb_event_thread.h"

#define PATH_SIZE 1100u /* Size of a path; large enough for a data folder and a file name. */

struct usb_seats {
    struct usb_event_thread usb_thread;
    uint8_t is_running;
    char choices[PATH_SIZE], sysfs[PATH_SIZE];
};

static struct usb_seats one;

struct usb_seats *usb_transport_start(const struct usb_transport_config *config,
                                      char why[HAL_TEXT_SIZE])
{
    CORE_ASSERT(config->clock.ops);
    struct usb_event_thread *usb_thread = &one.usb_thread;
    memset(&one, 0, sizeof one);
    why[0] = '\0';
    snprintf(one.choices, sizeof one.choices, "%s", config->choices ? config->choices : "");
    snprintf(one.sysfs, sizeof one.sysfs, "%s", config->sysfs ? config->sysfs : "/sys");
    usb_thread->clock = config->clock;
    usb_thread->choices_path = one.choices;
    usb_thread->sysfs = one.sysfs;
    usb_thread->tell = config->tell;
    usb_thread->tell_self = config->tell_self;
    usb_thread->is_unread = usb_choice_load(&usb_thread->choice, one.choices, why) < 0;
    for (uint32_t i = 0; i < config->listed_count; i++) {
        usb_choice_request(&usb_thread->choice, &config->listed[i], 1, 0);
    }
    one.is_running = usb_event_thread_begin(usb_thread, why) == 0;
    if (!one.is_running) {
        /* An empty device list is published with the reason why USB is not available. */
        struct usb_device_table *rows = &usb_thread->rows;
        for (uint32_t i = 0; i < POI_MAX; i++) {
            usb_thread->seat[i].is_never = 1;
        }
        snprintf(rows->text, sizeof rows->text, "%s", why);
        rows->wanted_count = 0; /* No keys are published, so that other drivers may use the selected
                                   controllers. */
        usb_device_list_publish(&usb_thread->device_list, rows);
    }
    return &one;
}

struct hid_port usb_transport_port(struct usb_seats *seats, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    return usb_slot_port(&seats->usb_thread.seat[index]);
}

struct hid_device_list usb_transport_roster(struct usb_seats *seats)
{
    return usb_device_list_device(&seats->usb_thread.device_list);
}

uint32_t usb_transport_wanted(struct usb_seats *seats, struct usb_key out[USB_REQUEST_MAX])
{
    return usb_device_list_wanted(&seats->usb_thread.device_list, out);
}

void usb_transport_stop(struct usb_seats *seats)
{
    if (seats->is_running) {
        usb_event_thread_end(&seats->usb_thread);
        seats->is_running = 0;
    }
}
