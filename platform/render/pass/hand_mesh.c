/* hand_mesh.c -- builds the mesh of a hand with its sleeve; see hand_mesh.h. The surface of a hand
 * is the smooth union of tapered bones, which gives soft transitions between the fingers and the
 * palm. The occlusion of the sky at each vertex comes from the same distance function. */
#include "platform/render/pass/hand_mesh.h"

#include "core/base/panic.h"

/* A tapered bone between two points, in inner radii of the ring in the axes of the handle. */
struct bone {
    vec3 from, to;
    float from_radius, to_radius;
};

/* Number of bones of a finger, from the knuckle to the tip. */
#define FINGER_BONES 3u
#define FINGER_COUNT 5u /* The thumb is finger 0. */
#define PALM_FIRST (FINGER_COUNT * FINGER_BONES)
/* The thumb lies on the handle and points to the ring. The other fingers wrap the handle: from the
 * knuckles on the right, down, below the handle, and up on the left. */
static const struct bone bones[] = {
    { { 0.02f, 0.18f, 4.72f }, { -0.25f, 0.37f, 3.86f }, 0.32f, 0.28f },
    { { -0.26f, 0.38f, 3.86f }, { -0.15f, 0.38f, 3.12f }, 0.26f, 0.205f },
    { { -0.15f, 0.38f, 3.12f }, { 0.00f, 0.24f, 2.60f }, 0.215f, 0.165f },
    { { 0.47f, 0.32f, 3.08f }, { 0.46f, -0.34f, 2.64f }, 0.235f, 0.20f },
    { { 0.46f, -0.34f, 2.64f }, { 0.02f, -0.50f, 2.54f }, 0.195f, 0.175f },
    { { 0.02f, -0.50f, 2.54f }, { -0.32f, -0.26f, 2.56f }, 0.175f, 0.145f },
    { { 0.62f, 0.24f, 3.46f }, { 0.58f, -0.46f, 3.06f }, 0.245f, 0.205f },
    { { 0.58f, -0.46f, 3.06f }, { 0.05f, -0.58f, 2.94f }, 0.20f, 0.18f },
    { { 0.05f, -0.58f, 2.94f }, { -0.33f, -0.32f, 2.96f }, 0.18f, 0.15f },
    { { 0.64f, 0.11f, 3.83f }, { 0.56f, -0.54f, 3.44f }, 0.235f, 0.195f },
    { { 0.56f, -0.54f, 3.44f }, { 0.05f, -0.62f, 3.33f }, 0.195f, 0.175f },
    { { 0.05f, -0.62f, 3.33f }, { -0.29f, -0.36f, 3.34f }, 0.17f, 0.145f },
    { { 0.57f, -0.03f, 4.16f }, { 0.48f, -0.56f, 3.80f }, 0.20f, 0.165f },
    { { 0.48f, -0.56f, 3.80f }, { 0.08f, -0.60f, 3.70f }, 0.165f, 0.15f },
    { { 0.08f, -0.60f, 3.70f }, { -0.20f, -0.40f, 3.70f }, 0.15f, 0.125f },
    /* The palm: a bone from the wrist to each knuckle, and the ball of the thumb. */
    { { 0.12f, 0.24f, 5.00f }, { 0.48f, 0.32f, 3.12f }, 0.30f, 0.24f },
    { { 0.22f, 0.18f, 5.00f }, { 0.60f, 0.23f, 3.50f }, 0.30f, 0.24f },
    { { 0.30f, 0.12f, 5.00f }, { 0.62f, 0.10f, 3.86f }, 0.30f, 0.24f },
    { { 0.34f, 0.06f, 5.00f }, { 0.55f, -0.06f, 4.20f }, 0.28f, 0.22f },
    { { 0.02f, 0.10f, 4.70f }, { 0.18f, 0.20f, 3.62f }, 0.34f, 0.24f },
    /* The web between the thumb and the index finger, and the knuckles. */
    { { -0.16f, 0.22f, 3.95f }, { 0.36f, 0.22f, 3.30f }, 0.24f, 0.16f },
    { { 0.50f, 0.38f, 3.10f }, { 0.51f, 0.30f, 2.98f }, 0.20f, 0.19f },
    { { 0.65f, 0.29f, 3.48f }, { 0.66f, 0.20f, 3.36f }, 0.20f, 0.19f },
    { { 0.69f, 0.14f, 3.85f }, { 0.69f, 0.06f, 3.74f }, 0.19f, 0.18f },
    /* The forearm, which is wider than thick. */
    { { 0.13f, 0.16f, 5.00f }, { 0.10f, 0.14f, 7.40f }, 0.33f, 0.46f },
    { { 0.33f, 0.10f, 5.00f }, { 0.36f, 0.10f, 7.40f }, 0.31f, 0.44f },
};
#define BONE_COUNT (sizeof bones / sizeof *bones)

#define BLEND 0.10f /* Width of the smooth transition between two bones. */
#define STEPS_MAX 12u
#define INSIDE 0.02f /* Depth from which a vertex is hidden inside the hand. */
/* The rows of the thumb whose `v` is above 1 / TIP_FROM close its tip. */
#define TIP_FROM 1.5f

/* Number of joints of a finger, from the knuckle to the end of the last bone. */
#define JOINT_COUNT (FINGER_BONES + 1u)
#define THUMB_COLUMNS 8u
#define THUMB_ROWS 7u
#define FIST_COLUMNS 18u
#define FIST_ROWS (JOINT_COUNT + 2u)
#define PALM_COLUMNS 11u
#define PALM_ROWS 7u
#define SLEEVE_COLUMNS 13u
#define SLEEVE_ROWS 4u

#define CUFF_V (1.0f / 3.0f) /* Coordinate `v` of the grid at which the sleeve begins. */
/* End of the palm along z, and coordinates `v` of the grid at the wrist and at the knuckles. */
#define PALM_END_Z 7.2f
#define PALM_BEND (4.0f / 6.0f)
#define PALM_CAP (2.0f / 6.0f)

/* Returns the signed distance of `p` from the surface of a hand. */
static float distance_to(vec3 p)
{
    float nearest = 1e3f;
    for (uint32_t i = 0; i < BONE_COUNT; i++) {
        const vec3 along = v3_sub(bones[i].to, bones[i].from);
        const vec3 there = v3_sub(p, bones[i].from);
        const float t = f_clamp(v3_dot(there, along) / v3_dot(along, along), 0.0f, 1.0f);
        const float radius = f_lerp(bones[i].from_radius, bones[i].to_radius, t);
        const float distance = v3_length(v3_muladd(there, along, -t)) - radius;
        const float h = f_max(BLEND - f_abs(distance - nearest), 0.0f) / BLEND;
        nearest = f_min(distance, nearest) - 0.25f * BLEND * h * h;
    }
    return nearest;
}

static vec3 normal_at(vec3 p)
{
    const float e = 0.01f;
    const vec3 slope = v3(distance_to(v3(p.x + e, p.y, p.z)) - distance_to(v3(p.x - e, p.y, p.z)),
                          distance_to(v3(p.x, p.y + e, p.z)) - distance_to(v3(p.x, p.y - e, p.z)),
                          distance_to(v3(p.x, p.y, p.z + e)) - distance_to(v3(p.x, p.y, p.z - e)));
    return v3_normalize_or(slope, v3(0.0f, 1.0f, 0.0f));
}

/* Returns the point at which a ray from `from` leaves the hand. Returns `from` if it is outside the
 * hand, and the point at the distance `reach` if the ray does not leave the hand before. */
static vec3 leave_hand(vec3 from, vec3 way, float reach)
{
    float at = 0.0f;
    for (uint32_t i = 0; i < STEPS_MAX && at < reach; i++) {
        at = f_max(at - distance_to(v3_muladd(from, way, at)), 0.0f);
    }
    return v3_muladd(from, way, f_min(at, reach));
}

/* Returns the fraction of the light from all sides that reaches a point of the surface. */
static float openness(vec3 p, vec3 normal)
{
    float shut = 0.0f;
    for (uint32_t i = 1; i <= 4u; i++) {
        const float height = 0.10f * (float)(i * i) * 0.5f;
        const float free = distance_to(v3_muladd(p, normal, height));
        shut += f_clamp(1.0f - free / height, 0.0f, 1.0f) * (0.46f - 0.08f * (float)i);
    }
    return f_clamp(1.0f - shut, 0.0f, 1.0f);
}

/* Returns the unit vector at the angle `turn` (in turns) around `along`, counter-clockwise as seen
 * against `along`. The turn 0 is at a right angle to `across`. */
static vec3 around(vec3 along, vec3 across, float turn)
{
    const vec3 side = v3_normalize_or(v3_cross(across, along), v3(1.0f, 0.0f, 0.0f));
    const vec3 up = v3_cross(along, side);
    return v3_add(v3_scale(side, f_cos(turn * F_TAU)), v3_scale(up, f_sin(turn * F_TAU)));
}

/* Returns a point of the thumb. `v` runs from the wrist to the tip. The last rows close the tip as
 * a part of a sphere. */
static struct shape_vertex thumb_point(float u, float v, const void *context)
{
    (void)context;
    const float at = f_min(v * TIP_FROM, 1.0f) * (float)FINGER_BONES;
    const uint32_t index = at < (float)FINGER_BONES ? (uint32_t)at : FINGER_BONES - 1u;
    const struct bone *const bone = &bones[index];
    const float t = at - (float)index;
    const vec3 along = v3_normalize_or(v3_sub(bone->to, bone->from), v3(0.0f, 0.0f, -1.0f));
    const float tip = f_max(v * TIP_FROM - 1.0f, 0.0f) / (TIP_FROM - 1.0f);
    const vec3 way =
        v3_add(v3_scale(around(along, v3(0.0f, 1.0f, 0.0f), u), f_cos(0.5f * F_PI * tip)),
               v3_scale(along, f_sin(0.5f * F_PI * tip)));
    const float radius = f_lerp(bone->from_radius, bone->to_radius, t);
    const vec3 centre = v3_lerp(bone->from, bone->to, t);
    return (struct shape_vertex){ .position = leave_hand(centre, way, 1.12f * radius), .u = 1.0f };
}

/* Fraction of the palm that the fingers cover behind their knuckles, so that no gap opens there. */
#define KNUCKLE_BACK 0.2f

/* Returns joint `joint` of a finger. Joint 0 is behind the knuckle. */
static vec3 joint_of(uint32_t finger, uint32_t joint)
{
    const struct bone *const first = &bones[finger * FINGER_BONES];
    CORE_ASSERT(joint < JOINT_COUNT);
    const vec3 wrist = v3(HAND_WRIST_X, HAND_WRIST_Y, HAND_WRIST_Z);
    return joint == 0 ? v3_lerp(first->from, wrist, KNUCKLE_BACK) : first[joint - 1u].to;
}

/* Returns the direction of a finger at joint `joint`. */
static vec3 tangent_of(uint32_t finger, uint32_t joint)
{
    const uint32_t before = joint > 0 ? joint - 1u : 0;
    const uint32_t after = joint + 1u < JOINT_COUNT ? joint + 1u : joint;
    return v3_normalize_or(v3_sub(joint_of(finger, after), joint_of(finger, before)),
                           v3(0.0f, -1.0f, 0.0f));
}

/* Sources of the normal of a vertex: the slope of the distance, the grid, and the common direction
 * of the inner sides of the fingers, which would otherwise fade where they meet the tips. */
#define NORMAL_SLOPE 0.0f
#define NORMAL_GRID 1.0f
#define NORMAL_INNER 2.0f

/* Depth of the groove between two closed fingers: 1 is the depth between round fingers. */
#define GROOVE 0.4f

/* A column of the fingers, which are closed together. */
struct fist_column {
    float finger; /* 0 for the index finger, 3 for the little finger. */
    float turn;   /* Turns around the finger: 0 on its back, 0.25 toward the little finger. */
};

/* Returns a point of the four fingers. `v` runs from the knuckles to the tips. `u` runs around the
 * fingers: from the side of the index finger over the backs, and back along the inner sides. `v` of
 * the vertex is the source of its normal. */
static struct shape_vertex fist_point(float u, float v, const void *context)
{
    (void)context;
    static const struct fist_column columns[FIST_COLUMNS] = {
        { 0.0f, -0.25f }, { 0.0f, -0.10f }, { 0.0f, 0.10f },  { 0.5f, 0.0f },  { 1.0f, -0.10f },
        { 1.0f, 0.10f },  { 1.5f, 0.0f },   { 2.0f, -0.10f }, { 2.0f, 0.10f }, { 2.5f, 0.0f },
        { 3.0f, -0.10f }, { 3.0f, 0.10f },  { 3.0f, 0.25f },  { 3.0f, 0.5f },  { 2.0f, 0.5f },
        { 1.0f, 0.5f },   { 0.0f, 0.5f },   { 0.0f, 0.75f },
    };
    const float row = v * (float)(FIST_ROWS - 1u);
    const float at = f_min(row, (float)(JOINT_COUNT - 1u));
    const uint32_t joint = at < (float)(JOINT_COUNT - 1u) ? (uint32_t)at : JOINT_COUNT - 2u;
    const float t = at - (float)joint;
    const float column = u * (float)(FIST_COLUMNS - 1u);
    const uint32_t from =
        column < (float)(FIST_COLUMNS - 1u) ? (uint32_t)column : FIST_COLUMNS - 2u;
    const float part = column - (float)from;
    const float place = f_lerp(columns[from].finger, columns[from + 1u].finger, part);
    const float turn = f_lerp(columns[from].turn, columns[from + 1u].turn, part);
    const uint32_t finger = place < 3.0f ? 1u + (uint32_t)place : 3u;
    const float share = place - (float)(finger - 1u);
    vec3 centre[2], along[2];
    for (uint32_t i = 0; i < 2u; i++) {
        centre[i] = v3_lerp(joint_of(finger + i, joint), joint_of(finger + i, joint + 1u), t);
        along[i] = v3_lerp(tangent_of(finger + i, joint), tangent_of(finger + i, joint + 1u), t);
    }
    const vec3 tangent = v3_normalize_or(v3_lerp(along[0], along[1], share), along[0]);
    const vec3 across =
        v3_normalize_or(v3_lerp(v3_sub(joint_of(4u, joint), joint_of(1u, joint)),
                                v3_sub(joint_of(4u, joint + 1u), joint_of(1u, joint + 1u)), t),
                        v3(0.0f, 0.0f, 1.0f));
    const vec3 outward = v3_normalize_or(v3_cross(across, tangent), v3(1.0f, 0.0f, 0.0f));
    const float c = f_cos(turn * F_TAU), s = f_sin(turn * F_TAU);
    const vec3 ring = v3_add(v3_scale(outward, c), v3_scale(across, s));
    const float tip = 0.25f * F_PI * f_max(row - (float)(JOINT_COUNT - 1u), 0.0f);
    const vec3 way = v3_add(v3_scale(ring, f_cos(tip)), v3_scale(tangent, f_sin(tip)));
    /* A column between two fingers lies low, and little light falls there. The tips are joined. */
    const bool is_between = f_abs(share - 0.5f) < 0.4f;
    const bool is_tip = row > (float)FIST_ROWS - 1.5f;
    const bool is_inner = f_abs(turn - 0.5f) < 0.1f && row > 1.5f;
    const vec3 low = leave_hand(v3_lerp(centre[0], centre[1], share), way, 0.05f);
    const vec3 high =
        v3_lerp(leave_hand(centre[0], way, 0.3f), leave_hand(centre[1], way, 0.3f), share);
    const float depth = is_between && !is_tip ? GROOVE : 0.0f;
    return (struct shape_vertex){ .position = v3_lerp(high, low, depth),
                                  .u = is_between ? 0.5f : 1.0f,
                                  .v = is_inner     ? NORMAL_INNER
                                       : is_between ? NORMAL_GRID
                                                    : NORMAL_SLOPE };
}

/* Returns a point of the palm and the forearm. `v` runs from the knuckles to the forearm. The first
 * rows close the palm at the knuckles. */
static struct shape_vertex palm_point(float u, float v, const void *context)
{
    (void)context;
    const vec3 knuckles = v3(0.55f, 0.13f, 3.55f),
               wrist = v3(HAND_WRIST_X, HAND_WRIST_Y, HAND_WRIST_Z);
    const vec3 end = v3(HAND_WRIST_X + 0.01f, HAND_WRIST_Y - 0.02f, PALM_END_Z);
    const vec3 centre =
        v < PALM_BEND ? v3_lerp(knuckles, wrist, f_max(v - PALM_CAP, 0.0f) / (PALM_BEND - PALM_CAP))
                      : v3_lerp(wrist, end, (v - PALM_BEND) / (1.0f - PALM_BEND));
    const float ahead = 0.5f * F_PI * f_max(PALM_CAP - v, 0.0f) / PALM_CAP;
    const vec3 ring = around(v3(0.0f, 0.0f, 1.0f), v3(0.0f, 1.0f, 0.0f), u);
    const vec3 way = v3_add(v3_scale(ring, f_cos(ahead)), v3(0.0f, 0.0f, -f_sin(ahead)));
    return (struct shape_vertex){ .position = leave_hand(centre, way, 1.2f), .u = 1.0f };
}

/* Returns a point of the sleeve. The first rows are the inside of the cuff. The sleeve is widest at
 * the cuff, where its lower edge hangs, and has folds along the arm. `u` and `v` of the vertex are
 * the openness and the distance around the sleeve, which is never negative. */
static struct shape_vertex sleeve_point(float u, float v, const void *context)
{
    (void)context;
    const float along = f_max(v - CUFF_V, 0.0f) / (1.0f - CUFF_V);
    const float inside = f_max(CUFF_V - v, 0.0f) / CUFF_V;
    const float c = f_sin(u * F_TAU), s = 0.0f - f_cos(u * F_TAU);
    const float hangs = 0.55f + 1.15f * (1.0f - along) * (1.0f - along);
    const float width = f_lerp(0.86f, 0.98f, along);
    const float folds =
        0.030f * f_sin(u * F_TAU * 5.0f + 9.0f * along) * f_smoothstep(0.0f, 0.2f, along) +
        0.022f * f_sin(u * F_TAU * 3.0f - 14.0f * along);
    const float wide = (1.0f + folds) * (1.0f - 0.10f * inside);
    const float height = s > 0.0f ? 0.68f * s : hangs * s;
    const vec3 p = v3(HAND_WRIST_X + width * wide * c, HAND_WRIST_Y + wide * height,
                      HAND_CUFF_Z + 0.12f * (0.0f - s) + (HAND_SLEEVE_END_Z - HAND_CUFF_Z) * along +
                          0.9f * inside);
    return (struct shape_vertex){ .position = p,
                                  .u = f_lerp(0.72f + 0.28f * s, 0.10f, f_min(8.0f * inside, 1.0f)),
                                  .v = 6.0f * u };
}

void hand_mesh(struct shape *shape)
{
    CORE_ASSERT(BONE_COUNT > PALM_FIRST);
    /* Parts that hide others come first, so that hidden pixels are not shaded. */
    shape_grid(shape, SLEEVE_COLUMNS, SLEEVE_ROWS, sleeve_point, NULL);
    const uint32_t first = shape->vertex_count;
    shape_grid(shape, THUMB_COLUMNS, THUMB_ROWS, thumb_point, NULL);
    shape_grid(shape, PALM_COLUMNS, PALM_ROWS, palm_point, NULL);
    shape_grid(shape, FIST_COLUMNS, FIST_ROWS, fist_point, NULL);
    for (uint32_t i = first; i < shape->vertex_count; i++) {
        struct shape_vertex *const vertex = &shape->vertices[i];
        /* A vertex inside the hand keeps the normal of the grid, because the slope of the distance
         * may point anywhere there. */
        if (vertex->v == NORMAL_INNER) {
            vertex->normal = v3(-0.39f, 0.92f, 0.0f);
        } else if (vertex->v == NORMAL_SLOPE && distance_to(vertex->position) > -INSIDE) {
            vertex->normal = normal_at(vertex->position);
        }
        vertex->u *= openness(vertex->position, vertex->normal);
        vertex->v = -1.0f; /* A negative value means skin. */
    }
}
