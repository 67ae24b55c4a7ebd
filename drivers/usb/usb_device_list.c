/* usb_device_list.c -- passes rows to the frame loop and commands to the event thread. */
#include "drivers/usb/usb_device_list.h"

#include <string.h>

void usb_device_list_init(struct usb_device_list *device_list, void (*wake)(void *self),
                          void *wake_self)
{
    memset(device_list, 0, sizeof *device_list);
    triple_buffer_init(&device_list->mail);
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        device_list->rows[device_list->mail.reading].row[i].seat = POI_MAX;
    }
    device_list->wake = wake;
    device_list->wake_self = wake_self;
}

void usb_device_list_publish(struct usb_device_list *device_list, const struct device_table *rows)
{
    device_list->rows[device_list->mail.writing] = *rows;
    triple_buffer_post(&device_list->mail);
}

int usb_device_list_take_command(struct usb_device_list *device_list, struct usb_command *out)
{
    const uint32_t taken = atomic_load_explicit(&device_list->taken, memory_order_relaxed);
    if (atomic_load_explicit(&device_list->pushed, memory_order_acquire) == taken) {
        return 0;
    }
    *out = device_list->order[taken % USB_COMMAND_MAX];
    atomic_store_explicit(&device_list->taken, taken + 1u, memory_order_release);
    return 1;
}

static const struct device_table *newest(struct usb_device_list *device_list)
{
    triple_buffer_fetch(&device_list->mail);
    return &device_list->rows[device_list->mail.reading];
}

uint32_t usb_device_list_wanted(struct usb_device_list *device_list,
                                struct usb_key out[USB_REQUEST_MAX])
{
    const struct device_table *rows = newest(device_list);
    memcpy(out, rows->wanted, rows->wanted_count * sizeof out[0]);
    return rows->wanted_count;
}

static void roster_rows(void *self, struct hid_row out[CONTROLLER_MAX])
{
    memcpy(out, newest(self)->row, sizeof newest(self)->row);
}

static int send_order(struct usb_device_list *device_list, const struct hid_row *row, int plays)
{
    const uint32_t pushed = atomic_load_explicit(&device_list->pushed, memory_order_relaxed);
    if (pushed - atomic_load_explicit(&device_list->taken, memory_order_acquire) ==
        USB_COMMAND_MAX) {
        return HAL_ERR_BUSY;
    }
    device_list->order[pushed % USB_COMMAND_MAX] =
        (struct usb_command){ .plays = plays != 0, .identity = row->identity };
    atomic_store_explicit(&device_list->pushed, pushed + 1u, memory_order_release);
    device_list->wake(device_list->wake_self);
    return HAL_OK;
}

static int roster_choose(void *self, uint32_t index)
{
    struct usb_device_list *device_list = self;
    const struct device_table *rows = newest(device_list);
    uint32_t playing = 0;
    if (index >= CONTROLLER_MAX || rows->row[index].state == CONTROLLER_NONE ||
        rows->row[index].state == CONTROLLER_UNSUPPORTED) {
        return HAL_ERR_ABSENT;
    }
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        playing += i != index && rows->row[i].state == CONTROLLER_ACTIVE;
    }
    return playing >= POI_MAX ? HAL_ERR_BUSY : send_order(device_list, &rows->row[index], 1);
}

static int roster_release(void *self, uint32_t index)
{
    struct usb_device_list *device_list = self;
    const struct device_table *rows = newest(device_list);
    if (index >= CONTROLLER_MAX || rows->row[index].state == CONTROLLER_NONE ||
        rows->row[index].state == CONTROLLER_UNSUPPORTED) {
        return HAL_ERR_ABSENT;
    }
    return send_order(device_list, &rows->row[index], 0);
}

static const char *roster_describe(void *self)
{
    return newest(self)->text;
}

struct hid_device_list usb_device_list_device(struct usb_device_list *device_list)
{
    static const struct hid_device_list_ops ops = {
        .rows = roster_rows,
        .choose = roster_choose,
        .release = roster_release,
        .describe = roster_describe,
    };
    return (struct hid_device_list){ .ops = &ops, .self = device_list };
}
