/* hid_sim.c -- implements the simulated transport and the simulated device list in memory. */
#include "drivers/sim/hid_sim.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/base/rng.h"

/* ---- Port ------------------------------------------------------------------------------------ */

/* Sends the pending output report, as the event thread of a real transport does. */
static void send_output(void *self)
{
    struct hid_port_sim *sim = self;
    const uint32_t size = sim->busy ? 0u : hid_port_outgoing(&sim->port);
    if (size > 0) {
        memcpy(sim->sent, sim->port.out_bytes, size);
        sim->sent_size = size;
        hid_port_sent(&sim->port);
    }
}

void hid_port_sim_plug(struct hid_port_sim *sim, const struct hid_device_info *face)
{
    if (sim->is_attached) {
        hid_port_detach(&sim->port);
    }
    if (face) {
        hid_port_attach(&sim->port, face);
    }
    sim->is_attached = face != NULL;
    sim->unplug_at = HID_SIM_NEVER;
}

void hid_port_sim_init(struct hid_port_sim *sim, struct hal_clock clock,
                       const struct hid_device_info *face)
{
    CORE_ASSERT(clock.ops);
    memset(sim, 0, sizeof *sim);
    sim->clock = clock;
    hid_port_init(&sim->port, send_output, sim);
    hid_port_sim_plug(sim, face);
}

static uint32_t random_u32(uint32_t number, uint32_t what)
{
    return rng_u32((struct rng_key){ 83, number, what, RNG_TEST });
}

static void scramble(struct hid_raw *raw, uint32_t number, uint32_t from)
{
    CORE_ASSERT(raw->size <= HID_REPORT_MAX);
    for (uint32_t i = from; i < raw->size; i++) {
        raw->bytes[i] = (uint8_t)random_u32(number, i);
    }
}

static void apply_fault(const struct hid_port_sim *sim, uint8_t kind, uint32_t number,
                        struct hid_raw *raw)
{
    CORE_ASSERT(kind < HID_SIM_KIND_COUNT && raw->size <= HID_REPORT_MAX);
    switch (kind) {
    case HID_SIM_GARBAGE:
        scramble(raw, number, 1);
        break;
    case HID_SIM_NOISE:
        raw->size = 1u + random_u32(number, HID_REPORT_MAX) % HID_REPORT_MAX;
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

void hid_port_sim_report(struct hid_port_sim *sim, const uint8_t *bytes, uint32_t size)
{
    const uint32_t number = sim->report_count;
    struct hid_raw raw = { .size = size < HID_REPORT_MAX ? size : HID_REPORT_MAX };
    uint32_t copies = 1;
    CORE_ASSERT(bytes && number < HID_SIM_NEVER);
    if (number >= sim->unplug_at) {
        hid_port_sim_plug(sim, NULL);
    }
    if (!sim->is_attached) {
        return;
    }
    sim->report_count++;
    memcpy(raw.bytes, bytes, raw.size);
    for (uint32_t i = 0; i < sim->fault_count; i++) {
        const struct hid_sim_fault *fault = &sim->faults[i];
        if (number >= fault->from && number < fault->to) {
            copies = fault->kind == HID_SIM_SILENCE ? 0u
                     : fault->kind == HID_SIM_TWICE ? 2u
                                                    : copies;
            apply_fault(sim, fault->kind, number, &raw);
        }
    }
    sim->last = raw;
    for (uint32_t i = 0; i < copies; i++) {
        hid_port_report(&sim->port, hal_now_ns(sim->clock), raw.bytes, raw.size);
    }
}

/* ---- The device list ------------------------------------------------------------------------ */

void hid_device_list_sim_init(struct hid_device_list_sim *sim,
                              struct hid_port_sim *const ports[POI_MAX])
{
    CORE_ASSERT(ports);
    memset(sim, 0, sizeof *sim);
    memcpy(sim->port, ports, sizeof sim->port);
}

/* Attaches the device of `row` to its slot, or to the first free slot. Returns false if all slots
 * are occupied. */
static bool attach_to_slot(struct hid_device_list_sim *sim, uint32_t row)
{
    CORE_ASSERT(row < CONTROLLER_MAX);
    for (uint32_t i = 0; i < POI_MAX && !sim->taken[row]; i++) {
        if (sim->port[i] && !memchr(sim->taken, (int)i + 1, CONTROLLER_MAX)) {
            sim->taken[row] = (uint8_t)(i + 1u);
        }
    }
    if (!sim->taken[row]) {
        return false;
    }
    struct hid_port_sim *port = sim->port[sim->taken[row] - 1u];
    if (!port->is_attached) {
        hid_port_sim_plug(port, sim->face[row]);
    }
    return true;
}

void hid_device_list_sim_plug(struct hid_device_list_sim *sim, uint32_t row,
                              const struct hid_device_info *face)
{
    CORE_ASSERT(row < CONTROLLER_MAX);
    if (!face && sim->taken[row]) {
        hid_port_sim_plug(sim->port[sim->taken[row] - 1u], NULL);
    }
    if (!face && !sim->chosen[row]) {
        sim->barred[row] = sim->denied[row] = false;
    }
    sim->face[row] = face;
    sim->who[row] = face ? face->identity : sim->who[row];
    if (face && sim->chosen[row]) {
        attach_to_slot(sim, row);
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
        out[i] = (struct hid_row){ .state = state, .slot = POI_MAX };
        if (out[i].state != CONTROLLER_NONE) {
            out[i].identity = sim->face[i] ? sim->face[i]->identity : sim->who[i];
        }
        if (sim->taken[i]) {
            out[i].slot = (uint8_t)(sim->taken[i] - 1u);
        }
    }
}

static int hid_device_list_sim_choose(void *self, uint32_t row, bool plays)
{
    struct hid_device_list_sim *sim = self;
    sim->choose_count += plays;
    sim->release_count += !plays;
    if (row >= CONTROLLER_MAX ||
        (plays ? !sim->face[row] || sim->barred[row] : !sim->chosen[row])) {
        return HAL_ERR_ABSENT;
    }
    if (plays && !sim->denied[row] && !attach_to_slot(sim, row)) {
        return HAL_ERR_BUSY;
    }
    if (!plays && sim->taken[row]) {
        hid_port_sim_plug(sim->port[sim->taken[row] - 1u], NULL);
        sim->taken[row] = 0;
    }
    sim->chosen[row] = plays;
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
                                                    .choose = hid_device_list_sim_choose,
                                                    .describe = describe_sim_list };
    return (struct hid_device_list){ .ops = &ops, .self = sim };
}
