/* shot_options.c -- implementation of shot_options.h: parses the command line of `make shot`. */
#include "tests/render/shot_options.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/core.h"

static uint8_t preset_named(const char *name)
{
    for (uint8_t id = 0; id < TANK_PRESET_COUNT; id++) {
        if (!strcmp(tank_preset(id)->name, name)) {
            return id;
        }
    }
    fprintf(stderr, "no tank '%s': festival, thesis or official\n", name);
    exit(2);
}

static uint8_t mode_named(const char *name)
{
    for (uint8_t mode = 0; mode < MODE_COUNT; mode++) {
        if (!strcmp(rules_of(mode)->name, name)) {
            return mode;
        }
    }
    fprintf(stderr, "no mode '%s': festival, championship or practice\n", name);
    exit(2);
}

static uint32_t species_named(const char *name)
{
    for (uint32_t i = 0; i < species_table_count; i++) {
        if (!strcmp(species_table[i]->card.id, name)) {
            return i;
        }
    }
    fprintf(stderr, "no species '%s'\n", name);
    exit(2);
}

enum kind { OPTION_FLAG, OPTION_BYTE, OPTION_NUMBER, OPTION_FLOAT, OPTION_TEXT };

/* Describes a command line option that sets one member of struct shot_options. */
static const struct plain_option {
    const char *name;
    enum kind kind;
    size_t offset;
    /* For an option with a float, the factor that converts the number on the command line to the
     * unit of the member. */
    float unit;
} plain_options[] = {
    { "--start", OPTION_FLAG, offsetof(struct shot_options, start), 0.0f },
    { "--compare", OPTION_FLAG, offsetof(struct shot_options, compare), 0.0f },
    { "--path", OPTION_FLAG, offsetof(struct shot_options, path), 0.0f },
    { "--size-layer", OPTION_FLAG, offsetof(struct shot_options, size_layer), 0.0f },
    { "--progress", OPTION_FLOAT, offsetof(struct shot_options, progress), 1.0f },
    { "--album", OPTION_BYTE, offsetof(struct shot_options, album), 0.0f },
    { "--menu", OPTION_TEXT, offsetof(struct shot_options, menu), 0.0f },
    { "--step", OPTION_BYTE, offsetof(struct shot_options, step), 0.0f },
    { "--coins", OPTION_BYTE, offsetof(struct shot_options, coins), 0.0f },
    { "--rotation", OPTION_BYTE, offsetof(struct shot_options, rotation), 0.0f },
    { "--inset", OPTION_FLOAT, offsetof(struct shot_options, inset), 0.001f },
    { "--light", OPTION_FLOAT, offsetof(struct shot_options, light), 0.01f },
    { "--shift", OPTION_FLOAT, offsetof(struct shot_options, shift), 0.001f },
    { "--en", OPTION_FLAG, offsetof(struct shot_options, english), 0.0f },
    { "--passes", OPTION_FLAG, offsetof(struct shot_options, passes), 0.0f },
    { "--steps", OPTION_FLAG, offsetof(struct shot_options, steps), 0.0f },
    { "--quality-step", OPTION_BYTE, offsetof(struct shot_options, quality_step), 0.0f },
    { "--paper", OPTION_FLAG, offsetof(struct shot_options, paper), 0.0f },
    { "--stress", OPTION_FLAG, offsetof(struct shot_options, stress), 0.0f },
    { "--careless", OPTION_FLAG, offsetof(struct shot_options, careless), 0.0f },
    { "--closer", OPTION_FLAG, offsetof(struct shot_options, closer), 0.0f },
    { "--drift", OPTION_FLAG, offsetof(struct shot_options, drift), 0.0f },
    { "--live", OPTION_FLAG, offsetof(struct shot_options, live), 0.0f },
    { "--plain", OPTION_FLAG, offsetof(struct shot_options, plain), 0.0f },
    { "--white", OPTION_FLAG, offsetof(struct shot_options, white), 0.0f },
    { "--day", OPTION_FLAG, offsetof(struct shot_options, day), 0.0f },
    { "--players", OPTION_BYTE, offsetof(struct shot_options, players), 0.0f },
    { "--samples", OPTION_NUMBER, offsetof(struct shot_options, samples), 0.0f },
    { "--fish", OPTION_NUMBER, offsetof(struct shot_options, fish), 0.0f },
    { "--seed", OPTION_NUMBER, offsetof(struct shot_options, seed), 0.0f },
    { "--water", OPTION_FLOAT, offsetof(struct shot_options, water_m), 0.001f },
    { "--tilt", OPTION_FLOAT, offsetof(struct shot_options, tilt_rad), F_DEG },
    { "--heel", OPTION_FLOAT, offsetof(struct shot_options, heel_rad), F_DEG },
    { "--follow", OPTION_FLOAT, offsetof(struct shot_options, follow_m), 1.0f },
    { "--stamina", OPTION_FLOAT, offsetof(struct shot_options, stamina), 1.0f },
    { "--oxygen", OPTION_FLOAT, offsetof(struct shot_options, oxygen_mg_l), 1.0f },
    { "--seconds", OPTION_FLOAT, offsetof(struct shot_options, seconds), 1.0f },
    { "--frames", OPTION_BYTE, offsetof(struct shot_options, frames), 0.0f },
    { "--every", OPTION_FLOAT, offsetof(struct shot_options, every_s), 1.0f },
    { "--scale", OPTION_FLOAT, offsetof(struct shot_options, scale), 1.0f },
    { "-o", OPTION_TEXT, offsetof(struct shot_options, out), 0.0f },
};

static void set_member(void *member, const struct plain_option *option, const char *value)
{
    switch (option->kind) {
    case OPTION_FLAG:
        *(uint8_t *)member = 1;
        break;
    case OPTION_BYTE:
        *(uint8_t *)member = (uint8_t)strtoul(value, NULL, 10);
        break;
    case OPTION_NUMBER:
        *(uint32_t *)member = (uint32_t)strtoul(value, NULL, 10);
        break;
    case OPTION_FLOAT:
        *(float *)member = option->unit * strtof(value, NULL);
        break;
    case OPTION_TEXT:
        *(const char **)member = value;
        break;
    }
}

static void read_plain(struct shot_options *o, const char *name, const char *value)
{
    for (size_t i = 0; i < sizeof plain_options / sizeof *plain_options; i++) {
        if (!strcmp(name, plain_options[i].name)) {
            set_member((char *)o + plain_options[i].offset, &plain_options[i], value);
        }
    }
}

static void read_named(struct shot_options *o, const char *name, const char *value)
{
    if (!strcmp(name, "--mode")) {
        o->mode = mode_named(value);
        o->modes = (uint8_t)(1u << o->mode);
    } else if (!strcmp(name, "--choose")) {
        o->modes = (1u << CHOICE_COUNT) - 1u;
        o->start = 1;
    } else if (!strcmp(name, "--lab")) {
        o->lab = 1;
        o->species = species_named(value);
    } else if (!strcmp(name, "--owner")) {
        o->owner = (uint8_t)(strtoul(value, NULL, 10) % POI_MAX);
    } else if (!strcmp(name, "--preset")) {
        o->preset = preset_named(value);
    } else if (!strcmp(name, "--close")) {
        sscanf(value, "%f,%f,%f", &o->close_x_m, &o->close_z_m, &o->close_m);
    } else if (!strcmp(name, "--fan")) {
        float x_cm = 0.0f, z_cm = 0.0f;
        const int is_there = sscanf(value, "%f,%f", &x_cm, &z_cm) == 2;
        o->fan = (struct shade_input){ (uint8_t)is_there, 0.01f * x_cm, 0.01f * z_cm, 0.10f };
    } else if (!strcmp(name, "--size")) {
        sscanf(value, "%ux%u", &o->width, &o->height);
    }
}

struct shot_options shot_options_parse(int argc, char **argv)
{
    struct shot_options o = { .seconds = 8.0f,
                              .width = 1280,
                              .height = 720,
                              .out = "out/shot.png",
                              .light = 1.0f,
                              .stamina = -1.0f,
                              .oxygen_mg_l = -1.0f };
    for (int i = 1; i < argc; i++) {
        const char *const value = i + 1 < argc ? argv[i + 1] : "";
        read_plain(&o, argv[i], value);
        read_named(&o, argv[i], value);
    }
    return o;
}

bool shot_is_upright(const struct shot_options *options)
{
    const float width = (float)options->width, height = (float)options->height;
    return options->rotation & 1u ? height < POINTER_UPRIGHT_ASPECT * width
                                  : width < POINTER_UPRIGHT_ASPECT * height;
}
