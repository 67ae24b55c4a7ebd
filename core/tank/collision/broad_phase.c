/* broad_phase.c -- keeps the bodies of all fish up to date, and determines how long the results of
 * a broad-phase query stay valid. */
#include "core/tank/collision/broad_phase.h"

#include "core/base/panic.h"
#include "core/input.h"
#include "core/tank/behavior/swim.h"

/* Constant part of the reach of a fish. The reach is the largest distance that the fish may move
 * before a new broad-phase query is due. The reach is REACH_SPARE times the distance that the
 * present motion predicts, plus REACH_SPARE_M. The spare distance covers most sudden starts and
 * turns. */
#define REACH_SPARE_M 0.0035f
#define REACH_SPARE 1.2f
/* Largest number of fish that broad_phase_update_moved() handles. The function compares each fish
 * that moved farther than the last query allows with all other fish. If there are more such fish, a
 * new query of all fish is as fast. */
#define AGAIN_MAX 8u
/* Radius of the sphere around a fish's box, divided by the length of the fish. The radius is half
 * the diagonal of the box, which is 5.5 cm for a fish of 5 x 2 x 1 cm. */
#define RADIUS_PER_LENGTH 0.55f

float broad_phase_space(const struct fish *fish, uint32_t fish_count, vec3 tank_size_m,
                        const struct behavior_params *params)
{
    CORE_ASSERT(fish_count <= TANK_FISH_MAX);
    CORE_ASSERT(tank_size_m.x > 0.0f && tank_size_m.y > 0.0f && tank_size_m.z > 0.0f);
    float volume_m3 = 0.0f;
    for (uint32_t i = 0; i < fish_count; i++) {
        const float both_m = 2.0f * params->space_per_length * fish[i].length_m;
        volume_m3 +=
            (fish[i].length_m + both_m) * (fish[i].height_m + both_m) * (fish[i].width_m + both_m);
    }
    const float fill = volume_m3 / (tank_size_m.x * tank_size_m.y * tank_size_m.z);
    if (fill <= params->space_fill_max) {
        return params->space_per_length;
    }
    const float share = f_clamp(f_exp(f_log(params->space_fill_max / fill) / 3.0f), 0.2f, 1.0f);
    return share * params->space_per_length;
}

void broad_phase_mark(struct broad_phase *broad_phase, const struct fish *fish, uint32_t fish_count)
{
    CORE_ASSERT(fish_count <= TANK_FISH_MAX);
    broad_phase->count = fish_count;
    for (uint32_t i = 0; i < fish_count; i++) {
        broad_phase->flags[i] = 0;
        broad_phase->play_m[i] = 0.5f * BROAD_PHASE_CONTACT_M;
        if (!fish_swims(&fish[i])) {
            broad_phase->way_m[i] = SWIM_FAR_M; /* The large distance SWIM_FAR_M forces a new search
                                                   for nearby fish as soon as the fish swims
                                                   again. */
        } else {
            /* A fish is in the air if its body stands out of the water. The first part of the
             * condition, a cheap test of a sphere around the body, already rejects most bodies. */
            const struct body *body = &broad_phase->body[i];
            const float y = body->centre_m.y, emerges_m = fish_emerges_m(&fish[i]);
            const bool is_airborne =
                fish[i].falls ||
                (y + body->half_x_m + body->half_y_m + body->half_z_m > emerges_m &&
                 y + body_extent_m(body).y > emerges_m);
            broad_phase->flags[i] = (uint8_t)(BODY_SWIMMING | (is_airborne ? BODY_AIRBORNE : 0) |
                                              (fish[i].gait == GAIT_SURFACE ? BODY_GULPING : 0));
        }
    }
}

void broad_phase_gather(struct broad_phase *broad_phase, const struct fish *fish,
                        uint32_t fish_count, float space)
{
    CORE_ASSERT(fish_count <= TANK_FISH_MAX);
    for (uint32_t i = 0; i < fish_count; i++) {
        if (fish_swims(&fish[i])) {
            const struct box box = fish_box(&fish[i]);
            broad_phase->body[i] = body_of(&box, space * fish[i].length_m);
        }
    }
    broad_phase_mark(broad_phase, fish, fish_count);
}

float broad_phase_reach_m(const struct fish *fish)
{
    const float pace_m_s = fish->speed_m_s + f_abs(fish->climb_m_s) + v3_length(fish->push_m_s) +
                           f_abs(fish->yaw_rate_rad_s) * RADIUS_PER_LENGTH * fish->length_m;
    return REACH_SPARE * (float)BROAD_PHASE_UPDATE_TICKS * CORE_TICK_S * pace_m_s + REACH_SPARE_M;
}

void broad_phase_sync(struct broad_phase *broad_phase, struct fish *fish)
{
    CORE_ASSERT(broad_phase->count <= TANK_FISH_MAX);
    for (uint32_t i = 0; i < broad_phase->count; i++) {
        const vec3 moved = v3_sub(broad_phase->body[i].centre_m, fish[i].position_m);
        if (broad_phase->flags[i] & BODY_SWIMMING && v3_dot(moved, moved) > 0.0f) {
            broad_phase->way_m[i] += v3_length(moved);
            fish[i].position_m = broad_phase->body[i].centre_m;
        }
    }
}

static bool is_beyond(const struct broad_phase *broad_phase, uint32_t i)
{
    const bool swims = broad_phase->flags[i] & BODY_SWIMMING;
    return swims && broad_phase->way_m[i] > broad_phase->reach_m[i] - broad_phase->play_m[i];
}

bool broad_phase_is_stale(const struct broad_phase *broad_phase)
{
    CORE_ASSERT(broad_phase->count <= TANK_FISH_MAX);
    bool farther = broad_phase->touch_count > broad_phase_contact_max(broad_phase);
    for (uint32_t i = 0; i < broad_phase->count; i++) {
        farther |= is_beyond(broad_phase, i);
    }
    return farther;
}

/* Adds a pair of fish to the contact list if the two fish could touch before the next query.
 * contact_is_apart() later subtracts the distance that each fish moved since its last query.
 * `other` has already moved a part of this distance, so the stored gap is the present gap plus that
 * part. */
static void contacts_add_pair(struct broad_phase *broad_phase, uint32_t fish, uint32_t other)
{
    CORE_ASSERT(fish != other);
    const struct body *a = &broad_phase->body[fish], *b = &broad_phase->body[other];
    const float way_m = broad_phase->way_m[other];
    const float left_m = f_max(broad_phase->reach_m[other] - way_m, 0.0f);
    const vec3 d = v3_sub(b->centre_m, a->centre_m);
    const float near_m = broad_phase->reach_m[fish] + left_m + a->half_x_m + a->half_y_m +
                         a->half_z_m + b->half_x_m + b->half_y_m + b->half_z_m;
    if (v3_dot(d, d) > near_m * near_m) {
        return;
    }
    const struct box_gap gap = body_gap(a, broad_phase->reach_m[fish], b, left_m);
    if (gap.space_m <= 0.0f && gap.body_m < broad_phase->reach_m[fish] + left_m) {
        CORE_ASSERT(broad_phase->near_count < broad_phase_contact_max(broad_phase));
        broad_phase->contact[broad_phase->near_count++] =
            (struct contact){ (fish_index)fish, (fish_index)other, gap.body_m + way_m };
        broad_phase->touch_count = broad_phase->near_count;
    }
}

bool broad_phase_update_moved(struct broad_phase *broad_phase, const struct fish *fish)
{
    CORE_ASSERT(broad_phase->count <= TANK_FISH_MAX);
    fish_index beyond[AGAIN_MAX];
    uint32_t count = 0;
    for (uint32_t i = 0; i < broad_phase->count; i++) {
        if (is_beyond(broad_phase, i)) {
            if (count == AGAIN_MAX) {
                return false;
            }
            beyond[count++] = (fish_index)i;
        }
    }
    if (broad_phase->touch_count + count * broad_phase->count >
        broad_phase_contact_max(broad_phase)) {
        return false;
    }
    for (uint32_t k = 0; k < count; k++) {
        uint32_t kept = 0;
        for (uint32_t c = 0; c < broad_phase->near_count; c++) {
            const struct contact contact = broad_phase->contact[c];
            broad_phase->contact[kept] = contact;
            kept += contact.a != beyond[k] && contact.b != beyond[k];
        }
        broad_phase->near_count = kept;
        broad_phase->touch_count = kept;
        broad_phase->way_m[beyond[k]] = 0.0f;
        broad_phase->reach_m[beyond[k]] =
            broad_phase->play_m[beyond[k]] + broad_phase_reach_m(&fish[beyond[k]]);
        for (uint32_t other = 0; other < broad_phase->count; other++) {
            if (other != beyond[k] && (broad_phase->flags[other] & BODY_SWIMMING)) {
                contacts_add_pair(broad_phase, beyond[k], other);
            }
        }
    }
    broad_phase_select_contacts(broad_phase);
    return true;
}

void broad_phase_select_contacts(struct broad_phase *broad_phase)
{
    CORE_ASSERT(broad_phase->near_count <= broad_phase_contact_max(broad_phase));
    uint32_t count = 0;
    for (uint32_t c = 0; c < broad_phase->near_count; c++) {
        const struct contact contact = broad_phase->contact[c];
        const float ways_m = broad_phase->way_m[contact.a] + broad_phase->way_m[contact.b];
        const float plays_m = broad_phase->play_m[contact.a] + broad_phase->play_m[contact.b];
        const bool swim =
            broad_phase->flags[contact.a] & broad_phase->flags[contact.b] & BODY_SWIMMING;
        if (swim && contact.gap_m - ways_m < plays_m) {
            broad_phase->contact[c] = broad_phase->contact[count];
            broad_phase->contact[count++] = contact;
        }
    }
    broad_phase->contact_count = count;
}
