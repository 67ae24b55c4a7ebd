/* device_table.c -- assigns rows of the controller menu, and reuses rows if there are more
 * controllers than rows. */
#include "drivers/usb/device_table.h"

#include <string.h>

#include "drivers/usb/usb_choice.h"

void device_table_clear(struct device_table *rows, uint32_t index)
{
    rows->row[index] = (struct hid_row){ .state = CONTROLLER_NONE, .seat = POI_MAX };
}

void device_table_init(struct device_table *rows)
{
    memset(rows, 0, sizeof *rows);
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        device_table_clear(rows, i);
    }
}

static uint32_t first_of(const struct device_table *rows, uint8_t state)
{
    uint32_t i = 0;
    while (i < CONTROLLER_MAX && rows->row[i].state != state) {
        i++;
    }
    return i;
}

static uint32_t count_of(const struct device_table *rows, uint8_t state)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        count += rows->row[i].state == state;
    }
    return count;
}

static uint32_t lost_row(const struct device_table *rows, const struct hid_identity *identity)
{
    uint32_t best = CONTROLLER_MAX, most = 0;
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        const uint32_t likeness = rows->row[i].state == CONTROLLER_LOST
                                      ? usb_choice_similarity(&rows->row[i].identity, identity)
                                      : 0u;
        if (likeness > most) {
            best = i;
            most = likeness;
        }
    }
    return best;
}

static uint32_t place_for(const struct device_table *rows, const struct hid_identity *identity,
                          int is_barred)
{
    const uint32_t lost = lost_row(rows, identity);
    if (lost < CONTROLLER_MAX) {
        return lost;
    }
    if (is_barred && count_of(rows, CONTROLLER_NONE) <= POI_MAX) {
        return CONTROLLER_MAX;
    }
    static const uint8_t yields[] = { CONTROLLER_NONE, CONTROLLER_UNSUPPORTED, CONTROLLER_LOST };
    uint32_t index = CONTROLLER_MAX;
    for (uint32_t i = 0; i < sizeof yields && index == CONTROLLER_MAX; i++) {
        index = first_of(rows, yields[i]);
    }
    return index;
}

uint32_t device_table_enter(struct device_table *rows, const struct hid_identity *identity,
                            int is_barred)
{
    const uint32_t index = place_for(rows, identity, is_barred);
    if (index < CONTROLLER_MAX) {
        rows->row[index] = (struct hid_row){
            .identity = *identity,
            .state = (uint8_t)(is_barred ? CONTROLLER_UNSUPPORTED : CONTROLLER_FREE),
            .seat = POI_MAX,
        };
    }
    return index;
}

uint32_t device_table_find(const struct device_table *rows, const struct hid_identity *identity)
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
