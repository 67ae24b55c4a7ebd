/* sensor_sim.c -- generates a report in each period and applies the selected fault. */
#include "drivers/sim/sensor_sim.h"

#include <stdbool.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/base/rng.h"

#define TREMBLE_M 5e-5f
#define TREMBLE_RAD 2e-4f
#define JUMP_M 1.0f

void sensor_sim_init(struct sensor_sim *sim, struct hal_clock clock, uint32_t rate_hz)
{
    CORE_ASSERT(clock.ops && rate_hz > 0);
    *sim = (struct sensor_sim){ .clock = clock, .period_ns = NS_PER_S / rate_hz };
    sim->next_ns = hal_now_ns(clock);
}

static bool fails_at(const struct sensor_sim *sim, enum sensor_fault fault, uint64_t time_ns)
{
    CORE_ASSERT(fault < SENSOR_FAULT_COUNT);
    return sim->fault == (uint8_t)fault && time_ns >= sim->from_ns && time_ns < sim->to_ns;
}

_Static_assert(sizeof(struct poi_target) == 6u * sizeof(float), "a pose has six numbers");

/* Returns the next report: the pose with noise, and with the fault that is active at `time_ns`. */
static struct poi_target next_report(struct sensor_sim *sim, uint64_t time_ns)
{
    static const uint32_t not_numbers[] = { 0x7fc00000u, 0x7f800000u, 0xff800000u, 0x7f800001u };
    struct poi_target target = sim->pose;
    float number[6];
    memcpy(number, &target, sizeof number);
    for (uint32_t i = 0; i < 6; i++) {
        const float spread = i < 3 ? TREMBLE_M : TREMBLE_RAD;
        number[i] += rng_range((struct rng_key){ 77, sim->count, i, RNG_TEST }, -spread, spread);
    }
    if (fails_at(sim, SENSOR_NOT_A_NUMBER, time_ns)) {
        memcpy(&number[sim->count % 6u], &not_numbers[sim->count / 6u % 4u], sizeof number[0]);
    }
    for (uint32_t i = 0; fails_at(sim, SENSOR_GARBAGE, time_ns) && i < 6; i++) {
        const uint32_t bits = rng_u32((struct rng_key){ 78, sim->count, i, RNG_TEST });
        memcpy(&number[i], &bits, sizeof bits);
    }
    memcpy(&target, number, sizeof number);
    if (fails_at(sim, SENSOR_STUCK, time_ns)) {
        target = sim->last;
    } else if (fails_at(sim, SENSOR_JUMPED, time_ns)) {
        target.position_m.x += target.position_m.x > 0.0f ? -JUMP_M : JUMP_M;
    } else if (fails_at(sim, SENSOR_FLIPPED, time_ns)) {
        target.angles.roll_rad += F_PI;
    }
    sim->last = target;
    sim->count++;
    return target;
}

static struct poi_sample sample_of(struct poi_target target, uint64_t time_ns)
{
    return (struct poi_sample){
        .time_ns = time_ns,
        .has_wrist = 1,
        .trembles = 1,
        .target = target,
    };
}

static int sensor_sim_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct sensor_sim *sim = self;
    CORE_ASSERT(sim->period_ns > 0 && sim->held_count <= SENSOR_SIM_HELD_MAX);
    const uint64_t now_ns = hal_now_ns(sim->clock);
    uint32_t count = 0;
    if (fails_at(sim, SENSOR_GONE, now_ns)) {
        return HAL_ERR_GONE;
    }
    if (!fails_at(sim, SENSOR_HELD_BACK, now_ns)) {
        for (; count < sim->held_count && count < max; count++) {
            out[count] = sample_of(sim->held[count], now_ns);
        }
        sim->held_count = 0;
    }
    for (; sim->next_ns <= now_ns; sim->next_ns += sim->period_ns) {
        const struct poi_target target = next_report(sim, sim->next_ns);
        const uint32_t copies = fails_at(sim, SENSOR_SILENT, sim->next_ns)  ? 0u
                                : fails_at(sim, SENSOR_TWICE, sim->next_ns) ? 2u
                                                                            : 1u;
        if (fails_at(sim, SENSOR_HELD_BACK, sim->next_ns)) {
            /* The buffer of delayed reports is full, so the oldest report is lost. */
            if (sim->held_count == SENSOR_SIM_HELD_MAX) {
                memmove(sim->held, sim->held + 1, sizeof sim->held - sizeof sim->held[0]);
                sim->held_count--;
            }
            sim->held[sim->held_count++] = target;
            continue;
        }
        for (uint32_t i = 0; i < copies && count < max; i++) {
            out[count++] = sample_of(target, sim->next_ns);
        }
    }
    return (int)count;
}

/* Restarts the reports at the current time. Reports from the time without the sensor are lost. */
static int sensor_sim_open(void *self)
{
    struct sensor_sim *sim = self;
    const uint64_t now_ns = hal_now_ns(sim->clock);
    sim->open_count++;
    if (fails_at(sim, SENSOR_GONE, now_ns)) {
        return HAL_ERR_GONE;
    }
    sim->next_ns = now_ns;
    sim->held_count = 0;
    return HAL_OK;
}

static int sensor_sim_set_force(void *self, const struct poi_force *force)
{
    struct sensor_sim *sim = self;
    CORE_ASSERT(force);
    sim->felt = *force;
    return fails_at(sim, SENSOR_GONE, hal_now_ns(sim->clock)) ? HAL_ERR_GONE : HAL_OK;
}

static void sensor_sim_set_view(void *self, const struct view *view,
                                const struct display_settings *display_settings, bool scoops)
{
    struct sensor_sim *sim = self;
    CORE_ASSERT(view);
    /* `display_settings` is unused, because the pose refers to the water and not to the screen. */
    (void)display_settings;
    (void)scoops; /* `scoops` is unused, because the sensor measures the real pose. */
    sim->view = *view;
}

static const char *sensor_sim_describe(void *self)
{
    (void)self;
    return "simulated sensor";
}

struct hal_poi sensor_sim_device(struct sensor_sim *sim)
{
    CORE_ASSERT(sim);
    static const struct hal_poi_ops ops = {
        .open = sensor_sim_open,
        .poll = sensor_sim_poll,
        .set_force = sensor_sim_set_force,
        .set_view = sensor_sim_set_view,
        .describe = sensor_sim_describe,
    };
    return (struct hal_poi){ .ops = &ops, .self = sim };
}
