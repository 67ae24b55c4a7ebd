/* scoop_planner.c -- plays on the kiosk in the guest through its USB poi until a fish is landed.
 *
 * Usage: scoop_planner RECORDING PLANS SECONDS
 *
 * The program recomputes the game from the kiosk's recording (twin.h). On a copy of this game, the
 * core's own bot simulates complete scoops. If a simulated scoop lands a fish, the program writes
 * its path to the file PLANS/plan: one pose for each of the 120 reports per second, in the format
 * of `kingyo-poi run --script`. Exit code 0 means that a fish was landed, 1 means a timeout, and 65
 * that another core wrote the recording. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "core/game/bot/bot.h"
#include "tests/vm/twin.h"

#define PLAN_TICKS_MAX (20u * CORE_TICK_HZ)
/* Number of ticks in which the poi moves back to its start position. */
#define HOME_TICKS (CORE_TICK_HZ)
/* Number of ticks for which the poi stays above the bowl after a fish has fallen into the bowl. */
#define AFTER_TICKS (CORE_TICK_HZ / 2u)
/* Time in seconds from the newest recorded tick to the first tick of the planned motion. During
 * this time the program computes the plan. */
#define THINK_S 4.0
/* Time in seconds at the end of THINK_S that is reserved for sending the plan to the poi. */
#define DELIVERY_S 0.10
/* Largest number of random scoops that are simulated for one state of the game. */
#define TRIES_MAX 40u
/* Number of additional simulations of each path, each with another start time. The delay until the
 * poi starts is not constant, so a good path lands a fish in all simulations. */
#define JITTERS 4u
/* Time in seconds over which the speed of the game's clock in the guest is measured. */
#define PACE_S 4.0
#define PACE_MIN 0.2
/* Largest age of the newest recorded tick, in seconds. The kiosk writes its recording once a
 * second, so the age is normally little more than one second. */
#define LATE_S 3.0

struct plan {
    struct poi_target way[PLAN_TICKS_MAX + HOME_TICKS];
    uint32_t count;
    uint32_t lands; /* Number of the JITTERS + 1 simulations in which the path landed a fish. */
};

/* Measured speed of the game in the guest. A slow emulated machine drops ticks, so its game runs
 * slower than real time. */
struct pace {
    double since_s;
    uint32_t since_ticks;
    double rate; /* Ticks per second of real time as a fraction of CORE_TICK_HZ, in (0, 1]. */
};

static struct twin twin;
static struct pace pace = { .rate = 1.0 };
/* Copy of the game in which scoops are simulated. The copy is static because its size is some
 * megabytes. */
static struct core copy;
static struct plan plans[2]; /* The best plan so far, and the plan that is being computed. */

static double now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static void wait_s(double seconds)
{
    if (seconds > 0.0) {
        const double whole = floor(seconds);
        const struct timespec time = { (time_t)whole, (long)((seconds - whole) * 1e9) };
        nanosleep(&time, NULL);
    }
}

static void measure_pace(double time_s)
{
    const double passed_s = time_s - pace.since_s;
    if (passed_s < PACE_S) {
        return;
    }
    if (pace.since_s > 0.0) {
        const double rate = (double)(twin.ticks - pace.since_ticks) / (passed_s * CORE_TICK_HZ);
        pace.rate = rate > 1.0 ? 1.0 : rate < PACE_MIN ? PACE_MIN : rate;
    }
    pace.since_s = time_s;
    pace.since_ticks = twin.ticks;
}

static uint32_t caught(const struct core *core)
{
    return core->game.player[0].caught;
}

/* Appends the path back to the start position, so that the next plan begins where this plan
 * began. */
static void append_return(struct plan *out, struct poi_target home)
{
    const struct poi_target last = out->way[out->count - 1];
    for (uint32_t i = 1; i <= HOME_TICKS; i++) {
        const float t = (float)i / (float)HOME_TICKS, share = t * t * (3.0f - 2.0f * t);
        struct poi_target at = home;
        at.position_m = v3_lerp(last.position_m, home.position_m, share);
        at.angles.yaw_rad = f_lerp(last.angles.yaw_rad, home.angles.yaw_rad, share);
        at.angles.pitch_rad = f_lerp(last.angles.pitch_rad, home.angles.pitch_rad, share);
        at.angles.roll_rad = f_lerp(last.angles.roll_rad, home.angles.roll_rad, share);
        out->way[out->count++] = at;
    }
}

/* Copies the game, and advances the copy by `lead` ticks while the poi rests. Returns the input of
 * the last tick. */
static struct input wait_on_copy(uint32_t lead, struct output *ignored)
{
    struct input input = twin.input;
    copy = twin.core;
    input.pressed = input.coin_count[0] = 0;
    input.poi[0].age_ticks = 0;
    for (uint32_t i = 0; i < lead; i++) {
        twin_tick(&copy, &input, ignored);
    }
    return input;
}

/* Returns 1 if a path that begins after `lead` ticks lands a fish in the simulation. The caller
 * tests several values of `lead`, because the delay until the poi starts is not constant. */
static int lands(uint32_t lead, const struct plan *way)
{
    static struct output ignored;
    struct input input = wait_on_copy(lead, &ignored);
    const uint32_t before = caught(&copy);
    for (uint32_t i = 0; i < way->count; i++) {
        input.poi[0].target = way->way[i];
        twin_tick(&copy, &input, &ignored);
    }
    return caught(&copy) > before;
}

/* Simulates a scoop of an expert bot that begins after `lead` ticks. If the scoop lands a fish,
 * writes its path to `out` and returns 1. */
static int plan_scoop(uint32_t lead, uint32_t seed, struct plan *out)
{
    static struct output ignored;
    struct bot bot;
    struct input input = wait_on_copy(lead, &ignored);
    const struct poi_target home = input.poi[0].target;
    const uint32_t before = caught(&copy);
    bot_init(&bot, &technique_expert, seed);
    bot.hand.pose = home;
    out->count = 0;
    for (uint32_t end = PLAN_TICKS_MAX; out->count < end && copy.game.phase == PHASE_ROUND;) {
        const struct vision vision = { &copy.game, &copy.world, 0 };
        input.poi[0].target = bot_tick(&bot, &vision);
        out->way[out->count++] = input.poi[0].target;
        twin_tick(&copy, &input, &ignored);
        if (end == PLAN_TICKS_MAX && caught(&copy) > before) {
            end = out->count + AFTER_TICKS < end ? out->count + AFTER_TICKS : end;
        }
    }
    if (caught(&copy) == before) {
        return 0;
    }
    append_return(out, home);
    return 1;
}

static void write_pose(FILE *file, const struct poi_target *target)
{
    const vec3 p = target->position_m;
    const double degrees = 57.29577951308232;
    fprintf(file, "%.2f %.2f %.2f %.2f %.2f %.2f\n", (double)p.x * 1e3, (double)p.y * 1e3,
            (double)p.z * 1e3, (double)target->angles.pitch_rad * degrees,
            (double)target->angles.yaw_rad * degrees, (double)target->angles.roll_rad * degrees);
}

/* Writes the plan to a temporary file and then renames the file, so that the program that reads the
 * plan never gets an incomplete one. */
static int send(const struct plan *way, const char *folder)
{
    char path[512], part[520];
    snprintf(path, sizeof path, "%s/plan", folder);
    snprintf(part, sizeof part, "%s.new", path);
    FILE *file = fopen(part, "w");
    if (!file) {
        perror(part);
        return 0;
    }
    for (double tick = 0.0; tick < (double)way->count; tick += pace.rate) {
        write_pose(file, &way->way[(uint32_t)tick]);
    }
    return fclose(file) == 0 && rename(part, path) == 0;
}

/* Returns 1 if a round is running without a pause and the poi is connected. */
static bool can_play(void)
{
    const struct game *game = &twin.core.game;
    return game->phase == PHASE_ROUND && !game->paused && twin.input.poi[0].link == POI_SOURCE_LIVE;
}

/* Computes one more plan. The plan replaces the best plan if it landed a fish in more simulations,
 * or in equally many simulations within a shorter time. */
static void plan_once(uint32_t seed)
{
    static const int32_t jitter_ticks[JITTERS] = { -12, 8, 18, 32 };
    const uint32_t lead = (uint32_t)(THINK_S * CORE_TICK_HZ * pace.rate);
    struct plan *best = &plans[0], *idea = &plans[1];
    if (!plan_scoop(lead, seed, idea) || (best->lands > JITTERS && best->count <= idea->count)) {
        return;
    }
    idea->lands = 1;
    for (uint32_t i = 0; i < JITTERS; i++) {
        idea->lands += (uint32_t)lands((uint32_t)((int32_t)lead + jitter_ticks[i]), idea);
    }
    if (idea->lands > best->lands || (idea->lands == best->lands && idea->count < best->count)) {
        *best = *idea;
    }
}

/* Computes plans until the start time and sends the best one. Returns 0 if no simulated scoop
 * landed a fish or the plan was not written. Otherwise returns the time in seconds after which the
 * recording shows the result: the duration of the plan plus LATE_S. */
static double try_once(double seen_s, const char *folder, uint32_t *luck)
{
    const double start_s = seen_s + THINK_S, enough_s = start_s - 3.0 * DELIVERY_S;
    uint32_t ideas = 0;
    plans[0].lands = 0;
    for (; ideas < TRIES_MAX && now_s() < enough_s; ideas++) {
        plan_once((*luck)++);
    }
    if (plans[0].lands == 0) {
        return 0.0;
    }
    wait_s(start_s - DELIVERY_S - now_s());
    const double long_s = (double)plans[0].count / (CORE_TICK_HZ * pace.rate);
    printf("scoop_planner: the best of %u ideas at tick %u takes %.1f s at %.0f %% of its pace; "
           "a fish in %u of %u trials\n",
           ideas, twin.ticks, long_s, 100.0 * pace.rate, plans[0].lands, JITTERS + 1u);
    fflush(stdout);
    return send(&plans[0], folder) ? long_s + LATE_S : 0.0;
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        fprintf(stderr, "usage: scoop_planner RECORDING PLANS SECONDS\n");
        return 2;
    }
    const double end_s = now_s() + strtod(argv[3], NULL);
    double busy_until_s = 0.0;
    uint32_t luck = 1, sent = 0;
    twin.path = argv[1];
    while (now_s() < end_s) {
        const int more = twin_follow(&twin);
        const double seen_s = now_s();
        if (more < 0) {
            printf("scoop_planner: tick %u is not the kiosk's\n", twin.differs_at);
            return 65;
        }
        if (more > 0) {
            measure_pace(seen_s);
        }
        if (twin.caught > 0) {
            printf("scoop_planner: %u landed after %u plans, %u ticks computed alike\n",
                   twin.caught, sent, twin.ticks);
            return 0;
        }
        if (more > 0 && can_play() && seen_s > busy_until_s) {
            const double long_s = try_once(seen_s, argv[2], &luck);
            busy_until_s = now_s() + long_s;
            sent += long_s > 0.0;
        }
        wait_s(0.05);
    }
    printf("scoop_planner: none landed after %u plans in %s s, %u ticks\n", sent, argv[3],
           twin.ticks);
    return 1;
}
