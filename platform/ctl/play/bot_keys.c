/* bot_keys.c -- the table of the keys of a bot file, and the conversion of their values. */
#include "platform/ctl/play/bot_keys.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/os/number.h"

enum kind { KIND_REAL, KIND_COUNT, KIND_WORD };

struct key {
    const char *name;
    uint8_t kind;  /* Type of the key's value (enum kind). */
    uint8_t above; /* 1 if the value must be greater than `min`, 0 if the value may also equal
                      `min`. */
    size_t offset; /* Offset of the field in struct technique, in bytes. */
    double min, max;
    const char *const *words; /* Allowed words, terminated by a null pointer. The value is the index
                                 of the word. A null `words` means that the value is a number. */
    const char *meaning;
};

static const char *const sides[] = {
    [SIDE_ANY] = "any", [SIDE_HEAD] = "head", [SIDE_TAIL] = "tail", [SIDE_COUNT] = NULL
};
static const char *const places[] = {
    [PLACE_CENTRE] = "centre", [PLACE_RIM] = "rim", [PLACE_COUNT] = NULL
};
static const char *const lifts[] = {
    [LIFT_DRAINED] = "drained", [LIFT_FAST] = "fast", [LIFT_COUNT] = NULL
};
static const char *const hunts[] = {
    [HUNT_SHADE] = "shade", [HUNT_CHASE] = "chase", [HUNT_COUNT] = NULL
};

#define AT(field) offsetof(struct technique, field)
#define REAL(field, least, most, text)                                                             \
    { .name = #field,                                                                              \
      .kind = KIND_REAL,                                                                           \
      .offset = AT(field),                                                                         \
      .min = least,                                                                                \
      .max = most,                                                                                 \
      .meaning = text }
#define SPEED(field, text)                                                                         \
    { .name = #field,                                                                              \
      .kind = KIND_REAL,                                                                           \
      .above = 1,                                                                                  \
      .offset = AT(field),                                                                         \
      .max = 2.0,                                                                                  \
      .meaning = text }
#define WORD(field, list, text)                                                                    \
    { .name = #field, .kind = KIND_WORD, .offset = AT(field), .words = list, .meaning = text }

static const struct key keys[] = {
    REAL(wet, 0.0, 1.0, "share of the paper that is wetted before the first scoop"),
    REAL(entry_deg, 0.0, 60.0, "slant of the paper as it goes into the water; 0 is flat"),
    REAL(glide_deg, 0.0, 90.0, "between paper and its way under water; 90 is broadside"),
    WORD(side, sides, "which end of the fish is over the ring first"),
    WORD(place, places, "what part of the paper is brought under it"),
    WORD(lift, lifts, "level till the water is off; or 2.5 times as fast, at once"),
    WORD(hunt, hunts, "wait in a still shade; or after it, at the arm's speed"),
    { .name = "fish_max",
      .kind = KIND_COUNT,
      .offset = AT(fish_max),
      .min = 1.0,
      .max = 8.0,
      .meaning = "fish that it wants on the paper before it lifts" },
    REAL(fish_m, 0.02, 0.1, "length of fish that it likes best"),
    SPEED(arm_m_s, "speed of its arm over the water"),
    SPEED(dip_m_s, "into the water"),
    SPEED(glide_m_s, "under the water"),
    SPEED(lift_m_s, "out of the water"),
    SPEED(carry_m_s, "to the bowl"),
    REAL(drain_s, 0.0, 3.0, "that it lets water run off"),
    REAL(patience_s, 0.0, 20.0, "that it waits for a fish to come to rest"),
    REAL(aim_m, 0.0, 0.05, "how far it misses, at most"),
    REAL(tremor_m, 0.0, 0.01, "how far its hand trembles"),
    REAL(reaction_min_s, 0.15, 1.0, "from the sight to the act, at least ..."),
    REAL(reaction_max_s, 0.15, 1.0, "... and at most"),
};
_Static_assert(sizeof keys / sizeof keys[0] == BOT_KEY_COUNT, "the header counts them");
_Static_assert(sizeof(struct technique) == 68, "a new field of a technique wants a key");

static double value_of(const struct key *key, const struct technique *technique)
{
    const unsigned char *at = (const unsigned char *)technique + key->offset;
    float real = 0.0f;
    if (key->kind != KIND_REAL) {
        return (double)*at;
    }
    memcpy(&real, at, sizeof real);
    return (double)real;
}

static const struct key *key_at(uint32_t key)
{
    CORE_ASSERT(key < BOT_KEY_COUNT);
    return &keys[key];
}

/* Parses `text` as a value of `key`. Returns 1 and stores the value in `*out` if the text is valid,
 * otherwise 0. */
static int read_value(const struct key *key, const char *text, double *out)
{
    uint32_t count = 0;
    int right = 0;
    if (key->kind == KIND_REAL) {
        right = number_parse_decimal(text, key->min, key->max, out);
        return right && !(key->above && (float)*out <= (float)key->min);
    }
    if (key->kind == KIND_COUNT) {
        right = number_parse(text, (uint32_t)key->min, (uint32_t)key->max, &count);
    } else {
        while (key->words[count] && strcmp(text, key->words[count]) != 0) {
            count++;
        }
        right = key->words[count] != NULL;
    }
    *out = right ? (double)count : *out;
    return right;
}

const char *bot_key_name(uint32_t key)
{
    return key_at(key)->name;
}

uint32_t bot_key_named(const char *name)
{
    uint32_t key = 0;
    while (key < BOT_KEY_COUNT && strcmp(name, keys[key].name) != 0) {
        key++;
    }
    return key;
}

int bot_key_set(uint32_t key, const char *text, struct technique *technique)
{
    double value = 0.0;
    if (!read_value(key_at(key), text, &value)) {
        return -1;
    }
    unsigned char *at = (unsigned char *)technique + keys[key].offset;
    const float real = (float)value;
    if (keys[key].kind == KIND_REAL) {
        memcpy(at, &real, sizeof real);
    } else {
        *at = (unsigned char)value;
    }
    return 0;
}

void bot_key_range(uint32_t key, char out[BOT_KEY_RANGE_MAX])
{
    const struct key *of = key_at(key);
    size_t used = 0;
    if (of->kind != KIND_WORD) {
        snprintf(out, BOT_KEY_RANGE_MAX, "%s%g to %g", of->above ? "over " : "", of->min, of->max);
        return;
    }
    out[0] = '\0';
    for (uint32_t i = 0; of->words[i] && used < BOT_KEY_RANGE_MAX; i++) {
        used += (size_t)snprintf(out + used, BOT_KEY_RANGE_MAX - used, "%s%s", i ? "|" : "",
                                 of->words[i]);
    }
}

int bot_keys_same(const struct technique *a, const struct technique *b)
{
    for (uint32_t i = 0; i < BOT_KEY_COUNT; i++) {
        const double x = value_of(&keys[i], a), y = value_of(&keys[i], b);
        if (x < y || x > y) {
            return 0;
        }
    }
    return 1;
}

static void print_value(const struct key *key, const struct technique *technique)
{
    const double value = value_of(key, technique);
    if (key->kind == KIND_WORD) {
        printf(" %-8s", key->words[(size_t)value]);
    } else {
        printf(" %-8g", value);
    }
}

void bot_keys_print(void)
{
    printf("\nA bot FILE has a 'key=value' a line; '#' begins a comment. base=novice|expert,\n"
           "before all other keys, says who plays where they say nothing (expert). The others:\n\n"
           "  %-15s %-14s %-8s %-8s %s\n",
           "key", "right is", "novice", "expert", "meaning");
    for (uint32_t i = 0; i < BOT_KEY_COUNT; i++) {
        char range[BOT_KEY_RANGE_MAX];
        bot_key_range(i, range);
        printf("  %-15s %-14s", keys[i].name, range);
        print_value(&keys[i], &technique_novice);
        print_value(&keys[i], &technique_expert);
        printf(" %s\n", keys[i].meaning);
    }
}
