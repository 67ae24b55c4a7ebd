/* carried_fish.c -- moves a carried fish on the paper: slaps, sliding, and the roll onto its
 * side. */
#include "core/poi/catch/carried_fish.h"

#include "core/base/panic.h"
#include "core/base/rng.h"
#include "core/poi/pose.h"

/* Roll angle of a lying fish. The angle is less than 90 degrees, because fins are between the body
 * and the paper. */
#define LIE_RAD (80.0f * F_DEG)
#define LIE_PER_S 8.0f
/* Coefficient of static friction between the fish's skin and wet paper. A fish starts to slide at a
 * tilt of 20 degrees. */
#define STICK 0.36f
#define SLIP 0.30f /* Coefficient of kinetic friction between the fish's skin and wet paper. */
/* Ratio of two accelerations above which a fish rolls over the 3 mm high ring: the acceleration
 * along the paper divided by the acceleration onto the paper. The value corresponds to a tilt of 40
 * degrees. */
#define WALL_STICK 0.84f
#define WALL_JUMP_M_S 0.40f /* Outward speed above which a fish passes over the ring at any tilt. */
/* Distance between the fish's centre and the ring when the fish's belly touches the ring. */
#define WALL_MARGIN_M 0.004f
#define SLAP_S 0.020f
/* Smallest force of a slap divided by the mass of the fish, for a fish with full vigour. */
#define SLAP_M_S2_MIN 10.0f
#define SLAP_M_S2_MAX 30.0f
#define SLAP_N_MAX 0.15f
/* Time constant with which the slaps of a fish become weaker out of water. */
#define CALM_TAU_S 3.0f
/* Factor by which a fish calms down faster while its head is higher than its tail. */
#define CALM_HEAD_UP 2.5f
/* Factor by which a fish calms down faster where the paper sags deeply and surrounds the fish. */
#define CALM_CRADLE 1.5f
#define CRADLE_M 0.003f /* Depth of the sag from which CALM_CRADLE applies fully. */
/* Highest speed that a slap gives to the fish. Few slaps reach this speed. */
#define FLOP_M_S 0.35f
/* Longest duration of a hop after a slap. A slap of 20 m/s^2 for 20 ms would lift the whole body
 * for 80 ms, but only the tail slaps. */
#define HOP_S 0.060f
#define HOP_SLIP 0.05f /* Coefficient of kinetic friction during a hop. */
/* Fraction of a fish's weight that the paper must carry so that the fish can slap and the ring can
 * block the fish. Water carries the rest of the weight. */
#define AGROUND 0.3f
#define FOOT_M 0.010f /* Radius of the patch of paper that supports a body. */
/* Largest slope of the paper that the weight of a single fish causes. The formula for the sag
 * ignores that the ring supports a part of a load near the ring, so the slope needs a limit. */
#define LEAN_MAX 0.25f
/* Speed of a fish that swims off the paper with full vigour, in body lengths per second. */
#define SWIM_LENGTHS 4.0f
#define SWIM_PER_S 10.0f /* Rate at which a swimming fish approaches the speed SWIM_LENGTHS. */
/* Lowest slap strength of a fish that calms down, because a fish never stops slapping
 * completely. */
#define VIGOUR_MIN 0.08f

enum { DRAW_GAP = 0, DRAW_PAUSE, DRAW_FORCE, DRAW_FOOT, DRAW_TURN, DRAW_FLOP, DRAW_COUNT };

static float draw_slap(const struct carried_fish *carried, uint32_t seed, uint32_t tick,
                       uint32_t which)
{
    CORE_ASSERT(which < DRAW_COUNT);
    const uint32_t who = carried->fish * DRAW_COUNT + which;
    return rng_unit((struct rng_key){ seed, tick, who, RNG_SHEET_SLAP });
}

float carried_fish_half_extent_m(const struct fish *fish, vec3 direction)
{
    const float x = 0.5f * fish->width_m * direction.x;
    const float y = 0.5f * fish->height_m * direction.y;
    const float z = 0.5f * fish->length_m * direction.z;
    return f_sqrt(x * x + y * y + z * z);
}

void carried_fish_tail(const struct carried_fish *carried, float length_m, float *x_m, float *z_m)
{
    CORE_ASSERT(length_m > 0.0f);
    *x_m = carried->x_m + 0.42f * length_m * f_sin(carried->heading_rad);
    *z_m = carried->z_m + 0.42f * length_m * f_cos(carried->heading_rad);
}

/* ---- Slaps of the tail ---------------------------------------------------------------------- */

static float advance_slap(struct carried_fish *carried, const struct fish *fish,
                          const struct paper_surface *ride, float dry, uint32_t seed, uint32_t tick)
{
    const float nose_x = -f_sin(carried->heading_rad), nose_z = -f_cos(carried->heading_rad);
    const float head_up = nose_x * ride->uphill_x + nose_z * ride->uphill_z;
    const float cradle = f_clamp(ride->belly_m / CRADLE_M, 0.0f, 1.0f);
    const float tire = (head_up > 0.25f ? CALM_HEAD_UP : 1.0f) * f_lerp(1.0f, CALM_CRADLE, cradle);
    carried->vigour += (VIGOUR_MIN - carried->vigour) * dry * tire * CORE_TICK_S / CALM_TAU_S;
    carried->rest_s -= CORE_TICK_S;
    carried->slap_s = f_max(0.0f, carried->slap_s - CORE_TICK_S);
    if (carried->rest_s > 0.0f || dry < AGROUND) {
        return 0.0f;
    }
    /* Starts a slap and sets `rest_s`, the random time until the next slap: 0.1 to 0.2 s, plus 0.5
     * s if the fish pauses. A calmer fish pauses more often. */
    const float push =
        f_lerp(SLAP_M_S2_MIN, SLAP_M_S2_MAX, draw_slap(carried, seed, tick, DRAW_FORCE)) *
        carried->vigour;
    const bool pause = draw_slap(carried, seed, tick, DRAW_PAUSE) > 0.25f + 0.6f * carried->vigour;
    carried->slap_s = SLAP_S;
    carried->slap_n = f_min(push * fish_mass_kg(fish->length_m), SLAP_N_MAX);
    carried->slap_d_m = f_lerp(0.002f, 0.005f, draw_slap(carried, seed, tick, DRAW_FOOT));
    carried->rest_s =
        f_lerp(0.1f, 0.2f, draw_slap(carried, seed, tick, DRAW_GAP)) + (pause ? 0.5f : 0.0f);
    carried->hop_s = HOP_S * (0.4f + 0.6f * carried->vigour);
    /* The slap turns the fish and throws it in a random direction. */
    const float turn = 2.0f * draw_slap(carried, seed, tick, DRAW_TURN) - 1.0f;
    const float luck = draw_slap(carried, seed, tick, DRAW_FLOP);
    const float flop = FLOP_M_S * carried->vigour * luck * luck * luck;
    carried->heading_rad = f_wrap_angle(carried->heading_rad + 0.5f * carried->vigour * turn);
    carried->slide_x_m_s -= flop * f_sin(carried->heading_rad + turn);
    carried->slide_z_m_s -= flop * f_cos(carried->heading_rad + turn);
    return carried->slap_n;
}

/* ---- Sliding on the paper ------------------------------------------------------------------- */

/* Moves the fish by gravity, by the slope of the paper and by friction. Friction is computed
 * implicitly, so that friction stops a fish but never reverses the fish's motion. */
static void slide(struct carried_fish *carried, const struct fish *fish,
                  const struct paper_surface *ride, float dry)
{
    const float press = f_max(0.0f, -ride->pull_m_s2.y) * dry;
    /* Slope of the paper under the fish, divided by the distance of the fish from the centre.
     * Two sags add up. The load on the whole paper makes a sag in the form of a paraboloid. A
     * single body of force F at the distance r from the centre sinks by F / (2 * pi * T) *
     * ln((a^2 - r^2) / (a * FOOT_M)), where T is the tension and a is the radius of the paper. A
     * body therefore also sinks deepest at the centre. */
    const float wide = ride->radius_m * ride->radius_m;
    const float square = f_min(carried->x_m * carried->x_m + carried->z_m * carried->z_m, wide);
    const float press_n = press * fish_mass_kg(fish->length_m);
    const float own = 2.0f * press_n * ride->give_per_n / (wide - square + FOOT_M * FOOT_M);
    const float lean =
        press * (2.0f * ride->belly_m / wide + f_min(own, LEAN_MAX / ride->radius_m));
    const float pull_x = ride->pull_m_s2.x * dry - lean * carried->x_m;
    const float pull_z = ride->pull_m_s2.z * dry - lean * carried->z_m;
    const float pull = f_sqrt(pull_x * pull_x + pull_z * pull_z);
    const float speed = f_sqrt(carried->slide_x_m_s * carried->slide_x_m_s +
                               carried->slide_z_m_s * carried->slide_z_m_s);
    const bool hops = carried->hop_s > 0.0f;
    carried->hop_s = f_max(0.0f, carried->hop_s - CORE_TICK_S);
    if (!hops && dry > 0.0f && speed < 0.01f && pull <= STICK * press) {
        carried->slide_x_m_s = carried->slide_z_m_s = 0.0f;
        return;
    }
    const float brake = (hops ? HOP_SLIP : SLIP) * press / f_max(speed, 0.01f);
    const float keep = 1.0f / (1.0f + CORE_TICK_S * brake);
    carried->slide_x_m_s = (carried->slide_x_m_s + pull_x * CORE_TICK_S) * keep;
    carried->slide_z_m_s = (carried->slide_z_m_s + pull_z * CORE_TICK_S) * keep;
    carried->x_m += carried->slide_x_m_s * CORE_TICK_S;
    carried->z_m += carried->slide_z_m_s * CORE_TICK_S;
}

/* Stops a fish that slides against the ring, unless the poi is steep or the fish is fast. */
static void stop_at_ring(struct carried_fish *carried, const struct paper_surface *ride)
{
    const float r = f_sqrt(carried->x_m * carried->x_m + carried->z_m * carried->z_m);
    const float wall = ride->radius_m - WALL_MARGIN_M;
    if (r < wall || r > ride->radius_m) {
        return;
    }
    const float out_x = carried->x_m / r, out_z = carried->z_m / r;
    const float pull = out_x * ride->pull_m_s2.x + out_z * ride->pull_m_s2.z;
    const float rush = out_x * carried->slide_x_m_s + out_z * carried->slide_z_m_s;
    if (pull > WALL_STICK * -ride->pull_m_s2.y || rush > WALL_JUMP_M_S || rush <= 0.0f) {
        return;
    }
    carried->slide_x_m_s -= rush * out_x;
    carried->slide_z_m_s -= rush * out_z;
    carried->x_m = wall * out_x;
    carried->z_m = wall * out_z;
}

float carried_fish_tick(struct carried_fish *carried, const struct fish *fish,
                        const struct paper_surface *ride, float dry, uint32_t seed,
                        uint32_t key_tick)
{
    CORE_ASSERT(dry >= 0.0f && dry <= 1.0f);
    CORE_ASSERT(ride->radius_m > 0.0f);
    const float force_n = advance_slap(carried, fish, ride, dry, seed, key_tick);
    /* A floating fish accelerates toward its nose. */
    const float goal_m_s = SWIM_LENGTHS * fish->length_m * carried->vigour;
    const float keep = 1.0f - SWIM_PER_S * (1.0f - dry) * CORE_TICK_S;
    const float gain_m_s = goal_m_s * (1.0f - keep);
    carried->slide_x_m_s = carried->slide_x_m_s * keep - gain_m_s * f_sin(carried->heading_rad);
    carried->slide_z_m_s = carried->slide_z_m_s * keep - gain_m_s * f_cos(carried->heading_rad);
    slide(carried, fish, ride, dry);
    if (dry > AGROUND) {
        stop_at_ring(carried, ride);
    }
    /* The roll and the height of the fish approach their rest values. The centre of a fish on its
     * side is half the fish's width above the paper. The centre of an upright fish is half the
     * fish's height above the paper. */
    const float step = f_min(1.0f, LIE_PER_S * CORE_TICK_S);
    carried->lie += (dry - carried->lie) * step;
    const float tilt = LIE_RAD * carried->lie;
    const float rest = carried_fish_half_extent_m(fish, v3(f_sin(tilt), f_cos(tilt), 0.0f));
    carried->height_m += (rest - carried->height_m) * f_min(1.0f, 2.0f * step);
    return force_n;
}

void carried_fish_pose(const struct carried_fish *carried, const struct paper_surface *ride,
                       vec3 poi_m, const struct basis *poi_axes, struct fish *fish)
{
    CORE_ASSERT(ride->radius_m > 0.0f);
    const float sine = f_sin(carried->heading_rad), cosine = f_cos(carried->heading_rad);
    const float tilt = LIE_RAD * carried->lie;
    const float across = f_sin(tilt) * (float)carried->side;
    const vec3 nose = v3(-sine, 0.0f, -cosine);
    const vec3 back = v3(-cosine * across, f_cos(tilt), sine * across);
    const struct basis axes =
        pose_look(vec_basis_to_world(poi_axes, nose), vec_basis_to_world(poi_axes, back));
    const float square = carried->x_m * carried->x_m + carried->z_m * carried->z_m;
    const float over_m =
        carried->height_m -
        (ride->belly_m * f_max(0.0f, 1.0f - square / (ride->radius_m * ride->radius_m)));
    const vec3 place = vec_basis_to_world(poi_axes, v3(carried->x_m, over_m, carried->z_m));
    fish->position_m = v3_add(poi_m, place);
    fish->angles = pose_angles(&axes);
    const float beat = carried->slap_s > 0.0f ? 1.0f : 0.15f;
    fish->tail_amplitude += (beat * carried->vigour - fish->tail_amplitude) * 0.3f;
    fish->tail_phase_rad += F_TAU * 8.0f * CORE_TICK_S * (0.1f + carried->vigour);
    fish->tail_phase_rad -= fish->tail_phase_rad >= F_TAU ? F_TAU : 0.0f;
    const float bend =
        carried->slap_s > 0.0f ? (float)carried->side * 4.0f * carried->slap_n : 0.0f;
    fish->bend_rad += (f_clamp(bend * 6.0f, -0.8f, 0.8f) - fish->bend_rad) * 0.25f;
}
