/* morph_export.c -- `kingyoctl morph export`: a fish as pictures and as meshes. */
#include <stdio.h>
#include <string.h>

#include "platform/ctl/morph_sheet.h"

#define FRAMES_MAX 10000u

static const char name[] = "export";

/* What is asked for beside the fish. */
struct wishes {
    const char *sheet, *folder, *view;
    uint32_t frame_count;
};

static bool find_view(const char *word, enum portrait_view *view)
{
    for (uint32_t i = 0; i < VIEW_COUNT; i++) {
        if (strcmp(word, portrait_view_names[i]) == 0) {
            *view = (enum portrait_view)i;
            return true;
        }
    }
    return false;
}

static enum exit_code write_frames(const struct morph_pick *pick, const struct wishes *wishes)
{
    enum portrait_view view;
    if (!find_view(wishes->view, &view)) {
        return morph_usage(name, "--view: '%.40s' is not side, above or aslant", wishes->view);
    }
    return morph_frames_write(pick, view, wishes->frame_count, wishes->folder);
}

static enum exit_code check(const struct morph_pick *pick, const struct wishes *wishes)
{
    const int kinds = (wishes->sheet != NULL) + (wishes->frame_count > 0);
    if (kinds != 1) {
        return morph_usage(name, "%s; one of --sheet FILE and --frames N",
                           kinds ? "too much at once" : "nothing to write");
    }
    if ((wishes->frame_count > 0) != (wishes->folder != NULL)) {
        return morph_usage(name, "--frames N and --dir D go together");
    }
    if (pick->has_place) {
        return morph_usage(name, "--progress, --age-days and --length-mm: this shows all of life");
    }
    return EXIT_OK;
}

static enum exit_code run(int argc, const char *const *argv)
{
    static struct morph_pick pick;
    struct wishes wishes = { .view = portrait_view_names[VIEW_SIDE] };
    const struct morph_option options[] = {
        { .name = "--sheet", .text = &wishes.sheet },
        { .name = "--dir", .text = &wishes.folder },
        { .name = "--view", .text = &wishes.view },
        { .name = "--frames", .count = &wishes.frame_count, .min = 2, .max = FRAMES_MAX },
    };
    enum exit_code code =
        morph_pick_read(&pick, name, MORPH_ASKS_CURVES | MORPH_ASKS_PLACE, options,
                        sizeof options / sizeof options[0], argc, argv);
    if (code == EXIT_OK) {
        code = check(&pick, &wishes);
    }
    if (code != EXIT_OK) {
        return code;
    }
    return wishes.sheet ? morph_sheet_write(&pick, wishes.sheet) : write_frames(&pick, &wishes);
}

const struct morph_command ctl_morph_export = {
    .name = name,
    .words = "SPECIES|FILE WHAT [--template T] [--thesis]",
    .summary = "a growing fish as pictures",
    .usage =
        "WHAT is one of\n"
        "  --sheet FILE.png           every key and nine in-betweens to the next, from its left,\n"
        "                             from above and aslant, with age, length and a bar of size\n"
        "  --frames N --dir D         N pictures at even steps of progress, as\n"
        "      [--view side|above|aslant] D/SPECIES_0000.png ..; from its left unless told\n",
    .run = run,
};
