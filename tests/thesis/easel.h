/* easel.h -- renders pictures of a tank with the kiosk's own renderer, without a screen. */
#ifndef KINGYO_TESTS_THESIS_EASEL_H
#define KINGYO_TESTS_THESIS_EASEL_H

#include <stdint.h>

#include "platform/ctl/tank/tank_lab.h"

#define EASEL_WIDTH 1280u
#define EASEL_HEIGHT 720u
#define EASEL_FINER_MAX 2u

enum easel_camera {
    CAMERA_TOP,    /* The whole tank from above. */
    CAMERA_CENTRE, /* The middle of the tank from above. */
    /* View through the side wall. In this view only fish and water are drawn. */
    CAMERA_SIDE,
    CAMERA_SLANT,   /* The whole tank from 60 degrees above the water. */
    CAMERA_SHADE,   /* The middle of the tank from above, with the shadow of a fan. */
    CAMERA_NOSES,   /* View near the surface, where fish breathe with their snouts up. */
    CAMERA_MEETING, /* Close view of `easel_shot.look_at_m` from above. */
};

struct easel_shot {
    enum easel_camera camera;
    vec3 look_at_m; /* Target of CAMERA_MEETING. */
    float width_m;  /* Width of the picture of CAMERA_MEETING. */
};

/* Opens the renderer. Each picture is drawn with `times` times its width and height, and then
 * averaged, because fins are thinner than a pixel. `times` is at most EASEL_FINER_MAX. Returns 0,
 * or -1 after a message on standard error. */
int easel_open(uint32_t times);

/* Returns the name of the OpenGL renderer. */
const char *easel_describe(void);

/* Writes a picture of the current state of the lab as a PNG file. Returns 0, or -1 after a message
 * on standard error. */
int easel_shoot(const struct tank_lab *lab, const struct easel_shot *shot, const char *path);

/* Draws one frame of the lab with the kiosk's own camera, and waits until the frame is complete.
 * The function is used to measure the time of a frame. */
void easel_draw(const struct tank_lab *lab);

/* Closes the renderer. */
void easel_close(void);

#endif
