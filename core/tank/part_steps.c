/* part_steps.c -- the division of a tick into substeps, and the end of a tick. */
#include "core/base/panic.h"
#include "core/input.h"
#include "core/tank/part.h"

#define STATION_M 0.003f        /* Largest motion of an obstacle per substep; ring and fish together
                                   are four times as thick. */
#define STATIONS_MAX 6u         /* Reached at 2.1 m/s; a faster hand makes longer substeps. */

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
        part->course[o] = (struct course){ from_m, obstacle->step_m, obstacle->turned };
        longest_m = f_max(longest_m, v3_length(obstacle->step_m));
    }
    part->back_count = 0;
    part->turns_back = 0;
    part->station_count = 1u + (uint32_t)f_min(longest_m / STATION_M, (float)(STATIONS_MAX - 1u));
    return part->station_count;
}

/* The first substep contains the whole rotation. */
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

void part_take(const struct crowd *crowd, struct fish *fish)
{
    for (uint32_t i = 0; i < crowd->count; i++) {
        if (crowd->flags[i] & CROWD_SWIMS) {
            fish[i].position_m = crowd->body[i].centre_m;
        }
    }
}

/* Sets the step of the obstacle to that of the whole tick, for code that needs the obstacle's
 * previous position (loose.c). */
static void lose_blocked_step(struct obstacle *obstacle, const struct course *course)
{
    obstacle->step_m = v3_sub(obstacle->centre_m, course->from_m);
    obstacle->turned = course->turned && !(obstacle->gave & OBSTACLE_GAVE_TURN);
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
