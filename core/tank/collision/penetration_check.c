/* penetration_check.c -- the penetration check: resolves the overlaps that the pushes of the
 * contact solver could not resolve. */
#include "core/base/panic.h"
#include "core/tank/collision/contact_solver_internal.h"

/* Number of overlaps per fish, on average, above which the fish count as a pile. A pile occurs only
 * if tank_stage_all() placed many fish at the same place.
 *
 * Normally a fish whose contact is missing in a full contact list returns to its previous pose. In
 * a pile such a fish is only pushed, because it would otherwise stay in the pile forever. */
#define PILE 2u
/* Upper limit of the number of rounds in which the penetration check changes no fish and only
 * undoes motion of obstacles. There are up to eight obstacles. The check undoes a part of an
 * obstacle's motion at most eight times, and then the rest, which takes 9 rounds per obstacle and
 * 72 rounds in total. The limit is higher to leave a reserve. */
#define ROUNDS_SPARE 256u

static float pair_depth_m(const struct body *a, const struct body *b)
{
    return f_max(0.0f, -body_gap(a, 0.0f, b, 0.0f).body_m);
}

/* Records that a fish reverts (returns) to its angles at the start of the tick. Only the first
 * substep rotates fish, so a revert in a later substep needs no record. */
static void note_turned_back(const struct solver_step *all, uint32_t index)
{
    if (all->solver->substep == 0) {
        all->broad_phase->flags[index] |= BODY_REVERTED;
        all->solver->reverts_angles = true;
        all->broad_phase->way_m[index] += contact_sweep_m(all, index);
    }
}

static void put_back(const struct solver_step *all, uint32_t index, uint32_t round)
{
    CORE_ASSERT(all->solver->result[index] != SOLVER_REVERTED);
    all->solver->reverted_count++;
    all->broad_phase->body[index] = contact_body_before(all, index);
    all->solver->result[index] = SOLVER_REVERTED;
    all->solver->fresh_round[index] = (uint16_t)(round + 1u);
    note_turned_back(all, index);
}

/* Returns true if the fish moved in this round or in the previous round, so that its pairs must be
 * checked again. */
static bool has_moved_recently(const struct contact_solver *solver, uint32_t index, uint32_t round)
{
    return round == 0 || solver->fresh_round[index] >= round;
}

/* Moves a fish along with an obstacle, beginning at the pose of the fish at the start of the
 * substep. Fish that move along with an obstacle cannot come nearer to that obstacle. Returns true
 * if the fish moved. Returns false and leaves the fish unchanged if the fish already moved along or
 * reverted in this substep, or if a wall leaves no room. Also returns false if the fish would move
 * farther than the last broad-phase query allows. */
static bool move_with_obstacle(const struct solver_step *all, uint32_t index, uint32_t o,
                               uint32_t round)
{
    CORE_ASSERT(o < all->place->obstacle_count);
    struct contact_solver *solver = all->solver;
    struct body body = contact_body_before(all, index);
    const vec3 from_m = body.centre_m;
    body.centre_m = obstacle_carry_m(&all->place->obstacles[o], from_m);
    const float way_m = v3_length(v3_sub(body.centre_m, from_m));
    const uint8_t result = solver->result[index];
    if (result == SOLVER_REVERTED || result >= SOLVER_CARRIED ||
        way_m > solver->step_max_m[index]) {
        return false;
    }
    const vec3 inside_m = contact_kept_inside_m(all, index, &body);
    if (inside_m.x != body.centre_m.x || inside_m.y != body.centre_m.y ||
        inside_m.z != body.centre_m.z) {
        return false;
    }
    all->broad_phase->body[index] = body;
    solver->result[index] = (uint8_t)(SOLVER_CARRIED + o);
    solver->fresh_round[index] = (uint16_t)(round + 1u);
    note_turned_back(all, index);
    return true;
}

/* Moves a fish along with the obstacle that presses the fish into another fish. Returning the fish
 * to its previous pose would not help, because the obstacle would press the fish again. Returns
 * true if the fish moved, and false if no obstacle presses the fish or if the fish cannot move
 * along. */
static bool move_with_pressing_obstacle(const struct solver_step *all, uint32_t index,
                                        uint32_t round)
{
    const uint8_t result = all->solver->result[index];
    return result >= SOLVER_PRESSED && result < SOLVER_CARRIED &&
           move_with_obstacle(all, index, (uint32_t)result - SOLVER_PRESSED, round);
}

/* Moves fish `other` along with the obstacle that carries fish `carried`. Returns true if
 * `other` moved. Returns false if no obstacle carries `carried`, or if `other` cannot move
 * along. */
static bool move_with_same_obstacle(const struct solver_step *all, uint32_t carried, uint32_t other,
                                    uint32_t round)
{
    const uint8_t result = all->solver->result[carried];
    return result >= SOLVER_CARRIED &&
           move_with_obstacle(all, other, (uint32_t)result - SOLVER_CARRIED, round);
}

/* Resolves the penetration of two fish. If an obstacle presses or carries one of the fish, moves
 * the fish along with the obstacle. Otherwise one fish returns to its previous pose, or both fish
 * if one is not enough. If the return of either fish would resolve the penetration, the fish that
 * moved farther returns. */
static void choose_reverted(const struct solver_step *all, uint32_t a, uint32_t b, float allowed_m,
                            uint32_t round)
{
    CORE_ASSERT(a != b);
    const struct contact_solver *solver = all->solver;
    const struct body *now = all->broad_phase->body;
    const bool is_a_pressed = move_with_pressing_obstacle(all, a, round);
    const bool is_b_pressed = move_with_pressing_obstacle(all, b, round);
    if (is_a_pressed || is_b_pressed || move_with_same_obstacle(all, a, b, round) ||
        move_with_same_obstacle(all, b, a, round)) {
        return;
    }
    const struct body was_a = contact_body_before(all, a), was_b = contact_body_before(all, b);
    const bool can_a = solver->result[a] != SOLVER_REVERTED;
    const bool can_b = solver->result[b] != SOLVER_REVERTED;
    const bool frees_a = can_a && pair_depth_m(&was_a, &now[b]) <= allowed_m;
    const bool frees_b = can_b && pair_depth_m(&now[a], &was_b) <= allowed_m;
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

static uint32_t check_contact_pairs(const struct solver_step *all, uint32_t round)
{
    CORE_ASSERT(all->broad_phase->contact_count <= all->broad_phase->near_count);
    const struct broad_phase *broad_phase = all->broad_phase;
    const struct contact_solver *solver = all->solver;
    uint32_t unresolved = 0;
    for (uint32_t c = 0; c < broad_phase->contact_count; c++) {
        const uint32_t a = broad_phase->contact[c].a, b = broad_phase->contact[c].b;
        const bool as_parted = solver->fresh_round[a] == 0 && solver->fresh_round[b] == 0;
        if ((!has_moved_recently(solver, a, round) && !has_moved_recently(solver, b, round)) ||
            (as_parted && contact_is_apart(all, &broad_phase->contact[c], 0.0f))) {
            continue;
        }
        const float depth_m = pair_depth_m(&broad_phase->body[a], &broad_phase->body[b]);
        if (depth_m > SOLVER_FREE_M &&
            (solver->result[a] != SOLVER_REVERTED || solver->result[b] != SOLVER_REVERTED)) {
            const struct body was_a = contact_body_before(all, a);
            const struct body was_b = contact_body_before(all, b);
            const float allowed_m = f_max(SOLVER_FREE_M, pair_depth_m(&was_a, &was_b));
            if (depth_m > allowed_m) {
                choose_reverted(all, a, b, allowed_m, round);
                unresolved++;
            }
        }
    }
    return unresolved;
}

/* Resolves the penetration of a fish and an obstacle. A fish that ran into the obstacle returns to
 * its previous pose. If the obstacle ran into the fish, the fish moves along with the obstacle. If
 * the fish has no room, the function undoes a part of the obstacle's motion. If the obstacle has no
 * motion left, the fish returns to its previous pose. Returns true if a position changed. */
static bool resolve_obstacle_penetration(const struct solver_step *all, uint32_t index, uint32_t o,
                                         vec3 out, float excess_m, uint32_t round)
{
    CORE_ASSERT(o < all->place->obstacle_count);
    CORE_ASSERT(excess_m > 0.0f);
    struct contact_solver *solver = all->solver;
    struct obstacle *obstacle = &all->place->obstacles[o];
    const struct body before = contact_body_before(all, index);
    const bool can = solver->result[index] != SOLVER_REVERTED;
    if (can && contact_is_clear(obstacle, &before, &before)) {
        put_back(all, index, round);
        return true;
    }
    if (move_with_obstacle(all, index, o, round)) {
        return true;
    }
    if (obstacle_apply_reaction(obstacle, out, excess_m)) {
        solver->reaction_round[o] = (uint16_t)(round + 1u);
        return true;
    }
    if (can) {
        put_back(all, index, round);
    }
    return can;
}

static uint32_t check_obstacles(const struct solver_step *all, uint32_t round)
{
    CORE_ASSERT(all->solver->beside_count <= all->broad_phase->count);
    const struct contact_solver *solver = all->solver;
    uint32_t changes = 0;
    for (uint32_t k = 0; k < solver->beside_count; k++) {
        const uint32_t i = solver->beside[k];
        for (uint32_t o = 0; o < all->place->obstacle_count; o++) {
            if (!has_moved_recently(solver, i, round) && solver->reaction_round[o] < round) {
                continue;
            }
            vec3 out;
            const struct body before = contact_body_before(all, i);
            const float excess_m =
                obstacle_excess_m(&all->place->obstacles[o], &all->broad_phase->body[i], &before,
                                  SOLVER_FREE_M, &out);
            if (excess_m > SOLVER_ROUNDING_M) {
                changes += resolve_obstacle_penetration(all, i, o, out, excess_m, round);
            }
        }
    }
    return changes;
}

/* Repeats rounds until no fish and no obstacle changes. In each round, fish move along with an
 * obstacle or return to their previous pose (revert), and motion of obstacles is undone. The loop
 * ends, because each fish moves along at most once and reverts at most once, and the motion of each
 * obstacle is undone a limited number of times. */
void penetration_check(const struct solver_step *all, bool is_parted)
{
    /* Reverts each fish with a contact that is missing, because the contact list was full, to its
     * pose at the start of the substep. These poses do not overlap, and the list contains all
     * contacts of the other fish. The contacts in a full list are random in each tick, so every
     * fish moves in some ticks. Fish in a pile are not reverted, only separated. */
    const struct broad_phase *broad_phase = all->broad_phase;
    const bool is_full = broad_phase->touch_count > broad_phase_contact_max(broad_phase);
    uint32_t held = 0;
    for (uint32_t i = 0; i < broad_phase->count && is_full; i++) {
        if (broad_phase->flags[i] & BODY_UNLISTED &&
            broad_phase->overlap_count <= PILE * broad_phase->count) {
            put_back(all, i, 0);
            held++;
        }
    }
    const bool is_known = held == 0 && is_parted;
    uint32_t unresolved = 1;
    for (uint32_t round = 0; unresolved > 0; round++) {
        CORE_ASSERT(round <= 2u * all->broad_phase->count + ROUNDS_SPARE);
        unresolved = round == 0 && is_known ? 0 : check_contact_pairs(all, round);
        unresolved += check_obstacles(all, round);
    }
}
