/* hid_sim.c -- implements the simulated HID ports and the simulated device list in memory. */
#include "drivers/sim/hid_sim.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/base/rng.h"

void hid_port_sim_init(struct hid_port_sim *sim, struct hal_clock clock,
                       const struct hid_device_info *face)
{
    CORE_ASSERT(clock.ops);
    memset(sim, 0, sizeof *sim);
    sim->clock = clock;
    sim->face = face;
    sim->unplug_at = HID_SIM_NEVER;
}

static uint64_t hid_port_sim_now_ns(const struct hid_port_sim *sim)
{
    return sim->clock.ops->now_ns(sim->clock.self);
}

/* ---- Injected faults ------------------------------------------------------------------------ */

static uint32_t draw_random_u32(uint32_t number, uint32_t what)
{
    return rng_u32((struct rng_key){ 83, number, what, RNG_TEST });
}

static void scramble(struct hid_raw *raw, uint32_t number, uint32_t from)
{
    CORE_ASSERT(raw->size <= HID_REPORT_MAX);
    for (uint32_t i = from; i < raw->size; i++) {
        raw->bytes[i] = (uint8_t)draw_random_u32(number, i);
    }
}

static void suffer(const struct hid_port_sim *sim, uint8_t kind, uint32_t number,
                   struct hid_raw *raw)
{
    CORE_ASSERT(kind < HID_SIM_KIND_COUNT && raw->size <= HID_REPORT_MAX);
    switch (kind) {
    case HID_SIM_GARBAGE:
        scramble(raw, number, 1);
        break;
    case HID_SIM_NOISE:
        raw->size = 1u + draw_random_u32(number, HID_REPORT_MAX) % HID_REPORT_MAX;
        scramble(raw, number, 0);
        break;
    case HID_SIM_SHORT:
        raw->size = (raw->size + 1u) / 2u;
        break;
    case HID_SIM_LONG:
        raw->size = raw->size + 8u < HID_REPORT_MAX ? raw->size + 8u : HID_REPORT_MAX;
        break;
    case HID_SIM_EMPTY:
        raw->size = 0;
        break;
    case HID_SIM_WRONG_ID:
        raw->bytes[0] = (uint8_t)~raw->bytes[0];
        break;
    case HID_SIM_JUMP:
        memset(raw->bytes + 1, number % 2u ? 0xff : 0x7f, raw->size > 0 ? raw->size - 1u : 0u);
        break;
    case HID_SIM_STUCK:
        *raw = sim->last.size > 0 ? sim->last : *raw;
        break;
    default:
        break;
    }
}

static int has_fault(const struct hid_port_sim *sim, uint8_t kind, uint32_t number)
{
    CORE_ASSERT(kind < HID_SIM_KIND_COUNT && (sim->faults || sim->fault_count == 0));
    for (uint32_t i = 0; i < sim->fault_count; i++) {
        const struct hid_sim_fault *fault = &sim->faults[i];
        if (fault->kind == kind && number >= fault->from && number < fault->to) {
            return 1;
        }
    }
    return 0;
}

/* ---- Connection and queue ------------------------------------------------------------------- */

/* Queues a report. If the queue is full, the report replaces the newest queued report, as in the
 * queue of the USB transport. */
static void arrive(struct hid_port_sim *sim, const struct hid_raw *raw)
{
    if (!sim->is_open) {
        return;
    }
    CORE_ASSERT(sim->ring_first < HID_REPORTS_MAX && sim->ring_count <= HID_REPORTS_MAX);
    if (sim->ring_count == HID_REPORTS_MAX) {
        sim->ring_count--;
        sim->lost_count++;
    }
    sim->ring[(sim->ring_first + sim->ring_count) % HID_REPORTS_MAX] = *raw;
    sim->ring_count++;
}

static void say_at(struct hid_port_sim *sim, const uint8_t *bytes, uint32_t size, uint64_t time_ns)
{
    struct hid_raw raw = { .time_ns = time_ns };
    const uint32_t number = sim->said_count;
    if (number >= sim->unplug_at || sim->gone || sim->absent) {
        sim->gone = 1;
        return;
    }
    CORE_ASSERT(bytes && sim->said_count < HID_SIM_NEVER);
    sim->said_count++;
    raw.size = size < HID_REPORT_MAX ? size : HID_REPORT_MAX;
    memcpy(raw.bytes, bytes, raw.size);
    for (uint8_t kind = HID_SIM_GARBAGE; kind < HID_SIM_KIND_COUNT; kind++) {
        if (has_fault(sim, kind, number)) {
            suffer(sim, kind, number, &raw);
            raw.time_ns = time_ns;
        }
    }
    sim->last = raw;
    if (!has_fault(sim, HID_SIM_SILENCE, number)) {
        arrive(sim, &raw);
    }
    if (has_fault(sim, HID_SIM_TWICE, number)) {
        arrive(sim, &raw);
    }
}

void hid_port_sim_report(struct hid_port_sim *sim, const uint8_t *bytes, uint32_t size)
{
    say_at(sim, bytes, size, hid_port_sim_now_ns(sim));
}

static void say_script(struct hid_port_sim *sim)
{
    CORE_ASSERT(sim->script_next <= sim->script_count);
    const uint64_t now_ns = hid_port_sim_now_ns(sim);
    while (sim->script_next < sim->script_count &&
           sim->script[sim->script_next].time_ns <= now_ns) {
        const struct hid_raw *raw = &sim->script[sim->script_next++];
        say_at(sim, raw->bytes, raw->size, raw->time_ns);
    }
}

/* ---- Operations of the port ----------------------------------------------------------------- */

static int hid_port_sim_open(void *self, struct hid_device_info *out)
{
    struct hid_port_sim *sim = self;
    CORE_ASSERT(out);
    sim->open_count++;
    if (!sim->face) {
        return HAL_ERR_ABSENT;
    }
    say_script(sim);
    if (sim->absent || (sim->gone && hid_port_sim_now_ns(sim) < sim->replug_ns)) {
        return HAL_ERR_GONE;
    }
    if (sim->gone) { /* The device was plugged in again. The reports from the time without the
                        device are lost. */
        sim->gone = 0;
        sim->unplug_at = HID_SIM_NEVER;
    }
    sim->is_open = 1;
    sim->ring_count = 0;
    *out = *sim->face;
    return HAL_OK;
}

static int hid_port_sim_take(void *self, struct hid_raw *out)
{
    struct hid_port_sim *sim = self;
    CORE_ASSERT(out && sim->ring_count <= HID_REPORTS_MAX);
    say_script(sim);
    if (sim->ring_count > 0) {
        *out = sim->ring[sim->ring_first];
        sim->ring_first = (sim->ring_first + 1u) % HID_REPORTS_MAX;
        sim->ring_count--;
        return 1;
    }
    if (sim->gone || sim->absent || !sim->is_open) {
        sim->gone = 1;
        sim->is_open = 0;
        return HAL_ERR_GONE;
    }
    return 0;
}

static int hid_port_sim_send(void *self, const uint8_t *bytes, uint32_t size)
{
    struct hid_port_sim *sim = self;
    CORE_ASSERT(bytes || size == 0);
    if (!sim->is_open || sim->gone) {
        return HAL_ERR_GONE;
    }
    if (sim->busy) {
        return HAL_ERR_BUSY;
    }
    sim->sent_size = size < HID_REPORT_MAX ? size : HID_REPORT_MAX;
    memcpy(sim->sent, bytes, sim->sent_size);
    sim->sent_count++;
    return HAL_OK;
}

static uint32_t hid_port_sim_lost_count(void *self)
{
    const struct hid_port_sim *sim = self;
    return sim->lost_count;
}

static const char *hid_port_sim_describe(void *self)
{
    const struct hid_port_sim *sim = self;
    return sim->face ? "simulated controller" : "no simulated controller";
}

struct hid_port hid_port_sim_port(struct hid_port_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hid_port_ops ops = {
        .open = hid_port_sim_open,
        .take = hid_port_sim_take,
        .send = hid_port_sim_send,
        .lost_count = hid_port_sim_lost_count,
        .describe = hid_port_sim_describe,
    };
    return (struct hid_port){ .ops = &ops, .self = sim };
}

/* ---- The device list ------------------------------------------------------------------------ */

void hid_device_list_sim_init(struct hid_device_list_sim *sim,
                              struct hid_port_sim *const seats[POI_MAX])
{
    CORE_ASSERT(seats);
    memset(sim, 0, sizeof *sim);
    memcpy(sim->seat, seats, sizeof sim->seat);
}

/* Attaches the device of `row` to its slot, or to the first free slot. Returns 0 if all slots are
 * occupied, otherwise 1. */
static int sit_down(struct hid_device_list_sim *sim, uint32_t row)
{
    CORE_ASSERT(row < CONTROLLER_MAX);
    for (uint32_t i = 0; i < POI_MAX && !sim->taken[row]; i++) {
        if (sim->seat[i] && !memchr(sim->taken, (int)i + 1, CONTROLLER_MAX)) {
            sim->taken[row] = (uint8_t)(i + 1u);
        }
    }
    if (!sim->taken[row]) {
        return 0;
    }
    struct hid_port_sim *seat = sim->seat[sim->taken[row] - 1u];
    seat->face = sim->face[row];
    seat->absent = sim->face[row] == NULL;
    return 1;
}

void hid_device_list_sim_plug(struct hid_device_list_sim *sim, uint32_t row,
                              const struct hid_device_info *face)
{
    CORE_ASSERT(row < CONTROLLER_MAX);
    if (!face && sim->taken[row]) {
        sim->seat[sim->taken[row] - 1u]->absent = 1;
    }
    if (!face && !sim->chosen[row]) {
        sim->barred[row] = sim->denied[row] = 0;
    }
    sim->face[row] = face;
    sim->who[row] = face ? face->identity : sim->who[row];
    if (face && sim->chosen[row]) {
        sit_down(sim, row);
    }
}

static void write_sim_rows(void *self, struct hid_row out[CONTROLLER_MAX])
{
    const struct hid_device_list_sim *sim = self;
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        const uint8_t state = !sim->face[i]     ? sim->chosen[i] ? CONTROLLER_LOST : CONTROLLER_NONE
                              : sim->barred[i]  ? CONTROLLER_UNSUPPORTED
                              : !sim->chosen[i] ? CONTROLLER_FREE
                              : sim->denied[i] || !sim->taken[i] ? CONTROLLER_DENIED
                                                                 : CONTROLLER_ACTIVE;
        out[i] = (struct hid_row){ .state = state, .seat = POI_MAX };
        if (out[i].state != CONTROLLER_NONE) {
            out[i].identity = sim->face[i] ? sim->face[i]->identity : sim->who[i];
        }
        if (sim->taken[i]) {
            out[i].seat = (uint8_t)(sim->taken[i] - 1u);
        }
    }
}

static int hid_device_list_sim_select(void *self, uint32_t row)
{
    struct hid_device_list_sim *sim = self;
    sim->choose_count++;
    if (row >= CONTROLLER_MAX || !sim->face[row] || sim->barred[row]) {
        return HAL_ERR_ABSENT;
    }
    if (!sim->denied[row] && !sit_down(sim, row)) {
        return HAL_ERR_BUSY;
    }
    sim->chosen[row] = 1;
    return HAL_OK;
}

static int hid_device_list_sim_release(void *self, uint32_t row)
{
    struct hid_device_list_sim *sim = self;
    sim->release_count++;
    if (row >= CONTROLLER_MAX || !sim->chosen[row]) {
        return HAL_ERR_ABSENT;
    }
    if (sim->taken[row]) {
        sim->seat[sim->taken[row] - 1u]->absent = 1;
    }
    sim->taken[row] = sim->chosen[row] = 0;
    return HAL_OK;
}

static const char *describe_sim_list(void *self)
{
    (void)self;
    return "controllers made of memory";
}

struct hid_device_list hid_device_list_sim_device(struct hid_device_list_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hid_device_list_ops ops = { .rows = write_sim_rows,
                                                    .choose = hid_device_list_sim_select,
                                                    .release = hid_device_list_sim_release,
                                                    .describe = describe_sim_list };
    return (struct hid_device_list){ .ops = &ops, .self = sim };
}
