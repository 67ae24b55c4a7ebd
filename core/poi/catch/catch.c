/* catch.c -- simulates one tick of the fish on a poi: capture, lying on the paper, fall and
 * landing. */
#include "core/poi/catch/catch.h"

#include "core/base/panic.h"
#include "core/base/physics.h"
#include "core/poi/catch/capture.h"
#include "core/poi/catch/carried_fish.h"
#include "core/view.h"

/* Lower limit of the line tension (force per width of paper) from which the compliance of the paper
 * is computed. The value is the tension of wet paper under a single fish. */
#define SLACK_N_M 1.5f
/* Acceleration away from the paper above which a fish lifts off the paper. */
#define LIFT_OFF_M_S2 0.5f
/* Highest sliding speed of a fish after it landed on the paper. Wet paper absorbs any higher
 * speed. */
#define LAND_M_S 0.2f
#define SLAP_EVERY_TICKS 8u /* Lowest number of ticks between two slap sounds of a poi. */
#define TEAR_EVERY_TICKS 14u
#define TEAR_LOUDER 0.2f

struct scoop { /* Data that the functions in this file share in one tick. */
    struct poi *poi;
    uint32_t poi_index;
    const struct stall *stall;
    struct tank *tank;
    struct output *output;
    uint32_t tick;
    struct basis axes;
    struct paper_surface ride;
    float pan;
    bool clear; /* True if the whole ring is above the water. */
    struct catch_result *results;
};

/* ---- Sounds of the poi ----------------------------------------------------------------------- */

/* Returns the stereo position of the place `at_m` in the tank. */
static float pan_at(const struct stall *stall, vec3 at_m)
{
    return view_pan(stall->is_turned, stall->tank->size_m, at_m);
}

static bool time_for(uint32_t *last, uint32_t now, uint32_t every)
{
    if (now - *last < every && *last != 0) {
        return false;
    }
    *last = now;
    return true;
}

/* Ticks between two creaks of the paper: CREAK_TICKS while the paper is in danger, and
 * CREAK_TICKS_MIN while the paper is about to tear. */
#define CREAK_TICKS 48u
#define CREAK_TICKS_MIN 24u
_Static_assert(CREAK_TICKS % CREAK_TICKS_MIN == 0, "slow creaks are tested when fast creaks are");
/* Danger, the result of sheet_warning(), above which the paper creaks (CREAK_FROM), and above which
 * it creaks faster (CREAK_FAST_FROM). */
#define CREAK_FROM 0.3f
#define CREAK_FAST_FROM 0.7f

/* Plays the creaks of paper that is about to tear. The number of the tick alone determines the
 * times of the creaks, so no state is necessary. */
static void sound_creak(const struct scoop *scoop)
{
    const struct poi *poi = scoop->poi;
    if (scoop->tick % CREAK_TICKS_MIN != 0 || poi->damage_immune || poi->strain.cells_torn > 0) {
        return;
    }
    const float warning = sheet_warning(&poi->sheet);
    if (warning >= (scoop->tick % CREAK_TICKS == 0 ? CREAK_FROM : CREAK_FAST_FROM)) {
        output_sound(scoop->output, SOUND_CREAK, 0.2f + 0.6f * warning, scoop->pan);
    }
}

/* Returns the share [0, 1] of the paper that is dry. */
static float dry_share(const struct sheet *sheet)
{
    float wet = 0.0f;
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        wet += sheet->wetness[i];
    }
    return f_clamp(1.0f - wet / (float)SHEET_CELL_COUNT, 0.0f, 1.0f);
}

/* Mass of carried water with which a lifted poi splashes most. */
#define SPLASH_FULL_KG 0.02f
/* Share of the paper that must be dry so that the sound of wetting is played. */
#define DRY_FROM 0.1f

/* Plays the sound of a tear. Most tears begin with few cells and grow within some ticks. A tear
 * that grows is therefore played again when it has become TEAR_LOUDER louder. */
static void sound_tear(const struct scoop *scoop)
{
    struct poi *poi = scoop->poi;
    if (poi->strain.cells_torn == 0) {
        return;
    }
    const float torn = f_clamp(0.4f + 0.03f * (float)poi->strain.cells_torn, 0.0f, 1.0f);
    if (time_for(&poi->tear_tick, scoop->tick, TEAR_EVERY_TICKS) ||
        torn > poi->tear_gain + TEAR_LOUDER) {
        poi->tear_gain = torn;
        output_sound(scoop->output, SOUND_TEAR, torn, scoop->pan);
    }
}

static void sound_ring(const struct scoop *scoop)
{
    struct poi *poi = scoop->poi;
    const float gain = f_clamp(0.2f + 0.9f * f_abs(poi->splash_m_s), 0.0f, 1.0f);
    if (poi->splash_m_s > 0.0f) {
        const float dry = dry_share(&poi->sheet);
        output_sound(scoop->output, SOUND_DIP, gain, scoop->pan);
        if (dry > DRY_FROM) {
            output_sound(scoop->output, SOUND_WET, dry, scoop->pan);
        }
    } else if (poi->splash_m_s < 0.0f) {
        const float water = f_min(poi->water_kg / SPLASH_FULL_KG, 1.0f);
        output_sound(scoop->output, SOUND_LIFT, gain * f_lerp(0.6f, 1.0f, water), scoop->pan);
    }
    if (poi->drops > 0) {
        output_sound(scoop->output, SOUND_DRIP, f_min(0.2f + 0.15f * (float)poi->drops, 1.0f),
                     scoop->pan);
    }
    sound_tear(scoop);
}

/* ---- Fish that leave the poi ----------------------------------------------------------------- */

static void remove_rider(struct poi *poi, uint32_t which)
{
    CORE_ASSERT(which < poi->carried_count);
    poi->carried_count--;
    poi->carried_fish[which] = poi->carried_fish[poi->carried_count];
}

/* Returns true if a falling fish meets the paper from above and the paper supports the fish. Writes
 * the new state of the fish to `lying`. A fish can meet the paper again after a slap threw the fish
 * up, or if the poi rises under the fish. `before_m` is the position of the fish in the previous
 * tick. The function converts the previous position with the poi's previous axes, and therefore
 * takes a rotation of the poi into account. */
static bool lands(const struct scoop *scoop, const struct carried_fish *carried, vec3 before_m,
                  struct carried_fish *lying)
{
    CORE_ASSERT(carried->state == CARRIED_FALLING);
    const struct poi *poi = scoop->poi;
    const struct fish *fish = &scoop->tank->fish[carried->fish];
    const struct basis was = vec_basis_from_angles(poi->before_angles);
    const vec3 from = vec_basis_to_body(&was, v3_sub(before_m, poi->before_m));
    const vec3 to = vec_basis_to_body(&scoop->axes, v3_sub(fish->position_m, poi->position_m));
    const vec3 speed =
        vec_basis_to_body(&scoop->axes, v3_sub(carried->fall_m_s, poi->velocity_m_s));
    if (from.y < 0.0f || to.y >= 0.0f) {
        return false;
    }
    const vec3 at = v3_lerp(from, to, from.y / (from.y - to.y));
    *lying = *carried;
    lying->state = CARRIED_LYING;
    lying->x_m = at.x;
    lying->z_m = at.z;
    lying->height_m = 0.0f;
    lying->slide_x_m_s = f_clamp(speed.x, -LAND_M_S, LAND_M_S);
    lying->slide_z_m_s = f_clamp(speed.z, -LAND_M_S, LAND_M_S);
    return carried_support_holds(&poi->sheet, lying, fish);
}

/* Advances the fall of a carried fish by one tick. Returns true if the fall ended in a bowl or
 * in the water. */
static bool advance_fall(const struct scoop *scoop, struct carried_fish *carried)
{
    CORE_ASSERT(carried->state != CARRIED_LYING);
    CORE_ASSERT(carried->fish < scoop->tank->fish_count);
    const vec3 before_m = scoop->tank->fish[carried->fish].position_m;
    /* A fish that falls fast or deep makes more noise. A fall from 5 cm ends with 1 m/s. */
    const float blow = f_clamp(0.35f + 0.5f * f_abs(carried->fall_m_s.y), 0.0f, 1.0f);
    struct carried_fish lying;
    uint32_t bowl;
    const enum fall_end end = catch_fall_tick(carried, scoop->stall, &bowl);
    if (end == FALL_INTO_BOWL || end == FALL_INTO_WATER) {
        struct catch_result *const result = &scoop->results[scoop->poi_index];
        result->fell_in_bowl = end == FALL_INTO_BOWL;
        result->fell_m = v3_flat(scoop->tank->fish[carried->fish].position_m);
        if (result->fell_in_bowl) {
            const struct bowl *const into = &scoop->stall->bowls[bowl];
            result->fell_m.y = into->position_m.y - bowl_level_m(into);
        }
        result->fell_m_s = carried->fall_m_s;
    }
    switch (end) {
    case FALL_INTO_BOWL:
        catch_count(carried, scoop->poi_index, bowl, scoop->results);
        output_sound(scoop->output, SOUND_CATCH, f_max(blow, 0.6f),
                     pan_at(scoop->stall, scoop->stall->bowls[bowl].position_m));
        return true;
    case FALL_INTO_WATER:
        scoop->results[scoop->poi_index].slipped += carried->clear_ticks >= CARRIED_CLEAR_TICKS;
        output_sound(scoop->output, SOUND_PLOP, blow, pan_at(scoop->stall, before_m));
        return true;
    default:
        if (carried->state == CARRIED_FALLING && lands(scoop, carried, before_m, &lying)) {
            *carried = lying;
            carried_fish_pose(carried, &scoop->ride, scoop->poi->position_m, &scoop->axes,
                              &scoop->tank->fish[carried->fish]);
        }
        return false;
    }
}

/* ---- Fish on the paper ----------------------------------------------------------------------- */

/* Advances a lying fish by one tick. Returns true if the fish has left the poi and is in the
 * water. A fish that starts to fall is still a carried fish, and the function returns false. */
static bool advance_lying_fish(struct scoop *scoop, struct carried_fish *carried)
{
    CORE_ASSERT(carried->state == CARRIED_LYING);
    struct fish *fish = &scoop->tank->fish[carried->fish];
    /* A catch is valid only after enough consecutive ticks in which the whole ring is above the
     * water with the fish on it. */
    if (!scoop->clear) {
        carried->clear_ticks = 0;
    } else if (carried->clear_ticks < CARRIED_CLEAR_TICKS) {
        carried->clear_ticks++;
    }
    const float dry = carried_load_dryness(scoop->poi, &scoop->axes, carried, fish);
    const float force_n =
        carried_fish_tick(carried, fish, &scoop->ride, dry, scoop->poi->seed, scoop->tick);
    if (force_n > 0.004f && time_for(&scoop->poi->slap_tick, scoop->tick, SLAP_EVERY_TICKS)) {
        output_sound(scoop->output, SOUND_SLAP, f_clamp(8.0f * force_n, 0.1f, 1.0f), scoop->pan);
    }
    const vec3 before = fish->position_m;
    carried_fish_pose(carried, &scoop->ride, scoop->poi->position_m, &scoop->axes, fish);
    fish->velocity_m_s = v3_scale(v3_sub(fish->position_m, before), 1.0f / CORE_TICK_S);
    const bool flies = scoop->ride.pull_m_s2.y * dry > LIFT_OFF_M_S2;
    const bool leaves = flies || !carried_support_holds(&scoop->poi->sheet, carried, fish);
    const float depth = -(scoop->poi->position_m.y + carried->x_m * scoop->axes.right.y +
                          carried->z_m * scoop->axes.back.y);
    if ((depth > CAPTURE_FLOAT_SHARE * fish->height_m) || (leaves && dry <= 0.0f)) {
        catch_set_free(scoop->tank, fish, fish->velocity_m_s); /* The fish floated off the paper
                                                                  and swims in the tank. */
        return true;
    }
    if (leaves) {
        const vec3 slide = v3(carried->slide_x_m_s, 0.0f, carried->slide_z_m_s);
        catch_fall_begin(carried,
                         v3_add(scoop->poi->velocity_m_s, vec_basis_to_world(&scoop->axes, slide)));
    }
    return false;
}

static void ride_all(struct scoop *scoop)
{
    uint32_t i = 0;
    carried_separation_tick(scoop->poi, scoop->tank->fish);
    while (i < scoop->poi->carried_count) {
        struct carried_fish *carried = &scoop->poi->carried_fish[i];
        CORE_ASSERT(carried->fish < scoop->tank->fish_count);
        const bool gone = carried->state == CARRIED_LYING ? advance_lying_fish(scoop, carried)
                                                          : advance_fall(scoop, carried);
        if (gone) {
            remove_rider(scoop->poi, i);
        } else {
            i++;
        }
    }
}

/* ---- Capture of fish, and jammed rings ------------------------------------------------------- */

/* Frees a ring that fish block while the hand pulls the ring up. The outermost fish slip off over
 * the edge of the ring first. Fish continue to slip off until the ring moves. The remaining inner
 * fish are lifted. */
static void free_jam(struct scoop *scoop)
{
    struct poi *poi = scoop->poi;
    const bool jams = capture_is_jammed(poi);
    poi->jam_ticks = (uint8_t)(jams ? poi->jam_ticks + (poi->jam_ticks < UINT8_MAX) : 0);
    for (uint32_t i = 0; i < scoop->tank->fish_count && jams; i++) {
        struct fish *fish = &scoop->tank->fish[i];
        if (fish_swims(fish) && capture_releases(poi, &scoop->axes, fish)) {
            capture_slip_off(poi, scoop->tank, fish);
        }
    }
}

static void update_all_fish(struct scoop *scoop)
{
    for (uint32_t i = 0; i < scoop->tank->fish_count; i++) {
        struct fish *fish = &scoop->tank->fish[i];
        if (fish->gait == GAIT_BOWL) {
            continue;
        }
        if (fish->gait != GAIT_HELD) {
            if (capture_touches(scoop->poi, &scoop->axes, fish)) {
                capture_fish(scoop->poi, scoop->poi_index, &scoop->axes, scoop->tank, i,
                             scoop->tick);
            } else if (capture_is_squeezed(scoop->poi, fish)) {
                capture_slip_off(scoop->poi, scoop->tank, fish);
            }
        } else if (fish->holder == scoop->poi_index && !catch_has_carried(scoop->poi, i)) {
            catch_set_free(scoop->tank, fish, v3(0.0f, 0.0f, 0.0f));
        }
    }
}

/* ---- Tick of a poi --------------------------------------------------------------------------- */

bool catch_has_carried(const struct poi *poi, uint32_t fish)
{
    CORE_ASSERT(poi->carried_count <= POI_CARRIED_MAX);
    for (uint32_t i = 0; i < poi->carried_count; i++) {
        if (poi->carried_fish[i].fish == fish) {
            return true;
        }
    }
    return false;
}

void catch_count(const struct carried_fish *carried, uint32_t poi, uint32_t bowl,
                 struct catch_result results[POI_MAX])
{
    CORE_ASSERT(poi < POI_MAX);
    CORE_ASSERT(bowl < POI_MAX);
    results[bowl].bowled++;
    if (carried->clear_ticks < CARRIED_CLEAR_TICKS) {
        results[poi].poured++;
    } else if (carried->walled) {
        results[poi].walled++;
    } else {
        results[bowl].landed++;
    }
}

void catch_tick(struct poi *poi, uint32_t poi_index, const struct stall *stall, uint32_t tick,
                struct output *output, struct catch_result results[POI_MAX])
{
    CORE_ASSERT(poi_index < POI_MAX);
    CORE_ASSERT(stall->bowl_count <= POI_MAX);
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const vec3 pull = v3_sub(v3(0.0f, -GRAVITY_M_S2, 0.0f), poi->acceleration_m_s2);
    /* The compliance of the paper depends on the tension that the weight of water and carried fish
     * causes. */
    const struct paper_grade *grade = sheet_grade(poi->sheet.grade);
    const float tension_n_m = sheet_tension_centre(grade, poi->pressure_pa, poi_radius_m(poi));
    struct scoop scoop = {
        .poi = poi,
        .poi_index = poi_index,
        .stall = stall,
        .tank = stall->tank,
        .output = output,
        .tick = tick,
        .axes = axes,
        .ride = { .pull_m_s2 = vec_basis_to_body(&axes, pull),
                  .uphill_x = axes.right.y,
                  .uphill_z = axes.back.y,
                  .radius_m = poi_radius_m(poi),
                  .belly_m = poi->sheet.sag_m,
                  .give_per_n = (1.0f / (F_TAU * f_max(tension_n_m, SLACK_N_M))) },
        .pan = pan_at(stall, poi->position_m),
        .clear = poi->position_m.y > poi_half_extent_m(poi, axes.up.y),
        .results = results,
    };
    /* Removes each fish from the list of carried fish if other code changed the state of the fish,
     * for example at the start of a new round. */
    for (uint32_t i = 0; i < poi->carried_count;) {
        const struct fish *fish = &stall->tank->fish[poi->carried_fish[i].fish];
        if (fish->gait == GAIT_HELD && fish->holder == poi_index) {
            i++;
        } else {
            remove_rider(poi, i);
        }
    }
    sound_ring(&scoop);
    sound_creak(&scoop);
    ride_all(&scoop);
    update_all_fish(&scoop);
    free_jam(&scoop);
    carried_load_gather(poi, &axes, scoop.ride.pull_m_s2.y, stall->tank->fish);
}
