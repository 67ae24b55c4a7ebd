/* ui_shots.c -- draws every screen of the user interface (screens.h) for visual review, and
 * compares the screens with golden pictures.
 *
 * Usage: build/tests/golden/ui_shots OUT TEXT [BACKDROP.png]
 *        build/tests/golden/ui_shots OUT --compare GOLDEN [SCENE.png...]
 *        build/tests/golden/ui_shots OUT --keep GOLDEN [SCENE.png...]
 *
 * The first form draws each screen for players off screen in both languages and in several sizes
 * over a backdrop. TEXT is the setting SET_TEXT, the size of small texts: 0 (normal) to 2
 * (largest). The backdrop is the picture BACKDROP.png of the tank, or plain water by default. The
 * pictures are written to OUT/NAME_LANGUAGE_WIDTHxHEIGHT.png. The program also prints the time to
 * draw one screen.
 *
 * With --compare the program draws all screens in four sizes and both languages. The pictures
 * SCENE.png of the tank are added. The program compares the pictures with the golden sheets in the
 * folder GOLDEN, and writes OUT/sheet.png, which shows all pictures at once, and one larger contact
 * sheet for each size to OUT/ui-WIDTHxHEIGHT.png. The exit status is 1 if a picture differs. --keep
 * writes the golden sheets. */
#include <GLES3/gl3.h>
#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include "platform/render/ui/ui.h"
#include "tests/golden/golden_sheet.h"
#include "tests/golden/screens.h"

#define WIDTH_MAX 3840
#define HEIGHT_MAX 2160
#define COST_DRAWS 20
/* Calls of specimen_pass_work() after which the textures of all specimens are complete. */
#define SKIN_CALLS 1500

static struct specimen_pass specimens;
static struct textures textures;
static struct scene scene;
static uint8_t pixels[WIDTH_MAX * HEIGHT_MAX * 4];

static int open_context(void)
{
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
        return 0;
    }
    SDL_Window *window = SDL_CreateWindow("ui", 0, 0, 64, 64, SDL_WINDOW_OPENGL);
    return window != NULL && SDL_GL_CreateContext(window) != NULL;
}

static GLuint make_target(GLsizei width, GLsizei height)
{
    GLuint framebuffer, colour, depth;
    glGenFramebuffers(1, &framebuffer);
    glGenTextures(1, &colour);
    glBindTexture(GL_TEXTURE_2D, colour);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour, 0);
    glGenRenderbuffers(1, &depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    return framebuffer;
}

/* Fills the render target with the middle of the backdrop, scaled to the size of the target. */
static void draw_backdrop(GLuint source, int source_width, int source_height, int width, int height)
{
    glClearColor(0.10f, 0.42f, 0.52f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    if (source == 0) {
        return;
    }
    const float scale = (float)height / (float)source_height;
    const int used =
        (int)((float)width / scale) < source_width ? (int)((float)width / scale) : source_width;
    const int left = (source_width - used) / 2;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
    glBlitFramebuffer(left, 0, left + used, source_height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                      GL_LINEAR);
}

static GLuint load_backdrop(const char *path, int *width, int *height)
{
    stbi_set_flip_vertically_on_load(1);
    unsigned char *picture = path != NULL ? stbi_load(path, width, height, NULL, 4) : NULL;
    if (picture == NULL) {
        return 0;
    }
    const GLuint framebuffer = make_target(*width, *height);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, *width, *height, GL_RGBA, GL_UNSIGNED_BYTE, picture);
    stbi_image_free(picture);
    return framebuffer;
}

/* The render target and the backdrop texture, with their sizes in picture. */
struct canvas {
    GLuint target, backdrop;
    int width, height, back_width, back_height;
};

static void draw_scene(struct ui *ui, const struct canvas *canvas)
{
    const struct display_transform transform = display_transform_of(
        &(struct display_settings){ .light = 1.0f }, (float)canvas->width, (float)canvas->height);
    draw_backdrop(canvas->backdrop, canvas->back_width, canvas->back_height, canvas->width,
                  canvas->height);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->target);
    ui_draw(ui, &specimens, &scene, &transform);
}

/* Draws the screen in `scene` and reads the picture back. Returns 0 if a font lacks a letter or if
 * the screen has too many shapes. */
static int draw_screen(struct ui *ui, const struct canvas *canvas, const struct screen *screen)
{
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->target);
    draw_scene(ui, canvas);
    if (screen->kind == SCREEN_LAB || screen->kind == SCREEN_ALBUM) {
        for (uint32_t k = 0; k < SKIN_CALLS; k++) {
            specimen_pass_work(&specimens, false);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, canvas->target);
        glClear(GL_DEPTH_BUFFER_BIT);
        draw_scene(ui, canvas);
    }
    glReadPixels(0, 0, canvas->width, canvas->height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    if (ui->batch.unbaked_count > 0 || ui->batch.dropped_count > 0) {
        fprintf(stderr, "ui_shots: %s has %u letters without a glyph and %u dropped shapes\n",
                screen->name, ui->batch.unbaked_count, ui->batch.dropped_count);
        return 0;
    }
    return 1;
}

static int write_picture(const char *path, int width, int height)
{
    for (int i = 0; i < width * height; i++) {
        pixels[i * 4 + 3] = 255;
    }
    stbi_flip_vertically_on_write(1);
    return stbi_write_png(path, width, height, 4, pixels, width * 4);
}

static void print_cost(struct ui *ui, const struct canvas *canvas, const char *name)
{
    /* Draws once without measurement, because drivers complete the compilation of a shader only
     * when the shader is first used. */
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->target);
    draw_scene(ui, canvas);
    glFinish();
    /* Start of the CPU time of the process, which includes all threads of a software renderer. */
    const clock_t start = clock();
    for (int i = 0; i < COST_DRAWS; i++) {
        draw_scene(ui, canvas);
    }
    glFinish();
    const double used_s = (double)(clock() - start) / CLOCKS_PER_SEC;
    printf("%-8s %4dx%-4d %3u quads %6.2f ms of processor time\n", name, canvas->width,
           canvas->height, ui->batch.quad_count, 1e3 * used_s / COST_DRAWS);
}

/* Draws every screen for players in every size and language. Returns 1 if all pictures were drawn
 * completely and written. */
static int shoot_all(struct ui *ui, const char *out, struct canvas canvas, uint8_t text_size)
{
    static const int sizes[][2] = {
        { 1280, 720 }, { 1920, 1080 }, { 720, 1280 }, { 1024, 768 }, { 640, 360 }
    };
    char path[512];
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes * LANGUAGE_COUNT; k++) {
        const uint8_t language = (uint8_t)(k % LANGUAGE_COUNT);
        canvas.width = sizes[k / LANGUAGE_COUNT][0];
        canvas.height = sizes[k / LANGUAGE_COUNT][1];
        if (language == 0) {
            canvas.target = make_target(canvas.width, canvas.height);
        }
        for (uint32_t i = 0; i < screens_count(); i++) {
            const struct screen screen =
                screens_fill(i, language, canvas.height > canvas.width, &scene, &ui->memory);
            scene.text_size = text_size;
            if (screen.kind != SCREEN_PLAYER) {
                continue;
            }
            if (language == 0) {
                print_cost(ui, &canvas, screen.name);
            }
            snprintf(path, sizeof path, "%s/%s_%s_%dx%d.png", out, screen.name,
                     language == LANGUAGE_JA ? "ja" : "en", canvas.width, canvas.height);
            if (!draw_screen(ui, &canvas, &screen) ||
                !write_picture(path, canvas.width, canvas.height)) {
                fprintf(stderr, "ui_shots: cannot write %s\n", path);
                return 0;
            }
        }
    }
    return 1;
}

/* ---- Comparison with golden sheets ----------------------------------------------------------- */

/* Sizes of the compared screens, and sizes of their tiles on the golden sheet, on the contact sheet
 * and on the sheet of all pictures. A golden tile has 1/16 of the width of its screen, 1/24 at
 * 1920x1080. Every screen is drawn at its full size before the picture is reduced. */
static const struct compared {
    int width, height, small[2], large[2], thumb[2];
} compared[] = {
    { 1280, 720, { 80, 45 }, { 320, 180 }, { 160, 90 } },
    { 1920, 1080, { 80, 45 }, { 320, 180 }, { 160, 90 } },
    { 720, 1280, { 45, 80 }, { 180, 320 }, { 90, 160 } },
    { 1024, 768, { 64, 48 }, { 256, 192 }, { 120, 90 } },
};
#define SIZE_COUNT (sizeof compared / sizeof *compared)

#define CONTACT_COLUMNS 12u /* Tiles in a row of a golden sheet or of a contact sheet. */
#define SHEET_WIDTH 3840    /* Width of the sheet of all pictures, in pixels. */

/* Folders, and the sheets with all pictures: one for each size, and one for the scenes. */
struct gallery {
    const char *out, *golden;
    bool keeps;
    struct golden_sheet thumbs[SIZE_COUNT + 1u];
};

static int open_thumbs(struct gallery *gallery, uint32_t index, const int tile[2])
{
    return golden_sheet_open(&gallery->thumbs[index], tile[0], tile[1],
                             (uint32_t)(SHEET_WIDTH / tile[0]));
}

/* Compares `sheet` with the golden sheet `name`, or writes the golden sheet if the gallery keeps
 * new sheets. Returns 1 if all pictures are as they must be. */
static int judge(const struct gallery *gallery, const struct golden_sheet *sheet, const char *name)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s.png", gallery->golden, name);
    if (!gallery->keeps) {
        return golden_sheet_compare(sheet, path) == 0;
    }
    printf("%s: %u pictures, kept\n", path, sheet->count);
    return golden_sheet_write(sheet, path);
}

/* Draws all screens of the size number `index`, and compares them. Returns 1 if all screens are as
 * they must be. */
static int compare_size(struct ui *ui, struct gallery *gallery, uint32_t index)
{
    const struct compared *const size = &compared[index];
    struct golden_sheet large, small, *const thumbs = &gallery->thumbs[index];
    struct canvas canvas = { .width = size->width, .height = size->height };
    char path[512], name[32];
    if (!golden_sheet_open(&large, size->large[0], size->large[1], CONTACT_COLUMNS) ||
        !golden_sheet_open(&small, size->small[0], size->small[1], CONTACT_COLUMNS) ||
        !open_thumbs(gallery, index, size->thumb)) {
        return 0;
    }
    canvas.target = make_target(canvas.width, canvas.height);
    int all = 1;
    for (uint32_t i = 0; i < screens_count() * LANGUAGE_COUNT; i++) {
        const uint8_t language = (uint8_t)(i % LANGUAGE_COUNT);
        const struct screen screen = screens_fill(i / LANGUAGE_COUNT, language,
                                                  size->height > size->width, &scene, &ui->memory);
        all &= draw_screen(ui, &canvas, &screen);
        snprintf(name, sizeof name, "%s %s", screen.name, language == LANGUAGE_JA ? "ja" : "en");
        golden_sheet_add(&large, name, pixels, canvas.width, canvas.height);
        golden_sheet_add(&small, name, pixels, canvas.width, canvas.height);
        golden_sheet_add(thumbs, name, pixels, canvas.width, canvas.height);
    }
    snprintf(path, sizeof path, "%s/ui-%dx%d.png", gallery->out, size->width, size->height);
    all &= golden_sheet_write(&large, path);
    snprintf(name, sizeof name, "ui-%dx%d", size->width, size->height);
    all &= judge(gallery, &small, name);
    golden_sheet_close(&large);
    golden_sheet_close(&small);
    return all;
}

/* Compares `count` pictures of the tank with the golden sheet of scenes. Returns 1 if all pictures
 * are as they must be. */
static int compare_scenes(struct gallery *gallery, char **paths, uint32_t count)
{
    static const int thumb[2] = { 320, 180 };
    struct golden_sheet small, *const thumbs = &gallery->thumbs[SIZE_COUNT];
    if (!golden_sheet_open(&small, compared[0].small[0], compared[0].small[1], CONTACT_COLUMNS) ||
        !open_thumbs(gallery, SIZE_COUNT, thumb)) {
        return 0;
    }
    stbi_set_flip_vertically_on_load(1);
    int all = 1;
    for (uint32_t i = 0; i < count; i++) {
        int width, height;
        uint8_t *const picture = stbi_load(paths[i], &width, &height, NULL, 4);
        if (picture == NULL) {
            fprintf(stderr, "ui_shots: %s: no picture\n", paths[i]);
            all = 0;
            continue;
        }
        const char *const slash = strrchr(paths[i], '/');
        const char *const name = slash != NULL ? slash + 1 : paths[i];
        golden_sheet_add(&small, name, picture, width, height);
        golden_sheet_add(thumbs, name, picture, width, height);
        stbi_image_free(picture);
    }
    all &= judge(gallery, &small, "scenes");
    golden_sheet_close(&small);
    return all;
}

static int compare_all(struct ui *ui, struct gallery *gallery, char **scenes, uint32_t scene_count)
{
    char path[512];
    int all = 1;
    for (uint32_t i = 0; i < SIZE_COUNT; i++) {
        all &= compare_size(ui, gallery, i);
    }
    if (scene_count > 0) {
        all &= compare_scenes(gallery, scenes, scene_count);
    }
    snprintf(path, sizeof path, "%s/sheet.png", gallery->out);
    all &= golden_sheet_write_stack(gallery->thumbs, SIZE_COUNT + (scene_count > 0), path);
    printf("%s\n", path);
    for (uint32_t i = 0; i <= SIZE_COUNT; i++) {
        golden_sheet_close(&gallery->thumbs[i]);
    }
    return all;
}

/* ---- Command line ---------------------------------------------------------------------------- */

static int open_ui(struct ui *ui)
{
    char why[256];
    SDL_setenv("SDL_VIDEODRIVER", "offscreen", 0);
    if (!open_context()) {
        fprintf(stderr, "ui_shots: no OpenGL ES 3 context: %s\n", SDL_GetError());
        return 0;
    }
    struct gl_status status = { 0 };
    textures_open(&status, &textures);
    specimen_pass_open(&status, &specimens, &textures);
    if (!gl_is_well(&status)) {
        fprintf(stderr, "ui_shots: %s\n", status.text);
        return 0;
    }
    if (!ui_init(ui, why, sizeof why)) {
        fprintf(stderr, "ui_shots: %s\n", why);
        return 0;
    }
    return 1;
}

int main(int count, char **arguments)
{
    static struct ui ui;
    const bool keeps = count >= 4 && strcmp(arguments[2], "--keep") == 0;
    const bool compares = keeps || (count >= 4 && strcmp(arguments[2], "--compare") == 0);
    const bool has_size =
        count > 2 && strlen(arguments[2]) == 1 && arguments[2][0] >= '0' && arguments[2][0] <= '2';
    if (!compares && (!has_size || count > 4)) {
        fputs("usage: ui_shots OUT TEXT [BACKDROP.png], with a TEXT from 0 to 2\n"
              "       ui_shots OUT --compare|--keep GOLDEN [SCENE.png...]\n",
              stderr);
        return 2;
    }
    if (!open_ui(&ui)) {
        return 1;
    }
    if (compares) {
        struct gallery gallery = { .out = arguments[1], .golden = arguments[3], .keeps = keeps };
        return compare_all(&ui, &gallery, arguments + 4, (uint32_t)count - 4u) ? 0 : 1;
    }
    struct canvas canvas = { 0 };
    canvas.backdrop =
        load_backdrop(count > 3 ? arguments[3] : NULL, &canvas.back_width, &canvas.back_height);
    if (!shoot_all(&ui, arguments[1], canvas, (uint8_t)(arguments[2][0] - '0'))) {
        return 74;
    }
    ui_close(&ui);
    specimen_pass_close(&specimens);
    return 0;
}
