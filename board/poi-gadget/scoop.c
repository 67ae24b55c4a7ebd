/* scoop.c -- moves the simulated hand through a table of strokes. Each scoop has a different target
 * position. */
#include "board/poi-gadget/scoop.h"

#define DEG F_DEG

/* Region of the target positions in metres. The festival tank is 0.85 m by 0.55 m, and 0.12 m deep.
 * The bowl of the first player floats at the near right corner, and its rim is 12 mm above the
 * water. The region keeps a distance from the bowl and from the walls. */
#define SPOT_LEFT_M (-0.30f)
#define SPOT_RIGHT_M 0.16f
#define SPOT_FAR_M (-0.12f)
#define SPOT_NEAR_M 0.12f
/* Position at the bowl in metres at which the poi is tipped. The position is left of the bowl's
 * centre, because a fish slides sideways off a ring that is tilted by 58 degrees. */
#define BOWL_X_M 0.289f
#define BOWL_Y_M 0.062f
#define BOWL_Z_M 0.185f

/* Table of the strokes of one scoop. Positions are relative to the target position, or to the bowl
 * if `at_bowl` is 1. */
static const struct stroke {
    uint8_t at_bowl;
    uint8_t buttons;
    float seconds;
    float x_m, y_m, z_m;
    float pitch_deg, roll_deg;
} strokes[SCOOP_STROKES] = {
    { 0, POI_BUTTON_START, 0.9f, 0.00f, 0.045f, 0.06f, -38.0f, 0.0f },
    /* Holds the poi still above the water, because its shade attracts fish. */
    { 0, 0, 1.2f, 0.00f, 0.045f, 0.06f, -38.0f, 0.0f },
    /* Moves the poi into the water in the direction of the paper's plane. */
    { 0, 0, 0.6f, 0.00f, -0.070f, -0.06f, -38.0f, 0.0f },
    { 0, 0, 0.5f, 0.00f, -0.070f, -0.10f, 0.0f, 0.0f }, /* Moves the poi forward under the fish. */
    /* Lifts the poi level, so that the water drains from the paper. */
    { 0, 0, 0.9f, 0.00f, 0.060f, -0.09f, 2.0f, 0.0f },
    { 1, 0, 1.1f, 0.00f, 0.020f, 0.00f, 2.0f, 0.0f },
    { 1, POI_BUTTON_OK, 0.5f, 0.00f, 0.000f, 0.00f, 0.0f, 58.0f }, /* Tips the poi to the right over
                                                                      the bowl, so that the fish
                                                                      slides off the paper. */
    { 1, 0, 0.6f, -0.03f, 0.030f, 0.00f, 0.0f, 0.0f },
};

/* Returns the target position of a scoop. Multiples of the plastic number's powers, modulo 1, fill
 * the region evenly without repetition. */
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
