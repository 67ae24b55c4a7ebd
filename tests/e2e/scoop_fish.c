/* scoop_fish.c -- makes one attempt to scoop a goldfish, as a player does: observes the fish,
 * follows one of them, scoops it and carries it to the bowl.
 *
 * Usage: scoop_fish WINDOW. WINDOW is a window number, as xdotool prints it.
 *
 * The program uses only the pictures of the window and the position of the bowl. The program moves
 * the X server's pointer as a mouse does, and prints its actions on standard output. Returns exit
 * status 0 if it carried something to the bowl, 1 if the fish escaped or no fish was suitable, and
 * 2 if the window cannot be read. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <X11/extensions/XTest.h>

#include "core/base/panic.h"
#include "core/tank/preset.h"
#include "drivers/pointer/pointer_poi.h"
#include "eye.h"

/* Time between two pictures in seconds. The kiosk shows at most 60 frames per second. */
#define FRAME_S 0.03
/* Number of pictures in which the fish are observed before one is chosen. */
#define CALM_FRAMES 12
#define CHOICE_MAX 40
/* Weight of the blue value in the choice of a fish, because a deeper fish is bluer. One unit of
 * blue (of 255) counts as much as a speed of this many pixels per second. The blue value of a fish
 * that is too deep for the ring is 10 to 20 higher than that of a fish within reach. */
#define BLUE_PX_S 4.0f
/* Highest blue value of a fish that lies on the paper. A fish on the paper has a blue value of
 * about 4, a fish that is seen through a tear 25, and a fish under the paper 80 to 150. */
#define PALE_BLUE 40
/* Distance in pixels between the fish and the point at which the ring enters the water. The ring
 * has a radius of 50 pixels and must not come down on the fish. */
#define ASIDE_PX 90.0f
#define HOVER_PX_S 480.0f /* Speed of the ring in the air, in pixels per second. */
/* Speed of the ring under water, in pixels per second. A higher speed tears the paper. */
#define UNDER_PX_S 150.0f
#define CARRY_PX_S 330.0f /* Speed of the ring while it carries a fish, in pixels per second. */

struct point {
    float x, y;
};

/* The fish that is followed: its last position, its velocity, and the time of the last picture. */
struct track {
    struct point at, speed;
    double seen_s;
    int size, blue;
};

static struct eye eye;
static struct point pointer;

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: %s\n", file, line, condition);
    exit(70);
}

static double now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static void wait_s(double seconds)
{
    const struct timespec time = { .tv_sec = (time_t)seconds,
                                   .tv_nsec = (long)((seconds - floor(seconds)) * 1e9) };
    nanosleep(&time, NULL);
}

static struct point to_screen(vec3 place_m)
{
    const struct view *view = &tank_preset(TANK_PRESET_FESTIVAL)->view;
    const struct basis axes = view_basis(view);
    const float aspect = (float)SCREEN_WIDTH / SCREEN_HEIGHT;
    const float tan_y = view_half_height_tan(view, aspect);
    const vec3 seen = vec_basis_to_body(&axes, v3_sub(place_m, view->eye_m));
    return (struct point){
        0.5f * (1.0f + seen.x / (-seen.z * tan_y * aspect)) * SCREEN_WIDTH,
        0.5f * (1.0f - seen.y / (-seen.z * tan_y)) * SCREEN_HEIGHT,
    };
}

static float distance(struct point a, struct point b)
{
    return hypotf(a.x - b.x, a.y - b.y);
}

/* Moves the pointer toward `goal` by at most `step_px`. Returns the remaining distance. */
static float step_to(struct point goal, float step_px)
{
    const float away = distance(goal, pointer);
    const float share = away > step_px ? step_px / away : 1.0f;
    pointer.x += (goal.x - pointer.x) * share;
    pointer.y += (goal.y - pointer.y) * share;
    XTestFakeMotionEvent(eye.display, -1, (int)lroundf(pointer.x), (int)lroundf(pointer.y), 0);
    XFlush(eye.display);
    return away * (1.0f - share);
}

static void glide(struct point goal, float px_s)
{
    double then_s = now_s();
    do {
        wait_s(0.012);
        const double time_s = now_s();
        if (step_to(goal, px_s * (float)(time_s - then_s)) < 0.5f) {
            return;
        }
        then_s = time_s;
    } while (1);
}

static void button(int is_down)
{
    XTestFakeButtonEvent(eye.display, 1, is_down, 0);
    XFlush(eye.display);
}

/* Returns the position at which the followed fish should be now, computed from its last position
 * and its velocity. */
static struct point expected(const struct track *track)
{
    const float since_s = (float)fmin(now_s() - track->seen_s, 0.2);
    return (struct point){ track->at.x + track->speed.x * since_s,
                           track->at.y + track->speed.y * since_s };
}

/* Takes a picture and finds the followed fish in it. Returns 0 if the fish is not found. */
static int follow(struct track *track)
{
    const struct point guess = expected(track);
    const struct rect around = { (int)guess.x - 40, (int)guess.y - 40, (int)guess.x + 40,
                                 (int)guess.y + 40 };
    if (!eye_capture(&eye, around)) {
        exit(2);
    }
    const double time_s = now_s();
    const float passed_s = (float)(time_s - track->seen_s);
    const struct blob blob = eye_follow(&eye, guess.x, guess.y);
    if (blob.count < track->size / 3) {
        return 0;
    }
    const struct point at = { blob.x, blob.y };
    /* Weight of the newest velocity in a moving average over about a quarter of a second. */
    const float trust = fminf(1.0f, passed_s / 0.25f);
    track->speed.x += trust * ((at.x - track->at.x) / passed_s - track->speed.x);
    track->speed.y += trust * ((at.y - track->at.y) / passed_s - track->speed.y);
    track->at = at;
    track->seen_s = time_s;
    return 1;
}

/* Observes the fish for a short time and chooses the calmest small one in the middle of the tank.
 * Returns 0 if no fish is suitable. */
static int choose(struct track *best)
{
    /* Middle of the tank, without the walls and the bowl. */
    static const struct rect middle = { 250, 170, 900, 470 };
    struct blob found[CHOICE_MAX], now[CHOICE_MAX];
    float wandered[CHOICE_MAX] = { 0 };
    if (!eye_capture(&eye, middle)) {
        exit(2);
    }
    const double begin_s = now_s();
    const int count = eye_find(&eye, found, CHOICE_MAX);
    for (int i = 0; i < count; i++) {
        now[i] = found[i];
    }
    for (int frame = 0; frame < CALM_FRAMES; frame++) {
        wait_s(FRAME_S);
        eye_capture(&eye, middle);
        for (int i = 0; i < count; i++) {
            now[i] = eye_follow(&eye, now[i].x, now[i].y);
            const struct point from = { found[i].x, found[i].y }, to = { now[i].x, now[i].y };
            wandered[i] = fmaxf(wandered[i], distance(from, to));
        }
    }
    const double time_s = now_s();
    const float passed_s = (float)(time_s - begin_s);
    float least = 1e9f;
    for (int i = 0; i < count; i++) {
        const struct point at = { now[i].x, now[i].y };
        const float effort = wandered[i] / passed_s + 0.05f * distance(at, pointer) +
                             BLUE_PX_S * (float)found[i].blue;
        if (effort < least && now[i].count > found[i].count / 2 &&
            now[i].count < 2 * found[i].count) {
            least = effort;
            *best = (struct track){
                .at = at, .seen_s = time_s, .size = now[i].count, .blue = found[i].blue
            };
            best->speed =
                (struct point){ (at.x - found[i].x) / passed_s, (at.y - found[i].y) / passed_s };
        }
    }
    return least < 1e8f;
}

/* Moves the pointer at the speed `px_s` to a point `aside_px` beside the fish, and follows the fish
 * meanwhile. Stops when the pointer arrives or `limit_s` has passed. Returns 0 if the fish
 * escaped. */
static int approach(struct track *track, float aside_px, float px_s, double limit_s)
{
    const double begin_s = now_s();
    double then_s = begin_s;
    int near_count = 0;
    while (now_s() - begin_s < limit_s && near_count < 3) {
        if (!follow(track)) {
            return 0;
        }
        const struct point seen = expected(track);
        const struct point goal = { seen.x + aside_px, seen.y };
        const double time_s = now_s();
        near_count = step_to(goal, px_s * (float)(time_s - then_s)) < 8.0f ? near_count + 1 : 0;
        then_s = time_s;
        wait_s(FRAME_S / 2);
    }
    return 1;
}

/* Returns 1 if a fish lies on the paper. A fish under the paper does not count. Seen through the
 * paper, the fish is pale, so its blue value is above PALE_BLUE. */
static int something_lies_on_the_paper(void)
{
    const struct rect around = { (int)pointer.x - 60, (int)pointer.y - 60, (int)pointer.x + 60,
                                 (int)pointer.y + 60 };
    if (!eye_capture(&eye, around)) {
        return 0;
    }
    const struct blob blob = eye_blob(&eye, pointer.x, pointer.y, 34);
    return blob.count > 40 && blob.blue < PALE_BLUE;
}

static int try_once(void)
{
    const vec3 bowl_m = tank_preset(TANK_PRESET_FESTIVAL)->bowl_m[0];
    struct track track;
    if (!choose(&track)) {
        printf("# no fish keeps still\n");
        return 1;
    }
    printf("# fish at %.0f,%.0f of %d px, blue %d, %.0f px/s", (double)track.at.x,
           (double)track.at.y, track.size, track.blue,
           (double)hypotf(track.speed.x, track.speed.y));
    const float aside_px = pointer.x > track.at.x ? ASIDE_PX : -ASIDE_PX;
    if (!approach(&track, aside_px, HOVER_PX_S, 1.5)) {
        printf(", away before the dip\n");
        return 1;
    }
    button(1);
    int is_there =
        approach(&track, aside_px, UNDER_PX_S, 0.3) && approach(&track, 0.0f, UNDER_PX_S, 1.5);
    button(0);
    printf(", %s %.0f px off", is_there ? "scooped" : "away,",
           (double)distance(pointer, expected(&track)));
    wait_s(0.6);
    if (!is_there || !something_lies_on_the_paper()) {
        printf(", no fish\n");
        return 1;
    }
    printf(", carried\n");
    glide(to_screen(v3(bowl_m.x, DIP_HOVER_M, bowl_m.z)), CARRY_PX_S);
    wait_s(1.2);
    return 0;
}

int main(int argc, char **argv)
{
    Window root, child;
    int x, y, window_x, window_y;
    unsigned mask;
    if (argc != 2 || !eye_open(&eye, argv[1])) {
        fprintf(stderr, "usage: scoop_fish WINDOW, with a DISPLAY\n");
        return 2;
    }
    XQueryPointer(eye.display, eye.window, &root, &child, &x, &y, &window_x, &window_y, &mask);
    pointer = (struct point){ (float)x, (float)y };
    const int status = try_once();
    XCloseDisplay(eye.display);
    return status;
}
