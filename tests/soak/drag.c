/* drag.c -- implementation of drag.h. All strokes are drawn at random from one seed, so that every
 * run is the same. */
#include "tests/soak/drag.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/rng.h"
#include "platform/cpu.h"

#define BOWL_FULL 12u

static float draw(const struct drag *drag, uint32_t which, float low, float high)
{
    const struct rng_key key = { drag->core.config.seed, drag->stroke, which, RNG_TEST };
    return rng_range(key, low, high);
}

void drag_init(struct drag *drag, uint8_t preset, uint32_t fish_count, uint32_t seed)
{
    const struct core_config config = {
        .seed = seed, .preset = preset, .fish_count = fish_count, .round_s = 600
    };
    memset(drag, 0, sizeof *drag);
    if (core_init(&drag->core, &config) != CORE_OK) {
        abort();
    }
    drag->input.poi[0].link = POI_SOURCE_LIVE;
    drag->input.poi[0].has_wrist = 1;
    drag->input.poi[0].target.position_m = v3(0.0f, 0.10f, 0.0f);
    drag->to_m = drag->input.poi[0].target.position_m;
}

/* Draws the target of the next stroke at random: a point in the tank, a wall, a corner, the floor,
 * or a point above the water. From a point above the water, the next stroke enters the water
 * again. */
static void next_stroke(struct drag *drag)
{
    const vec3 size = drag->core.world.tank.size_m;
    drag->stroke++;
    const float kind = draw(drag, 0, 0.0f, 1.0f);
    vec3 to = v3(draw(drag, 1, -0.5f, 0.5f) * size.x, -draw(drag, 2, 0.0f, 1.0f) * size.y,
                 draw(drag, 3, -0.5f, 0.5f) * size.z);
    if (kind < 0.15f) {
        to.x = to.x < 0.0f ? -0.5f * size.x : 0.5f * size.x;
    }
    if (kind < 0.05f || (kind > 0.15f && kind < 0.30f)) {
        to.z = to.z < 0.0f ? -0.5f * size.z : 0.5f * size.z;
    }
    if (kind > 0.30f && kind < 0.45f) {
        to.y = -size.y;
    } else if (kind > 0.90f) {
        to.y = 0.06f;
    }
    drag->to_m = to;
    /* Draws the speed so that its logarithm has a uniform distribution. Slow strokes are then as
     * frequent as fast ones. */
    drag->speed_m_s = 0.1f * f_exp(draw(drag, 4, 0.0f, 2.708f));
    const float tilt = kind > 0.6f ? 90.0f : 50.0f;
    drag->angles =
        (struct angles){ draw(drag, 5, -90.0f, 90.0f) * F_DEG, draw(drag, 6, -tilt, tilt) * F_DEG,
                         draw(drag, 7, -tilt, tilt) * F_DEG };
}

static void move_target(struct drag *drag)
{
    struct poi_target *hand = &drag->input.poi[0].target;
    const vec3 way = v3_sub(drag->to_m, hand->position_m);
    const float step_m = drag->speed_m_s * CORE_TICK_S;
    if (v3_length(way) <= step_m) {
        next_stroke(drag);
    }
    hand->position_m = v3_add(hand->position_m, v3_limit(way, step_m));
    drag->hand_m += (double)f_min(step_m, v3_length(way));
    hand->angles.yaw_rad += 0.03f * (drag->angles.yaw_rad - hand->angles.yaw_rad);
    hand->angles.pitch_rad += 0.03f * (drag->angles.pitch_rad - hand->angles.pitch_rad);
    hand->angles.roll_rad += 0.03f * (drag->angles.roll_rad - hand->angles.roll_rad);
}

static void tick_core(struct drag *drag)
{
    drag->output.sound_count = 0;
    if (core_tick(&drag->core, &drag->input, &drag->output) != CORE_OK) {
        fputs("soak: " CPU_FLOAT_WRONG "\n", stderr);
        exit(70);
    }
    drag->input.pressed = 0;
}

void drag_begin(struct drag *drag)
{
    cpu_set_float();
    while (drag->core.game.phase != PHASE_ROUND) {
        drag->input.pressed = drag->core.game.tick % 60u == 0 ? INPUT_START : 0u;
        tick_core(drag);
    }
    next_stroke(drag);
}

/* Replaces torn paper by new paper, because a ring with torn paper would push the fish less. */
static void renew_paper(struct poi *poi)
{
    if (poi->sheet.paper_cells < poi->sheet.paper_cells_new) {
        sheet_init(&poi->sheet, poi->sheet.grade, POI_RADIUS_M, poi->seed);
    }
}

void drag_tick(struct drag *drag)
{
    struct core *core = &drag->core;
    move_target(drag);
    renew_paper(&core->world.poi[0]);
    if (core->world.bowl[0].fish_count > BOWL_FULL) {
        bowl_empty(&core->world.bowl[0], 0, &core->world.tank);
    }
    if (core->game.tick - core->game.phase_tick > CORE_TICK_HZ) {
        /* Moves the start of the phase one tick later in each tick. The round therefore never
         * reaches its end. */
        core->game.phase_tick++;
    }
    tick_core(drag);
    const vec3 hand = drag->input.poi[0].target.position_m;
    drag->lag_sum_m += (double)v3_length(v3_sub(hand, core->world.poi[0].position_m));
    drag->ticks++;
}

void drag_calm_tick(struct drag *drag)
{
    struct core *core = &drag->core;
    struct obstacle bowl = bowl_obstacle(&core->world.bowl[0]);
    tank_tick(&core->world.tank, core->game.tick, &bowl, 1);
    core->game.tick++;
}
