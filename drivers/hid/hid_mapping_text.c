/* hid_mapping_text.c -- writes a mapping as one line of text, and parses it. Also implements the
 * three-line text format of a mapping file.
 *
 *   learned fly x=rate:1:u8@0:128..255~12 dip=press:1:u1@37:0..1 ok=press:0:u8@16:0..1/00070028
 *
 * The first words are the source, the style and the optional flags "trembles" and "feels". Each
 * further word is a binding with the syntax role=manner:report:bits@offset:rest..full. Optional
 * suffixes are ~dead for a dead zone and /usage for an element of an array. */
#include "drivers/hid/hid_mapping.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"

static const char *const source_words[] = { "none", "own", "known", "offered", "learned" };
static const char *const style_words[] = { "none", "pose", "pointer", "fly" };
static const char *const manner_words[] = { "place", "rate", "step", "press", "hat" };
static const char *const role_words[] = {
    "none",  "x",   "y",        "z",        "pitch", "yaw",  "roll",  "tilt", "dip",
    "level", "fan", "in-range", "sequence", "start", "left", "right", "ok",   "hat",
};

#define COUNT(words) ((uint32_t)(sizeof words / sizeof words[0]))
_Static_assert(COUNT(role_words) == HID_ROLE_COUNT, "every role has a word");
_Static_assert(COUNT(manner_words) == HID_BINDING_KIND_COUNT, "every manner has a word");
_Static_assert(COUNT(source_words) == HID_MAPPING_LEARNED + 1, "every source has a word");
_Static_assert(COUNT(style_words) == HID_STYLE_FLY + 1, "every style has a word");

#define WORD_SIZE 96u

/* ---- Writing of a mapping ------------------------------------------------------------------- */

int hid_mapping_write(const struct hid_mapping *map, char text[HID_MAPPING_TEXT_SIZE])
{
    if (map->source >= COUNT(source_words) || map->style >= COUNT(style_words) ||
        map->count > HID_BINDING_MAX) {
        return -1;
    }
    int used = snprintf(text, HID_MAPPING_TEXT_SIZE, "%s %s%s%s", source_words[map->source],
                        style_words[map->style], map->trembles ? " trembles" : "",
                        map->feels ? " feels" : "");
    for (uint32_t i = 0; i < map->count; i++) {
        const struct hid_binding *binding = &map->binding[i];
        if (binding->role >= HID_ROLE_COUNT || binding->manner >= HID_BINDING_KIND_COUNT) {
            return -1;
        }
        char dead[24] = "", usage[16] = "";
        if (binding->dead) {
            snprintf(dead, sizeof dead, "~%" PRId64, binding->dead);
        }
        if (binding->usage) {
            snprintf(usage, sizeof usage, "/%08" PRIx32, binding->usage);
        }
        used += snprintf(text + used, HID_MAPPING_TEXT_SIZE - (size_t)used,
                         " %s=%s:%u:%c%u@%" PRIu32 ":%" PRId64 "..%" PRId64 "%s%s",
                         role_words[binding->role], manner_words[binding->manner],
                         binding->report_id, binding->is_signed ? 's' : 'u', binding->bit_size,
                         binding->bit_offset, binding->rest, binding->full, dead, usage);
        if ((uint32_t)used >= HID_MAPPING_TEXT_SIZE) {
            return -1;
        }
    }
    return 0;
}

/* ---- Parsing of a mapping ------------------------------------------------------------------- */

static int hid_mapping_text_fail(char error[HAL_TEXT_SIZE], const char *what, const char *word)
{
    snprintf(error, HAL_TEXT_SIZE, "%s: '%.60s'", what, word);
    return -1;
}

static int index_of(const char *const *words, uint32_t count, const char *word)
{
    CORE_ASSERT(count > 0);
    for (uint32_t i = 0; i < count; i++) {
        if (strcmp(words[i], word) == 0) {
            return (int)i;
        }
    }
    return -1;
}

/* Copies the next word and advances `*text` to the end of the word. Returns 1, 0 if no word is
 * left, or -1 if the word has WORD_SIZE bytes or more. */
static int next_word(const char **text, char word[WORD_SIZE])
{
    const char *at = *text + strspn(*text, " \t");
    const size_t length = strcspn(at, " \t");
    if (length >= WORD_SIZE) {
        return -1;
    }
    memcpy(word, at, length);
    word[length] = '\0';
    *text = at + length;
    return length > 0;
}

/* Parses a number from `low` to `high` that is followed by the text `end`, and advances `*at` past
 * `end`. Returns 1, or 0 on a syntax or range error. */
static int read_number(const char **at, int base, int64_t low, int64_t high, const char *end,
                       int64_t *out)
{
    char *stop = NULL;
    CORE_ASSERT(base == 10 || base == 16);
    CORE_ASSERT(low <= high);
    const char first = **at;
    if (first != '-' && !(first >= '0' && first <= '9') &&
        !(base == 16 && first >= 'a' && first <= 'f')) {
        return 0;
    }
    const long long value = strtoll(*at, &stop, base);
    const size_t length = strlen(end);
    if (strncmp(stop, end, length) != 0 || value < low || value > high) {
        return 0;
    }
    *at = stop + length;
    *out = value;
    return 1;
}

static int read_field(const char *at, struct hid_binding *out)
{
    int64_t report, bits, offset;
    if (!read_number(&at, 10, 0, 255, ":", &report) || (*at != 's' && *at != 'u')) {
        return 0;
    }
    out->is_signed = *at++ == 's';
    if (!read_number(&at, 10, 1, 32, "@", &bits) ||
        !read_number(&at, 10, 0, HID_REPORT_BITS_MAX, ":", &offset) ||
        !read_number(&at, 10, -HID_VALUE_MAX, HID_VALUE_MAX, "..", &out->rest) ||
        !read_number(&at, 10, -HID_VALUE_MAX, HID_VALUE_MAX, "", &out->full)) {
        return 0;
    }
    out->report_id = (uint8_t)report;
    out->bit_size = (uint8_t)bits;
    out->bit_offset = (uint32_t)offset;
    /* The suffixes "~dead" and "/usage" at the end of a word are optional. */
    if (*at == '~') {
        at++;
        if (!read_number(&at, 10, 1, HID_VALUE_MAX, "", &out->dead)) {
            return 0;
        }
    }
    if (*at == '/') {
        int64_t usage;
        at++;
        if (!read_number(&at, 16, 1, UINT32_MAX, "", &usage)) {
            return 0;
        }
        out->usage = (hid_usage)usage;
    }
    return *at == '\0';
}

static int read_binding(char *word, struct hid_binding *out)
{
    CORE_ASSERT(strlen(word) < WORD_SIZE);
    char *manner = strchr(word, '=');
    char *field = manner ? strchr(manner, ':') : NULL;
    if (!field) {
        return 0;
    }
    *manner++ = '\0';
    *field++ = '\0';
    const int role = index_of(role_words, COUNT(role_words), word);
    const int how = index_of(manner_words, COUNT(manner_words), manner);
    *out = (struct hid_binding){ .role = (uint8_t)role, .manner = (uint8_t)how };
    return role > 0 && how >= 0 && read_field(field, out);
}

int hid_mapping_read(struct hid_mapping *out, const char *text, char error[HAL_TEXT_SIZE])
{
    char word[WORD_SIZE] = "", kept[WORD_SIZE];
    memset(out, 0, sizeof *out);
    const int source =
        next_word(&text, word) > 0 ? index_of(source_words, COUNT(source_words), word) : -1;
    if (source <= 0) {
        return hid_mapping_text_fail(error, "begins with no word for where a map is from", word);
    }
    const int style =
        next_word(&text, word) > 0 ? index_of(style_words, COUNT(style_words), word) : -1;
    if (style <= 0) {
        return hid_mapping_text_fail(error, "no style of play behind its source", word);
    }
    out->source = (uint8_t)source;
    out->style = (uint8_t)style;
    int more;
    while ((more = next_word(&text, word)) > 0) {
        memcpy(kept, word, sizeof kept);
        if (strcmp(word, "trembles") == 0) {
            out->trembles = 1;
        } else if (strcmp(word, "feels") == 0) {
            out->feels = 1;
        } else if (out->count == HID_BINDING_MAX) {
            return hid_mapping_text_fail(error, "more bindings than a map holds", kept);
        } else if (!read_binding(word, &out->binding[out->count])) {
            return hid_mapping_text_fail(error, "not role=manner:report:bits@offset:rest..full",
                                         kept);
        } else {
            out->count++;
        }
    }
    return more < 0 ? hid_mapping_text_fail(error, "a word too long", text) : 0;
}

/* ---- Files of mappings ----------------------------------------------------------------------- */

#define FIRST_LINE "kingyo poi 1"

static int is_word_character(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/* Copies letters, digits and '_' to `out`, and writes each other byte as %XX. Truncates the result
 * to fit into `size` bytes. */
static void escape(const char *text, char *out, size_t size)
{
    size_t used = 0;
    CORE_ASSERT(size > 0);
    for (; *text && used + 4u < size; text++) {
        if (is_word_character(*text)) {
            out[used++] = *text;
        } else {
            snprintf(out + used, 4, "%%%02X", (unsigned)(uint8_t)*text);
            used += 3;
        }
    }
    out[used] = '\0';
}

static int hex_value(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* Reverses escape(). Returns 1, or 0 if the result is too long for `size` or if `text` is not a
 * valid output of escape(). */
static int unescape(const char *text, char *out, size_t size)
{
    CORE_ASSERT(size > 0);
    size_t used = 0;
    while (*text) {
        if (used + 1u >= size) {
            return 0;
        }
        if (is_word_character(*text)) {
            out[used++] = *text++;
            continue;
        }
        const int high = *text == '%' ? hex_value(text[1]) : -1;
        const int low = high >= 0 ? hex_value(text[2]) : -1;
        if (low < 0 || high * 16 + low == 0) {
            return 0;
        }
        out[used++] = (char)(high * 16 + low);
        text += 3;
    }
    out[used] = '\0';
    return 1;
}

void hid_mapping_store_name(const struct hid_mapping_store_entry *entry,
                            char name[HID_MAPPING_STORE_NAME_SIZE])
{
    char serial[3u * HID_TEXT_SIZE];
    CORE_ASSERT(memchr(entry->serial, 0, sizeof entry->serial));
    escape(entry->serial, serial, sizeof serial);
    snprintf(name, HID_MAPPING_STORE_NAME_SIZE, "%04x-%04x-%s.poi", entry->vendor, entry->product,
             serial);
}

int hid_mapping_store_write(const struct hid_mapping_store_entry *entry,
                            char text[HID_MAPPING_STORE_TEXT_SIZE])
{
    char serial[3u * HID_TEXT_SIZE], map[HID_MAPPING_TEXT_SIZE];
    if (hid_mapping_write(&entry->map, map) != 0) {
        return -1;
    }
    escape(entry->serial, serial, sizeof serial);
    const int length =
        snprintf(text, HID_MAPPING_STORE_TEXT_SIZE, FIRST_LINE "\n%04x:%04x:%s\n%s\n",
                 entry->vendor, entry->product, serial, map);
    return (size_t)length < HID_MAPPING_STORE_TEXT_SIZE ? 0 : -1;
}

/* Copies the next line into `line` and advances `*text`. Returns 1, or 0 if no complete line is
 * left or if the line does not fit into `size` bytes. */
static int hid_mapping_store_text_next_line(const char **text, char *line, size_t size)
{
    CORE_ASSERT(size > 0);
    const size_t length = strcspn(*text, "\n");
    if ((*text)[length] != '\n' || length >= size) {
        return 0;
    }
    memcpy(line, *text, length);
    line[length] = '\0';
    *text += length + 1u;
    return 1;
}

static int read_hex4(const char *text, uint16_t *out)
{
    if (strspn(text, "0123456789abcdef") != 4) {
        return 0;
    }
    *out = (uint16_t)strtoul(text, NULL, 16);
    return 1;
}

int hid_mapping_store_read(struct hid_mapping_store_entry *out, const char *text,
                           char error[HAL_TEXT_SIZE])
{
    char line[HID_MAPPING_STORE_TEXT_SIZE];
    memset(out, 0, sizeof *out);
    if (!hid_mapping_store_text_next_line(&text, line, sizeof line) ||
        strcmp(line, FIRST_LINE) != 0) {
        snprintf(error, HAL_TEXT_SIZE, "not \"" FIRST_LINE "\"");
        return 1;
    }
    if (!hid_mapping_store_text_next_line(&text, line, sizeof line) || strlen(line) < 10 ||
        line[4] != ':' || line[9] != ':' || !read_hex4(line, &out->vendor) ||
        !read_hex4(line + 5, &out->product) ||
        !unescape(line + 10, out->serial, sizeof out->serial)) {
        snprintf(error, HAL_TEXT_SIZE, "not vendor:product:serial");
        return 2;
    }
    if (!hid_mapping_store_text_next_line(&text, line, sizeof line) || *text) {
        snprintf(error, HAL_TEXT_SIZE, "not one line of a map");
        return 3;
    }
    return hid_mapping_read(&out->map, line, error) == 0 ? 0 : 3;
}
