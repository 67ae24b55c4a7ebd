/* poi_pass.c -- draws the pois (paper scoops). The unit of length in the meshes of the ring and the
 * handle is the inner radius of the ring. */
#include "platform/render/pass/poi_pass.h"

#include <string.h>

#include "core/base/panic.h"
#include "platform/render/gl_util.h"
#include "shaders.h"

/* Number of samples along each side of the square around the paper. Neighbouring samples are 6.7 mm
 * apart. */
#define LINES 12u
/* Number of bisection steps. This number of steps narrows a range of some centimetres to a
 * hundredth of a millimetre. */
#define HALVINGS 12

/* Heights of the paper above the ring's centre, at the sample points on the paper. */
struct relief {
    uint32_t count;
    float height_m[LINES * LINES];
    float low_m, high_m;
};

struct poi_pool poi_pool_of(const struct scene_poi *poi)
{
    CORE_ASSERT(poi->ring_radius_m > 0.0f);
    struct poi_pool pool = { POI_NO_POOL_M, f_clamp(poi->water_m, 0.0f, POI_FILM_M) };
    const float depth_m = poi->water_m - pool.film_m;
    if (!(depth_m > 1e-5f)) {
        return pool;
    }
    struct relief relief = { .low_m = 1.0f, .high_m = -1.0f };
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const float radius_m = poi->ring_radius_m;
    for (uint32_t i = 0; i < LINES * LINES; i++) {
        const float x = ((float)(i % LINES) + 0.5f) * (2.0f / (float)LINES) - 1.0f;
        const float z = ((float)(i / LINES) + 0.5f) * (2.0f / (float)LINES) - 1.0f;
        const float r2 = x * x + z * z;
        if (r2 > 1.0f) {
            continue;
        }
        const float height_m =
            radius_m * (x * axes.right.y + z * axes.back.y) - poi->sag_m * (1.0f - r2) * axes.up.y;
        relief.height_m[relief.count++] = height_m;
        relief.low_m = f_min(relief.low_m, height_m);
        relief.high_m = f_max(relief.high_m, height_m);
    }
    float low_m = relief.low_m, high_m = relief.high_m + depth_m;
    for (int i = 0; i < HALVINGS; i++) {
        const float middle_m = 0.5f * (low_m + high_m);
        float sum_m = 0.0f;
        for (uint32_t k = 0; k < relief.count; k++) {
            sum_m += f_max(middle_m - relief.height_m[k], 0.0f);
        }
        /* sum_m / relief.count is the mean depth of the water over the whole paper if the surface
         * of the water is at the height `middle_m`. */
        if (sum_m / (float)relief.count < depth_m) {
            low_m = middle_m;
        } else {
            high_m = middle_m;
        }
    }
    pool.level_m = poi->position_m.y + 0.5f * (low_m + high_m);
    return pool;
}

/* Distance from the poi's centre to the middle of the ring's plastic. The unit is the inner radius
 * of the ring. In a real poi, the inner radius is 40 mm and the outer radius is 46.5 mm. */
#define RING_MIDDLE 1.08f
#define RING_HALF_WIDTH 0.085f
#define RING_HALF_HEIGHT 0.062f
#define RING_COLUMNS 57u
#define RING_ROWS 11u
#define HANDLE_START 1.10f
/* Length of the handle in inner radii of the ring. In a real poi, the length is 10 cm. */
#define HANDLE_LENGTH 2.55f
#define HANDLE_ROWS 22u
#define HANDLE_COLUMNS 13u
/* Thickness in metres from which the water film on the paper shines fully. */
#define FILM_SHINES_M 0.0004f
#define PAPER_COLUMNS 49u
#define PAPER_ROWS 11u
/* Maximum number of fish on the paper that darken the paper. Must equal the array size of `rests`
 * in poi_paper.vert.glsl. More fish would add no visible shade. */
#define RESTS_MAX 2
/* Distances from the ring's centre to the outer edge of the ring, and to the handle's end, in inner
 * radii of the ring. */
#define RING_REACH (RING_MIDDLE + RING_HALF_WIDTH)
#define HANDLE_REACH (HANDLE_START + HANDLE_LENGTH)
/* Largest half height and half width of the ring and the handle, in inner radii of the ring. */
#define THICKNESS 0.14f

const float *poi_paint(uint8_t owner)
{
    static const float paints[POI_MAX][4] = {
        { 0.97f, 0.30f, 0.46f, 0.0f }, /* Peach pink, the most common colour of pois at festival
                                          stalls. */
        { 0.20f, 0.52f, 0.95f, 2.0f },
        { 0.25f, 0.76f, 0.36f, 3.0f },
        { 0.98f, 0.74f, 0.16f, 4.0f },
    };
    CORE_ASSERT(owner < POI_MAX);
    return paints[owner];
}

static struct shape_vertex ring_point(float u, float v, const void *context)
{
    (void)context;
    const float around = u * F_TAU;
    const float section = -v * F_TAU;
    const float r = RING_MIDDLE + RING_HALF_WIDTH * f_cos(section);
    const vec3 p = v3(r * f_cos(around), RING_HALF_HEIGHT * f_sin(section), r * f_sin(around));
    return (struct shape_vertex){ .position = p, .u = u, .v = v };
}

/* Returns a point of the handle, which is a flat bar with a slim neck at the ring, a broader grip
 * and a round end. `u` is the position around the bar and `v` the position along it, both 0 ..
 * 1. */
static struct shape_vertex handle_point(float u, float v, const void *context)
{
    (void)context;
    const float neck = f_smoothstep(0.0f, 0.16f, v);
    const float grip = f_smoothstep(0.28f, 0.62f, v);
    const float end = f_sqrt(
        f_max(1.0f - f_max((v - 0.93f) / 0.07f, 0.0f) * f_max((v - 0.93f) / 0.07f, 0.0f), 0.0f));
    const float half_width = (0.135f - 0.055f * neck + 0.040f * grip) * f_max(end, 0.001f);
    const float half_height = 0.055f * f_max(end, 0.001f);
    const float section = u * F_TAU;
    const vec3 p = v3(half_width * f_cos(section), half_height * f_sin(section),
                      HANDLE_START + HANDLE_LENGTH * v);
    return (struct shape_vertex){ .position = p, .u = u, .v = v };
}

static struct shape_vertex paper_point(float u, float v, const void *context)
{
    (void)context;
    const float around = -u * F_TAU;
    const float r =
        v * 1.01f; /* The factor 1.01 places the outermost vertices inside the plastic of
                                  the poi's ring. */
    return (struct shape_vertex){ .position = v3(r * f_cos(around), r * f_sin(around), 0.0f) };
}

static struct paper_program link_paper(struct gl_status *status, uint32_t variant)
{
    static const char *const names[PAPER_VARIANTS] = { "poi paper", "poi paper and pool",
                                                       "practice paper",
                                                       "practice paper and pool" };
    static const char *const defines[PAPER_VARIANTS] = { "", "#define POOL\n", "#define PRACTICE\n",
                                                         "#define POOL\n#define PRACTICE\n" };
    CORE_ASSERT(variant < PAPER_VARIANTS);
    const GLuint name = gl_program(status, names[variant], defines[variant], shader_poi_paper_vert,
                                   shader_poi_paper_frag, "sheet fibres");
    return (struct paper_program){ .name = name,
                                   .pose = glGetUniformLocation(name, "pose"),
                                   .paper = glGetUniformLocation(name, "paper"),
                                   .rests = glGetUniformLocation(name, "rests"),
                                   .spines = glGetUniformLocation(name, "spines"),
                                   .pool = glGetUniformLocation(name, "pool") };
}

void poi_pass_open(struct gl_status *status, struct poi_pass *pass)
{
    pass->frame_program =
        gl_program(status, "poi frame", "", shader_poi_frame_vert, shader_poi_frame_frag, "");
    pass->cap_program = gl_program(status, "poi cap", "#define CAP\n", shader_poi_frame_vert,
                                   shader_poi_frame_frag, "");
    pass->cap_pose = glGetUniformLocation(pass->cap_program, "pose");
    pass->frame_pose = glGetUniformLocation(pass->frame_program, "pose");
    pass->frame_paint = glGetUniformLocation(pass->frame_program, "paint");
    for (uint32_t i = 0; i < PAPER_VARIANTS; i++) {
        pass->papers[i] = link_paper(status, i);
    }
    gl_ring_open(status, "sheets", &pass->sheet_ring,
                 &(struct gl_texture_desc){ .internal_format = GL_RGBA8,
                                            .width = SHEET_SIDE,
                                            .height = SHEET_SIDE,
                                            .layers = POI_MAX });
    memset(pass->ages, POI_OPEN_TICKS, sizeof pass->ages);
    struct shape shape = { 0 };
    shape_grid(&shape, RING_COLUMNS, RING_ROWS, ring_point, NULL);
    shape_grid(&shape, HANDLE_COLUMNS, HANDLE_ROWS, handle_point, NULL);
    shape_upload(&shape, &pass->solid);
    shape.vertex_count = shape.index_count = 0;
    shape_grid(&shape, PAPER_COLUMNS, PAPER_ROWS, paper_point, NULL);
    shape_upload(&shape, &pass->disc);
}

void poi_pass_close(struct poi_pass *pass)
{
    glDeleteProgram(pass->frame_program);
    glDeleteProgram(pass->cap_program);
    for (uint32_t i = 0; i < PAPER_VARIANTS; i++) {
        glDeleteProgram(pass->papers[i].name);
    }
    gl_ring_close(&pass->sheet_ring);
    shape_close(&pass->solid);
    shape_close(&pass->disc);
}

#define CELL_COUNT (SHEET_SIDE * SHEET_SIDE)
#define CELL_NONE UINT16_MAX
/* Distance in cells from the edge of a hole that the largest value in the texture stands for. */
#define FLAP_CELLS_MAX 8.0f
/* Shortest and longest length of the torn paper at the edge of a hole, in cells. */
#define FLAP_CELLS_SHORT 1.8f
#define FLAP_CELLS_LONG 7.0f
/* Distance from the ring's centre, in radii, from which a strip of torn paper stays on the ring. */
#define FRINGE 0.96f
/* Distance from the edge at which a new hole is open, as a share of the largest distance. */
#define SLIT 0.8f
/* Integrity of torn paper. */
#define FLAP_INTEGRITY 215u

/* Returns the coordinate of the centre of a row or column, in radii of the ring. */
static float line_at(uint32_t line)
{
    return ((float)line + 0.5f) * (2.0f / (float)SHEET_SIDE) - 1.0f;
}

/* Returns the length in cells of the torn paper that hangs from the edge of a hole at the cell
 * `edge`. The length varies along the edge, so that some places have a long flap. */
static float flap_cells(uint32_t edge)
{
    const float x = line_at(edge % SHEET_SIDE), z = line_at(edge / SHEET_SIDE);
    const float wave = f_sin(6.1f * x + 3.0f * z + 0.7f) + f_sin(5.3f * z - 2.9f * x + 2.1f);
    return f_lerp(FLAP_CELLS_SHORT, FLAP_CELLS_LONG, f_smoothstep(0.1f, 1.2f, wave));
}

/* Returns the distance between two cells, in cells. CELL_NONE is far from every cell. */
static float cell_distance(uint32_t cell, uint32_t other)
{
    const float x = (float)(cell % SHEET_SIDE) - (float)(other % SHEET_SIDE);
    const float z = (float)(cell / SHEET_SIDE) - (float)(other / SHEET_SIDE);
    return other == CELL_NONE ? 1e6f : f_sqrt(x * x + z * z);
}

/* Writes to `nearest` the cell of paper that is nearest to each cell, in two sweeps over all
 * cells. A cell takes the nearest paper of the four neighbours that the sweep has visited. */
static void find_nearest_paper(uint16_t nearest[CELL_COUNT])
{
    static const int32_t steps[4][2] = { { -1, 0 }, { -1, -1 }, { 0, -1 }, { 1, -1 } };
    for (uint32_t i = 0; i < 2u * CELL_COUNT; i++) {
        const uint32_t cell = i < CELL_COUNT ? i : 2u * CELL_COUNT - 1u - i;
        const uint32_t sign = i < CELL_COUNT ? 1u : UINT32_MAX;
        for (uint32_t k = 0; k < 4u && nearest[cell] != cell; k++) {
            const uint32_t column = cell % SHEET_SIDE + sign * (uint32_t)steps[k][0];
            const uint32_t row = cell / SHEET_SIDE + sign * (uint32_t)steps[k][1];
            const uint32_t other = row * SHEET_SIDE + column;
            if (column < SHEET_SIDE && row < SHEET_SIDE &&
                cell_distance(cell, nearest[other]) < cell_distance(cell, nearest[cell])) {
                nearest[cell] = nearest[other];
            }
        }
    }
}

/* Fills the holes in `cells` with flaps of torn paper. While a hole opens (`ages`), its flaps reach
 * almost to the place that is farthest from the edge, so that the hole is drawn as a slit there. */
static void add_flaps(const struct scene_poi *poi, const uint8_t ages[CELL_COUNT],
                      uint8_t cells[CELL_COUNT][4])
{
    uint16_t nearest[CELL_COUNT];
    float farthest = 0.0f;
    for (uint32_t cell = 0; cell < CELL_COUNT; cell++) {
        const float x = line_at(cell % SHEET_SIDE), z = line_at(cell / SHEET_SIDE);
        const bool is_paper = poi->integrity[cell] > 0 || x * x + z * z > FRINGE * FRINGE;
        nearest[cell] = is_paper ? (uint16_t)cell : CELL_NONE;
    }
    find_nearest_paper(nearest);
    for (uint32_t cell = 0; cell < CELL_COUNT; cell++) {
        farthest = f_max(farthest, cell_distance(cell, nearest[cell]));
    }
    for (uint32_t cell = 0; cell < CELL_COUNT; cell++) {
        if (poi->integrity[cell] == 0) {
            const float away = cell_distance(cell, nearest[cell]);
            const float open = (float)ages[cell] / (float)POI_OPEN_TICKS;
            const float flap = flap_cells(nearest[cell]);
            const float reach = f_lerp(f_max(SLIT * farthest, flap), flap, open);
            const float rest = 1.0f - 0.5f * away / reach;
            cells[cell][1] = FLAP_INTEGRITY;
            cells[cell][2] = (uint8_t)(255.0f * f_max(rest, 0.0f));
            cells[cell][3] =
                (uint8_t)(open * f_min(away, FLAP_CELLS_MAX) * (255.0f / FLAP_CELLS_MAX));
        }
    }
}

void poi_sheet_cells(const struct scene_poi *poi, const uint8_t ages[CELL_COUNT],
                     uint8_t cells[CELL_COUNT][4])
{
    for (uint32_t cell = 0; cell < CELL_COUNT; cell++) {
        cells[cell][0] = poi->wetness[cell];
        cells[cell][1] = poi->integrity[cell];
        cells[cell][2] = 255;
        cells[cell][3] = poi->shows_stress ? poi->stress[cell] : 0;
    }
    if (poi->paper_left < 1.0f) {
        add_flaps(poi, ages, cells);
    }
}

void poi_sheet_age(const struct scene_poi *poi, uint32_t ticks, uint8_t ages[CELL_COUNT])
{
    for (uint32_t cell = 0; cell < CELL_COUNT; cell++) {
        const uint32_t age = ages[cell] + (ticks < POI_OPEN_TICKS ? ticks : POI_OPEN_TICKS);
        ages[cell] = poi->integrity[cell] > 0 ? 0
                     : age < POI_OPEN_TICKS   ? (uint8_t)age
                                              : (uint8_t)POI_OPEN_TICKS;
    }
}

void poi_pass_prepare(struct poi_pass *pass, const struct scene *scene)
{
    const uint32_t ticks = scene->tick - pass->tick;
    pass->tick = scene->tick;
    gl_bind_texture(0, GL_TEXTURE_2D_ARRAY, gl_ring_turn(&pass->sheet_ring));
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct scene_poi *const poi = &scene->poi[i];
        if (!poi->present) {
            continue;
        }
        poi_sheet_age(poi, ticks, pass->ages[i]);
        poi_sheet_cells(poi, pass->ages[i], pass->cells);
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, (GLint)i, SHEET_SIDE, SHEET_SIDE, 1, GL_RGBA,
                        GL_UNSIGNED_BYTE, pass->cells);
    }
}

/* Returns the height in metres of the highest point of the poi if `sign` is 1. Returns the height
 * of the lowest point, times -1, if `sign` is -1. */
static float extent(const struct scene_poi *poi, float sign)
{
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const float steep = f_sqrt(f_max(1.0f - axes.up.y * axes.up.y, 0.0f));
    const float reach = f_max(RING_REACH * steep, HANDLE_REACH * sign * axes.back.y);
    return sign * poi->position_m.y + poi->ring_radius_m * (reach + THICKNESS) + poi->sag_m;
}

bool poi_is_below(const struct scene_poi *poi)
{
    return poi->present && extent(poi, -1.0f) > 0.0f;
}

bool poi_is_above(const struct scene_poi *poi)
{
    return poi->present && extent(poi, 1.0f) > 0.0f;
}

/* Height in metres above or below the water, up to which a poi makes the refraction smaller. */
#define CALM_HEIGHT_M 0.030f
/* Width in metres of the soft edge, around the ring, of the area with smaller refraction. */
#define CALM_EDGE_M 0.02f

float poi_calm_reach_m(const struct scene_poi *poi)
{
    return RING_REACH * poi->ring_radius_m + CALM_EDGE_M;
}

float poi_refraction_share(const struct scene_poi *poi, const struct basis *axes, float x_m,
                           float z_m)
{
    const vec3 off = v3(x_m - poi->position_m.x, 0.0f, z_m - poi->position_m.z);
    const float away_m = v3_length(off);
    const float reach_m = poi_calm_reach_m(poi);
    /* The plane of a steep poi has no height beside the poi. */
    const float steep = f_max(f_abs(axes->up.y), 0.2f) * (axes->up.y < 0.0f ? -1.0f : 1.0f);
    const float height_m = poi->position_m.y - v3_dot(off, axes->up) / steep;
    return f_max(f_smoothstep(0.0f, CALM_HEIGHT_M, f_abs(height_m)),
                 f_smoothstep(reach_m - CALM_EDGE_M, reach_m, away_m));
}

void poi_pose_of_axes(float out[16], vec3 position_m, const struct basis *axes, float scale)
{
    CORE_ASSERT(scale > 0.0f);
    const vec3 columns[4] = { v3_scale(axes->right, scale), v3_scale(axes->up, scale),
                              v3_scale(axes->back, scale), position_m };
    for (uint32_t i = 0; i < 4; i++) {
        const float column[4] = { columns[i].x, columns[i].y, columns[i].z, i == 3u ? 1.0f : 0.0f };
        memcpy(out + 4u * i, column, sizeof column);
    }
}

void poi_pose(float out[16], vec3 position_m, struct angles angles, float scale)
{
    const struct basis axes = vec_basis_from_angles(angles);
    poi_pose_of_axes(out, position_m, &axes, scale);
}

void poi_pass_frame(const struct poi_pass *pass, const struct scene_poi *poi)
{
    float pose[16];
    const struct basis axes = scene_handle_axes(poi);
    poi_pose_of_axes(pose, poi->position_m, &axes, poi->ring_radius_m);
    glUseProgram(pass->frame_program);
    glUniformMatrix4fv(pass->frame_pose, 1, GL_FALSE, pose);
    glUniform4fv(pass->frame_paint, 1, poi_paint(poi->owner));
    glEnable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    shape_draw(&pass->solid);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
}

void poi_pass_paper(const struct poi_pass *pass, const struct scene *scene, uint32_t index,
                    const struct textures *textures, bool is_below)
{
    CORE_ASSERT(index < POI_MAX && scene->fish_count <= SCENE_FISH_MAX);
    const struct scene_poi *const poi = &scene->poi[index];
    float pose[16], rests[RESTS_MAX][4] = { 0 }, spines[RESTS_MAX][3] = { 0 };
    poi_pose(pose, poi->position_m, poi->angles, poi->ring_radius_m);
    /* The first RESTS_MAX fish on the paper darken the paper. In `rests`, an entry with a fish
     * length of 0 is unused. */
    for (uint32_t i = 0, count = 0; i < scene->fish_count && count < RESTS_MAX; i++) {
        const struct scene_fish *const fish = &scene->fish[i];
        const vec3 at = fish->position_m;
        const float away_m = v3_length(v3_sub(at, poi->position_m));
        if (fish->place == SCENE_ON_POI && away_m <= poi->ring_radius_m * 1.5f) {
            const vec3 back = vec_basis_from_angles(fish->angles).back;
            memcpy(rests[count], (const float[4]){ at.x, at.y, at.z, fish->length_m },
                   sizeof rests[count]);
            memcpy(spines[count], (const float[3]){ back.x, back.y, back.z }, sizeof spines[count]);
            count++;
        }
    }
    const struct poi_pool pool = poi_pool_of(poi);
    const uint32_t variant = (pool.level_m > POI_NO_POOL_M ? PAPER_POOL : 0u) |
                             (poi->shows_stress ? PAPER_PRACTICE : 0u);
    const struct paper_program *const program = &pass->papers[variant];
    glUseProgram(program->name);
    gl_bind_texture(0, GL_TEXTURE_2D_ARRAY, gl_ring_texture(&pass->sheet_ring));
    gl_bind_texture(1, GL_TEXTURE_2D, textures->paper);
    glUniformMatrix4fv(program->pose, 1, GL_FALSE, pose);
    glUniform4fv(program->rests, RESTS_MAX, rests[0]);
    glUniform3fv(program->spines, RESTS_MAX, spines[0]);
    glUniform4f(program->paper, poi->sag_m / poi->ring_radius_m, (float)index,
                is_below ? 1.0f : 0.0f, poi->warning);
    glUniform2f(program->pool, pool.level_m, f_smoothstep(0.0f, FILM_SHINES_M, pool.film_m));
    glEnable(GL_BLEND);
    shape_draw(&pass->disc);
    glDisable(GL_BLEND);
}

void poi_pass_cap(const struct poi_pass *pass, const struct scene *scene)
{
    glUseProgram(pass->cap_program);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct scene_poi *const poi = &scene->poi[i];
        if (poi->present) {
            float pose[16];
            poi_pose(pose, poi->position_m, poi->angles, poi->ring_radius_m);
            glUniformMatrix4fv(pass->cap_pose, 1, GL_FALSE, pose);
            shape_draw(&pass->disc);
        }
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}
