/* renderer.c -- the order of a frame. */
#include "platform/render/renderer.h"

#include <stdio.h>
#include <string.h>

#ifndef GL_CONTEXT_LOST_KHR
#define GL_CONTEXT_LOST_KHR 0x0507 /* GL_KHR_robustness; drivers without it never say so. */
#endif

static const char *gl_string(GLenum name)
{
    const char *const text = (const char *)glGetString(name);
    return text ? text : "unknown";
}

/* "OpenGL ES 3.2 Mesa 22.3.6" and "llvmpipe (LLVM 15.0.6, 256 bits)" become one short name. */
static void name_context(struct renderer *renderer)
{
    const char *const version = gl_string(GL_VERSION);
    const char *const device = gl_string(GL_RENDERER);
    const size_t prefix = strlen("OpenGL ES ");
    const int version_length =
        (int)(strlen(version) > prefix ? prefix + strcspn(version + prefix, " ") : strlen(version));
    snprintf(renderer->gl_name, sizeof renderer->gl_name, "%.*s %.*s", version_length, version,
             (int)strcspn(device, "("), device);
    const size_t length = strlen(renderer->gl_name);
    if (length && renderer->gl_name[length - 1] == ' ') {
        renderer->gl_name[length - 1] = '\0';
    }
}

static uint32_t scaled(uint32_t size, float scale)
{
    const float pixels = (float)size * scale + 0.5f;
    return pixels < 1.0f ? 1u : (uint32_t)pixels;
}

static void open_targets(struct renderer *renderer)
{
    const uint32_t width = renderer->config.width;
    const uint32_t height = renderer->config.height;
    const struct quality best = quality_choose(&(struct quality_wish){
        .renderer = gl_string(GL_RENDERER),
        .width = width,
        .height = height,
        .scene_scale = renderer->config.scene_scale,
        .samples = renderer->config.samples,
        .samples_max = renderer->samples_max,
        .side_max = renderer->side_max,
    });
    renderer->quality = quality_lower(&best, renderer->step);
    const struct quality *const quality = &renderer->quality;
    gl_target_open(&renderer->status, "ground", &renderer->ground,
                   &(struct gl_target_desc){ .internal_format = GL_RGBA8,
                                             .width = scaled(width, quality->floor_scale),
                                             .height = scaled(height, quality->floor_scale) });
    gl_target_open(&renderer->status, "life", &renderer->life,
                   &(struct gl_target_desc){ .internal_format = GL_RGBA8,
                                             .width = scaled(width, quality->scene_scale),
                                             .height = scaled(height, quality->scene_scale),
                                             .samples = quality->samples,
                                             .depth = true });
    if (quality->samples > 1) {
        gl_target_open(&renderer->status, "screen", &renderer->screen,
                       &(struct gl_target_desc){ .internal_format = GL_RGBA8,
                                                 .width = width,
                                                 .height = height,
                                                 .samples = quality->samples,
                                                 .depth = true });
    }
}

static void close_targets(struct renderer *renderer)
{
    gl_target_close(&renderer->ground);
    gl_target_close(&renderer->life);
    gl_target_close(&renderer->screen);
}

static void open_passes(struct renderer *renderer)
{
    struct gl_status *const status = &renderer->status;
    frame_open(&renderer->frame);
    textures_open(status, &renderer->textures);
    light_pass_open(status, &renderer->light);
    basin_pass_open(status, &renderer->basin);
    specimen_pass_open(status, &renderer->specimens, &renderer->textures);
    fish_pass_open(status, &renderer->fish, &renderer->specimens.memory);
    poi_pass_open(status, &renderer->poi);
    bowl_pass_open(status, &renderer->bowl);
    fan_pass_open(status, &renderer->fan);
    air_pass_open(status, &renderer->air);
    drip_pass_open(status, &renderer->drip);
    edge_pass_open(status, &renderer->edge);
    char why[HAL_TEXT_SIZE] = "";
    if (!ui_init(&renderer->ui, why, sizeof why)) {
        gl_fail(status, "words: %s", why);
    }
    renderer->ui.memory.shelf = renderer->config.shelf;
}

int renderer_open(struct renderer *renderer, const struct renderer_config *config)
{
    GLint samples_max = 1, side_max = GL_TEXTURE_SURE;
    memset(renderer, 0, sizeof *renderer);
    renderer->config = *config;
    renderer_place(renderer, &(struct showing){ .light = 1.0f });
    glGetIntegerv(GL_MAX_SAMPLES, &samples_max);
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side_max);
    renderer->samples_max = (uint32_t)samples_max;
    renderer->side_max = (uint32_t)side_max;
    name_context(renderer);
    open_passes(renderer);
    open_targets(renderer);
    return gl_is_well(&renderer->status) ? HAL_OK : HAL_ERR_GONE;
}

void renderer_close(struct renderer *renderer)
{
    close_targets(renderer);
    ui_close(&renderer->ui);
    edge_pass_close(&renderer->edge);
    drip_pass_close(&renderer->drip);
    air_pass_close(&renderer->air);
    fan_pass_close(&renderer->fan);
    bowl_pass_close(&renderer->bowl);
    poi_pass_close(&renderer->poi);
    fish_pass_close(&renderer->fish);
    specimen_pass_close(&renderer->specimens);
    basin_pass_close(&renderer->basin);
    light_pass_close(&renderer->light);
    textures_close(&renderer->textures);
    frame_close(&renderer->frame);
}

void renderer_place(struct renderer *renderer, const struct showing *showing)
{
    renderer->showing = *showing;
    renderer->placing = placing_of(showing, (float)renderer->config.width,
                                   (float)renderer->config.height);
}

int renderer_resize(struct renderer *renderer, uint32_t width, uint32_t height)
{
    if (width == renderer->config.width && height == renderer->config.height) {
        return HAL_OK;
    }
    renderer->config.width = width;
    renderer->config.height = height;
    renderer_place(renderer, &renderer->showing);
    close_targets(renderer);
    open_targets(renderer);
    return gl_is_well(&renderer->status) ? HAL_OK : HAL_ERR_GONE;
}

int renderer_lower(struct renderer *renderer, uint32_t step)
{
    if (step == renderer->step) {
        return HAL_OK;
    }
    renderer->step = step;
    close_targets(renderer);
    open_targets(renderer);
    return gl_is_well(&renderer->status) ? HAL_OK : HAL_ERR_GONE;
}

static void step_done(const struct renderer *renderer, enum render_step step)
{
    if (renderer->on_step) {
        renderer->on_step(renderer->on_step_context, step);
    }
}

/* The interface leaves its own state behind, as do other drawers in the context. */
static void reset_state(void)
{
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    glFrontFace(GL_CCW);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

static void prepare(struct renderer *renderer, const struct scene *scene)
{
    frame_begin(&renderer->frame, scene, &renderer->placing);
    fish_pass_prepare(&renderer->fish, scene, &renderer->frame.view, &renderer->quality);
    basin_pass_prepare(&renderer->basin, scene);
    poi_pass_prepare(&renderer->poi, scene);
    step_done(renderer, STEP_PREPARE);
}

static void draw_light(const struct renderer *renderer, const struct scene *scene)
{
    light_pass_caustics(&renderer->light, &renderer->textures);
    light_pass_shadows(&renderer->light, scene, &renderer->fish, &renderer->poi);
    step_done(renderer, STEP_LIGHT);
}

static void draw_ground(const struct renderer *renderer)
{
    gl_target_bind(&renderer->ground);
    glClearColor(0.05f, 0.24f, 0.30f, 1.0f); /* Refraction may look a little past the walls. */
    glClear(GL_COLOR_BUFFER_BIT);
    basin_pass_ground(&renderer->basin, renderer->light.caustics.texture,
                      renderer->light.shadows.texture);
    step_done(renderer, STEP_GROUND);
}

/* Everything below the surface but the tank: opaque bodies, then what lets light through, from the
 * bottom up. */
static void draw_life(const struct renderer *renderer, const struct scene *scene)
{
    const GLuint caustics = renderer->light.caustics.texture;
    gl_target_bind(&renderer->life);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    for (enum fish_group group = FISH_FAR; group <= FISH_ON_POI; group++) {
        fish_pass_bodies(&renderer->fish, group, &renderer->textures, caustics);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->bowl[i].present) {
            bowl_pass_hull(&renderer->bowl, &scene->bowl[i], caustics);
        }
        if (poi_is_below(&scene->poi[i])) {
            poi_pass_frame(&renderer->poi, &scene->poi[i]);
        }
    }
    air_pass_draw(&renderer->air, scene);
    for (enum fish_group group = FISH_FAR; group <= FISH_GULPING; group++) {
        fish_pass_fins(&renderer->fish, group, caustics);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (poi_is_below(&scene->poi[i])) {
            poi_pass_paper(&renderer->poi, scene, i, &renderer->textures);
        }
    }
    fish_pass_fins(&renderer->fish, FISH_ON_POI, caustics);
    gl_target_resolve(&renderer->life);
    step_done(renderer, STEP_LIFE);
}

static void bind_screen(const struct renderer *renderer)
{
    if (renderer->screen.framebuffer) {
        gl_target_bind(&renderer->screen);
    } else {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, (GLsizei)renderer->config.width, (GLsizei)renderer->config.height);
    }
}

/* The water writes depth, so what is drawn after it shows only above it; each bowl's mouth is then
 * opened again. */
static void draw_surface(const struct renderer *renderer, const struct scene *scene)
{
    bind_screen(renderer);
    glClearColor(0.02f, 0.015f, 0.02f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    basin_pass_water(&renderer->basin, &renderer->textures, renderer->ground.texture,
                     renderer->life.texture);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->bowl[i].present) {
            bowl_pass_hole(&renderer->bowl, &scene->bowl[i]);
        }
    }
    step_done(renderer, STEP_SURFACE);
}

static void draw_bowls(const struct renderer *renderer, const struct scene *scene)
{
    const GLuint caustics = renderer->light.caustics.texture;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->bowl[i].present) {
            bowl_pass_shell(&renderer->bowl, &scene->bowl[i], caustics);
        }
    }
    fish_pass_bodies(&renderer->fish, FISH_IN_BOWL, &renderer->textures, caustics);
    fish_pass_fins(&renderer->fish, FISH_IN_BOWL, caustics);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->bowl[i].present) {
            bowl_pass_water(&renderer->bowl, &scene->bowl[i]);
        }
    }
}

static void draw_pois(const struct renderer *renderer, const struct scene *scene)
{
    const GLuint caustics = renderer->light.caustics.texture;
    fish_pass_bodies(&renderer->fish, FISH_ON_POI, &renderer->textures, caustics);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (poi_is_above(&scene->poi[i])) {
            poi_pass_paper(&renderer->poi, scene, i, &renderer->textures);
            poi_pass_frame(&renderer->poi, &scene->poi[i]); /* Its outline fades over the paper. */
        }
    }
    fish_pass_fins(&renderer->fish, FISH_ON_POI, caustics);
}

/* What stands out of the water, without its tint: the surface hides the rest by its depth. */
static void draw_snouts(const struct renderer *renderer)
{
    fish_pass_rings(&renderer->fish);
    fish_pass_snouts(&renderer->fish, &renderer->textures, renderer->light.caustics.texture);
}

/* The rim may stand before a bowl and is always behind a poi; a fan is over all of them. */
static void draw_above(const struct renderer *renderer, const struct scene *scene)
{
    draw_snouts(renderer);
    draw_bowls(renderer, scene);
    basin_pass_deck(&renderer->basin, &renderer->textures);
    drip_pass_draw(&renderer->drip, scene);
    draw_pois(renderer, scene);
    glDisable(GL_DEPTH_TEST);
    fan_pass_draw(&renderer->fan, scene, &renderer->textures);
    step_done(renderer, STEP_ABOVE);
}

/* Brings a multisampled picture to the default framebuffer. */
static void finish_screen(const struct renderer *renderer)
{
    static const GLenum spent = GL_DEPTH;
    const struct gl_target *const screen = &renderer->screen;
    if (!screen->framebuffer) {
        glInvalidateFramebuffer(GL_FRAMEBUFFER, 1, &spent); /* Words need no depth. */
        return;
    }
    const GLint width = (GLint)renderer->config.width;
    const GLint height = (GLint)renderer->config.height;
    gl_target_resolve(screen);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, screen->resolve);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
}

static void draw_tank(struct renderer *renderer, const struct scene *scene)
{
    prepare(renderer, scene);
    draw_light(renderer, scene);
    draw_ground(renderer);
    draw_life(renderer, scene);
    draw_surface(renderer, scene);
    draw_above(renderer, scene);
}

/* In a round the fish of lab and album can wait. */
static void draw_ui(struct renderer *renderer, const struct scene *scene)
{
    if (scene->phase != PHASE_READY && scene->phase != PHASE_ROUND) {
        specimen_pass_work(&renderer->specimens, true);
    }
    ui_draw(&renderer->ui, &renderer->specimens, scene, &renderer->placing);
}

/* Lab and album cover the tank. Their specimens get what samples there are. */
static void draw_page(struct renderer *renderer, const struct scene *scene)
{
    bind_screen(renderer);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_ui(renderer, scene);
    finish_screen(renderer);
}

void renderer_draw(struct renderer *renderer, const struct scene *scene)
{
    reset_state();
    if (renderer->placing.light <= 0.0f) {
        edge_pass_night();
        return;
    }
    if (scene->phase == PHASE_LAB || scene->phase == PHASE_ALBUM) {
        draw_page(renderer, scene);
    } else {
        draw_tank(renderer, scene);
        finish_screen(renderer);
        draw_ui(renderer, scene);
    }
    edge_pass_draw(&renderer->edge, &renderer->placing);
    step_done(renderer, STEP_UI);
}

int renderer_read(struct renderer *renderer, struct hal_image *image)
{
    const uint32_t width = renderer->config.width;
    const uint32_t height = renderer->config.height;
    const size_t row = (size_t)width * 3u;
    image->width = width;
    image->height = height;
    if (image->size < row * height || width > RENDERER_WIDTH_MAX) {
        return HAL_ERR_IO;
    }
    /* OpenGL's first row is the lowest, and RGBA is the one layout that every ES 3 driver reads. */
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (uint32_t y = 0; y < height; y++) {
        uint8_t *out = image->rgb + row * (height - 1u - y);
        glReadPixels(0, (GLint)y, (GLsizei)width, 1, GL_RGBA, GL_UNSIGNED_BYTE, renderer->row);
        for (uint32_t x = 0; x < width; x++, out += 3) {
            memcpy(out, renderer->row + x * 4u, 3);
        }
    }
    return HAL_OK;
}

bool renderer_is_alive(struct renderer *renderer)
{
    const GLenum error = glGetError();
    if (error == GL_OUT_OF_MEMORY) {
        gl_fail(&renderer->status, "OpenGL is out of memory");
    } else if (error == GL_CONTEXT_LOST_KHR) {
        gl_fail(&renderer->status, "the graphics driver has reset");
    }
    return gl_is_well(&renderer->status);
}

const char *renderer_error(const struct renderer *renderer)
{
    return renderer->status.text;
}

void renderer_describe(const struct renderer *renderer, char *out, size_t size)
{
    const struct quality *const quality = &renderer->quality;
    const int length = snprintf(out, size, "%s, %ux%u, scene %.2gx, floor %.2gx", renderer->gl_name,
                                renderer->config.width, renderer->config.height,
                                (double)quality->scene_scale, (double)quality->floor_scale);
    if (quality->samples > 1 && length > 0 && (size_t)length < size) {
        snprintf(out + length, size - (size_t)length, ", %u samples", quality->samples);
    }
}
