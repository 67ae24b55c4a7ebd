/* usb_roster.c -- rows to the frame loop, commands to the event thread. */
#include "drivers/usb_roster.h"

#include <string.h>

void usb_roster_init(struct usb_roster *roster, void (*wake)(void *self), void *wake_self)
{
    memset(roster, 0, sizeof *roster);
    usb_mail_init(&roster->mail);
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        roster->rows[roster->mail.reading].row[i].seat = POI_MAX;
    }
    roster->wake = wake;
    roster->wake_self = wake_self;
}

void usb_roster_post(struct usb_roster *roster, const struct usb_rows *rows)
{
    roster->rows[roster->mail.writing] = *rows;
    usb_mail_post(&roster->mail);
}

int usb_roster_order(struct usb_roster *roster, struct usb_order *out)
{
    const uint32_t taken = atomic_load_explicit(&roster->taken, memory_order_relaxed);
    if (atomic_load_explicit(&roster->pushed, memory_order_acquire) == taken) {
        return 0;
    }
    *out = roster->order[taken % USB_ORDER_MAX];
    atomic_store_explicit(&roster->taken, taken + 1u, memory_order_release);
    return 1;
}

static const struct usb_rows *newest(struct usb_roster *roster)
{
    usb_mail_fetch(&roster->mail);
    return &roster->rows[roster->mail.reading];
}

uint32_t usb_roster_wanted(struct usb_roster *roster, struct usb_key out[USB_WISH_MAX])
{
    const struct usb_rows *rows = newest(roster);
    memcpy(out, rows->wanted, rows->wanted_count * sizeof out[0]);
    return rows->wanted_count;
}

static void roster_rows(void *self, struct hid_row out[CONTROLLER_MAX])
{
    memcpy(out, newest(self)->row, sizeof newest(self)->row);
}

static int send_order(struct usb_roster *roster, const struct hid_row *row, int plays)
{
    const uint32_t pushed = atomic_load_explicit(&roster->pushed, memory_order_relaxed);
    if (pushed - atomic_load_explicit(&roster->taken, memory_order_acquire) == USB_ORDER_MAX) {
        return HAL_ERR_BUSY;
    }
    roster->order[pushed % USB_ORDER_MAX] =
        (struct usb_order){ .plays = plays != 0, .identity = row->identity };
    atomic_store_explicit(&roster->pushed, pushed + 1u, memory_order_release);
    roster->wake(roster->wake_self);
    return HAL_OK;
}

static int roster_choose(void *self, uint32_t index)
{
    struct usb_roster *roster = self;
    const struct usb_rows *rows = newest(roster);
    uint32_t playing = 0;
    if (index >= CONTROLLER_MAX || rows->row[index].state == CONTROLLER_NONE ||
        rows->row[index].state == CONTROLLER_BARRED) {
        return HAL_ERR_NONE;
    }
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        playing += i != index && rows->row[i].state == CONTROLLER_PLAYS;
    }
    return playing >= POI_MAX ? HAL_ERR_BUSY : send_order(roster, &rows->row[index], 1);
}

static int roster_release(void *self, uint32_t index)
{
    struct usb_roster *roster = self;
    const struct usb_rows *rows = newest(roster);
    if (index >= CONTROLLER_MAX || rows->row[index].state == CONTROLLER_NONE ||
        rows->row[index].state == CONTROLLER_BARRED) {
        return HAL_ERR_NONE;
    }
    return send_order(roster, &rows->row[index], 0);
}

static const char *roster_describe(void *self)
{
    return newest(self)->text;
}

struct hid_roster usb_roster_face(struct usb_roster *roster)
{
    static const struct hid_roster_ops ops = {
        .rows = roster_rows,
        .choose = roster_choose,
        .release = roster_release,
        .describe = roster_describe,
    };
    return (struct hid_roster){ .ops = &ops, .self = roster };
}
