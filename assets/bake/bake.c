/* bake.c -- the command line of the bake. Each run bakes one asset, so that make rebuilds only the
 * assets that changed. */
#include "assets/bake/bake.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "platform/os/exit_code.h"

void bake_fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("bake: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(EXIT_BAD_DATA);
}

void *bake_alloc(size_t size)
{
    void *bytes = calloc(1, size);
    if (bytes == NULL) {
        bake_fail("out of memory (%zu bytes)", size);
    }
    return bytes;
}

uint8_t *bake_read(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        bake_fail("cannot read %s: %s", path, strerror(errno));
    }
    fseek(file, 0, SEEK_END);
    const long length = ftell(file);
    rewind(file);
    if (length < 0) {
        bake_fail("cannot read %s: %s", path, strerror(errno));
    }
    uint8_t *bytes = bake_alloc((size_t)length + 1);
    if (fread(bytes, 1, (size_t)length, file) != (size_t)length) {
        bake_fail("cannot read %s: it ended early", path);
    }
    fclose(file);
    *size = (size_t)length;
    return bytes;
}

FILE *bake_open(const char *path)
{
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        bake_fail("cannot write %s: %s", path, strerror(errno));
    }
    return file;
}

void bake_close(FILE *file, const char *path)
{
    const int failed = ferror(file);
    if (fclose(file) != 0 || failed) {
        bake_fail("cannot write %s: %s", path, strerror(errno));
    }
}

void bake_write(const char *path, const void *bytes, size_t size)
{
    FILE *file = bake_open(path);
    fwrite(bytes, 1, size, file);
    bake_close(file, path);
}

void bake_header(const char *path)
{
    static const struct {
        const char *name;
        uint32_t value;
        const char *why;
    } numbers[] = {
        { "CAUSTICS_SIZE", CAUSTICS_SIZE, "R8; tiles in x and y." },
        { "CAUSTICS_FRAMES", CAUSTICS_FRAMES, "One loop, frame after frame." },
        { "PATTERN_WIDTH", PATTERN_WIDTH, "RG8: red patch, scale. Snout to tail root ..." },
        { "PATTERN_HEIGHT", PATTERN_HEIGHT, "... and round the girth from the back; wraps." },
        { "PATTERN_LAYERS", PATTERN_LAYERS, "From all red to mostly white." },
        { "ENVIRONMENT_SIZE", ENVIRONMENT_SIZE, "RGB8; uv = .5 + .5 dir.xz / (1 + dir.y)." },
        { "WOOD_SIZE", WOOD_SIZE, "R8; tiles; grain runs along x." },
        { "PAPER_SIZE", PAPER_SIZE, "R8; tiles; 128 is plain paper." },
        { "FONT_WIDTH", FONT_ATLAS_WIDTH, "R8; ASSET_FONT_ROWS and _PAGES are in fonts.h." },
        { "FONT_EDGE", FONT_EDGE, "Value on an outline." },
        { "FONT_STEP", FONT_STEP, "Value per atlas pixel of distance." },
    };
    FILE *file = bake_open(path);
    fputs("/* assets.h -- sizes and names of what was baked; written by assets/bake. */\n"
          "#ifndef KINGYO_GENERATED_ASSETS_H\n#define KINGYO_GENERATED_ASSETS_H\n\n"
          "#include <stdint.h>\n\n",
          file);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        fprintf(file, "#define ASSET_%s %uu /* %s */\n", numbers[i].name, numbers[i].value,
                numbers[i].why);
    }
    fputs("\n/* Texels, row 0 first, channels interleaved, rows unpadded. */\n", file);
    static const char *const blobs[] = { "caustics", "patterns", "environment",
                                         "wood",     "paper",    "font" };
    for (size_t i = 0; i < sizeof blobs / sizeof *blobs; i++) {
        fprintf(file, "extern const uint8_t asset_%s[];\n", blobs[i]);
    }
    fputs("\n#endif\n", file);
    bake_close(file, path);
}

static double seconds_now(void)
{
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void bake_print_asset(const char *asset, const char *path, double start_s)
{
    printf("  BAKE  %s (%s, %.1f s)\n", path, asset, seconds_now() - start_s);
}

static int bake_texture(const char *asset, const char *path)
{
    static const struct {
        const char *name;
        size_t size;
        void (*fill)(uint8_t *texels);
    } textures[] = {
        { "caustics", CAUSTICS_SIZE * CAUSTICS_SIZE * CAUSTICS_FRAMES, bake_caustics },
        { "patterns", PATTERN_WIDTH * PATTERN_HEIGHT * PATTERN_LAYERS * 2u, bake_patterns },
        { "environment", ENVIRONMENT_SIZE * ENVIRONMENT_SIZE * 3u, bake_environment },
        { "wood", WOOD_SIZE * WOOD_SIZE, bake_wood },
        { "paper", PAPER_SIZE * PAPER_SIZE, bake_paper },
    };
    for (size_t i = 0; i < sizeof textures / sizeof *textures; i++) {
        if (strcmp(textures[i].name, asset) == 0) {
            uint8_t *texels = bake_alloc(textures[i].size);
            textures[i].fill(texels);
            bake_write(path, texels, textures[i].size);
            free(texels);
            return 1;
        }
    }
    return 0;
}

static int bake_words(int count, char **arguments)
{
    static struct text_file files[TEXT_LANGUAGES];
    if (count == 5 && strcmp(arguments[1], "text") == 0) {
        text_read(files, arguments[2]);
        text_write_keys(files, arguments[3]);
        text_write_table(files, arguments[4]);
        return 1;
    }
    if (count == 6 && strcmp(arguments[1], "font") == 0) {
        const struct font_output output = { .atlas_path = arguments[3],
                                            .table_path = arguments[4],
                                            .header_path = arguments[5] };
        text_read(files, arguments[2]);
        font_bake(files, arguments[2], &output);
        return 1;
    }
    return 0;
}

int main(int count, char **arguments)
{
    const double start_s = seconds_now();
    if (count == 3 && strcmp(arguments[1], "header") == 0) {
        bake_header(arguments[2]);
        return EXIT_SUCCESS;
    }
    if (count == 3 && bake_texture(arguments[1], arguments[2])) {
        bake_print_asset(arguments[1], arguments[2], start_s);
        return EXIT_SUCCESS;
    }
    if (bake_words(count, arguments)) {
        bake_print_asset(arguments[1], arguments[3], start_s);
        return EXIT_SUCCESS;
    }
    fputs("usage: bake caustics|patterns|environment|wood|paper FILE\n"
          "       bake header FILE\n"
          "       bake text DIRECTORY KEYS.h TABLE.c\n"
          "       bake font DIRECTORY ATLAS TABLE.c FONTS.h\n",
          stderr);
    return EXIT_USAGE;
}
