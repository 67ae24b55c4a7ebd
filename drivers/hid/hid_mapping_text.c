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

/* Writes an error message. Returns -1. */
static int fail(char error[HAL_TEXT_SIZE], const char *what, const char *word)
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

/* Parses report:bits@offset:rest..full with the optional suffixes ~dead and /usage. Returns true,
 * or false on a syntax or range error. */
static bool read_field(const char *at, struct hid_binding *out)
{
    long long report, bits, offset, rest, full, dead = 0, usage = 0;
    char sign;
    int end = 0;
    /* Only these characters are allowed, because sscanf() also accepts blanks and plus signs. The
     * widths prevent an overflow. */
    if (strspn(at, "0123456789abcdefsu-:@.~/") != strlen(at) ||
        sscanf(at, "%18lld:%c%18lld@%18lld:%18lld..%18lld%n", &report, &sign, &bits, &offset, &rest,
               &full, &end) != 6) {
        return false;
    }
    at += end;
    if (*at == '~' && sscanf(at, "~%18lld%n", &dead, &end) == 1 && dead > 0) {
        at += end;
    }
    if (*at == '/' && sscanf(at, "/%15llx%n", (unsigned long long *)&usage, &end) == 1 &&
        usage > 0) {
        at += end;
    }
    if (*at || (sign != 's' && sign != 'u') || report < 0 || report > 255 || bits < 1 ||
        bits > 32 || offset < 0 || offset > HID_REPORT_BITS_MAX || rest < -HID_VALUE_MAX ||
        rest > HID_VALUE_MAX || full < -HID_VALUE_MAX || full > HID_VALUE_MAX ||
        dead > HID_VALUE_MAX || usage > UINT32_MAX) {
        return false;
    }
    out->is_signed = sign == 's';
    out->report_id = (uint8_t)report;
    out->bit_size = (uint8_t)bits;
    out->bit_offset = (uint32_t)offset;
    out->rest = rest;
    out->full = full;
    out->dead = dead;
    out->usage = (hid_usage)usage;
    return true;
}

static bool read_binding(char *word, struct hid_binding *out)
{
    CORE_ASSERT(strlen(word) < WORD_SIZE);
    char *manner = strchr(word, '=');
    char *field = manner ? strchr(manner, ':') : NULL;
    if (!field) {
        return false;
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
        return fail(error, "the first word is no source of a mapping", word);
    }
    const int style =
        next_word(&text, word) > 0 ? index_of(style_words, COUNT(style_words), word) : -1;
    if (style <= 0) {
        return fail(error, "the second word is no style of a mapping", word);
    }
    out->source = (uint8_t)source;
    out->style = (uint8_t)style;
    int more;
    while ((more = next_word(&text, word)) > 0) {
        memcpy(kept, word, sizeof kept);
        if (strcmp(word, "trembles") == 0) {
            out->trembles = true;
        } else if (strcmp(word, "feels") == 0) {
            out->feels = true;
        } else if (out->count == HID_BINDING_MAX) {
            return fail(error, "a mapping has too many bindings", kept);
        } else if (!read_binding(word, &out->binding[out->count])) {
            return fail(error, "a binding must be role=manner:report:bits@offset:rest..full", kept);
        } else {
            out->count++;
        }
    }
    return more < 0 ? fail(error, "a word too long", text) : 0;
}

/* ---- Files of mappings ----------------------------------------------------------------------- */

#define FIRST_LINE "kingyo poi 1"
#define HEX_DIGITS "0123456789abcdef"

static bool is_word_character(char c)
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

/* Reverses escape(). Returns true, or false if the result is too long for `size` or if `text` is
 * not a valid output of escape(). */
static bool unescape(const char *text, char *out, size_t size)
{
    CORE_ASSERT(size > 0);
    size_t used = 0;
    while (*text && used + 1u < size) {
        unsigned byte = (uint8_t)*text;
        if (is_word_character(*text)) {
            text++;
        } else if (*text == '%' && strspn(text + 1, "0123456789ABCDEF") >= 2u &&
                   sscanf(text, "%%%2X", &byte) == 1 && byte > 0) {
            text += 3;
        } else {
            return false;
        }
        out[used++] = (char)byte;
    }
    out[used] = '\0';
    return !*text;
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

/* Copies the next line into `line` and advances `*text`. Returns true, or false if no complete line
 * is left or if the line does not fit into `size` bytes. */
static bool next_line(const char **text, char *line, size_t size)
{
    CORE_ASSERT(size > 0);
    const size_t length = strcspn(*text, "\n");
    if ((*text)[length] != '\n' || length >= size) {
        return false;
    }
    memcpy(line, *text, length);
    line[length] = '\0';
    *text += length + 1u;
    return true;
}

int hid_mapping_store_read(struct hid_mapping_store_entry *out, const char *text,
                           char error[HAL_TEXT_SIZE])
{
    char line[HID_MAPPING_STORE_TEXT_SIZE];
    int end = 0;
    memset(out, 0, sizeof *out);
    if (!next_line(&text, line, sizeof line) || strcmp(line, FIRST_LINE) != 0) {
        snprintf(error, HAL_TEXT_SIZE, "not \"" FIRST_LINE "\"");
        return 1;
    }
    if (!next_line(&text, line, sizeof line) || strspn(line, HEX_DIGITS) != 4u ||
        strspn(line + 5, HEX_DIGITS) != 4u ||
        sscanf(line, "%hx:%hx:%n", &out->vendor, &out->product, &end) != 2 || end != 10 ||
        !unescape(line + end, out->serial, sizeof out->serial)) {
        snprintf(error, HAL_TEXT_SIZE, "must be vendor:product:serial");
        return 2;
    }
    if (!next_line(&text, line, sizeof line) || *text) {
        snprintf(error, HAL_TEXT_SIZE, "must be one line with a mapping");
        return 3;
    }
    return hid_mapping_read(&out->map, line, error) == 0 ? 0 : 3;
}
