/* sensor_sim.c -- generates a report in each period and applies the selected fault. */
#include "drivers/sim/sensor_sim.h"

#include <string.h>

#include "core/base/panic.h"
#include "core/base/rng.h"

#define NS_PER_S 1000000000ull
#define TREMBLE_M 5e-5f
#define TREMBLE_RAD 2e-4f
#define JUMP_M 1.0f

static uint64_t sensor_sim_now_ns(const struct sensor_sim *sim)
{
    return sim->clock.ops->now_ns(sim->clock.self);
}

void sensor_sim_init(struct sensor_sim *sim, struct hal_clock clock, uint32_t rate_hz)
{
    CORE_ASSERT(clock.ops && rate_hz > 0);
    *sim = (struct sensor_sim){ .clock = clock, .period_ns = NS_PER_S / rate_hz };
    sim->next_ns = sensor_sim_now_ns(sim);
}

static int fails_at(const struct sensor_sim *sim, enum sensor_fault fault, uint64_t time_ns)
{
    CORE_ASSERT(fault < SENSOR_FAULT_COUNT);
    return sim->fault == (uint8_t)fault && time_ns >= sim->from_ns && time_ns < sim->to_ns;
}

static float sensor_sim_draw(const struct sensor_sim *sim, uint32_t what, float spread)
{
    return rng_range((struct rng_key){ 77, sim->count, what, RNG_TEST }, -spread, spread);
}

static struct poi_target true_target(const struct sensor_sim *sim)
{
    struct poi_target target = sim->hand;
    target.position_m.x += sensor_sim_draw(sim, 0, TREMBLE_M);
    target.position_m.y += sensor_sim_draw(sim, 1, TREMBLE_M);
    target.position_m.z += sensor_sim_draw(sim, 2, TREMBLE_M);
    target.angles.yaw_rad += sensor_sim_draw(sim, 3, TREMBLE_RAD);
    target.angles.pitch_rad += sensor_sim_draw(sim, 4, TREMBLE_RAD);
    target.angles.roll_rad += sensor_sim_draw(sim, 5, TREMBLE_RAD);
    return target;
}

static void spoil_bits(const struct sensor_sim *sim, struct poi_target *target)
{
    uint32_t bits[6];
    for (uint32_t i = 0; i < 6; i++) {
        bits[i] = rng_u32((struct rng_key){ 78, sim->count, i, RNG_TEST });
    }
    memcpy(target, bits, sizeof *target);
}

static void spoil_one(const struct sensor_sim *sim, struct poi_target *target)
{
    CORE_ASSERT(target);
    static const uint32_t none[] = { 0x7fc00000u, 0x7f800000u, 0xff800000u, 0x7f800001u };
    uint8_t *bytes = (uint8_t *)target;
    memcpy(bytes + sim->count % 6u * sizeof(float), &none[sim->count / 6u % 4u], sizeof(float));
}

static struct poi_target sensor_sim_reading(struct sensor_sim *sim, uint64_t time_ns)
{
    CORE_ASSERT(sim->fault < SENSOR_FAULT_COUNT);
    struct poi_target target = true_target(sim);
    if (fails_at(sim, SENSOR_STUCK, time_ns)) {
        target = sim->last;
    } else if (fails_at(sim, SENSOR_JUMPED, time_ns)) {
        target.position_m.x += target.position_m.x > 0.0f ? -JUMP_M : JUMP_M;
    } else if (fails_at(sim, SENSOR_FLIPPED, time_ns)) {
        target.angles.roll_rad += F_PI;
    } else if (fails_at(sim, SENSOR_NOT_A_NUMBER, time_ns)) {
        spoil_one(sim, &target);
    } else if (fails_at(sim, SENSOR_GARBAGE, time_ns)) {
        spoil_bits(sim, &target);
    }
    sim->last = target;
    sim->count++;
    return target;
}

/* Delays a report. When the buffer is full, the oldest report is lost. */
static void hold_back(struct sensor_sim *sim, struct poi_target target)
{
    CORE_ASSERT(sim->held_count <= SENSOR_SIM_HELD_MAX);
    if (sim->held_count == SENSOR_SIM_HELD_MAX) {
        memmove(sim->held, sim->held + 1, (SENSOR_SIM_HELD_MAX - 1u) * sizeof sim->held[0]);
        sim->held_count--;
    }
    sim->held[sim->held_count++] = target;
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

static uint32_t let_go(struct sensor_sim *sim, struct poi_sample *out, uint32_t max,
                       uint64_t now_ns)
{
    CORE_ASSERT(sim->held_count <= SENSOR_SIM_HELD_MAX && (out || max == 0));
    uint32_t count = 0;
    while (count < sim->held_count && count < max) {
        out[count] = sample_of(sim->held[count], now_ns);
        count++;
    }
    sim->held_count = 0;
    return count;
}

static int sensor_sim_poll(void *self, struct poi_sample *out, uint32_t max)
{
    struct sensor_sim *sim = self;
    CORE_ASSERT(sim->period_ns > 0);
    const uint64_t now_ns = sensor_sim_now_ns(sim);
    if (fails_at(sim, SENSOR_GONE, now_ns)) {
        return HAL_ERR_GONE;
    }
    uint32_t count = fails_at(sim, SENSOR_HELD_BACK, now_ns) ? 0 : let_go(sim, out, max, now_ns);
    for (; sim->next_ns <= now_ns; sim->next_ns += sim->period_ns) {
        const struct poi_target target = sensor_sim_reading(sim, sim->next_ns);
        const uint32_t copies = fails_at(sim, SENSOR_TWICE, sim->next_ns) ? 2u : 1u;
        if (fails_at(sim, SENSOR_HELD_BACK, sim->next_ns)) {
            hold_back(sim, target);
        } else if (!fails_at(sim, SENSOR_SILENT, sim->next_ns)) {
            for (uint32_t i = 0; i < copies && count < max; i++) {
                out[count++] = sample_of(target, sim->next_ns);
            }
        }
    }
    return (int)count;
}

/* Restarts the reports at the current time. Reports from the time without the sensor are lost. */
static int sensor_sim_open(void *self)
{
    struct sensor_sim *sim = self;
    const uint64_t now_ns = sensor_sim_now_ns(sim);
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
    return fails_at(sim, SENSOR_GONE, sensor_sim_now_ns(sim)) ? HAL_ERR_GONE : HAL_OK;
}

static void sensor_sim_set_view(void *self, const struct view *view,
                                const struct display_settings *display_settings)
{
    struct sensor_sim *sim = self;
    CORE_ASSERT(view);
    (void)display_settings; /* Unused, because the pose refers to the water and not to the
                               screen. */
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
