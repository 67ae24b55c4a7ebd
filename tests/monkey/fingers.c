/* fingers.c -- sends random keys, pointer events and window sizes to the kiosk's window on the X
 * screen of DISPLAY.
 *
 * Usage: fingers SEED SECONDS. The program sends STEPS_A_SECOND random steps
 * (tests/monkey/random_step.h) per second. The program finds the kiosk's window by its title.
 * While no such window is visible, the program sends nothing. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>

#include "core/base/panic.h"
#include "tests/monkey/random_step.h"

#define STEPS_A_SECOND 30u
#define TITLE "Kingyo"

static Display *display;
static uint32_t down, event_count;

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: %s\n", file, line, condition);
    exit(70);
}

/* Ignores X errors. The window may be destroyed between two requests. The default error handler
 * would then end this program. */
static int ignore_error(Display *from, XErrorEvent *error)
{
    (void)from;
    (void)error;
    return 0;
}

/* Returns the kiosk's visible window and writes its attributes. Returns None if no such window is
 * visible. */
static Window find_window(XWindowAttributes *attributes)
{
    Window root, parent, *children = NULL, found = None;
    unsigned count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
    for (unsigned i = 0; i < count && found == None; i++) {
        char *name = NULL;
        if (XFetchName(display, children[i], &name) && name && strstr(name, TITLE) &&
            XGetWindowAttributes(display, children[i], attributes) &&
            attributes->map_state == IsViewable) {
            found = children[i];
        }
        if (name) {
            XFree(name);
        }
    }
    if (children) {
        XFree(children);
    }
    return found;
}

static void press_key(int key)
{
    static const KeySym symbols[STEP_KEY_COUNT] = {
        [STEP_KEY_START] = XK_space,     [STEP_KEY_LEFT] = XK_Left,  [STEP_KEY_RIGHT] = XK_Right,
        [STEP_KEY_UP] = XK_Up,           [STEP_KEY_DOWN] = XK_Down,  [STEP_KEY_ENTER] = XK_Return,
        [STEP_KEY_COIN] = XK_5,          [STEP_KEY_COIN_2] = XK_6,   [STEP_KEY_LANGUAGE] = XK_l,
        [STEP_KEY_FULL_SCREEN] = XK_F11, [STEP_KEY_TILT] = XK_F4,    [STEP_KEY_UNUSED] = XK_x,
        [STEP_KEY_TEST] = XK_F2,         [STEP_KEY_SERVICE] = XK_F3, [STEP_KEY_ESCAPE] = XK_Escape,
    };
    const KeyCode code = XKeysymToKeycode(display, symbols[key]);
    XTestFakeKeyEvent(display, code, True, 0);
    XTestFakeKeyEvent(display, code, False, 0);
    event_count++;
}

static void click(unsigned button)
{
    XTestFakeButtonEvent(display, button, True, 0);
    XTestFakeButtonEvent(display, button, False, 0);
    event_count++;
}

static void press_button(enum step_press press)
{
    const unsigned button = press == STEP_PRESS_LEFT ? 1 : 3;
    down ^= 1u << button;
    XTestFakeButtonEvent(display, button, (down & 1u << button) != 0, 0);
    event_count++;
}

static void act(const struct random_step *next)
{
    XWindowAttributes at;
    const Window window = find_window(&at);
    if (window == None) {
        return;
    }
    if (next->key >= 0) {
        press_key(next->key);
    }
    if (next->moves) {
        XTestFakeMotionEvent(display, -1, at.x + next->x_mille * at.width / 1000,
                             at.y + next->y_mille * at.height / 1000, 0);
        event_count++;
    }
    if (next->press != STEP_PRESS_NONE) {
        press_button((enum step_press)next->press);
    }
    if (next->wheel != 0) {
        click(next->wheel > 0 ? 4 : 5);
    }
    if (next->width > 0) {
        XResizeWindow(display, window, (unsigned)next->width, (unsigned)next->height);
        event_count++;
    }
    XSync(display, False);
}

int main(int argc, char **argv)
{
    display = XOpenDisplay(NULL);
    if (argc != 3 || !display) {
        fprintf(stderr, "usage: fingers SEED SECONDS, with a DISPLAY\n");
        return 2;
    }
    XSetErrorHandler(ignore_error);
    const uint32_t seed = (uint32_t)strtoul(argv[1], NULL, 10);
    const uint32_t steps = STEPS_A_SECOND * (uint32_t)strtoul(argv[2], NULL, 10);
    const struct timespec pause = { .tv_nsec = 1000000000 / STEPS_A_SECOND };
    for (uint32_t step = 0; step < steps; step++) {
        const struct random_step next = random_step_at(seed, step);
        act(&next);
        nanosleep(&pause, NULL);
    }
    printf("%u events\n", event_count);
    XCloseDisplay(display);
    return 0;
}
