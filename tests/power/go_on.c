/* go_on.c -- the morning after. */
#include "tests/power/go_on.h"

#include <stdio.h>
#include <string.h>

#include "platform/storage.h"
#include "tests/power/hour.h"

#define FRAMES (30u * 60u)

static struct hour morning;
static struct storage store;

static int refuse(char why[BOOKS_WHY_SIZE], const char *what)
{
    snprintf(why, BOOKS_WHY_SIZE, "played on: %s", what);
    return -1;
}

static uint32_t credits(const struct purse *purse)
{
    return purse->paid + purse->service;
}

/* The start is the first entry; a round that was open comes back with the second, and its credit
 * with it. What was not open brings nothing back. */
static int opens_well(const struct books *before, uint32_t last_id, char why[BOOKS_WHY_SIZE])
{
    const struct ledger_entry *boot = &morning.entries[last_id + 1u], *back = boot + 1;
    const uint8_t open = before->purse.open;
    const int was_paid = open == OPEN_PAID || open == OPEN_SERVICE;
    if (boot->kind != LEDGER_BOOT || credits(&boot->purse) != credits(&before->purse)) {
        return refuse(why, "the start is not the first entry, or changed the purse");
    }
    if (open != OPEN_NONE && (back->kind != LEDGER_REFUND || back->detail != REFUND_RESTART ||
                              back->purse.open != OPEN_NONE ||
                              credits(&back->purse) !=
                                  credits(&before->purse) + (uint32_t)was_paid)) {
        return refuse(why, "the round that was open did not come back, or not once");
    }
    uint32_t refunds = 0;
    for (uint32_t id = last_id + 1u; id <= morning.kept_id; id++) {
        refunds += morning.entries[id].kind == LEDGER_REFUND &&
                   morning.entries[id].detail == REFUND_RESTART;
    }
    return refunds == (open != OPEN_NONE) ? 0 : refuse(why, "what was open came back twice");
}

static int play(const char *folder, uint32_t last_id, char why[BOOKS_WHY_SIZE])
{
    store = (struct storage){ .dir = folder };
    const struct hal_storage device = storage_device(&store);
    if (device.ops->open(device.self) != HAL_OK ||
        hour_open(&morning, 1000u + last_id, device) != 0) {
        return refuse(why, device.ops->describe(device.self));
    }
    for (uint32_t i = 0; i < FRAMES; i++) {
        hour_frame(&morning, device);
    }
    return device.ops->close(device.self) == 0 ? 0 : refuse(why, "entries were not written");
}

int go_on(const char *folder, const struct books *before, uint32_t last_id,
          char why[BOOKS_WHY_SIZE])
{
    struct books books = *before;
    struct memory memory;
    struct books_file file;
    char path[300];
    if (play(folder, last_id, why) != 0 || opens_well(before, last_id, why) != 0) {
        return -1;
    }
    for (uint32_t id = last_id + 1u; id <= morning.kept_id; id++) {
        books_add(&books, &morning.entries[id]);
    }
    memset(&memory, 0, sizeof memory);
    settings_reset(&memory.settings);
    store = (struct storage){ .dir = folder };
    const struct hal_storage device = storage_device(&store);
    if (device.ops->open(device.self) != HAL_OK) {
        return refuse(why, device.ops->describe(device.self));
    }
    device.ops->remember(device.self, &memory);
    device.ops->close(device.self);
    snprintf(path, sizeof path, "%.250s/" STORAGE_FILE, folder);
    if (memory.ledger.last_id != morning.kept_id || books_read(path, 0, &file) != 0) {
        return refuse(why, "its entries are not there");
    }
    return books_agree(&books, &memory, &file, why);
}
