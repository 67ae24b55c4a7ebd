/* hid_device_list_sim.c -- implements a simulated device list in memory. */
#include "drivers/sim/hid_device_list_sim.h"

#include <string.h>

void hid_device_list_sim_init(struct hid_device_list_sim *sim,
                              struct hid_port_sim *const seats[POI_MAX])
{
    memset(sim, 0, sizeof *sim);
    memcpy(sim->seat, seats, sizeof sim->seat);
}

static int is_seated(const struct hid_device_list_sim *sim, uint32_t seat)
{
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        if (sim->taken[i] == seat + 1u) {
            return 1;
        }
    }
    return 0;
}

static int sit_down(struct hid_device_list_sim *sim, uint32_t row)
{
    for (uint32_t i = 0; i < POI_MAX && !sim->taken[row]; i++) {
        if (sim->seat[i] && !is_seated(sim, i)) {
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

static uint8_t state_of(const struct hid_device_list_sim *sim, uint32_t row)
{
    if (!sim->face[row]) {
        return sim->chosen[row] ? CONTROLLER_LOST : CONTROLLER_NONE;
    }
    return sim->barred[row]                       ? CONTROLLER_UNSUPPORTED
           : !sim->chosen[row]                    ? CONTROLLER_FREE
           : sim->denied[row] || !sim->taken[row] ? CONTROLLER_DENIED
                                                  : CONTROLLER_ACTIVE;
}

static void rows(void *self, struct hid_row out[CONTROLLER_MAX])
{
    const struct hid_device_list_sim *sim = self;
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        out[i] = (struct hid_row){ .state = state_of(sim, i), .seat = POI_MAX };
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

static const char *describe(void *self)
{
    (void)self;
    return "controllers made of memory";
}

struct hid_device_list hid_device_list_sim_device(struct hid_device_list_sim *sim)
{
    static const struct hid_device_list_ops ops = { .rows = rows,
                                                    .choose = hid_device_list_sim_select,
                                                    .release = hid_device_list_sim_release,
                                                    .describe = describe };
    return (struct hid_device_list){ .ops = &ops, .self = sim };
}
