/* renderer.c -- draws one frame by calling the render passes in order. */
#include "platform/render/renderer.h"

#include "core/base/panic.h"

static void step_done(const struct renderer *renderer, enum render_step step)
{
    CORE_ASSERT(step < STEP_COUNT);
    if (renderer->on_step) {
        renderer->on_step(renderer->on_step_context, step);
    }
}

/* Draws all objects below the water surface except the tank. Opaque bodies are drawn first. Then
 * translucent objects are drawn from the lowest to the highest. */
static void draw_life(const struct renderer *renderer, const struct scene *scene)
{
    const GLuint caustics = renderer->light.caustics.texture;
    gl_target_bind(&renderer->life);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    for (enum fish_group group = FISH_SMALL; group <= FISH_ON_POI; group++) {
        fish_pass_bodies(&renderer->fish, group, false, &renderer->textures, caustics);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->bowl[i].present) {
            bowl_pass_hull(&renderer->bowl, &scene->bowl[i]);
        }
        if (poi_is_below(&scene->poi[i])) {
            poi_pass_frame(&renderer->poi, &scene->poi[i]);
        }
    }
    quad_pass_air(&renderer->quad, scene, false);
    quad_pass_scraps(&renderer->quad, scene);
    for (enum fish_group group = FISH_SMALL; group <= FISH_GULPING; group++) {
        fish_pass_fins(&renderer->fish, group, caustics);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (poi_is_below(&scene->poi[i])) {
            poi_pass_paper(&renderer->poi, scene, i, &renderer->textures, true);
        }
    }
    fish_pass_fins(&renderer->fish, FISH_ON_POI, caustics);
    gl_target_resolve(&renderer->life);
    step_done(renderer, STEP_LIFE);
}

static void bind_default(const struct renderer *renderer)
{
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, (GLsizei)renderer->config.width, (GLsizei)renderer->config.height);
}

static void bind_screen(const struct renderer *renderer)
{
    if (renderer->screen.framebuffer) {
        gl_target_bind(&renderer->screen);
    } else {
        bind_default(renderer);
    }
}

/* Binds the target for a page of words and specimens, which is never smaller than the screen. */
static void bind_page(const struct renderer *renderer)
{
    if (renderer->screen.resolve) {
        gl_target_bind(&renderer->screen);
    } else {
        bind_default(renderer);
    }
}

/* Draws the inside of the bowls, which the tank's water surface must not cover. Drawing the inside
 * first also saves the pixels of the tank's water that the bowls hide. */
static void draw_bowl_contents(const struct renderer *renderer, const struct scene *scene)
{
    const GLuint caustics = renderer->light.caustics.texture;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->bowl[i].present) {
            bowl_pass_inside(&renderer->bowl, &scene->bowl[i], caustics);
        }
    }
    fish_pass_bowl_shadows(&renderer->fish);
    fish_pass_bodies(&renderer->fish, FISH_IN_BOWL, false, &renderer->textures, caustics);
    fish_pass_fins(&renderer->fish, FISH_IN_BOWL, caustics);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->bowl[i].present) {
            bowl_pass_water(&renderer->bowl, &scene->bowl[i]);
            bowl_pass_cap(&renderer->bowl, &scene->bowl[i]);
        }
    }
}

/* Draws the objects above the water. The order of drawing gives the right overlaps: the rim may
 * hide a bowl, a poi (paper scoop) always hides the rim, and a hand-held fan hides all other
 * objects. */
static void draw_above(const struct renderer *renderer, const struct scene *scene)
{
    const GLuint caustics = renderer->light.caustics.texture;
    /* The parts of a gulping fish that are above the surface are drawn without the water's tint.
     * The depth of the surface hides the parts below the surface. */
    fish_pass_rings(&renderer->fish);
    fish_pass_bodies(&renderer->fish, FISH_GULPING_FAR, true, &renderer->textures, caustics);
    fish_pass_bodies(&renderer->fish, FISH_GULPING, true, &renderer->textures, caustics);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->bowl[i].present) {
            bowl_pass_hull(&renderer->bowl, &scene->bowl[i]);
        }
    }
    basin_pass_deck(&renderer->basin, &renderer->frame, &renderer->deck);
    quad_pass_air(&renderer->quad, scene, true);
    quad_pass_drips(&renderer->quad, scene);
    fish_pass_bodies(&renderer->fish, FISH_ON_POI, false, &renderer->textures, caustics);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (poi_is_above(&scene->poi[i])) {
            poi_pass_paper(&renderer->poi, scene, i, &renderer->textures, false);
            /* The ring and the handle are drawn after the paper because the smoothed outline of the
             * ring is blended with the paper. */
            poi_pass_frame(&renderer->poi, &scene->poi[i]);
        }
    }
    fish_pass_fins(&renderer->fish, FISH_ON_POI, caustics);
    quad_pass_spray(&renderer->quad, scene);
    poi_pass_cap(&renderer->poi, scene);
    hand_pass_draw(&renderer->hand, scene, HAND_OUTLINE);
    glDisable(GL_DEPTH_TEST);
    quad_pass_fans(&renderer->quad, scene);
    glEnable(GL_DEPTH_TEST);
    hand_pass_fans(&renderer->hand, scene);
    glDisable(GL_DEPTH_TEST);
    step_done(renderer, STEP_ABOVE);
}

/* Copies a multisampled or smaller picture to the default framebuffer. */
static void finish_screen(const struct renderer *renderer)
{
    static const GLenum spent = GL_DEPTH;
    const struct gl_target *const screen = &renderer->screen;
    if (!screen->framebuffer) {
        glInvalidateFramebuffer(GL_FRAMEBUFFER, 1, &spent); /* Invalidates the depth buffer, because
                                                               the user interface, which is drawn
                                                               next, needs no depth. */
        return;
    }
    /* A draw call copies the picture, because a driver for a tiled GPU can draw the words in the
     * same job. It begins a job of its own for glBlitFramebuffer(), which loads and stores every
     * pixel of the screen once more. The clear avoids a load of the old picture. */
    gl_target_resolve(screen);
    bind_default(renderer);
    glClear(GL_COLOR_BUFFER_BIT);
    quad_pass_copy(&renderer->quad, screen->texture);
}

static void draw_tank(struct renderer *renderer, const struct scene *scene)
{
    frame_begin(&renderer->frame, scene, &renderer->transform, renderer->screen_px,
                renderer->below_px);
    renderer_fit_below(renderer);
    fish_pass_prepare(&renderer->fish, scene, &renderer->frame, &renderer->quality);
    basin_pass_prepare(&renderer->basin, scene);
    bowl_pass_prepare(&renderer->bowl, scene, renderer->display_settings.has_white_bowls != 0);
    poi_pass_prepare(&renderer->poi, scene);
    hand_pass_prepare(&renderer->hand, scene);
    basin_pass_keep_deck(&renderer->basin, &renderer->frame, scene, &renderer->transform,
                         &renderer->deck, &renderer->textures);
    step_done(renderer, STEP_PREPARE);
    light_pass_shades(&renderer->light, &renderer->frame.shades);
    light_pass_caustics(&renderer->light, &renderer->textures);
    light_pass_shadows(&renderer->light, scene, &renderer->fish, &renderer->poi);
    step_done(renderer, STEP_LIGHT);
    frame_bind(&renderer->frame, true);
    gl_target_bind(&renderer->ground);
    /* This clear colour is visible where the shader of the water surface reads the refracted
     * picture outside the walls. */
    glClearColor(0.03f, 0.16f, 0.21f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    basin_pass_ground(&renderer->basin, renderer->light.caustics.texture,
                      renderer->light.shadows.texture);
    step_done(renderer, STEP_GROUND);
    draw_life(renderer, scene);
    gl_target_bind(&renderer->mirror);
    glClearColor(0.0f, 0.0f, 0.5f, 0.5f);
    glClear(GL_COLOR_BUFFER_BIT);
    basin_pass_mirror(&renderer->basin, &renderer->textures);
    /* The water surface writes depth, so that objects drawn later are visible only above the
     * surface. */
    frame_bind(&renderer->frame, false);
    bind_screen(renderer);
    glClearColor(0.02f, 0.015f, 0.02f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    hand_pass_draw(&renderer->hand, scene, HAND_INSIDE);
    draw_bowl_contents(renderer, scene);
    basin_pass_water(&renderer->basin, renderer->ground.texture, renderer->life.texture,
                     renderer->mirror.texture);
    step_done(renderer, STEP_SURFACE);
    draw_above(renderer, scene);
}

/* Draws the user interface. Outside a round, first spends a limited time on painting unfinished
 * fish textures, which the growth lab and the album show. */
static void draw_ui(struct renderer *renderer, const struct scene *scene)
{
    if (scene->phase != PHASE_READY && scene->phase != PHASE_ROUND) {
        specimen_pass_work(&renderer->specimens, true);
    }
    ui_draw(&renderer->ui, &renderer->specimens, scene, &renderer->transform);
}

void renderer_draw(struct renderer *renderer, const struct scene *scene)
{
    CORE_ASSERT(scene->fish_count <= SCENE_FISH_MAX);
    /* The OpenGL state is set in each frame, because the user interface and other users of the
     * context change the state. */
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    glFrontFace(GL_CCW);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    if (renderer->transform.light <= 0.0f) {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); /* At brightness 0 the screen is black, and nothing
                                                 else is drawn. */
        glClear(GL_COLOR_BUFFER_BIT);
        return;
    }
    if (scene->phase == PHASE_LAB || scene->phase == PHASE_ALBUM) {
        /* The pages of the growth lab and of the album cover the tank completely. Their specimens
         * use multisampling if multisampling is enabled. */
        bind_page(renderer);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_ui(renderer, scene);
        if (renderer->screen.resolve) {
            finish_screen(renderer);
        }
    } else {
        draw_tank(renderer, scene);
        finish_screen(renderer);
        draw_ui(renderer, scene);
    }
    quad_pass_edge(&renderer->quad, &renderer->transform);
    step_done(renderer, STEP_UI);
}
