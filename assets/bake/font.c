/* font.c -- bakes the glyphs that the user interface needs, each as a signed distance field.
 *
 * assets/text/fonts.txt assigns text keys to fonts. A font gets its base set of characters and
 * every character in the texts of its keys in every language. A new text therefore adds its glyphs
 * automatically.
 *
 * The font atlas holds the glyphs' distance fields on pages of equal size, one page below the
 * other. OpenGL ES 3.0 does not guarantee textures of more than 2,048 texels a side.
 * OpenGL ES 3.0 guarantees array textures, so each page becomes one layer of an array texture. */
#include "assets/bake/bake.h"

#include <assert.h>
#include <errno.h>
#include <fnmatch.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <stb/stb_truetype.h>

#include "core/base/printable.h"

#define GLYPHS_MAX 2048u
/* Width of the margin around a glyph in atlas pixels. The margin is FONT_EDGE / FONT_STEP pixels
 * wide. Texels at this distance outside the outline have the value 0. */
#define FONT_PADDING 10
#define KEY_PATTERNS_MAX 192u
/* Largest code that a Latin font file supplies: the end of the Unicode block Latin Extended-A. */
#define LATIN_LAST 0x17fu

struct atlas {
    uint32_t page_rows;  /* Height of a page in texels, a multiple of 4 and at most
                            FONT_PAGE_ROWS_MAX. */
    uint32_t page_count; /* Number of pages, at most FONT_PAGES_MAX. */
};

/* An open font file and the factor from its units to atlas pixels. */
struct font_file {
    char path[256];
    stbtt_fontinfo info;
    float scale;
};

struct glyph {
    uint32_t code;
    const struct font_file *file; /* Font file with the outline of the glyph. */
    int index;                    /* Index of the glyph in `file`. */
    uint8_t *field; /* Distance field of width x height values. Null for a glyph without ink, such
                       as a space. */
    int width, height, left_px, top_px;
    uint32_t x, y; /* Position in the atlas. Page n begins at row n * page_rows. */
};

struct face {
    char name[32], base[16];
    char patterns[KEY_PATTERNS_MAX][32];
    uint32_t pattern_count;
    float em_px;
    /* The font file, and an optional font file whose Latin letters, digits and signs replace those
     * of `file`. The path of an absent Latin file is empty. */
    struct font_file file, latin;
    struct glyph *glyphs;
    uint32_t glyph_count;
};

/* Fonts that assets/text/fonts.txt lists. */
struct face_list {
    struct face faces[FONT_MAX];
    uint32_t count;
};

static void read_face(void *self, const char *path, char *line, uint32_t number)
{
    struct face_list *list = self;
    int length = 0;
    if (list->count == FONT_MAX) {
        bake_fail("%s:%u: more than %u fonts (FONT_MAX)", path, number, FONT_MAX);
    }
    struct face *face = &list->faces[list->count++];
    if (sscanf(line, "%31s %f %15s %255[^ \t:]:%255s %n", face->name, &face->em_px, face->base,
               face->file.path, face->latin.path, &length) < 5 &&
        sscanf(line, "%31s %f %15s %255s %n", face->name, &face->em_px, face->base, face->file.path,
               &length) < 4) {
        bake_fail("%s:%u: expected `name em-pixels set file[:latin-file] keys...`", path, number);
    }
    if (!(face->em_px >= 8.0f && face->em_px <= 256.0f)) {
        bake_fail("%s:%u: em of %g pixels is not in 8 .. 256", path, number, (double)face->em_px);
    }
    line += length;
    for (const char *key = strsep(&line, " \t"); key; key = strsep(&line, " \t")) {
        if (face->pattern_count == KEY_PATTERNS_MAX) {
            bake_fail("%s:%u: more than %u keys", path, number, KEY_PATTERNS_MAX);
        }
        snprintf(face->patterns[face->pattern_count++], sizeof face->patterns[0], "%s", key);
    }
}

static void open_file(const struct face *face, struct font_file *file)
{
    if (access(file->path, R_OK) != 0) {
        bake_fail("font %s: cannot read %s: %s; `make setup` installs the fonts", face->name,
                  file->path, strerror(errno));
    }
    size_t size;
    /* The memory is never freed, because stb_truetype reads the file's bytes until the program
     * ends. */
    const uint8_t *bytes = bake_read(file->path, &size);
    const int offset = stbtt_GetFontOffsetForIndex(bytes, 0);
    if (size < 12 || offset < 0 || !stbtt_InitFont(&file->info, bytes, offset)) {
        bake_fail("font %s: %s is not a TrueType font", face->name, file->path);
    }
    file->scale = stbtt_ScaleForMappingEmToPixels(&file->info, face->em_px);
}

static void open_face(struct face *face)
{
    open_file(face, &face->file);
    if (face->latin.path[0] != '\0') {
        open_file(face, &face->latin);
    }
    face->glyphs = bake_alloc(GLYPHS_MAX * sizeof *face->glyphs);
}

/* Returns the font file that has the best outline of a character. */
static const struct font_file *file_of(const struct face *face, uint32_t code)
{
    const bool is_latin = code <= LATIN_LAST && face->latin.path[0] != '\0';
    return is_latin && stbtt_FindGlyphIndex(&face->latin.info, (int)code) != 0 ? &face->latin
                                                                               : &face->file;
}

/* Adds a glyph, unless the font already has it. Returns false if the font files lack the character
 * or the font already has GLYPHS_MAX glyphs. */
static bool add_glyph(struct face *face, uint32_t code)
{
    assert(face->glyphs && face->glyph_count <= GLYPHS_MAX);
    for (uint32_t i = 0; i < face->glyph_count; i++) {
        if (face->glyphs[i].code == code) {
            return true;
        }
    }
    const struct font_file *file = file_of(face, code);
    const int index = stbtt_FindGlyphIndex(&file->info, (int)code);
    if (index == 0 || face->glyph_count == GLYPHS_MAX) {
        return false;
    }
    face->glyphs[face->glyph_count++] =
        (struct glyph){ .code = code, .file = file, .index = index };
    return true;
}

static void add_range(struct face *face, uint32_t first, uint32_t last)
{
    assert(first <= last);
    for (uint32_t code = first; code <= last; code++) {
        if (!add_glyph(face, code)) {
            bake_fail("font %s (%s) lacks U+%04X of its set `%s`", face->name, face->file.path,
                      (unsigned)code, face->base);
        }
    }
}

/* Adds the base set of characters of a font. The base set "names" contains every character that a
 * guest's name may have (core/game/ranking/name_keyboard.h). */
static void add_base(struct face *face)
{
    const bool names = strcmp(face->base, "names") == 0;
    const bool all = names || strcmp(face->base, "ascii") == 0;
    if (!all && strcmp(face->base, "digits") != 0) {
        bake_fail("font %s: the glyph set is `ascii`, `names` or `digits`, not `%s`", face->name,
                  face->base);
    }
    add_range(face, all ? 0x20 : '0', all ? 0x7e : '9');
    if (names) {
        add_range(face, 0x3041, 0x3093); /* Hiragana. */
        add_range(face, 0x30a1, 0x30f4); /* Katakana. */
        /* Adds two characters of Japanese names: the katakana middle dot and the prolonged sound
         * mark. */
        add_range(face, 0x30fb, 0x30fc);
    }
}

static void add_words(struct face *face, const struct text_file *file)
{
    for (uint32_t i = 0; i < file->count; i++) {
        const struct text_line *line = &file->lines[i];
        /* `pattern` becomes the index of the font's first pattern that matches the key. */
        uint32_t pattern = 0;
        while (pattern < face->pattern_count &&
               fnmatch(face->patterns[pattern], line->key, 0) != 0) {
            pattern++;
        }
        if (pattern == face->pattern_count) {
            continue;
        }
        const char *at = line->words, *start = at;
        for (uint32_t code = printable_next(&at); code != 0; code = printable_next(&at)) {
            if (!add_glyph(face, code)) {
                bake_fail("font %s (%s) lacks `%.*s` (U+%04X), which %s:%u uses", face->name,
                          face->file.path, (int)(at - start), start, code, file->path, line->line);
            }
            start = at;
        }
    }
}

static int by_code(const void *a, const void *b)
{
    const struct glyph *left = a, *right = b;
    return left->code < right->code ? -1 : left->code > right->code;
}

/* Sorts the glyphs by code and computes the size of each glyph as draw_face() will draw it. Too
 * many glyphs are thus detected before the slow drawing. */
static void measure_face(struct face *face)
{
    qsort(face->glyphs, face->glyph_count, sizeof *face->glyphs, by_code);
    for (uint32_t i = 0; i < face->glyph_count; i++) {
        struct glyph *glyph = &face->glyphs[i];
        int left, top, right, bottom;
        stbtt_GetGlyphBitmapBox(&glyph->file->info, glyph->index, glyph->file->scale,
                                glyph->file->scale, &left, &top, &right, &bottom);
        if (left < right && top < bottom) {
            glyph->width = right - left + 2 * FONT_PADDING;
            glyph->height = bottom - top + 2 * FONT_PADDING;
        }
    }
}

static void draw_face(struct face *face)
{
    for (uint32_t i = 0; i < face->glyph_count; i++) {
        struct glyph *glyph = &face->glyphs[i];
        int width = 0, height = 0;
        glyph->field = stbtt_GetGlyphSDF(&glyph->file->info, glyph->file->scale, glyph->index,
                                         FONT_PADDING, FONT_EDGE, (float)FONT_STEP, &width, &height,
                                         &glyph->left_px, &glyph->top_px);
        if (width != glyph->width || height != glyph->height) {
            bake_fail("font %s: U+%04X was measured %dx%d and drawn %dx%d", face->name,
                      (unsigned)glyph->code, glyph->width, glyph->height, width, height);
        }
    }
}

static void write_tables(struct face *faces, uint32_t count, const char *path)
{
    FILE *file = bake_open(path);
    fputs("/* fonts.c -- the place of each glyph in asset_font; written by assets/bake. */\n"
          "#include \"fonts.h\"\n",
          file);
    for (uint32_t i = 0; i < count; i++) {
        fprintf(file, "\nstatic const struct font_glyph %s_glyphs[] = {\n", faces[i].name);
        for (uint32_t k = 0; k < faces[i].glyph_count; k++) {
            const struct glyph *glyph = &faces[i].glyphs[k];
            const float em_px = faces[i].em_px;
            int advance, bearing;
            stbtt_GetGlyphHMetrics(&glyph->file->info, glyph->index, &advance, &bearing);
            fprintf(file, "    { 0x%04x, %u, %u, %d, %d, %.5ff, %.5ff, %.5ff },\n", glyph->code,
                    glyph->x, glyph->y, glyph->width, glyph->height,
                    (double)((float)glyph->left_px / em_px), (double)((float)glyph->top_px / em_px),
                    (double)((float)advance * glyph->file->scale / em_px));
        }
        fputs("};\n", file);
    }
    fputs("\nconst struct font asset_fonts[FONT_COUNT] = {\n", file);
    for (uint32_t i = 0; i < count; i++) {
        const struct face *face = &faces[i];
        int left, bottom, right, top;
        const struct font_file *const zero = file_of(face, '0');
        const float cap_em = stbtt_GetCodepointBox(&zero->info, '0', &left, &bottom, &right, &top)
                                 ? (float)top * zero->scale / face->em_px
                                 : 0.7f;
        fprintf(file, "    { \"%s\", %s_glyphs, %u, %.1ff, %.5ff },\n", face->name, face->name,
                face->glyph_count, (double)face->em_px, (double)cap_em);
    }
    fputs("};\n", file);
    bake_close(file, path);
}

static void write_ids(const struct face *faces, uint32_t count, const struct atlas *atlas,
                      const char *path)
{
    FILE *file = bake_open(path);
    fputs("/* fonts.h -- the baked fonts; written by assets/bake from assets/text/fonts.txt. */\n"
          "#ifndef KINGYO_GENERATED_FONTS_H\n#define KINGYO_GENERATED_FONTS_H\n\n"
          "#include \"assets/font.h\"\n\nenum font_id {\n",
          file);
    for (uint32_t i = 0; i < count; i++) {
        fputs("    FONT_", file);
        bake_put_capitals(file, faces[i].name);
        fputs(",\n", file);
    }
    fprintf(file,
            "    FONT_COUNT,\n};\n\n"
            "#define ASSET_FONT_ROWS %uu /* Rows of pixels in one page. */\n"
            "#define ASSET_FONT_PAGES %uu /* Pages, stored one below another. */\n"
            "extern const struct font asset_fonts[FONT_COUNT];\n\n#endif\n",
            atlas->page_rows, atlas->page_count);
    bake_close(file, path);
}

static int by_height(const void *a, const void *b)
{
    const struct glyph *left = *(struct glyph *const *)a, *right = *(struct glyph *const *)b;
    if (left->height != right->height) {
        return right->height - left->height;
    }
    return left->code < right->code ? -1 : left->code > right->code;
}

/* Places the glyphs from left to right in rows of falling height, so that the first glyph of each
 * row is its highest. Returns the number of pages of `page_rows` rows that the glyphs need. */
static uint32_t lay_out(struct glyph **glyphs, uint32_t count, uint32_t page_rows)
{
    uint32_t x = FONT_ATLAS_WIDTH, y = 0, next_y = 0, page = 0;
    for (uint32_t i = 0; i < count; i++) {
        assert(glyphs[i]->width >= 0 && (uint32_t)glyphs[i]->width <= FONT_ATLAS_WIDTH);
        const uint32_t width = (uint32_t)glyphs[i]->width, height = (uint32_t)glyphs[i]->height;
        if (x + width > FONT_ATLAS_WIDTH) {
            x = 0;
            y = next_y;
            if (y + height > page_rows) {
                y = 0;
                page++;
            }
            next_y = y + height;
        }
        glyphs[i]->x = x;
        glyphs[i]->y = page * page_rows + y;
        x += width;
    }
    return page + 1;
}

/* Sorts the glyphs by height and places each glyph on one page. Uses as few pages as possible, and
 * no page is higher than needed. Ends the bake if the glyphs need more than FONT_PAGES_MAX pages.
 * The error message then names the file `list`. */
static struct atlas atlas_pack(struct glyph **glyphs, uint32_t count, const char *list)
{
    qsort(glyphs, count, sizeof *glyphs, by_height);
    struct atlas atlas = { .page_rows = FONT_PAGE_ROWS_MAX };
    atlas.page_count = lay_out(glyphs, count, atlas.page_rows);
    if (atlas.page_count > FONT_PAGES_MAX) {
        bake_fail("%s: %u glyphs fill %u pages of %ux%u texels, and FONT_PAGES_MAX is %u: give a "
                  "font fewer em pixels or fewer keys",
                  list, count, atlas.page_count, FONT_ATLAS_WIDTH, FONT_PAGE_ROWS_MAX,
                  FONT_PAGES_MAX);
    }
    while (lay_out(glyphs, count, atlas.page_rows - 4u) == atlas.page_count) {
        atlas.page_rows -= 4u;
    }
    lay_out(glyphs, count, atlas.page_rows);
    return atlas;
}

/* Writes the pages with the distance fields to the file `path`. */
static void atlas_write(const struct atlas *atlas, struct glyph *const *glyphs, uint32_t count,
                        const char *path)
{
    const size_t size = (size_t)FONT_ATLAS_WIDTH * atlas->page_rows * atlas->page_count;
    uint8_t *texels = bake_alloc(size);
    for (uint32_t i = 0; i < count; i++) {
        const struct glyph *glyph = glyphs[i];
        assert(glyph->x + (uint32_t)glyph->width <= FONT_ATLAS_WIDTH);
        for (int row = 0; row < glyph->height; row++) {
            memcpy(texels + (size_t)(glyph->y + (uint32_t)row) * FONT_ATLAS_WIDTH + glyph->x,
                   glyph->field + row * glyph->width, (size_t)glyph->width);
        }
    }
    bake_write(path, texels, size);
    free(texels);
}

void font_bake(char **paths)
{
    static struct text_file files[TEXT_LANGUAGES];
    static struct face_list list;
    static struct glyph *all[FONT_MAX * GLYPHS_MAX];
    char path[BAKE_PATH_SIZE];
    uint32_t glyph_count = 0;
    text_read(files, paths[0]);
    snprintf(path, sizeof path, "%s/fonts.txt", paths[0]);
    bake_read_lines(path, read_face, &list);
    for (uint32_t i = 0; i < list.count; i++) {
        struct face *face = &list.faces[i];
        open_face(face);
        add_base(face);
        for (uint32_t k = 0; k < TEXT_LANGUAGES; k++) {
            add_words(face, &files[k]);
        }
        measure_face(face);
        for (uint32_t k = 0; k < face->glyph_count; k++) {
            all[glyph_count++] = &face->glyphs[k];
        }
    }
    assert(glyph_count <= FONT_MAX * GLYPHS_MAX);
    const struct atlas atlas = atlas_pack(all, glyph_count, path);
    for (uint32_t i = 0; i < list.count; i++) {
        draw_face(&list.faces[i]);
    }
    atlas_write(&atlas, all, glyph_count, paths[1]);
    write_tables(list.faces, list.count, paths[2]);
    write_ids(list.faces, list.count, &atlas, paths[3]);
}
