/* part.c -- rounds of small pushes, then the judgement. */
#include "core/tank/part.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/input.h"
#include "core/tank/part_lanes.h"
#include "core/tank/rim.h"

#define SKIN_M 0.0001f          /* What parting leaves between two bodies. */
#define PART_ROUNDS_MAX 12      /* Most ticks need two; a shoved crowd uses them all. */
#define TOPPLE_ROUND 5          /* What four rounds could not part is jammed. */
#define PART_STEP_MAX_M 0.002f  /* A round. */
#define CLEAR_ROUNDS 4u
#define PILE 2u                 /* Overlaps a fish: nobody free comes to that in a tick. */
#define CLOSE_MAX 64u           /* Contacts measured at a time. */
#define STATION_M 0.003f        /* An obstacle's step; ring and fish together are four times so
                                   thick. */
#define STATIONS_MAX 6u         /* 2.1 m/s; a hand that is faster still takes longer steps. */

#define ROUNDING_M 1e-6f        /* By which the same pose may seem deeper. */
#define ROUNDS_SPARE 256u       /* Rounds in which only pois give way: eight of eight at most, and
                                   the last look. */

struct parting {
    struct part *part;
    struct crowd *crowd;
    const struct part_place *place;
};

/* Where it may go back to: where the step began. */
static vec3 before_m(const struct parting *all, uint32_t index)
{
    const struct part *part = all->part;
    return part->station == 0 ? part->began_m[index] : part->step_began_m[index];
}

static int is_same(vec3 a, vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Whether no pose of the body could reach out. */
static int is_far_inside(const struct tank_bounds *bounds, const struct body *body)
{
    const float reach_m = body->half_x_m + body->half_y_m + body->half_z_m;
    const vec3 p = body->centre_m, low = bounds->low_m, high = bounds->high_m;
    return p.x - low.x > reach_m && high.x - p.x > reach_m && p.y - low.y > reach_m &&
           high.y - p.y > reach_m && p.z - low.z > reach_m && high.z - p.z > reach_m;
}

/* Where a body of this fish would be within walls, floor and surface. */
static vec3 kept_inside_m(const struct parting *all, uint32_t index, const struct body *body)
{
    const struct tank_bounds *bounds = &all->place->bounds;
    if (is_far_inside(bounds, body)) {
        return body->centre_m;
    }
    const vec3 extent = body_extent_m(body);
    const vec3 low = v3_add(bounds->low_m, extent), high = v3_sub(bounds->high_m, extent);
    const uint8_t flags = all->crowd->flags[index];
    vec3 p = body->centre_m;
    p.x = f_clamp(p.x, low.x, high.x);
    p.z = f_clamp(p.z, low.z, high.z);
    p.y = f_max(p.y, low.y);
    if (!(flags & CROWD_AIRBORNE)) {
        const float out_m = flags & CROWD_GULPS ? 2.0f * body->half_y_m : 0.0f;
        p.y = f_min(p.y, high.y + out_m);
    }
    return p;
}

static void keep_inside(const struct parting *all, uint32_t index)
{
    struct body *body = &all->crowd->body[index];
    body->centre_m = kept_inside_m(all, index, body);
}

static int is_inside(const struct parting *all, uint32_t index, const struct body *body)
{
    return is_same(kept_inside_m(all, index, body), body->centre_m);
}

/* As crowd_follow() for one that was moved just now: is_apart() must know of it. */
static void follow(const struct parting *all, uint32_t index)
{
    CORE_ASSERT(all->crowd->flags[index] & CROWD_SWIMS);
    struct fish *fish = &all->place->fish[index];
    const vec3 centre_m = all->crowd->body[index].centre_m;
    all->crowd->way_m[index] += v3_length(v3_sub(centre_m, fish->position_m));
    fish->position_m = centre_m;
}

/* Whether what two bodies have come since the look leaves more than `apart_m` of their gap: then it
 * need not be measured. */
static int is_apart(const struct parting *all, const struct contact *contact, float apart_m)
{
    const float *way_m = all->crowd->way_m;
    return contact->gap_m - (way_m[contact->a] + way_m[contact->b]) > apart_m;
}

/* Moves it as far as its step allows, and returns what is left. Back to where it came from it may
 * go, however hard it ran into others. */
static vec3 shove(const struct parting *all, uint32_t index, vec3 move)
{
    struct body *body = &all->crowd->body[index];
    const vec3 wanted = v3_add(body->centre_m, move);
    const vec3 before = before_m(all, index);
    const vec3 step = v3_limit(v3_sub(wanted, before), all->part->step_max_m[index]);
    body->centre_m = v3_add(before, step);
    const vec3 left = v3_sub(wanted, body->centre_m);
    keep_inside(all, index);
    follow(all, index);
    return left;
}

/* A stack of fish that fills the water from floor to surface cannot be parted upward: it topples.
 */
static vec3 topple(const struct body *a, const struct body *b, vec3 axis)
{
    vec3 aside = v3_sub(b->centre_m, a->centre_m);
    aside.y = 0.0f;
    return v3_normalize_or(v3_mad(v3_scale(axis, 0.5f), v3_normalize_or(aside, a->right), 1.0f),
                           axis);
}

static float mass_of(const struct body *body)
{
    return body->half_z_m * body->half_z_m * body->half_z_m;
}

/* So far at least they are apart now: until they come nearer, nobody asks again. */
static void know_apart(const struct parting *all, struct contact *contact, float apart_m)
{
    const float *way_m = all->crowd->way_m;
    const float gap_m = apart_m - ROUNDING_M + (way_m[contact->a] + way_m[contact->b]);
    contact->gap_m = f_max(contact->gap_m, gap_m);
}

/* Whether the pair had to be parted. */
static int part_pair(const struct parting *all, struct contact *contact, int round)
{
    const struct body *a = &all->crowd->body[contact->a], *b = &all->crowd->body[contact->b];
    const struct box box_a = body_box(a), box_b = body_box(b);
    struct box_gap gap = box_gap(&box_a, 0.0f, &box_b, 0.0f);
    if (gap.body_m >= 0.0f) {
        know_apart(all, contact, gap.body_m);
        return 0;
    }
    if (round >= TOPPLE_ROUND && f_abs(gap.axis.y) > 0.7f) {
        gap.axis = topple(a, b, gap.axis);
    }
    const float depth_m = f_min(SKIN_M - gap.body_m, PART_STEP_MAX_M);
    const float share_a = mass_of(b) / (mass_of(a) + mass_of(b));
    const vec3 part = v3_scale(gap.axis, depth_m);
    const vec3 left_a = shove(all, contact->a, v3_scale(part, -share_a));
    const vec3 left_b = shove(all, contact->b, v3_sub(v3_scale(part, 1.0f - share_a), left_a));
    /* Who cannot give way leaves it to the other. */
    shove(all, contact->a, v3_scale(left_b, -1.0f));
    return 1;
}

/* The body in the pose that it may go back to. Bodies turn in the first step only. */
static struct body before_of(const struct parting *all, uint32_t index)
{
    const struct part *part = all->part;
    struct body body = all->crowd->body[index];
    body.centre_m = before_m(all, index);
    if (part->station == 0) {
        const struct basis axes = basis_from_angles(part->began_angles[index]);
        body.right = axes.right;
        body.up = axes.up;
        body.back = axes.back;
    }
    return body;
}

static int is_clear(const struct obstacle *obstacle, const struct body *body,
                    const struct body *before)
{
    vec3 unused;
    return rim_excess_m(obstacle, body, before, PART_FREE_M, &unused) <= ROUNDING_M;
}

/* What ring, hull and paper want of a body. */
static vec3 push_off(const struct parting *all, uint32_t index, const struct obstacle *obstacle)
{
    const struct body *body = &all->crowd->body[index];
    const vec3 hard = rim_hard_push(obstacle, body);
    const vec3 paper = rim_paper_push(obstacle, body, before_m(all, index));
    return v3_dot(hard, hard) > 0.0f ? hard : paper;
}

/* Pushes help nearly always. In the corner between paper and ring one undoes the other: there the
 * fish goes along with the poi. */
static void clear_obstacle(const struct parting *all, uint32_t index, uint32_t o)
{
    const struct obstacle *obstacle = &all->place->obstacles[o];
    struct body *body = &all->crowd->body[index];
    const struct body before = before_of(all, index);
    for (uint32_t k = 0; k < CLEAR_ROUNDS; k++) {
        const vec3 move = push_off(all, index, obstacle);
        if (v3_dot(move, move) == 0.0f) {
            return;
        }
        all->part->fate[index] = (uint8_t)(PART_PRESSED + o);
        shove(all, index, move);
        if (is_clear(obstacle, body, &before)) {
            return;
        }
    }
    struct body carried = *body;
    carried.centre_m = rim_carry_m(obstacle, before.centre_m);
    if (is_clear(obstacle, &carried, &before)) {
        body->centre_m = carried.centre_m;
        keep_inside(all, index);
    }
}

static void clear_obstacles(const struct parting *all, uint32_t index)
{
    for (uint32_t o = 0; o < all->place->obstacle_count; o++) {
        clear_obstacle(all, index, o);
    }
}

/* A body beside an obstacle must not be shoved into it. */
static void clear_if_beside(const struct parting *all, uint32_t index)
{
    if (all->crowd->flags[index] & CROWD_BESIDE) {
        clear_obstacles(all, index);
    }
}

/* Who could touch an obstacle in this step may be taken along by it so far. */
static float look_beside(const struct parting *all, uint32_t index)
{
    const struct box box = body_box(&all->crowd->body[index]);
    float rush_m = 0.0f;
    int beside = 0;
    for (uint32_t o = 0; o < all->place->obstacle_count; o++) {
        const struct obstacle *obstacle = &all->place->obstacles[o];
        if (obstacle_in_reach(obstacle, &box)) {
            const vec3 from_m = before_m(all, index);
            beside = 1;
            rush_m = f_max(rush_m, v3_length(v3_sub(rim_carry_m(obstacle, from_m), from_m)));
        }
    }
    if (beside) {
        all->crowd->flags[index] |= CROWD_BESIDE;
        all->part->beside[all->part->beside_count++] = (fish_index)index;
    }
    return rush_m;
}

/* How far any point of a body goes by turning alone, at most. */
static float sweep_m(const struct parting *all, uint32_t index)
{
    const struct angles now = all->place->fish[index].angles,
                        was = all->part->began_angles[index];
    const float yaw_rad = f_abs(now.yaw_rad - was.yaw_rad);
    const float turn_rad = f_min(yaw_rad, F_TAU - yaw_rad) +
                           f_abs(now.pitch_rad - was.pitch_rad) +
                           f_abs(now.roll_rad - was.roll_rad);
    const struct body *body = &all->crowd->body[index];
    return all->part->station == 0 ? turn_rad * (body->half_z_m + body->half_y_m) : 0.0f;
}

/* One that parting has moved must not end in an obstacle. */
static void clear_shoved(const struct parting *all, uint32_t index)
{
    clear_if_beside(all, index);
    follow(all, index);
}

/* Contacts whose gap may be used up, measured several at a time. */
struct close {
    uint32_t count;
    uint32_t contact[CLOSE_MAX];
    fish_index a[CLOSE_MAX + LANES_MAX], b[CLOSE_MAX + LANES_MAX];
    float gap_m[CLOSE_MAX + LANES_MAX];
};

/* Notes that contact `c` is to be measured. */
static void note_close(struct close *close, const struct contact *contact, uint32_t c)
{
    close->contact[close->count] = c;
    close->a[close->count] = contact->a;
    close->b[close->count++] = contact->b;
}

/* Measures those noted, and notes none. */
static void measure(const struct parting *all, struct close *close)
{
    const uint32_t count = close->count;
    for (uint32_t lane = 0; lane < LANES_MAX; lane++) {
        close->a[count + lane] = 0;
        close->b[count + lane] = 0;
    }
    pairs_gaps(all->crowd->body, close->a, close->b, count, all->place->lanes, close->gap_m);
    for (uint32_t k = 0; k < count; k++) {
        know_apart(all, &all->crowd->contact[close->contact[k]], close->gap_m[k]);
    }
    close->count = 0;
}

/* Learns anew of all contacts how far they are apart, where what is known does not keep them so:
 * most were only seen to come near. */
static void measure_close(const struct parting *all)
{
    const struct crowd *crowd = all->crowd;
    struct close close;
    close.count = 0;
    for (uint32_t c = 0; c < crowd->contact_count; c++) {
        if (!is_apart(all, &crowd->contact[c], 0.0f)) {
            note_close(&close, &crowd->contact[c], c);
        }
        if (close.count == CLOSE_MAX) {
            measure(all, &close);
        }
    }
    measure(all, &close);
}

/* In turn, so that a shove goes on through all of a row that come later. Returns how many had to be
 * parted. */
static uint32_t relax_once(const struct parting *all, int round)
{
    struct crowd *crowd = all->crowd;
    uint32_t parted = 0;
    for (uint32_t c = 0; c < crowd->contact_count; c++) {
        struct contact *contact = &crowd->contact[c];
        if (!is_apart(all, contact, 0.0f) && part_pair(all, contact, round)) {
            clear_shoved(all, contact->a);
            clear_shoved(all, contact->b);
            parted++;
        }
    }
    return parted;
}

/* Returns whether the last round found nobody to part: then the judgement knows all pairs. */
static int relax(const struct parting *all)
{
    uint32_t parted = 1;
    measure_close(all);
    for (int round = 0; round < PART_ROUNDS_MAX && parted > 0; round++) {
        parted = relax_once(all, round);
    }
    return parted == 0;
}

/* ---- The judgement -------------------------------------------------------------------------- */

static float pair_depth_m(const struct body *a, const struct body *b)
{
    const struct box box_a = body_box(a), box_b = body_box(b);
    return box_depth_m(&box_a, &box_b);
}

static float pair_allowed_m(const struct parting *all, uint32_t a, uint32_t b)
{
    const struct body was_a = before_of(all, a), was_b = before_of(all, b);
    return f_max(PART_FREE_M, pair_depth_m(&was_a, &was_b));
}

/* Fish turn in the first step; later one only loses a shove. */
static void note_turned_back(const struct parting *all, uint32_t index)
{
    if (all->part->station == 0) {
        all->crowd->flags[index] |= CROWD_BACK;
        all->part->turns_back = 1;
        all->crowd->way_m[index] += sweep_m(all, index);
    }
}

static void put_back(const struct parting *all, uint32_t index, uint32_t round)
{
    CORE_ASSERT(all->part->fate[index] != PART_BACK);
    all->part->back_count++;
    all->crowd->body[index] = before_of(all, index);
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
    const int is_full = crowd->touch_count > CROWD_CONTACT_MAX;
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
    struct body body = before_of(all, index);
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
    const struct body was_a = before_of(all, a), was_b = before_of(all, b);
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
            (as_parted && is_apart(all, &crowd->contact[c], 0.0f))) {
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
    const struct body before = before_of(all, index);
    const int can = part->fate[index] != PART_BACK;
    if (can && is_clear(obstacle, &before, &before)) {
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
            const struct body before = before_of(all, i);
            const float excess_m = rim_excess_m(&all->place->obstacles[o], &all->crowd->body[i],
                                                &before, PART_FREE_M, &out);
            if (excess_m > ROUNDING_M) {
                changes += (uint32_t)settle_with(all, i, o, out, excess_m, round);
            }
        }
    }
    return changes;
}

/* Each round carries or puts back somebody or makes a poi give way; each fish can be carried once
 * and go back once, even after it was carried, and each poi can give way a few times. */
static void judge(const struct parting *all, int is_parted)
{
    uint32_t guilty = 1;
    for (uint32_t round = 0; guilty > 0; round++) {
        CORE_ASSERT(round <= 2u * all->crowd->count + ROUNDS_SPARE);
        guilty = round == 0 && is_parted ? 0 : judge_pairs(all, round);
        guilty += judge_obstacles(all, round);
    }
}

/* ---- Walls, and what is in the water -------------------------------------------------------- */

static void clear_one(const struct parting *all, uint32_t index)
{
    struct crowd *crowd = all->crowd;
    struct part *part = all->part;
    crowd->flags[index] &= (uint8_t)~CROWD_BESIDE;
    const vec3 moved_m = v3_sub(crowd->body[index].centre_m, before_m(all, index));
    const float rush_m = look_beside(all, index);
    part->step_max_m[index] = v3_length(moved_m) + all->place->shove_max_m + rush_m;
    clear_if_beside(all, index);
    keep_inside(all, index);
    const vec3 led_m = v3_sub(crowd->body[index].centre_m, before_m(all, index));
    crowd->play_m[index] = part->step_max_m[index] + v3_length(led_m) + sweep_m(all, index);
}

/* Whether part_clear_block() may have that many fish: all of them there, and plain swimmers. */
static int is_plain(const struct crowd *crowd, uint32_t first, uint32_t width)
{
    uint32_t all_same = crowd->count - first >= width;
    for (uint32_t i = first; i < first + width && all_same; i++) {
        all_same = crowd->flags[i] == CROWD_SWIMS;
    }
    return (int)all_same;
}

/* ---- Public --------------------------------------------------------------------------------- */

void part_begin(struct part *part, const struct fish *fish, uint32_t fish_count)
{
    for (uint32_t i = 0; i < fish_count; i++) {
        part->began_m[i] = fish[i].position_m;
        part->began_angles[i] = fish[i].angles;
    }
}

uint32_t part_stations(struct part *part, const struct part_place *place)
{
    float longest_m = 0.0f;
    for (uint32_t o = 0; o < place->obstacle_count; o++) {
        struct obstacle *obstacle = &place->obstacles[o];
        const vec3 from_m = v3_sub(obstacle->centre_m, obstacle->step_m);
        part->course[o] = (struct course){ from_m, obstacle->step_m };
        longest_m = f_max(longest_m, v3_length(obstacle->step_m));
    }
    part->back_count = 0;
    part->turns_back = 0;
    part->station_count = 1u + (uint32_t)f_min(longest_m / STATION_M, (float)(STATIONS_MAX - 1u));
    return part->station_count;
}

/* All of a turn belongs to the first step. */
void part_advance(struct part *part, struct crowd *crowd, const struct part_place *place,
                  uint32_t station)
{
    part->station = station;
    for (uint32_t o = 0; o < place->obstacle_count; o++) {
        struct obstacle *obstacle = &place->obstacles[o];
        if (station == 0) {
            obstacle->centre_m = part->course[o].from_m;
        } else {
            obstacle->turned = 0;
        }
        obstacle->step_m = v3_scale(part->course[o].step_m, 1.0f / (float)part->station_count);
        obstacle->centre_m = v3_add(obstacle->centre_m, obstacle->step_m);
        obstacle->give_count = 0;
    }
    if (station > 0) {
        crowd_follow(crowd, place->fish);
        for (uint32_t i = 0; i < crowd->count; i++) {
            part->step_began_m[i] = place->fish[i].position_m;
        }
    }
}

void part_clear(struct part *part, struct crowd *crowd, const struct part_place *place)
{
    const struct parting all = { part, crowd, place };
    const uint32_t width = place->lanes == LANES_MAX ? LANES_MAX : 4u;
    part->beside_count = 0;
    memset(part->gave_round, 0, sizeof part->gave_round);
    memset(part->fate, PART_MOVES, crowd->count * sizeof part->fate[0]);
    memset(part->fresh_round, 0, crowd->count * sizeof part->fresh_round[0]);
    for (uint32_t i = 0; i < crowd->count;) {
        const uint32_t count = crowd->count - i < width ? crowd->count - i : width;
        uint32_t left = (1u << count) - 1u; /* Whom nobody has cleared, a bit each. */
        if (part->station == 0 && is_plain(crowd, i, width)) {
            left = LANES_PICK(place->lanes, part_clear_block)(part, crowd, place, i);
        }
        for (uint32_t k = 0; left != 0; k++, left >>= 1u) {
            if (left & 1u && crowd->flags[i + k] & CROWD_SWIMS) {
                clear_one(&all, i + k);
            }
        }
        i += count;
    }
}

void part_relax(struct part *part, struct crowd *crowd, const struct part_place *place)
{
    const struct parting all = { part, crowd, place };
    relax(&all);
}

void part_bodies(struct part *part, struct crowd *crowd, const struct part_place *place)
{
    const struct parting all = { part, crowd, place };
    const int is_parted = relax(&all);
    judge(&all, hold_unlisted(&all) == 0 && is_parted);
}

void part_take(const struct crowd *crowd, struct fish *fish)
{
    for (uint32_t i = 0; i < crowd->count; i++) {
        if (crowd->flags[i] & CROWD_SWIMS) {
            fish[i].position_m = crowd->body[i].centre_m;
        }
    }
}

static void lose_blocked_step(struct obstacle *obstacle, const struct course *course)
{
    obstacle->step_m = v3_sub(obstacle->centre_m, course->from_m);
    if (obstacle->gave & OBSTACLE_GAVE_PLACE) {
        const vec3 lost_m = v3_sub(course->step_m, obstacle->step_m);
        obstacle->velocity_m_s = v3_mad(obstacle->velocity_m_s, lost_m, -(float)CORE_TICK_HZ);
    }
}

void part_end(struct part *part, const struct crowd *crowd, const struct part_place *place)
{
    for (uint32_t i = 0; i < crowd->count && part->turns_back; i++) {
        if (crowd->flags[i] & CROWD_BACK) {
            CORE_ASSERT(crowd->flags[i] & CROWD_SWIMS);
            place->fish[i].angles = part->began_angles[i];
            place->fish[i].yaw_rate_rad_s = 0.0f;
        }
    }
    for (uint32_t o = 0; o < place->obstacle_count; o++) {
        lose_blocked_step(&place->obstacles[o], &part->course[o]);
    }
}
