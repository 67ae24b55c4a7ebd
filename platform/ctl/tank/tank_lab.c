/* tank_lab.c -- advances the simulated tank, and measures the tank after each tick. */
#include "platform/ctl/tank/tank_lab.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "core/poi/catch/catch.h"
#include "core/poi/poi.h"
#include "core/poi/poi_fields.h"
#include "core/tank/tank_fields.h"
#include "platform/cpu.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/ctl/tank/tank_files.h"
#include "platform/os/clock.h"
#include "platform/os/print.h"

#define POI_GRADE 5u /* Paper grade of the poi. The championship mode has the same grade. */
/* Default number of ticks between two observations for a tank with more fish than a kiosk has. 24
 * ticks give 5 observations per second. For 100,000 fish, one observation takes more computing time
 * than one tick. */
#define OBSERVE_MANY_TICKS 24u

static const char path_speaker[] = "kingyoctl tank: --poi-path";
static const char place_speaker[] = "kingyoctl tank: --place";

uint32_t tank_lab_seconds(const struct tank_options *plan)
{
    return plan->tick_count / CORE_TICK_HZ + 1u;
}

/* ---- Counting fish --------------------------------------------------------------------------- */

static struct shade_cast cast_of(const struct plan_shade *shade)
{
    return (struct shade_cast){
        .present = 1,
        .x_m = (float)shade->x_m,
        .z_m = (float)shade->z_m,
        .radius_m = (float)shade->radius_m,
        .dark = SHADE_FAN_DARK,
    };
}

/* Returns true if the fish is within any shade of the plan. A shade that is not cast at the moment
 * counts too. */
static bool is_shaded(const struct tank_lab *lab, const struct fish *fish)
{
    for (uint32_t i = 0; i < lab->plan->shade_count; i++) {
        const struct shade_cast cast = cast_of(&lab->plan->shade[i]);
        if (shade_covers(&cast, fish->position_m)) {
            return true;
        }
    }
    return false;
}

static void count_second(struct tank_lab *lab)
{
    const uint32_t second = lab->tick / CORE_TICK_HZ;
    for (uint32_t i = 0; i < lab->tank.fish_count; i++) {
        const struct fish *fish = &lab->tank.fish[i];
        lab->surfacing_count[second] += fish->gait == GAIT_SURFACE ? 1u : 0u;
        lab->shade_count[second] += fish_swims(fish) && is_shaded(lab, fish) ? 1u : 0u;
    }
}

/* Adds the gaits, speeds, encounters and overlaps of all fish after a tick. */
static void observe(struct tank_lab *lab)
{
    struct lab_sums *sums = &lab->sums;
    CORE_ASSERT(lab->tick > lab->observed_tick);
    for (uint32_t i = 0; i < lab->tank.fish_count; i++) {
        const struct fish *fish = &lab->tank.fish[i];
        sums->gait_ticks[fish->gait]++;
        sums->stamina += (double)fish->stamina;
        if (fish_swims(fish) && !fish->falls) {
            const double speed_m_s = (double)v3_length(fish->velocity_m_s);
            sums->swim_ticks++;
            sums->speed_m_s += speed_m_s;
            sums->speed_max_m_s = fmax(sums->speed_max_m_s, speed_m_s);
        }
    }
    sums->fish_ticks += lab->tank.fish_count;
    tank_meetings_update(&lab->meetings, &lab->tank, lab->tick - lab->observed_tick);
    overlap_add(&lab->overlap, &lab->tank, &lab->overlaps);
    lab->observed_tick = lab->tick;
}

/* ---- One tick -------------------------------------------------------------------------------- */

/* Advances the tank by one tick and records the CPU time of the calling thread. Unlike the
 * wall-clock time, the CPU time excludes other processes. An observation evicts the tank's data
 * from the CPU caches. The ticks in the next broad-phase period are therefore slower and are not
 * recorded. */
static void tick_tank(struct tank_lab *lab, struct obstacle *obstacles, uint32_t count)
{
    const uint64_t begin_ns = clock_ns(CLOCK_THREAD_CPUTIME_ID);
    tank_tick(&lab->tank, lab->tick, obstacles, count);
    const uint64_t end_ns = clock_ns(CLOCK_THREAD_CPUTIME_ID);
    if (lab->observe_every <= BROAD_PHASE_UPDATE_TICKS || lab->observed_tick == 0 ||
        lab->tick >= lab->observed_tick + BROAD_PHASE_UPDATE_TICKS) {
        CORE_ASSERT(lab->timed_count < lab->plan->tick_count);
        lab->tick_ns[lab->timed_count++] = (float)(end_ns - begin_ns);
    }
}

static void cast_shades(struct tank_lab *lab)
{
    struct shade_cast casts[TANK_SHADE_MAX] = { 0 };
    CORE_ASSERT(lab->plan->shade_count <= SHADE_MAX);
    const double now_s = (double)lab->tick / CORE_TICK_HZ;
    for (uint32_t i = 0; i < lab->plan->shade_count; i++) {
        const struct plan_shade *shade = &lab->plan->shade[i];
        if (now_s >= shade->from_s && now_s < shade->to_s) {
            casts[i] = cast_of(shade);
        }
    }
    if (lab->path.count > 0) {
        casts[SHADE_MAX] = poi_shade(&lab->poi);
    }
    tank_cast(&lab->tank, casts);
}

void tank_lab_tick(struct tank_lab *lab)
{
    CORE_ASSERT(lab->tick < lab->plan->tick_count && lab->observe_every > 0);
    const bool has_poi = lab->path.count > 0;
    struct poi *poi = &lab->poi;
    struct obstacle ring = { 0 };
    /* The steps have the order of core_tick(): poi, water, fish, captures. */
    if (has_poi) {
        const double now_s = (double)(lab->tick + 1u) / CORE_TICK_HZ;
        const struct poi_grip grip = { .target = tank_path_at(&lab->path, now_s), .has_wrist = 1 };
        lab->output.sound_count = 0;
        poi_tick(poi, &grip, &lab->tank, &lab->bowl);
        surface_disturbance_tick(poi, &lab->tank.water, lab->tank.size_m);
    }
    if (lab->tick % 2u == 0) {
        water_step(&lab->tank.water, lab->tank.size_m);
    }
    if (has_poi) {
        ring = poi_obstacle(poi);
    }
    cast_shades(lab);
    tick_tank(lab, has_poi ? &ring : NULL, has_poi ? 1 : 0);
    if (has_poi) {
        const struct stall stall = { &lab->tank, &lab->bowl, 1, false };
        struct catch_result caught[POI_MAX] = { 0 };
        poi_apply_reaction(poi, &ring);
        catch_tick(poi, 0, &stall, lab->tick, &lab->output, caught);
    }
    lab->tick++;
    if (lab->tick % lab->observe_every == 0 || lab->tick == lab->plan->tick_count) {
        observe(lab);
    }
    if (lab->tick % CORE_TICK_HZ == 0) {
        count_second(lab);
    }
}

uint64_t tank_lab_hash(const struct tank_lab *lab)
{
    const uint64_t hash =
        lab->path.count > 0 ? field_hash(HASH_START, &poi_fields, &lab->poi) : HASH_START;
    return field_hash(hash, &tank_fields, &lab->tank);
}

/* ---- Opening the tank ------------------------------------------------------------------------ */

static enum exit_code open_tank(struct tank_lab *lab)
{
    static struct tank_place place;
    const struct tank_options *plan = lab->plan;
    struct tank_config config = plan->config;
    config.lanes = cpu_lanes();
    if (plan->place) {
        const enum exit_code code = tank_place_read(&place, place_speaker, plan->place);
        const uint32_t most = tank_config_fish_max(&config);
        if (code != EXIT_OK) {
            return code;
        }
        if (plan->has_fish && place.count != config.fish_count) {
            return ctl_usage("tank", "--fish: %u, but %s places %u", config.fish_count, plan->place,
                             place.count);
        }
        if (place.count > most) {
            return print_fail(EXIT_BAD_DATA, "%s: %s: %u fish; this tank holds 1 to %u",
                              place_speaker, plan->place, place.count, most);
        }
        config.fish_count = place.count;
    }
    if (!tank_open(&lab->tank, &config)) {
        return print_fail(EXIT_NOT_SO,
                          "kingyoctl tank: %u fish do not fit in this tank with the seed %u",
                          config.fish_count, config.seed);
    }
    return plan->place ? tank_place_stage(&place, &lab->tank, place_speaker, plan->place) : EXIT_OK;
}

enum exit_code tank_lab_open(struct tank_lab *lab, const struct tank_options *plan)
{
    lab->plan = plan;
    CORE_ASSERT(plan->tick_count > 0);
    enum exit_code code = open_tank(lab);
    if (code == EXIT_OK && plan->poi_path) {
        code = tank_path_read(&lab->path, path_speaker, plan->poi_path);
    }
    if (code != EXIT_OK) {
        return code;
    }
    if (plan->poi_path) {
        const struct poi_target hand = tank_path_at(&lab->path, 0.0);
        poi_init(&lab->poi, POI_GRADE, hand.position_m, plan->config.seed);
        lab->poi.link = POI_SOURCE_LIVE;
        lab->poi.angles = hand.angles;
    }
    const uint32_t seconds = tank_lab_seconds(plan);
    lab->tick_ns = calloc(plan->tick_count, sizeof *lab->tick_ns);
    lab->shade_count = calloc(seconds, sizeof *lab->shade_count);
    lab->surfacing_count = calloc(seconds, sizeof *lab->surfacing_count);
    if (!lab->tick_ns || !lab->shade_count || !lab->surfacing_count) {
        print_error("kingyoctl tank: out of memory");
        tank_lab_close(lab);
        return EXIT_IO;
    }
    lab->observe_every = plan->observe_every > 0                  ? plan->observe_every
                         : lab->tank.fish_count > TANK_FISH_KIOSK ? OBSERVE_MANY_TICKS
                                                                  : 1u;
    lab->oxygen_start_mg_l = lab->tank.oxygen.dissolved_mg_l;
    count_second(lab);
    return EXIT_OK;
}

void tank_lab_close(struct tank_lab *lab)
{
    free(lab->tick_ns);
    free(lab->shade_count);
    free(lab->surfacing_count);
    lab->tick_ns = NULL;
    lab->shade_count = lab->surfacing_count = NULL;
}
