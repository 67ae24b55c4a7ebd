/* bake.c -- the command line of the bake. Each run bakes one asset, so that make rebuilds only the
 * assets that changed. The files are read and written with plain stdio, because only make runs the
 * bake, on files of the source tree, and deletes the output of a failed run. */
#include "assets/bake/bake.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "platform/os/exit_code.h"

#define BLANKS " \t\r\n\v\f"

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
    struct stat about;
    FILE *file = fopen(path, "rb");
    if (file == NULL || fstat(fileno(file), &about) != 0) {
        bake_fail("cannot read %s: %s", path, strerror(errno));
    }
    uint8_t *bytes = bake_alloc((size_t)about.st_size + 1);
    *size = fread(bytes, 1, (size_t)about.st_size, file);
    if (*size != (size_t)about.st_size) {
        bake_fail("cannot read %s: the file ended early", path);
    }
    fclose(file);
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

char *bake_trim(char *text)
{
    text += strspn(text, BLANKS);
    char *end = text + strlen(text);
    while (end > text && strchr(BLANKS, end[-1])) {
        *--end = '\0';
    }
    return text;
}

void bake_read_lines(const char *path,
                     void (*read_line)(void *self, const char *path, char *line, uint32_t number),
                     void *self)
{
    size_t size;
    char *rest = (char *)bake_read(path, &size);
    /* The lines are never freed, because the tables that are read from them refer to their texts.
     * NOLINTNEXTLINE(clang-analyzer-unix.Malloc) */
    for (uint32_t number = 1; rest; number++) {
        char *line = bake_trim(strsep(&rest, "\n"));
        if (line[0] != '\0' && line[0] != '#') {
            read_line(self, path, line, number);
        }
    }
}

void bake_put_capitals(FILE *file, const char *words)
{
    for (const char *c = words; *c != '\0'; c++) {
        fputc(toupper((unsigned char)*c), file);
    }
}

/* Writes the sizes of the baked assets as a C header. */
static void header_bake(char **paths)
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
        { "PATTERN_LAYERS", PATTERN_LAYERS, "From all red to nearly white." },
        { "ENVIRONMENT_SIZE", ENVIRONMENT_SIZE, "RGB8; uv = .5 + .5 dir.xz / (1 + dir.y)." },
        { "BACKDROP_WIDTH", BACKDROP_WIDTH, "RGB8; night, then day; row 0 is the street." },
        { "BACKDROP_HEIGHT", BACKDROP_HEIGHT, "Rows of each of the two pictures." },
        { "WOOD_SIZE", WOOD_SIZE, "R8; tiles; grain runs along x." },
        { "PAPER_SIZE", PAPER_SIZE, "R8; tiles; 128 is plain paper." },
        { "FONT_WIDTH", FONT_ATLAS_WIDTH, "R8; ASSET_FONT_ROWS and _PAGES are in fonts.h." },
        { "FONT_EDGE", FONT_EDGE, "Value on an outline." },
        { "FONT_STEP", FONT_STEP, "Value per atlas pixel of distance." },
    };
    FILE *file = bake_open(paths[0]);
    fputs("/* assets.h -- sizes and names of the baked assets; written by assets/bake. */\n"
          "#ifndef KINGYO_GENERATED_ASSETS_H\n#define KINGYO_GENERATED_ASSETS_H\n\n"
          "#include <stdint.h>\n\n",
          file);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        fprintf(file, "#define ASSET_%s %uu /* %s */\n", numbers[i].name, numbers[i].value,
                numbers[i].why);
    }
    fputs("\n/* Texels, row 0 first, channels interleaved, rows unpadded. */\n", file);
    static const char *const blobs[] = { "caustics", "patterns", "environment", "backdrop",
                                         "wood",     "paper",    "font" };
    for (size_t i = 0; i < sizeof blobs / sizeof *blobs; i++) {
        fprintf(file, "extern const uint8_t asset_%s[];\n", blobs[i]);
    }
    fputs("\n#endif\n", file);
    bake_close(file, paths[0]);
}

/* List of all assets. For a texture, an entry has the size of the texels and a function that fills
 * them. For any other asset, an entry has a function that writes the files. */
static const struct asset {
    const char *name, *usage;
    int path_count; /* Number of paths that the asset expects on the command line. */
    size_t size;
    void (*fill)(uint8_t *texels);
    void (*bake)(char **paths);
} assets[] = {
    { "caustics", "FILE", 1, (size_t)CAUSTICS_SIZE *CAUSTICS_SIZE *CAUSTICS_FRAMES, bake_caustics,
      NULL },
    { "patterns", "FILE", 1, (size_t)PATTERN_WIDTH *PATTERN_HEIGHT *PATTERN_LAYERS * 2u,
      bake_patterns, NULL },
    { "environment", "FILE", 1, (size_t)ENVIRONMENT_SIZE *ENVIRONMENT_SIZE * 3u, bake_environment,
      NULL },
    { "backdrop", "FILE", 1, (size_t)BACKDROP_WIDTH *BACKDROP_HEIGHT * 6u, bake_backdrop, NULL },
    { "wood", "FILE", 1, (size_t)WOOD_SIZE *WOOD_SIZE, bake_wood, NULL },
    { "paper", "FILE", 1, (size_t)PAPER_SIZE *PAPER_SIZE, bake_paper, NULL },
    { "header", "FILE", 1, 0, NULL, header_bake },
    { "text", "DIRECTORY KEYS.h TABLE.c", 3, 0, NULL, text_bake },
    { "font", "DIRECTORY ATLAS TABLE.c FONTS.h", 4, 0, NULL, font_bake },
    { "words", "refused.txt TABLE.c", 2, 0, NULL, words_bake },
};
#define ASSET_COUNT (sizeof assets / sizeof assets[0])

int main(int count, char **arguments)
{
    for (size_t i = 0; i < ASSET_COUNT; i++) {
        const struct asset *asset = &assets[i];
        if (count != 2 + asset->path_count || strcmp(arguments[1], asset->name) != 0) {
            continue;
        }
        if (asset->bake) {
            asset->bake(arguments + 2);
        } else {
            uint8_t *texels = bake_alloc(asset->size);
            asset->fill(texels);
            bake_write(arguments[2], texels, asset->size);
            free(texels);
        }
        printf("  BAKE  %s\n", asset->name);
        return EXIT_SUCCESS;
    }
    for (size_t i = 0; i < ASSET_COUNT; i++) {
        fprintf(stderr, "%s bake %s %s\n", i == 0 ? "usage:" : "      ", assets[i].name,
                assets[i].usage);
    }
    return EXIT_USAGE;
}
