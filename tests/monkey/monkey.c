/* monkey.c -- sends random keys, pointer events, window sizes and device plug events to the real
 * frame loop.
 *
 * Usage: monkey SEED SECONDS. SECONDS are seconds of the simulated clock at 60 frames per second.
 *
 * Keys and pointer events pass through SDL's event queue into the real drivers. The real renderer
 * draws each frame off screen. A second poi (drivers/sim/pointer_sim.h) is plugged in and
 * unplugged. When the kiosk ends, the program opens it again. Equal seeds print the same state
 * hash.
 *
 * Exits with 0 if each frame returned within FRAME_S, with 70 if a frame hung, and with 1 if the
 * display was lost. */
#include <SDL.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/tank/preset.h"
#include "drivers/null.h"
#include "drivers/pointer/buttons_keyboard.h"
#include "drivers/pointer/mouse_poi.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "drivers/sim/storage_sim.h"
#include "platform/kiosk/kiosk.h"
#include "platform/os/clock.h"
#include "platform/render/display_gl.h"
#include "tests/monkey/random_step.h"

#define FRAME_NS 16666667ull
#define FRAMES_A_SECOND 60u
/* Time limit for a frame in seconds. The limit is generous, because a frame with sanitizers on a
 * busy machine takes only about 0.1 s. */
#define FRAME_S 30u
#define WIDTH 320
#define HEIGHT 240

static struct {
    struct clock_sim clock;
    struct display_gl display;
    struct buttons_keyboard keyboard;
    struct mouse_poi mouse;
    struct pointer_sim poi;
    struct storage_sim storage;
    struct hal hal;
    struct kiosk kiosk;
    uint32_t seed, frame, end_count;
    /* Combined hash of the states at the end of each run of the kiosk. */
    uint64_t hash;
    /* Bit set of the pressed mouse buttons. Bit 0 is the left button and bit 1 is the right
     * button. */
    uint32_t down;
} rig;
static char hang_words[96];
static struct pointer_report report;

static void on_hang(int number)
{
    (void)number;
    const ssize_t written = write(STDERR_FILENO, hang_words, strlen(hang_words));
    _exit(written < 0 ? 71 : 70);
}

static void push_key(SDL_Keycode code)
{
    SDL_Event event = { .key = { .type = SDL_KEYDOWN, .keysym.sym = code } };
    SDL_PushEvent(&event);
    event.key.type = SDL_KEYUP;
    SDL_PushEvent(&event);
}

static void press_key(int key)
{
    static const SDL_Keycode codes[STEP_KEY_COUNT] = {
        [STEP_KEY_START] = SDLK_SPACE,   [STEP_KEY_LEFT] = SDLK_LEFT,
        [STEP_KEY_RIGHT] = SDLK_RIGHT,   [STEP_KEY_UP] = SDLK_UP,
        [STEP_KEY_DOWN] = SDLK_DOWN,     [STEP_KEY_ENTER] = SDLK_RETURN,
        [STEP_KEY_COIN] = SDLK_5,        [STEP_KEY_COIN_2] = SDLK_6,
        [STEP_KEY_LANGUAGE] = SDLK_l,    [STEP_KEY_FULL_SCREEN] = SDLK_F11,
        [STEP_KEY_TILT] = SDLK_F4,       [STEP_KEY_UNUSED] = SDLK_x,
        [STEP_KEY_TEST] = SDLK_F2,       [STEP_KEY_SERVICE] = SDLK_F3,
        [STEP_KEY_ESCAPE] = SDLK_ESCAPE,
    };
    push_key(codes[key]);
}

static void move_pointer(const struct random_step *next)
{
    SDL_Event event = { .motion = { .type = SDL_MOUSEMOTION,
                                    .windowID = SDL_GetWindowID(rig.display.window),
                                    .x = next->x_mille * WIDTH / 1000,
                                    .y = next->y_mille * HEIGHT / 1000,
                                    .xrel = 20,
                                    .yrel = 20 } };
    SDL_PushEvent(&event);
}

static void press_button(enum step_press press)
{
    const uint32_t bit = press == STEP_PRESS_LEFT ? 1u : 2u;
    rig.down ^= bit;
    SDL_Event event = { .button = {
                            .type = rig.down & bit ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP,
                            .button = bit == 1u ? SDL_BUTTON_LEFT : SDL_BUTTON_RIGHT,
                        } };
    SDL_PushEvent(&event);
}

static void turn_wheel(int steps)
{
    SDL_Event event = { .wheel = { .type = SDL_MOUSEWHEEL, .preciseY = (float)steps } };
    SDL_PushEvent(&event);
}

/* Lets the second poi send one report. In half of the cases, the poi is unplugged before the report
 * and is plugged in again after a random time of up to 3 s. */
static void plug_or_unplug(uint32_t chance)
{
    report = (struct pointer_report){ .time_ns = rig.clock.now_ns,
                                      .x_px = (float)(chance % WIDTH),
                                      .y_px = (float)(chance / 7u % HEIGHT),
                                      .width_px = WIDTH,
                                      .height_px = HEIGHT,
                                      .buttons = (uint8_t)(chance / 3u % 8u) };
    rig.poi.reports = &report;
    rig.poi.feed.count = 1;
    rig.poi.feed.next = 0;
    rig.poi.feed.unplug_at = chance & 1u ? 0 : REPORT_FEED_NEVER;
    rig.poi.feed.replug_ns = rig.clock.now_ns + (uint64_t)(chance / 11u % 3000u) * 1000000u;
}

static void act(void)
{
    const struct random_step next = random_step_at(rig.seed, rig.frame);
    if (next.key >= 0) {
        press_key(next.key);
    }
    if (next.moves) {
        move_pointer(&next);
    }
    if (next.press != STEP_PRESS_NONE) {
        press_button((enum step_press)next.press);
    }
    if (next.wheel != 0) {
        turn_wheel(next.wheel);
    }
    if (next.width > 0) {
        SDL_SetWindowSize(rig.display.window, next.width, next.height);
    }
    if (next.plugs) {
        plug_or_unplug(next.chance);
    }
}

static int open_kiosk(void)
{
    rig.storage = (struct storage_sim){ 0 };
    rig.hal.storage = storage_sim_device(&rig.storage);
    const struct kiosk_config config = {
        .core = { .seed = rig.seed, .fish_count = 40, .players = 2, .round_s = 10, .modes = 15 },
        .stopwatch = clock_device()
    };
    return kiosk_init(&rig.kiosk, &rig.hal, &config) == CORE_OK;
}

static void close_kiosk(void)
{
    rig.hash = rig.hash * 31u + core_hash(&rig.kiosk.core);
    kiosk_close_store(&rig.kiosk, &rig.hal);
}

static int open_board(void)
{
    const struct view *view = &tank_preset(TANK_PRESET_FESTIVAL)->view;
    rig.clock.now_ns = 1000000000u;
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    rig.display.config =
        (struct display_gl_config){ .width = WIDTH, .height = HEIGHT, .off_screen = true };
    rig.hal.display = display_gl_device(&rig.display);
    if (rig.hal.display.ops->open(&rig.display) != HAL_OK) {
        return 0;
    }
    rig.hal.buttons = buttons_keyboard_device(&rig.keyboard);
    mouse_poi_init(&rig.mouse, rig.hal.clock, view, WIDTH, HEIGHT, POINTER_FILTER_MOUSE);
    rig.hal.poi[0] = mouse_poi_devices(&rig.mouse).poi;
    rig.hal.fan[0] = mouse_poi_devices(&rig.mouse).fan;
    pointer_sim_init(&rig.poi, rig.hal.clock, view);
    rig.hal.poi[1] = pointer_sim_devices(&rig.poi).poi;
    return 1;
}

/* Runs one frame. Returns KIOSK_RUNS if the kiosk continues or was opened again, otherwise the
 * reason for its end. */
static enum kiosk_end run_frame(uint32_t *phases)
{
    snprintf(hang_words, sizeof hang_words, "monkey: seed %u: frame %u hangs\n", rig.seed,
             rig.frame);
    alarm(FRAME_S);
    act();
    rig.clock.now_ns += FRAME_NS;
    const enum kiosk_end end = kiosk_frame(&rig.kiosk, &rig.hal);
    *phases |= 1u << rig.kiosk.core.game.phase;
    if (end == KIOSK_QUIT || end == KIOSK_RESTART) {
        close_kiosk();
        rig.end_count++;
        return open_kiosk() ? KIOSK_RUNS : end;
    }
    return end;
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "usage: monkey SEED SECONDS\n");
        return 2;
    }
    uint32_t phases = 0, rounds = 0;
    rig.seed = (uint32_t)strtoul(argv[1], NULL, 10);
    const uint32_t frames = FRAMES_A_SECOND * (uint32_t)strtoul(argv[2], NULL, 10);
    signal(SIGALRM, on_hang);
    if (!open_board() || !open_kiosk()) {
        fprintf(stderr, "monkey: %s\n", rig.hal.display.ops->describe(&rig.display));
        return 1;
    }
    enum kiosk_end end = KIOSK_RUNS;
    for (; rig.frame < frames && end == KIOSK_RUNS; rig.frame++) {
        const uint32_t before = rig.kiosk.core.game.round_count;
        end = run_frame(&phases);
        rounds += rig.kiosk.core.game.round_count > before;
    }
    alarm(0);
    close_kiosk();
    printf("%u frames, %u rounds, phases %03x, ended and opened again %u times, hash %016llx\n",
           rig.frame, rounds, phases, rig.end_count, (unsigned long long)rig.hash);
    return end == KIOSK_RUNS ? 0 : 1;
}
