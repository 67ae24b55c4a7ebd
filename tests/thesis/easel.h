/* easel.h -- takes pictures of a tank through the kiosk's own renderer, without a screen. */
#ifndef KINGYO_TESTS_THESIS_EASEL_H
#define KINGYO_TESTS_THESIS_EASEL_H

#include <stdint.h>

#include "platform/ctl/tank_lab.h"

#define EASEL_WIDTH 1280u
#define EASEL_HEIGHT 720u
#define EASEL_FINER_MAX 2u

enum easel_camera {
    CAMERA_TOP,     /* The whole tank from above. */
    CAMERA_CENTRE,  /* Its middle from above. */
    CAMERA_SIDE,    /* Through the wall: fish and water alone. */
    CAMERA_SLANT,   /* The whole tank from 60 degrees above the water. */
    CAMERA_SHADE,   /* What lies about the middle, from above. */
    CAMERA_NOSES,   /* Near the surface, to see who breathes there. */
    CAMERA_MEETING, /* From above, close to `easel.look_at_m`. */
};

struct easel_shot {
    enum easel_camera camera;
    vec3 look_at_m; /* CAMERA_MEETING: where, ... */
    float width_m;  /* ... and how much of it. */
};

/* Pictures are drawn `times` <= EASEL_FINER_MAX times as large and averaged: fins are thin. 0, or
 * -1 and why on standard error. */
int easel_open(uint32_t times);

/* What draws, in words. */
const char *easel_describe(void);

/* Writes a PNG of the lab as it is now. 0, or -1 and why. */
int easel_shoot(const struct tank_lab *lab, const struct easel_shot *shot, const char *path);

/* Draws the stall's own view of the lab once, finished; for whoever measures that. */
void easel_draw(const struct tank_lab *lab);

void easel_close(void);

#endif
