/* bowl_pass.c -- draws the floating bowls. The bowl's shell is a surface of revolution. Horizontal
 * lengths are in mouth radii, and vertical lengths in bowl depths. */
#include "platform/render/pass/bowl_pass.h"

#include "core/base/panic.h"
#include "platform/render/gl_util.h"
#include "platform/render/pass/poi_pass.h"
#include "shaders.h"

#define SHELL_COLUMNS 49u
#define SHELL_ROWS 12u
#define LIP_ROWS 4u
/* Thickness of the bowl's wall in mouth radii. The value corresponds to 2 mm of enamelled steel. */
#define WALL 0.030f
#define BOTTOM 0.94f /* Depth of the bowl's inner floor below the mouth, in bowl depths. */
#define DISC_ROWS 2u

struct lathe {
    float from, to; /* Range of the parameter t of profile(). t is 0 at the bottom of the bowl and 1
                       at the lip. */
    bool outside;
};

/* Writes the radius and the height of the point `t` (0 .. 1) of the bowl's profile. The profile is
 * a superellipse, whose shape is between a cup and a dish. */
static void profile(float t, bool outside, float *r, float *y)
{
    const float angle = t * 0.5f * F_PI;
    const float grow = outside ? WALL : 0.0f;
    *r = f_exp(0.62f * f_log(f_max(f_sin(angle), 1e-7f))) + grow;
    *y = -(outside ? 1.0f : BOTTOM) * f_exp(0.85f * f_log(f_max(f_cos(angle), 1e-4f)));
}

static struct shape_vertex shell_point(float u, float v, const void *context)
{
    const struct lathe *const lathe = context;
    const float t = f_lerp(lathe->from, lathe->to, v);
    const float around = (lathe->outside ? u : -u) * -F_TAU;
    float r;
    float y;
    profile(t, lathe->outside, &r, &y);
    if (!lathe->outside && v == 1.0f) { /* The inside ends below the lip, without a gap. */
        r = 1.0f + 0.3f * WALL;
        y = 0.0f;
    }
    return (struct shape_vertex){ .position = v3(r * f_cos(around), y, r * f_sin(around)),
                                  .u = lathe->outside ? 1.0f : 0.0f,
                                  .v = t };
}

/* Returns a point of the bowl's rounded lip. `u` (0 .. 1) is the position around the bowl. `v` is 0
 * at the inner edge of the lip and 1 at the outer edge. */
static struct shape_vertex lip_point(float u, float v, const void *context)
{
    (void)context;
    const float around = u * F_TAU;
    const float turn = v * F_PI;
    const float r = 1.0f + WALL * 0.5f * (1.0f - f_cos(turn));
    return (struct shape_vertex){
        .position = v3(r * f_cos(around), WALL * 0.6f * f_sin(turn), r * f_sin(around)),
        .u = 1.0f,
        .v = 1.0f,
    };
}

static struct shape_vertex disc_point(float u, float v, const void *context)
{
    (void)context;
    const float around = -u * F_TAU;
    return (struct shape_vertex){ .position = v3(v * f_cos(around), 0.0f, v * f_sin(around)) };
}

static struct bowl_part open_part(struct gl_status *status, const char *name, const char *defines)
{
    struct bowl_part part;
    part.program =
        gl_program(status, name, defines, shader_bowl_vert, shader_bowl_frag, "caustics");
    part.mouth = glGetUniformLocation(part.program, "mouth");
    part.form = glGetUniformLocation(part.program, "form");
    part.paint = glGetUniformLocation(part.program, "paint");
    part.heel = glGetUniformLocation(part.program, "heel");
    return part;
}

void bowl_pass_open(struct gl_status *status, struct bowl_pass *pass)
{
    static const struct lathe inside = { 0.0f, 1.0f, false };
    static const struct lathe outside = { 0.25f, 1.0f, true };
    struct shape shape = { 0 };
    pass->inside_part = open_part(status, "bowl inside", "#define INSIDE\n");
    pass->hull_part = open_part(status, "bowl", "");
    pass->cap_part = open_part(status, "bowl cap", "#define CAP\n");
    pass->water_part = open_part(status, "bowl water", "#define WATER\n");
    shape_grid(&shape, SHELL_COLUMNS, SHELL_ROWS, shell_point, &inside);
    pass->hull_first = shape.index_count;
    shape_grid(&shape, SHELL_COLUMNS, SHELL_ROWS, shell_point, &outside);
    shape_grid(&shape, SHELL_COLUMNS, LIP_ROWS, lip_point, NULL);
    shape_upload(&shape, &pass->shell);
    shape.vertex_count = shape.index_count = 0;
    shape_grid(&shape, SHELL_COLUMNS, DISC_ROWS, disc_point, NULL);
    shape_upload(&shape, &pass->disc);
}

void bowl_pass_close(struct bowl_pass *pass)
{
    glDeleteProgram(pass->inside_part.program);
    glDeleteProgram(pass->hull_part.program);
    glDeleteProgram(pass->cap_part.program);
    glDeleteProgram(pass->water_part.program);
    shape_close(&pass->shell);
    shape_close(&pass->disc);
}

void bowl_pass_prepare(struct bowl_pass *pass, const struct scene *scene, bool is_white)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        count += scene->bowl[i].present;
    }
    pass->is_white = is_white;
    pass->is_plain = is_white && count < 2;
}

static void use(const struct bowl_pass *pass, const struct bowl_part *part,
                const struct scene_bowl *bowl)
{
    static const float white[4] = { 1.0f, 0.995f, 0.97f, 0.0f };
    CORE_ASSERT(bowl->radius_m > 0.0f && bowl->depth_m > 0.0f);
    const vec3 at = bowl->position_m;
    const struct basis axes = vec_basis_from_angles(bowl->angles);
    const float heel[9] = { axes.right.x, axes.right.y, axes.right.z, axes.up.x,  axes.up.y,
                            axes.up.z,    axes.back.x,  axes.back.y,  axes.back.z };
    const float level = -bowl->water_below_m / bowl->depth_m;
    glUseProgram(part->program);
    glUniformMatrix3fv(part->heel, 1, GL_FALSE, heel);
    glUniform4f(part->mouth, at.x, at.y, at.z, bowl->radius_m);
    /* The loop finds by bisection the inner radius `r` of the bowl at the height `level` of the
     * bowl's water (in bowl depths). */
    float low = 0.0f;
    float high = 1.0f;
    float r = 1.0f;
    for (int i = 0; i < 16; i++) {
        const float middle = 0.5f * (low + high);
        float height;
        profile(middle, false, &r, &height);
        if (height < level) {
            low = middle;
        } else {
            high = middle;
        }
    }
    glUniform4f(part->form, bowl->depth_m, level, r, pass->is_white ? 1.0f : 0.0f);
    glUniform4fv(part->paint, 1, pass->is_plain ? white : poi_paint(bowl->owner));
}

/* The depth function stays GL_LEQUAL. After a draw call with GL_ALWAYS, the driver of V3D switches
 * off the early depth test for the rest of the picture. */
void bowl_pass_cap(const struct bowl_pass *pass, const struct scene_bowl *bowl)
{
    use(pass, &pass->cap_part, bowl);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    shape_draw(&pass->disc);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void bowl_pass_inside(const struct bowl_pass *pass, const struct scene_bowl *bowl, GLuint caustics)
{
    gl_bind_texture(0, GL_TEXTURE_2D, caustics);
    use(pass, &pass->inside_part, bowl);
    glEnable(GL_CULL_FACE);
    shape_draw_range(&pass->shell, 0, pass->hull_first);
    glDisable(GL_CULL_FACE);
}

void bowl_pass_hull(const struct bowl_pass *pass, const struct scene_bowl *bowl)
{
    use(pass, &pass->hull_part, bowl);
    glEnable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    shape_draw_range(&pass->shell, pass->hull_first, (uint32_t)pass->shell.index_count);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
}

void bowl_pass_water(const struct bowl_pass *pass, const struct scene_bowl *bowl)
{
    use(pass, &pass->water_part, bowl);
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    shape_draw(&pass->disc);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}
