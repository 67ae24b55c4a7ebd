/* hid_desk.c -- executes the operator's controller commands and reports the device list. */
#include "drivers/hid_desk.h"

#include <stdio.h>
#include <string.h>

void hid_desk_init(struct hid_desk *desk, struct hid_roster roster, struct hid_book *book,
                   struct poi_hid *const seats[POI_MAX])
{
    memset(desk, 0, sizeof *desk);
    desk->roster = roster;
    desk->book = book;
    desk->learn_seat = POI_MAX;
    memcpy(desk->seat, seats, sizeof desk->seat);
}

/* ---- Learning ------------------------------------------------------------------------------- */

static struct poi_hid *learning_seat(const struct hid_desk *desk)
{
    return desk->learn_seat < POI_MAX ? desk->seat[desk->learn_seat] : NULL;
}

static void show_report(void *self, const struct hid_raw *raw)
{
    struct hid_desk *desk = self;
    hid_learn_report(&desk->learn, raw);
}

static void leave_seat(struct hid_desk *desk)
{
    struct poi_hid *seat = learning_seat(desk);
    if (seat) {
        poi_hid_show(seat, (struct hid_watch){ 0 });
    }
    desk->learn_seat = POI_MAX;
    desk->learn_waits = desk->keeps = desk->writes = 0;
}

static void fail_learning(struct hid_desk *desk)
{
    leave_seat(desk);
    desk->learn.step = LEARN_FAILED;
}

static int is_kind(const struct hid_identity *one, const struct hid_identity *other)
{
    return one->vendor == other->vendor && one->product == other->product &&
           strcmp(one->serial, other->serial) == 0;
}

/* Releases a controller that only learning had chosen and whose mapping was not kept. Repeated
 * at the next poll while the device list is busy. */
static void give_back(struct hid_desk *desk)
{
    const struct hid_row *row = &desk->row[desk->learn_row];
    desk->gives_back =
        desk->gives_back && is_kind(&row->identity, &desk->learn_identity) &&
        desk->roster.ops->release(desk->roster.self, desk->learn_row) == HAL_ERR_BUSY;
}

/* Ends learning. The controller continues to play with `map`, or, if `map` is null, with the
 * mapping that it has without learning. */
static void stop_learning(struct hid_desk *desk, const struct hid_map *map)
{
    struct poi_hid *seat = learning_seat(desk);
    if (seat) {
        poi_hid_remap(seat, map);
    }
    leave_seat(desk);
    desk->learn.step = LEARN_NONE;
}

static void end_learning(struct hid_desk *desk)
{
    const int plays_on = desk->learn.step == LEARN_UNKEPT || desk->writes;
    stop_learning(desk, plays_on ? &desk->learn.map : NULL);
    give_back(desk);
}

/* Ends a running learning procedure and starts one for `row`. Restarting the same row preserves
 * gives_back. */
static void begin_anew(struct hid_desk *desk, uint32_t row)
{
    const int again = desk->learn.step != LEARN_NONE && desk->learn_row == row;
    if (again) {
        stop_learning(desk, NULL);
    } else if (desk->learn.step != LEARN_NONE) {
        end_learning(desk);
    }
    desk->gives_back = desk->row[row].state == CONTROLLER_FREE || (again && desk->gives_back);
    desk->learn_row = (uint8_t)row;
    desk->learn_identity = desk->row[row].identity;
}

static int begin_learning(struct hid_desk *desk, uint32_t row)
{
    begin_anew(desk, row);
    const int result = desk->row[row].state == CONTROLLER_PLAYS
                           ? HAL_OK
                           : desk->roster.ops->choose(desk->roster.self, row);
    if (result != HAL_OK) {
        desk->gives_back = 0;
        fail_learning(desk);
        return result;
    }
    /* The menu shows "keep still" while the controller is being attached. */
    desk->learn.step = LEARN_REST;
    desk->learn.report_count = 0;
    desk->learn_waits = 1;
    return HAL_OK;
}

static int is_same(const struct hid_identity *one, const struct hid_identity *other)
{
    return is_kind(one, other) && strcmp(one->port, other->port) == 0;
}

/* Continues learning when the frame loop has opened the controller's slot, which takes up to one
 * second. */
static void sit_down(struct hid_desk *desk)
{
    const struct hid_row *row = &desk->row[desk->learn_row];
    struct poi_hid *seat = row->seat < POI_MAX ? desk->seat[row->seat] : NULL;
    if (row->state == CONTROLLER_DENIED || row->state == CONTROLLER_BARRED ||
        row->state == CONTROLLER_NONE) {
        fail_learning(desk);
        return;
    }
    if (!seat || !seat->is_open || !is_same(&seat->face.identity, &row->identity)) {
        return;
    }
    desk->learn_waits = 0;
    desk->learn_seat = row->seat;
    /* Some devices report their serial number only after they are opened. */
    desk->learn_identity = row->identity;
    hid_learn_begin(&desk->learn, &seat->face);
    if (desk->learn.step == LEARN_FAILED) {
        leave_seat(desk);
        return;
    }
    poi_hid_show(seat, (struct hid_watch){ .report = show_report, .self = desk });
}

static void go_on(struct hid_desk *desk)
{
    struct poi_hid *seat = learning_seat(desk);
    if (!seat) {
        return; /* Not attached yet, so there is no step to finish. */
    }
    hid_learn_next(&desk->learn);
    if (desk->learn.step == LEARN_TRY) {
        poi_hid_show(seat, (struct hid_watch){ 0 });
        if (!poi_hid_remap(seat, &desk->learn.map)) {
            poi_hid_remap(seat, NULL);
            fail_learning(desk);
        }
    } else if (desk->learn.step == LEARN_FAILED) {
        leave_seat(desk);
    }
}

/* Ends learning only after the file is on the card, so that the operator may then switch the
 * kiosk off safely. */
static void watch_writing(struct hid_desk *desk)
{
    const int result = hid_book_written(desk->book);
    if (result == HAL_OK) {
        stop_learning(desk, &desk->learn.map);
    } else if (result != HAL_ERR_BUSY) {
        desk->writes = 0;
        desk->learn.step = LEARN_UNKEPT;
    }
}

static int keep(struct hid_desk *desk)
{
    const struct poi_hid *seat = learning_seat(desk);
    if (!seat || (desk->learn.step != LEARN_TRY && desk->learn.step != LEARN_UNKEPT)) {
        return HAL_ERR_IO;
    }
    const int result = hid_book_keep(desk->book, &seat->face.identity, &desk->learn.map);
    desk->learn.step = result == HAL_OK || result == HAL_ERR_BUSY ? LEARN_TRY : LEARN_UNKEPT;
    desk->gives_back = 0;
    desk->keeps = result == HAL_ERR_BUSY;
    desk->writes = result == HAL_OK;
    if (desk->writes) {
        watch_writing(desk);
    }
    return result == HAL_ERR_BUSY ? HAL_OK : result;
}

/* ---- Commands ------------------------------------------------------------------------------- */

static void forget(struct hid_desk *desk)
{
    desk->forgets = hid_book_forget(desk->book, &desk->forget_identity) == HAL_ERR_BUSY;
}

static int release(struct hid_desk *desk, uint32_t row)
{
    if (desk->learn.step != LEARN_NONE && desk->learn_row == row) {
        stop_learning(desk, NULL);
        desk->gives_back = 0; /* The row is released below in any case. */
    }
    if (desk->row[row].state != CONTROLLER_NONE) {
        desk->forget_identity = desk->row[row].identity;
        forget(desk);
    }
    return desk->roster.ops->release(desk->roster.self, row);
}

static int hid_desk_order(void *self, const struct desk_order *order)
{
    struct hid_desk *desk = self;
    if (order->row >= CONTROLLER_MAX) {
        return HAL_ERR_NONE;
    }
    switch (order->kind) {
    case DESK_CHOOSE:
        desk->gives_back &= order->row != desk->learn_row;
        return desk->roster.ops->choose(desk->roster.self, order->row);
    case DESK_RELEASE:
        return release(desk, order->row);
    case DESK_LEARN:
        return begin_learning(desk, order->row);
    case DESK_LEARN_NEXT:
        go_on(desk);
        return HAL_OK;
    case DESK_LEARN_KEEP:
        return keep(desk);
    case DESK_LEARN_END:
        end_learning(desk);
        return HAL_OK;
    default:
        return HAL_OK;
    }
}

/* ---- Device list ---------------------------------------------------------------------------- */

/* Advances learning once for each poll. Learning fails if the controller is unplugged, because
 * an incomplete recording cannot be used. */
static void watch_learning(struct hid_desk *desk)
{
    const struct poi_hid *seat = learning_seat(desk);
    if (desk->learn_waits) {
        sit_down(desk);
    } else if (seat && !seat->is_open && !desk->writes) {
        fail_learning(desk);
    }
    if (desk->keeps) {
        keep(desk);
    } else if (desk->writes) {
        watch_writing(desk);
    }
    if (desk->gives_back && desk->learn.step == LEARN_NONE) {
        give_back(desk);
    }
}

static int hid_desk_poll(void *self, struct desk_input *out)
{
    struct hid_desk *desk = self;
    desk->roster.ops->rows(desk->roster.self, desk->row);
    watch_learning(desk);
    if (desk->forgets) {
        forget(desk);
    }
    memset(out, 0, sizeof *out);
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        out->state[i] = desk->row[i].state;
    }
    out->learn_step = desk->learn.step;
    out->learn_row = desk->learn.step == LEARN_NONE ? 0u : desk->learn_row;
    out->learn_progress = desk->learn_waits ? 0u : hid_learn_progress(&desk->learn);
    return HAL_OK;
}

static const char *hid_desk_name(void *self, uint32_t row)
{
    struct hid_desk *desk = self;
    if (row >= CONTROLLER_MAX || desk->row[row].state == CONTROLLER_NONE) {
        return "";
    }
    const struct hid_identity *who = &desk->row[row].identity;
    snprintf(desk->name, sizeof desk->name, "%04x:%04x %.*s%s%.9s", who->vendor, who->product,
             hid_text_fit(who->name, 24), who->name, who->port[0] ? ", " : "", who->port);
    return desk->name;
}

static const char *hid_desk_describe(void *self)
{
    const struct hid_desk *desk = self;
    return desk->roster.ops->describe(desk->roster.self);
}

struct hal_controllers hid_desk_device(struct hid_desk *desk)
{
    static const struct hal_controllers_ops ops = {
        .poll = hid_desk_poll,
        .name = hid_desk_name,
        .order = hid_desk_order,
        .describe = hid_desk_describe,
    };
    return (struct hal_controllers){ .ops = &ops, .self = desk };
}
