/* eye.h -- what a test sees of the kiosk's window: the warm colours of goldfish, a picture at a
 * time. */
#ifndef KINGYO_TESTS_E2E_EYE_H
#define KINGYO_TESTS_E2E_EYE_H

#include <stdint.h>

#include <X11/Xlib.h>

#define SCREEN_WIDTH 1280
#define SCREEN_HEIGHT 720

struct rect {
    int left, top, right, bottom; /* Pixels; the last two are just outside. */
};

struct eye {
    Display *display;
    Window window;
    struct rect seen; /* By the last look. */
    uint8_t warm[SCREEN_HEIGHT][SCREEN_WIDTH];
    uint8_t blue[SCREEN_HEIGHT][SCREEN_WIDTH];
};

/* Warm pixels around a place, their centre, and the least blue of them: all water is blue, and the
 * more of it lies over a fish the less of its own red comes through. */
struct blob {
    float x, y;
    int count, blue;
};

/* `window` is a number as xdotool prints it, on the screen that DISPLAY names. 1 on success. */
int eye_open(struct eye *eye, const char *window);

/* Takes a picture of a part of the window; 0 when the window is gone. */
int eye_look(struct eye *eye, struct rect wanted);

/* What is warm in the square of half a side `reach_px` about a place. */
struct blob eye_blob(const struct eye *eye, float centre_x, float centre_y, int reach_px);

/* The fish that was near a place a moment ago: climbs to the middle of the warmth around it. */
struct blob eye_follow(const struct eye *eye, float x, float y);

/* Fish that are not too large and not in a crowd, at most `count_max`; returns how many. */
int eye_find(const struct eye *eye, struct blob *list, int count_max);

#endif
