/* scoop.c -- a table of strokes, and a different target position for each scoop. */
#include "board/poi-gadget/scoop.h"

#define DEG F_DEG

/* The festival tank is 0.85 m by 0.55 m, and 0.12 m deep. The bowl of the first player floats at
 * the near right corner, 12 mm above the water. The target positions keep a distance from the bowl
 * and from the walls. */
#define SPOT_LEFT_M (-0.30f)
#define SPOT_RIGHT_M 0.16f
#define SPOT_FAR_M (-0.12f)
#define SPOT_NEAR_M 0.12f
/* Target position at the bowl. It is left of the bowl's middle by the distance that a fish slides
 * off a ring tilted by 58 degrees. */
#define BOWL_X_M 0.289f
#define BOWL_Y_M 0.062f
#define BOWL_Z_M 0.185f

/* Strokes with positions relative to the target position or to the bowl. */
static const struct stroke {
    uint8_t at_bowl;
    uint8_t buttons;
    float seconds;
    float x_m, y_m, z_m;
    float pitch_deg, roll_deg;
} strokes[SCOOP_STROKES] = {
    { 0, POI_BUTTON_START, 0.9f, 0.00f, 0.045f, 0.06f, -38.0f, 0.0f },
    /* Holds a still shade, which attracts fish. */
    { 0, 0, 1.2f, 0.00f, 0.045f, 0.06f, -38.0f, 0.0f },
    /* Enters the water along the paper's plane. */
    { 0, 0, 0.6f, 0.00f, -0.070f, -0.06f, -38.0f, 0.0f },
    { 0, 0, 0.5f, 0.00f, -0.070f, -0.10f, 0.0f, 0.0f }, /* Glides under the fish. */
    /* Lifts the poi level, so that the water drains. */
    { 0, 0, 0.9f, 0.00f, 0.060f, -0.09f, 2.0f, 0.0f },
    { 1, 0, 1.1f, 0.00f, 0.020f, 0.00f, 2.0f, 0.0f },
    { 1, POI_BUTTON_OK, 0.5f, 0.00f, 0.000f, 0.00f, 0.0f, 58.0f }, /* Tips the poi to the right. */
    { 1, 0, 0.6f, -0.03f, 0.030f, 0.00f, 0.0f, 0.0f },
};

/* Returns a target position. The additive steps of the plastic number fill the plane evenly without
 * repetition. */
static vec3 spot_m(uint32_t scoop)
{
    const float u = 0.5f + (float)scoop * 0.7548777f, v = 0.5f + (float)scoop * 0.5698403f;
    return v3(f_lerp(SPOT_LEFT_M, SPOT_RIGHT_M, u - f_floor(u)), 0.0f,
              f_lerp(SPOT_FAR_M, SPOT_NEAR_M, v - f_floor(v)));
}

static struct pose_line line_of(uint32_t number)
{
    const struct stroke *stroke = &strokes[number % SCOOP_STROKES];
    const vec3 base_m =
        stroke->at_bowl ? v3(BOWL_X_M, BOWL_Y_M, BOWL_Z_M) : spot_m(number / SCOOP_STROKES % 4096u);
    return (struct pose_line){
        .glide_s = stroke->seconds,
        .buttons = stroke->buttons,
        .target = { .position_m = v3_add(base_m, v3(stroke->x_m, stroke->y_m, stroke->z_m)),
                    .angles = { .pitch_rad = stroke->pitch_deg * DEG,
                                .roll_rad = stroke->roll_deg * DEG } },
    };
}

void scoop_step(struct scoop *scoop, float seconds, struct poi_report *out)
{
    if (pose_glide_is_there(&scoop->glide)) {
        const struct pose_line next = line_of(scoop->stroke++);
        pose_glide_send(&scoop->glide, &next);
    }
    pose_glide_step(&scoop->glide, seconds, out);
}
