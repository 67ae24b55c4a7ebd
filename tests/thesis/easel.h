/* easel.h -- renders pictures of a tank with the kiosk's own renderer, without a screen. */
#ifndef KINGYO_TESTS_THESIS_EASEL_H
#define KINGYO_TESTS_THESIS_EASEL_H

#include <stdint.h>

#include "platform/ctl/tank/tank_lab.h"

#define EASEL_WIDTH 1280u
#define EASEL_HEIGHT 720u
#define EASEL_FINER_MAX 2u

enum easel_camera {
    CAMERA_TOP,     /* The whole tank from above. */
    CAMERA_CENTRE,  /* The middle of the tank from above. */
    CAMERA_SIDE,    /* View through the wall with only fish and water. */
    CAMERA_SLANT,   /* The whole tank from 60 degrees above the water. */
    CAMERA_SHADE,   /* The area around the middle of the tank from above. */
    CAMERA_NOSES,   /* View near the surface, which shows the fish that breathe there. */
    CAMERA_MEETING, /* View from above, close to `easel.look_at_m`. */
};

struct easel_shot {
    enum easel_camera camera;
    vec3 look_at_m; /* Target of CAMERA_MEETING. */
    float width_m;  /* Width of the picture of CAMERA_MEETING. */
};

/* Opens the renderer. Pictures are drawn `times` as large and averaged, because fins are thin.
 * `times` is at most EASEL_FINER_MAX. Returns 0, or -1 after a message on standard error. */
int easel_open(uint32_t times);

/* Returns the name of the renderer. */
const char *easel_describe(void);

/* Writes a PNG file of the current state of the lab. Returns 0, or -1 after a message on standard
 * error. */
int easel_shoot(const struct tank_lab *lab, const struct easel_shot *shot, const char *path);

/* Draws the stall's own view of the lab once and waits until it is complete. Used for time
 * measurements. */
void easel_draw(const struct tank_lab *lab);

/* Closes the renderer. */
void easel_close(void);

#endif
