/* hand_mesh.c -- builds the mesh of a hand with its sleeve, and the picture of the skin; see
 * hand_mesh.h. The fingers are bent tubes. The palm is the smooth union of tapered bones. The light
 * that reaches each place of the skin comes from the distance to the surface of these shapes. */
#include "platform/render/pass/hand_mesh.h"

#include <string.h>

#include "core/base/panic.h"

/* A tapered bone between two points, in inner radii of the ring in the axes of the handle. */
struct bone {
    vec3 from, to;
    float from_radius, to_radius;
};

/* Number of joints of a finger, from the knuckle to the tip. The knuckle is inside the palm. */
#define JOINT_COUNT 4u
#define FINGER_COUNT 5u /* The thumb is finger 0, and the index finger is finger 1. */

struct finger {
    vec3 joints[JOINT_COUNT];
    float radii[JOINT_COUNT];
};

/* The thumb presses the handle from the left, and the index finger lies on the handle. The other
 * fingers bend around the right side of the handle. Their tips are below the handle. */
static const struct finger fingers[FINGER_COUNT] = {
    { { { 0.07f, 0.12f, 4.76f },
        { -0.38f, 0.20f, 4.00f },
        { -0.42f, 0.16f, 3.36f },
        { -0.23f, 0.02f, 2.88f } },
      { 0.22f, 0.250f, 0.220f, 0.170f } },
    { { { 0.07f, 0.22f, 4.55f },
        { 0.14f, 0.46f, 3.30f },
        { 0.13f, 0.37f, 2.92f },
        { 0.07f, 0.25f, 2.66f } },
      { 0.22f, 0.222f, 0.195f, 0.160f } },
    { { { 0.24f, 0.25f, 4.50f },
        { 0.46f, 0.31f, 3.04f },
        { 0.40f, -0.18f, 2.86f },
        { 0.04f, -0.34f, 2.96f } },
      { 0.23f, 0.230f, 0.205f, 0.165f } },
    { { { 0.40f, 0.20f, 4.55f },
        { 0.71f, 0.14f, 3.27f },
        { 0.55f, -0.31f, 3.16f },
        { 0.14f, -0.40f, 3.32f } },
      { 0.22f, 0.225f, 0.200f, 0.160f } },
    { { { 0.52f, 0.12f, 4.62f },
        { 0.82f, -0.03f, 3.62f },
        { 0.62f, -0.36f, 3.52f },
        { 0.26f, -0.40f, 3.68f } },
      { 0.18f, 0.195f, 0.175f, 0.140f } },
};

/* The palm: a bone from the wrist to each knuckle, and the balls of the thumb and of the little
 * finger. Then the forearm, which is wider than thick. */
static const struct bone palm[] = {
    { { 0.12f, 0.18f, 5.00f }, { 0.05f, 0.34f, 4.04f }, 0.29f, 0.20f },
    { { 0.20f, 0.18f, 5.00f }, { 0.29f, 0.36f, 3.98f }, 0.29f, 0.20f },
    { { 0.27f, 0.16f, 5.00f }, { 0.52f, 0.29f, 4.06f }, 0.29f, 0.19f },
    { { 0.33f, 0.13f, 5.00f }, { 0.70f, 0.17f, 4.18f }, 0.28f, 0.19f },
    { { 0.06f, 0.14f, 4.86f }, { -0.28f, 0.17f, 4.14f }, 0.30f, 0.27f },
    { { 0.36f, 0.06f, 4.86f }, { 0.62f, 0.02f, 4.14f }, 0.28f, 0.26f },
    { { 0.13f, 0.16f, 5.00f }, { 0.10f, 0.14f, 7.40f }, 0.29f, 0.44f },
    { { 0.32f, 0.12f, 5.00f }, { 0.36f, 0.10f, 7.40f }, 0.27f, 0.42f },
};
#define PALM_BONES (sizeof palm / sizeof *palm)

#define BLEND 0.12f /* Width of the smooth transition between two bones of the palm. */
#define SOFT 0.24f  /* Width of the transition of the light between the palm and a finger. */
#define THIN 1e-3f  /* Width of nearly no transition. */
#define STEPS_MAX 12u

/* Columns and rows of the grids. The first and the last column of a tube are the same line. */
#define STRAIGHT_COLUMNS 6u
#define BENT_COLUMNS 7u
#define FINGER_ROWS 6u
#define PALM_COLUMNS 11u
#define PALM_ROWS 6u
#define SLEEVE_COLUMNS 11u
#define SLEEVE_ROWS 7u

/* The thumb and the index finger, whose outline is seen most, are nearly straight. Their five sides
 * enclose the circle of the finger, and the shader cuts the drawn finger at the circle. The six
 * sides of the other fingers lie inside and outside the circle. */
#define STRAIGHT_COUNT 2u
#define FIVE_SIDES 1.19f
#define SIX_SIDES 1.10f
/* Coordinate `v` of the grid of the palm at the knuckles. */
#define PALM_CAP (2.0f / 5.0f)

/* Rows of texels of the picture of the skin that show one finger, and the palm. Along a row lies
 * the direction from the knuckle to the tip. */
#define FINGER_TEXELS (HAND_SKIN_SIDE / 8u)
#define PALM_TEXELS (HAND_SKIN_SIDE - FINGER_COUNT * FINGER_TEXELS)

static float distance_to_bone(vec3 p, const struct bone *bone)
{
    const vec3 along = v3_sub(bone->to, bone->from);
    const vec3 there = v3_sub(p, bone->from);
    const float t = f_clamp(v3_dot(there, along) / v3_dot(along, along), 0.0f, 1.0f);
    const float radius = f_lerp(bone->from_radius, bone->to_radius, t);
    return v3_length(v3_muladd(there, along, -t)) - radius;
}

/* Returns the smooth union of two distances. `width` is the width of the transition. */
static float blend(float a, float b, float width)
{
    const float h = f_max(width - f_abs(a - b), 0.0f) / width;
    return f_min(a, b) - 0.25f * width * h * h;
}

/* Returns the signed distance of `p` from the surface of the palm and the forearm. */
static float distance_to_palm(vec3 p)
{
    float nearest = 1e3f;
    for (uint32_t i = 0; i < PALM_BONES; i++) {
        nearest = blend(nearest, distance_to_bone(p, &palm[i]), BLEND);
    }
    return nearest;
}

/* Returns the signed distance of `p` from the surface of the palm and of all fingers. `width` is
 * the width of the smooth transition between the palm and a finger. */
static float distance_to_hand(vec3 p, float width)
{
    float nearest = 1e3f;
    for (uint32_t i = 0; i < FINGER_COUNT; i++) {
        const struct finger *const finger = &fingers[i];
        for (uint32_t k = 0; k + 1u < JOINT_COUNT; k++) {
            const struct bone bone = { finger->joints[k], finger->joints[k + 1u], finger->radii[k],
                                       finger->radii[k + 1u] };
            nearest = f_min(nearest, distance_to_bone(p, &bone));
        }
    }
    return blend(nearest, distance_to_palm(p), width);
}

/* Returns the direction away from the hand. The palm and the fingers have the same direction where
 * they meet, so that the edge between them is not visible. */
static vec3 hand_normal(vec3 p)
{
    const float e = 0.01f;
    const float here = distance_to_hand(p, SOFT);
    const vec3 slope = v3(distance_to_hand(v3(p.x + e, p.y, p.z), SOFT) - here,
                          distance_to_hand(v3(p.x, p.y + e, p.z), SOFT) - here,
                          distance_to_hand(v3(p.x, p.y, p.z + e), SOFT) - here);
    return v3_normalize_or(slope, v3(0.0f, 1.0f, 0.0f));
}

/* Returns the fraction of the light from all sides that reaches a point of the surface. */
static float openness(vec3 p, vec3 normal)
{
    float shut = 0.0f;
    for (uint32_t i = 1; i <= 3u; i++) {
        const float height = 0.07f * (float)(i * i);
        const float free = distance_to_hand(v3_muladd(p, normal, height), THIN);
        shut += f_clamp(1.0f - free / height, 0.0f, 1.0f) * (0.54f - 0.10f * (float)i);
    }
    return f_clamp(1.0f - shut, 0.0f, 1.0f);
}

static bool is_straight(const struct finger *finger)
{
    return finger < fingers + STRAIGHT_COUNT;
}

/* A place on a finger: its point, the direction away from the bone, and where it lies. */
struct finger_place {
    vec3 point, normal;
    vec3 along;  /* Direction of the bone, toward the tip. */
    float joint; /* Joints from the knuckle (0) to the tip (3). */
    float turn; /* Angle around the finger in turns, from 0 on its back to 0.5 on its inner side. */
    float capped; /* 0 before the tip, and 1 at the end of the finger. */
};

/* Returns the place of finger `finger` at (u, v). `v` runs from the knuckle to the end of the tip.
 * `u` runs around the finger, whose back has the coordinate 0.5. */
static struct finger_place finger_at(const struct finger *finger, float u, float v, float scale)
{
    /* Joints at which the rows of the grid lie. The first bent joint of a finger that wraps the
     * handle has three rows, because this joint is an outline. */
    static const float places[2][FINGER_ROWS] = { { 0.0f, 0.52f, 1.06f, 1.68f, 3.0f, 3.0f },
                                                  { 0.0f, 0.66f, 1.44f, 2.10f, 3.0f, 3.0f } };
    const float *const rows = places[is_straight(finger)];
    static const float caps[FINGER_ROWS] = { 0.0f, 0.0f, 0.0f, 0.0f, 0.33f, 1.0f };
    const float row = f_clamp(v, 0.0f, 1.0f) * (float)(FINGER_ROWS - 1u);
    const uint32_t from = row < (float)(FINGER_ROWS - 1u) ? (uint32_t)row : FINGER_ROWS - 2u;
    const float t = f_lerp(rows[from], rows[from + 1u], row - (float)from);
    const float cap = f_lerp(caps[from], caps[from + 1u], row - (float)from);
    const uint32_t joint = t < 2.0f ? (uint32_t)t : 2u;
    vec3 bones[JOINT_COUNT - 1u];
    for (uint32_t i = 0; i < JOINT_COUNT - 1u; i++) {
        bones[i] = v3_normalize_or(v3_sub(finger->joints[i + 1u], finger->joints[i]),
                                   v3(0.0f, 0.0f, -1.0f));
    }
    const vec3 first = v3_lerp(bones[0], bones[1], f_smoothstep(0.66f, 1.44f, t));
    const vec3 along =
        v3_normalize_or(v3_lerp(first, bones[2], f_smoothstep(1.7f, 2.3f, t)), first);
    const vec3 axis = v3_cross(bones[0], bones[2]); /* The joints bend around this axis. */
    const vec3 back = v3_normalize_or(v3_cross(along, axis), v3(0.0f, 1.0f, 0.0f));
    const vec3 side = v3_cross(back, along);
    const float angle = (u - 0.5f) * F_TAU;
    const vec3 ring = v3_add(v3_scale(back, f_cos(angle)), v3_scale(side, 0.0f - f_sin(angle)));
    const vec3 way =
        v3_add(v3_scale(ring, f_cos(0.5f * F_PI * cap)), v3_scale(along, f_sin(0.5f * F_PI * cap)));
    const float share = t - (float)joint;
    const vec3 centre = v3_lerp(finger->joints[joint], finger->joints[joint + 1u], share);
    const float radius = scale * f_lerp(finger->radii[joint], finger->radii[joint + 1u], share);
    return (struct finger_place){ .point = v3_muladd(centre, way, radius),
                                  .normal = way,
                                  .along = along,
                                  .joint = t,
                                  .turn = f_abs(u - 0.5f),
                                  .capped = cap };
}

static struct shape_vertex finger_point(float u, float v, const void *context)
{
    const struct finger *const finger = context;
    const float row = (float)(finger - fingers) * (float)FINGER_TEXELS + 0.5f;
    return (struct shape_vertex){
        .position = finger_at(finger, u, v, is_straight(finger) ? FIVE_SIDES : SIX_SIDES).point,
        .u = (0.5f + v * (float)(HAND_SKIN_SIDE - 1u)) / (float)HAND_SKIN_SIDE,
        .v = (row + u * (float)(FINGER_TEXELS - 1u)) / (float)HAND_SKIN_SIDE - 1.0f,
    };
}

/* Returns the point of the palm at (u, v). `v` runs from the knuckles to the forearm. The first
 * rows close the palm at the knuckles. */
static vec3 palm_at(float u, float v)
{
    /* Places of the rows along z. The wrist, which bends, is between two rows. */
    static const float rows[PALM_ROWS] = { 4.0f, 4.0f, 4.0f, 4.66f, 5.36f, 6.8f };
    const vec3 knuckles = v3(0.34f, 0.27f, 4.0f);
    const vec3 wrist = v3(HAND_WRIST_X, HAND_WRIST_Y, HAND_WRIST_Z);
    const float row = f_clamp(v, 0.0f, 1.0f) * (float)(PALM_ROWS - 1u);
    const uint32_t from = row < (float)(PALM_ROWS - 1u) ? (uint32_t)row : PALM_ROWS - 2u;
    const float z = f_lerp(rows[from], rows[from + 1u], row - (float)from);
    vec3 centre = v3_lerp(knuckles, wrist, f_min(z - knuckles.z, 1.0f));
    centre.z = z;
    const float ahead = 0.5f * F_PI * f_max(PALM_CAP - v, 0.0f) / PALM_CAP;
    const float angle = u * F_TAU;
    const vec3 way =
        v3(f_sin(angle) * f_cos(ahead), 0.0f - f_cos(angle) * f_cos(ahead), 0.0f - f_sin(ahead));
    float at = 0.0f;
    for (uint32_t i = 0; i < STEPS_MAX; i++) {
        at = f_max(at - distance_to_palm(v3_muladd(centre, way, at)), 0.0f);
    }
    return v3_muladd(centre, way, at);
}

static struct shape_vertex palm_point(float u, float v, const void *context)
{
    (void)context;
    const float row = (float)(FINGER_COUNT * FINGER_TEXELS) + 0.5f;
    return (struct shape_vertex){
        .position = palm_at(u, v),
        .u = (0.5f + v * (float)(HAND_SKIN_SIDE - 1u)) / (float)HAND_SKIN_SIDE,
        .v = (row + u * (float)(PALM_TEXELS - 1u)) / (float)HAND_SKIN_SIDE - 1.0f,
    };
}

/* Returns a point of the sleeve. The first rows are the dark inside of the cuff, which is visible
 * behind the wrist because the lower edge of the cuff is in front of the upper edge. Then follow
 * the hem and the cloth. The cloth hangs far below the forearm near the cuff, and has folds along
 * the arm. `u` and `v` of the vertex are the openness, and the distance around the sleeve or
 * HAND_HEM. */
static struct shape_vertex sleeve_point(float u, float v, const void *context)
{
    (void)context;
    /* Places of the rows along the sleeve. Two rows lie at one place where the cloth changes. */
    static const float alongs[SLEEVE_ROWS] = { 0.0f, 0.0f, 0.0f, 0.035f, 0.035f, 0.20f, 1.0f };
    const float row = f_clamp(v, 0.0f, 1.0f) * (float)(SLEEVE_ROWS - 1u);
    const uint32_t from = row < (float)(SLEEVE_ROWS - 1u) ? (uint32_t)row : SLEEVE_ROWS - 2u;
    const float along = f_lerp(alongs[from], alongs[from + 1u], row - (float)from);
    const float inside = f_max(1.0f - row, 0.0f);
    const float c = f_sin(u * F_TAU), s = 0.0f - f_cos(u * F_TAU);
    const float loose = (1.0f - along) * (1.0f - along);
    /* Every second column of the grid lies in a fold. The folds start behind the hem. */
    const float fold = (0.5f + 0.5f * f_cos(u * F_TAU * 5.0f)) * (0.7f + 0.3f * f_sin(u * 17.0f)) *
                       f_smoothstep(0.0f, 0.16f, along);
    const float wide = (1.0f - 0.07f * fold) * (1.0f - 0.10f * inside);
    const float bag = f_sin(F_PI * f_min(2.5f * along, 1.0f));
    const float hangs = 0.62f + 0.66f * loose + 1.10f * bag;
    const float flat = 1.0f - 0.22f * loose * f_max(0.0f - s, 0.0f); /* A bag of cloth is flat. */
    const vec3 p =
        v3(HAND_WRIST_X + (0.92f + 0.06f * loose + 0.34f * bag) * flat * wide * c,
           HAND_WRIST_Y + wide * (s > 0.0f ? 0.60f : hangs) * s - 0.12f * bag,
           HAND_CUFF_Z + 0.30f * s * loose + (HAND_SLEEVE_END_Z - HAND_CUFF_Z) * along + inside);
    const bool is_hem = row > 1.5f && row < 3.5f;
    const float open = row < 1.5f ? f_lerp(0.46f, 0.14f, inside) : 0.88f + 0.12f * s - 0.30f * fold;
    return (struct shape_vertex){ .position = p, .u = open, .v = is_hem ? HAND_HEM : 6.0f * u };
}

/* Replaces the normals of a grid of `columns`, whose first and last column are the same line, by
 * the means of the normals of the triangles. The edge of the drawn hand is where the normals turn
 * away from the camera, so that normals that do not agree with the triangles leave holes. */
static void smooth_normals(struct shape *shape, uint32_t first, uint32_t first_index,
                           uint32_t columns)
{
    for (uint32_t i = first; i < shape->vertex_count; i++) {
        shape->vertices[i].normal = v3(0.0f, 0.0f, 0.0f);
    }
    for (uint32_t i = first_index; i < shape->index_count; i += 3) {
        const uint16_t *const corners = &shape->indices[i];
        const vec3 a = shape->vertices[corners[0]].position;
        const vec3 normal = v3_cross(v3_sub(shape->vertices[corners[1]].position, a),
                                     v3_sub(shape->vertices[corners[2]].position, a));
        for (uint32_t k = 0; k < 3; k++) {
            vec3 *const sum = &shape->vertices[corners[k]].normal;
            *sum = v3_add(*sum, normal);
        }
    }
    for (uint32_t i = first; i < shape->vertex_count; i += columns) {
        struct shape_vertex *const row = &shape->vertices[i];
        row[0].normal = row[columns - 1u].normal = v3_add(row[0].normal, row[columns - 1u].normal);
        for (uint32_t k = 0; k < columns; k++) {
            row[k].normal = v3_normalize_or(row[k].normal, v3(0.0f, 0.0f, -1.0f));
        }
    }
}

/* Appends a finger. Writes the directions of its bones if the finger is straight. */
static void add_finger(struct shape *shape, vec3 *axes, const struct finger *finger)
{
    const uint32_t first = shape->vertex_count, first_index = shape->index_count;
    const uint32_t columns = is_straight(finger) ? STRAIGHT_COLUMNS : BENT_COLUMNS;
    shape_grid(shape, columns, FINGER_ROWS, finger_point, finger);
    CORE_ASSERT(shape->vertex_count <= HAND_VERTEX_MAX);
    if (!is_straight(finger)) {
        smooth_normals(shape, first, first_index, columns);
    }
    for (uint32_t i = 0; is_straight(finger) && i < columns * FINGER_ROWS; i++) {
        const float u = (float)(i % columns) / (float)(columns - 1u);
        const float v = (float)(i / columns) / (float)(FINGER_ROWS - 1u);
        const struct finger_place place = finger_at(finger, u, v, FIVE_SIDES);
        shape->vertices[first + i].normal = place.normal;
        axes[first + i] = place.along;
    }
}

void hand_mesh(struct shape *shape, vec3 axes[HAND_VERTEX_MAX])
{
    CORE_ASSERT(shape->vertex_count == 0);
    memset(axes, 0, HAND_VERTEX_MAX * sizeof *axes);
    /* Parts that hide others come first, so that hidden pixels are not shaded. */
    shape_grid(shape, SLEEVE_COLUMNS, SLEEVE_ROWS, sleeve_point, NULL);
    const uint32_t vertex = shape->vertex_count, index = shape->index_count;
    shape_grid(shape, PALM_COLUMNS, PALM_ROWS, palm_point, NULL);
    smooth_normals(shape, vertex, index, PALM_COLUMNS);
    for (uint32_t i = 0; i < FINGER_COUNT; i++) {
        add_finger(shape, axes, &fingers[i]);
    }
}

/* Writes the colour of the skin for the fraction `light` of the light, [0, 1]. Light that enters
 * the skin leaves it red, so that shadows are warm. `blush` and `nail` in [0, 1] mix in the colours
 * of a joint and of a nail. */
static void paint_skin(uint8_t *texel, float light, float blush, float nail)
{
    static const float skins[3] = { 0.98f, 0.86f, 0.67f };
    static const float blushes[3] = { 0.98f, 0.72f, 0.55f };
    static const float nails[3] = { 1.0f, 0.84f, 0.75f };
    static const float warmth[3] = { 0.40f, 0.02f, -0.06f };
    for (uint32_t i = 0; i < 3u; i++) {
        const float lit = light * (1.0f + warmth[i] * (1.0f - light));
        const float tone = f_lerp(f_lerp(skins[i], blushes[i], blush), nails[i], nail);
        texel[i] = (uint8_t)(255.0f * f_clamp(lit * tone, 0.0f, 1.0f));
    }
}

/* Returns the light on a surface: little in grooves, and more on a surface that faces up. A place
 * inside another part of the hand is light, because the triangles may show this place. */
static float light_on(vec3 p)
{
    const vec3 normal = hand_normal(p);
    const float depth = f_max(0.0f - distance_to_hand(p, SOFT), 0.0f);
    const float open = 0.2f + 0.8f * openness(v3_muladd(p, normal, depth), normal);
    const float buried = f_smoothstep(0.16f, 0.24f, depth);
    return f_lerp(open, 0.9f, buried) * (0.74f + 0.26f * normal.y);
}

static void paint_finger(uint8_t *texel, const struct finger *finger, float u, float v)
{
    const struct finger_place place = finger_at(finger, u, v, 1.0f);
    const float back = f_smoothstep(0.24f, 0.12f, place.turn);
    const float bend = f_min(f_abs(place.joint - 1.0f), f_abs(place.joint - 2.0f));
    /* Two creases at each joint, and the edge of the nail. */
    const float crease = f_smoothstep(0.05f, 0.0f, f_abs(bend - 0.07f)) * back;
    const float ahead = place.joint - 2.72f + 0.5f * place.capped;
    const float far = f_sqrt(ahead * ahead * 7.0f + place.turn * place.turn * 36.0f);
    const float nail = f_smoothstep(0.92f, 0.80f, far);
    const float edge = f_smoothstep(0.16f, 0.02f, f_abs(far - 0.92f));
    const float light = light_on(place.point) * (1.0f - 0.09f * crease - 0.20f * edge);
    const float blush = f_max(f_smoothstep(0.34f, 0.05f, bend) * back,
                              f_smoothstep(2.5f, 3.2f, place.joint + 0.4f * place.capped));
    paint_skin(texel, light, 0.4f * blush, 0.8f * nail);
}

static void paint_palm(uint8_t *texel, float u, float v)
{
    const vec3 p = palm_at(u, v);
    /* Distances to the two nearest bones of the fingers, between which lies a shallow groove. */
    float nearest = 1e3f, second = 1e3f;
    for (uint32_t i = 0; i + 1u < FINGER_COUNT; i++) {
        const float distance = distance_to_bone(p, &palm[i]);
        second = f_min(second, f_max(nearest, distance));
        nearest = f_min(nearest, distance);
    }
    const float ahead = f_smoothstep(4.9f, 3.9f, p.z);
    const float groove = f_smoothstep(0.09f, 0.0f, second - nearest) * ahead;
    const float light = light_on(p) * (1.0f - 0.12f * groove);
    paint_skin(texel, light, 0.2f * f_smoothstep(4.05f, 3.75f, p.z), 0.0f);
}

void hand_skin(uint8_t texels[HAND_SKIN_SIDE * HAND_SKIN_SIDE][3])
{
    for (uint32_t i = 0; i < HAND_SKIN_SIDE * HAND_SKIN_SIDE; i++) {
        const uint32_t row = i / HAND_SKIN_SIDE, finger = row / FINGER_TEXELS;
        const float v = (float)(i % HAND_SKIN_SIDE) / (float)(HAND_SKIN_SIDE - 1u);
        if (finger < FINGER_COUNT) {
            const float u = (float)(row % FINGER_TEXELS) / (float)(FINGER_TEXELS - 1u);
            paint_finger(texels[i], &fingers[finger], u, v);
        } else {
            const uint32_t first = FINGER_COUNT * FINGER_TEXELS;
            paint_palm(texels[i], (float)(row - first) / (float)(PALM_TEXELS - 1u), v);
        }
    }
}
