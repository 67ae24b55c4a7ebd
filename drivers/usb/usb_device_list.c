/* usb_device_list.c -- assigns the rows of the controller menu to controllers, and reuses rows if
 * there are more controllers than rows. Passes the rows to the frame loop and the operator's
 * commands to the event thread. */
#include "drivers/usb/usb_device_list.h"

#include <string.h>

#include "core/base/panic.h"

void usb_device_table_clear(struct usb_device_table *rows, uint32_t index)
{
    CORE_ASSERT(index < CONTROLLER_MAX);
    rows->row[index] = (struct hid_row){ .state = CONTROLLER_NONE, .slot = POI_MAX };
}

void usb_device_table_init(struct usb_device_table *rows)
{
    memset(rows, 0, sizeof *rows);
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        usb_device_table_clear(rows, i);
    }
}

/* Returns the row for the new controller `identity`, or CONTROLLER_MAX if there is none. The order
 * of the choices is that of usb_device_table_enter(). */
static uint32_t row_for(const struct usb_device_table *rows, const struct hid_identity *identity,
                        bool is_barred)
{
    static const uint8_t yields[] = { CONTROLLER_NONE, CONTROLLER_UNSUPPORTED, CONTROLLER_LOST };
    uint32_t lost = CONTROLLER_MAX, most = 0, empty_count = 0;
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        const struct hid_row *row = &rows->row[i];
        const uint32_t likeness =
            row->state == CONTROLLER_LOST ? usb_choice_similarity(&row->identity, identity) : 0u;
        lost = likeness > most ? i : lost;
        most = likeness > most ? likeness : most;
        empty_count += row->state == CONTROLLER_NONE;
    }
    if (lost < CONTROLLER_MAX || (is_barred && empty_count <= POI_MAX)) {
        return lost;
    }
    for (uint32_t kind = 0; kind < sizeof yields; kind++) {
        for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
            if (rows->row[i].state == yields[kind]) {
                return i;
            }
        }
    }
    return CONTROLLER_MAX;
}

uint32_t usb_device_table_enter(struct usb_device_table *rows, const struct hid_identity *identity,
                                bool is_barred)
{
    const uint32_t index = row_for(rows, identity, is_barred);
    if (index < CONTROLLER_MAX) {
        rows->row[index] = (struct hid_row){
            .identity = *identity,
            .state = (uint8_t)(is_barred ? CONTROLLER_UNSUPPORTED : CONTROLLER_FREE),
            .slot = POI_MAX,
        };
    }
    return index;
}

uint32_t usb_device_table_find(const struct usb_device_table *rows,
                               const struct hid_identity *identity)
{
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        const struct hid_row *row = &rows->row[i];
        if (row->state != CONTROLLER_NONE && row->identity.vendor == identity->vendor &&
            row->identity.product == identity->product &&
            !strcmp(row->identity.serial, identity->serial) &&
            !strcmp(row->identity.port, identity->port)) {
            return i;
        }
    }
    return CONTROLLER_MAX;
}

/* ---- Exchange between the threads ------------------------------------------------------------ */

void usb_device_list_init(struct usb_device_list *device_list, void (*wake)(void *self),
                          void *wake_self)
{
    CORE_ASSERT(wake);
    memset(device_list, 0, sizeof *device_list);
    triple_buffer_init(&device_list->newest);
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        device_list->rows[device_list->newest.reading].row[i].slot = POI_MAX;
    }
    device_list->wake = wake;
    device_list->wake_self = wake_self;
}

void usb_device_list_publish(struct usb_device_list *device_list,
                             const struct usb_device_table *rows)
{
    CORE_ASSERT(rows->wanted_count <= USB_REQUEST_MAX);
    device_list->rows[device_list->newest.writing] = *rows;
    triple_buffer_post(&device_list->newest);
}

bool usb_device_list_take_command(struct usb_device_list *device_list, struct usb_command *out)
{
    const uint32_t taken = atomic_load_explicit(&device_list->taken, memory_order_relaxed);
    const uint32_t pushed = atomic_load_explicit(&device_list->pushed, memory_order_acquire);
    CORE_ASSERT(pushed - taken <= USB_COMMAND_MAX);
    if (pushed == taken) {
        return false;
    }
    *out = device_list->order[taken % USB_COMMAND_MAX];
    atomic_store_explicit(&device_list->taken, taken + 1u, memory_order_release);
    return true;
}

static const struct usb_device_table *newest_device_table(struct usb_device_list *device_list)
{
    CORE_ASSERT(device_list->newest.reading < TRIPLE_BUFFER_SLOTS);
    triple_buffer_fetch(&device_list->newest);
    return &device_list->rows[device_list->newest.reading];
}

uint32_t usb_device_list_wanted(struct usb_device_list *device_list,
                                struct usb_key out[USB_REQUEST_MAX])
{
    const struct usb_device_table *rows = newest_device_table(device_list);
    memcpy(out, rows->wanted, rows->wanted_count * sizeof out[0]);
    return rows->wanted_count;
}

static void copy_rows(void *self, struct hid_row out[CONTROLLER_MAX])
{
    const struct usb_device_table *rows = newest_device_table(self);
    memcpy(out, rows->row, sizeof rows->row);
}

/* Queues the command to select (`plays` is true) or to release the controller of row `index`.
 * Returns HAL_OK, HAL_ERR_ABSENT if the operator cannot give a command for the row, or HAL_ERR_BUSY
 * if the queue is full. Also returns HAL_ERR_BUSY if a controller is selected and POI_MAX other
 * controllers play. */
static int choose(void *self, uint32_t index, bool plays)
{
    struct usb_device_list *device_list = self;
    const struct hid_row *rows = newest_device_table(device_list)->row;
    if (index >= CONTROLLER_MAX || rows[index].state == CONTROLLER_NONE ||
        rows[index].state == CONTROLLER_UNSUPPORTED) {
        return HAL_ERR_ABSENT;
    }
    uint32_t playing = 0;
    for (uint32_t i = 0; plays && i < CONTROLLER_MAX; i++) {
        playing += i != index && rows[i].state == CONTROLLER_ACTIVE;
    }
    const uint32_t pushed = atomic_load_explicit(&device_list->pushed, memory_order_relaxed);
    const uint32_t taken = atomic_load_explicit(&device_list->taken, memory_order_acquire);
    if (playing >= POI_MAX || pushed - taken == USB_COMMAND_MAX) {
        return HAL_ERR_BUSY;
    }
    device_list->order[pushed % USB_COMMAND_MAX] =
        (struct usb_command){ .plays = plays, .identity = rows[index].identity };
    atomic_store_explicit(&device_list->pushed, pushed + 1u, memory_order_release);
    device_list->wake(device_list->wake_self);
    return HAL_OK;
}

static const char *describe(void *self)
{
    return newest_device_table(self)->text;
}

struct hid_device_list usb_device_list_device(struct usb_device_list *device_list)
{
    static const struct hid_device_list_ops ops = {
        .rows = copy_rows,
        .choose = choose,
        .describe = describe,
    };
    return (struct hid_device_list){ .ops = &ops, .self = device_list };
}
