/* judge.c -- what pushes could not part: who goes back or is carried, and when a poi gives way. */
#include "core/base/panic.h"
#include "core/tank/parting.h"

#define PILE 2u /* Overlaps a fish: nobody free comes to that in a tick. */
#define ROUNDS_SPARE 256u /* Rounds in which only pois give way: eight of eight at most, and the
                             last look. */

static int is_same(vec3 a, vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static int is_inside(const struct parting *all, uint32_t index, const struct body *body)
{
    return is_same(parting_kept_inside_m(all, index, body), body->centre_m);
}

static float pair_depth_m(const struct body *a, const struct body *b)
{
    const struct box box_a = body_box(a), box_b = body_box(b);
    return box_depth_m(&box_a, &box_b);
}

static float pair_allowed_m(const struct parting *all, uint32_t a, uint32_t b)
{
    const struct body was_a = parting_before(all, a), was_b = parting_before(all, b);
    return f_max(PART_FREE_M, pair_depth_m(&was_a, &was_b));
}

/* Fish turn in the first step; later one only loses a shove. */
static void note_turned_back(const struct parting *all, uint32_t index)
{
    if (all->part->station == 0) {
        all->crowd->flags[index] |= CROWD_BACK;
        all->part->turns_back = 1;
        all->crowd->way_m[index] += parting_sweep_m(all, index);
    }
}

static void put_back(const struct parting *all, uint32_t index, uint32_t round)
{
    CORE_ASSERT(all->part->fate[index] != PART_BACK);
    all->part->back_count++;
    all->crowd->body[index] = parting_before(all, index);
    all->part->fate[index] = PART_BACK;
    all->part->fresh_round[index] = (uint16_t)(round + 1u);
    note_turned_back(all, index);
}

/* Where the list of contacts is full, nobody knows what the others could run into: whose contact
 * found no place keeps the pose in which the step began. That was free of all who keep theirs, and
 * of the rest the list tells. Places are drawn anew in each tick, so that some always move; and a
 * pile that was staged so has nothing to lose, it is only parted. Returns how many are held. */
static uint32_t hold_unlisted(const struct parting *all)
{
    const struct crowd *crowd = all->crowd;
    const int is_full = crowd->touch_count > crowd_contact_max(crowd);
    uint32_t held = 0;
    for (uint32_t i = 0; i < crowd->count && is_full; i++) {
        if (crowd->flags[i] & CROWD_UNLISTED && crowd->overlap_count <= PILE * crowd->count) {
            put_back(all, i, 0);
            held++;
        }
    }
    return held;
}

/* Whether it was moved in this round or the last, so that its pairs must be judged again. */
static int is_fresh(const struct part *part, uint32_t index, uint32_t round)
{
    return round == 0 || part->fresh_round[index] >= round;
}

/* Lets a fish go along with an obstacle from where the step began: whoever goes along with the same
 * one cannot come nearer to it. Returns 0, and leaves it, where walls leave no room or the way is
 * farther than it may go in a step: the look knows only whom it could meet on that. */
static int carry(const struct parting *all, uint32_t index, uint32_t o, uint32_t round)
{
    struct part *part = all->part;
    struct body body = parting_before(all, index);
    const vec3 from_m = body.centre_m;
    body.centre_m = rim_carry_m(&all->place->obstacles[o], from_m);
    const float way_m = v3_length(v3_sub(body.centre_m, from_m));
    const uint8_t fate = part->fate[index];
    if (fate == PART_BACK || fate >= PART_CARRIED || way_m > part->step_max_m[index] ||
        !is_inside(all, index, &body)) {
        return 0;
    }
    all->crowd->body[index] = body;
    part->fate[index] = (uint8_t)(PART_CARRIED + o);
    part->fresh_round[index] = (uint16_t)(round + 1u);
    note_turned_back(all, index);
    return 1;
}

/* Whom an obstacle presses into another would only be pressed again: it is carried. */
static int carry_pressed(const struct parting *all, uint32_t index, uint32_t round)
{
    const uint8_t fate = all->part->fate[index];
    return fate >= PART_PRESSED && fate < PART_CARRIED &&
           carry(all, index, (uint32_t)fate - PART_PRESSED, round);
}

/* And who is in the way of one that is carried goes along, too. */
static int carry_too(const struct parting *all, uint32_t carried, uint32_t other, uint32_t round)
{
    const uint8_t fate = all->part->fate[carried];
    return fate >= PART_CARRIED && carry(all, other, (uint32_t)fate - PART_CARRIED, round);
}

/* Of two that are too deep in each other the one goes back whose going back is enough; when either
 * would do, the one that came farther. */
static void choose(const struct parting *all, uint32_t a, uint32_t b, float allowed_m,
                   uint32_t round)
{
    const struct part *part = all->part;
    const struct body *now = all->crowd->body;
    const int pressed = carry_pressed(all, a, round) + carry_pressed(all, b, round);
    if (pressed > 0 || carry_too(all, a, b, round) || carry_too(all, b, a, round)) {
        return;
    }
    const struct body was_a = parting_before(all, a), was_b = parting_before(all, b);
    const int can_a = part->fate[a] != PART_BACK, can_b = part->fate[b] != PART_BACK;
    const int frees_a = can_a && pair_depth_m(&was_a, &now[b]) <= allowed_m;
    const int frees_b = can_b && pair_depth_m(&now[a], &was_b) <= allowed_m;
    if (frees_a && frees_b) {
        const float way_a_m = v3_length(v3_sub(now[a].centre_m, was_a.centre_m));
        const float way_b_m = v3_length(v3_sub(now[b].centre_m, was_b.centre_m));
        put_back(all, way_a_m >= way_b_m ? a : b, round);
        return;
    }
    if (can_a && !frees_b) {
        put_back(all, a, round);
    }
    if (can_b && !frees_a) {
        put_back(all, b, round);
    }
}

static uint32_t judge_pairs(const struct parting *all, uint32_t round)
{
    const struct crowd *crowd = all->crowd;
    const struct part *part = all->part;
    uint32_t guilty = 0;
    for (uint32_t c = 0; c < crowd->contact_count; c++) {
        const uint32_t a = crowd->contact[c].a, b = crowd->contact[c].b;
        const int as_parted = part->fresh_round[a] == 0 && part->fresh_round[b] == 0;
        if ((!is_fresh(part, a, round) && !is_fresh(part, b, round)) ||
            (as_parted && parting_is_apart(all, &crowd->contact[c], 0.0f))) {
            continue;
        }
        const float depth_m = pair_depth_m(&crowd->body[a], &crowd->body[b]);
        if (depth_m > PART_FREE_M && (part->fate[a] != PART_BACK || part->fate[b] != PART_BACK)) {
            const float allowed_m = pair_allowed_m(all, a, b);
            if (depth_m > allowed_m) {
                choose(all, a, b, allowed_m, round);
                guilty++;
            }
        }
    }
    return guilty;
}

/* A fish that ran into an obstacle goes back. One that the obstacle ran into would gain nothing by
 * that: it is carried along. Where there is no room for that either, the obstacle gives way, unless
 * it has nothing left to give. Returns whether anything changed. */
static int settle_with(const struct parting *all, uint32_t index, uint32_t o, vec3 out,
                       float excess_m, uint32_t round)
{
    struct part *part = all->part;
    struct obstacle *obstacle = &all->place->obstacles[o];
    const struct body before = parting_before(all, index);
    const int can = part->fate[index] != PART_BACK;
    if (can && parting_is_clear(obstacle, &before, &before)) {
        put_back(all, index, round);
        return 1;
    }
    if (carry(all, index, o, round)) {
        return 1;
    }
    if (rim_give_way(obstacle, out, excess_m)) {
        part->gave_round[o] = (uint16_t)(round + 1u);
        return 1;
    }
    if (can) {
        put_back(all, index, round);
    }
    return can;
}

static uint32_t judge_obstacles(const struct parting *all, uint32_t round)
{
    const struct part *part = all->part;
    uint32_t changes = 0;
    for (uint32_t k = 0; k < part->beside_count; k++) {
        const uint32_t i = part->beside[k];
        for (uint32_t o = 0; o < all->place->obstacle_count; o++) {
            if (!is_fresh(part, i, round) && part->gave_round[o] < round) {
                continue;
            }
            vec3 out;
            const struct body before = parting_before(all, i);
            const float excess_m = rim_excess_m(&all->place->obstacles[o], &all->crowd->body[i],
                                                &before, PART_FREE_M, &out);
            if (excess_m > PARTING_ROUNDING_M) {
                changes += (uint32_t)settle_with(all, i, o, out, excess_m, round);
            }
        }
    }
    return changes;
}

/* Each round carries or puts back somebody or makes a poi give way; each fish can be carried once
 * and go back once, even after it was carried, and each poi can give way a few times. */
void parting_judge(const struct parting *all, int is_parted)
{
    const int is_known = hold_unlisted(all) == 0 && is_parted;
    uint32_t guilty = 1;
    for (uint32_t round = 0; guilty > 0; round++) {
        CORE_ASSERT(round <= 2u * all->crowd->count + ROUNDS_SPARE);
        guilty = round == 0 && is_known ? 0 : judge_pairs(all, round);
        guilty += judge_obstacles(all, round);
    }
}
