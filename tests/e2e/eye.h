/* eye.h -- finds goldfish by their warm colours in pictures of the kiosk's window. */
#ifndef KINGYO_TESTS_E2E_EYE_H
#define KINGYO_TESTS_E2E_EYE_H

#include <stdint.h>

#include <X11/Xlib.h>

#define SCREEN_WIDTH 1280
#define SCREEN_HEIGHT 720

struct rect {
    int left, top, right, bottom; /* Edges of a rectangle in pixels. `right` and `bottom` are the
                                     first column and row outside. */
};

struct eye {
    Display *display;
    Window window;
    struct rect seen; /* Rectangle that the last call of eye_capture() has read. */
    uint8_t warm[SCREEN_HEIGHT][SCREEN_WIDTH];
    uint8_t blue[SCREEN_HEIGHT][SCREEN_WIDTH];
};

/* A group of warm pixels: their centre (x, y), their number, and their lowest blue value. Water is
 * blue, so a deeper fish has a higher blue value. */
struct blob {
    float x, y;
    int count, blue;
};

/* Opens the window with the number `window`, as xdotool prints it, on the screen that the variable
 * DISPLAY names. Returns 1 on success. */
int eye_open(struct eye *eye, const char *window);

/* Reads the picture of the rectangle `area` of the window. Returns 0 if the window no longer
 * exists. */
int eye_capture(struct eye *eye, struct rect area);

/* Returns the warm pixels (the reddish pixels of fish) in a square around the given centre.
 * `reach_px` is half the side of the square in pixels. */
struct blob eye_blob(const struct eye *eye, float centre_x, float centre_y, int reach_px);

/* Finds the fish again that was near (x, y) in the previous picture. The search moves step by step
 * to the centre of the warm pixels. */
struct blob eye_follow(const struct eye *eye, float x, float y);

/* Finds the fish that are neither too large nor too close to other fish. Writes at most `count_max`
 * of them to `list` and returns their number. */
int eye_find(const struct eye *eye, struct blob *list, int count_max);

#endif
