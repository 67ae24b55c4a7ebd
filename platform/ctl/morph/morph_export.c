/* morph_export.c -- `kingyoctl morph export`, which writes a fish as pictures or as meshes for
 * other programs. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "platform/ctl/morph/morph_export.h"

#define FRAMES_MAX 10000u

static const char name[] = "export";

/* Options of `kingyoctl morph export` that do not select the fish. */
struct wishes {
    const char *sheet, *obj, *glb, *folder, *view;
    uint32_t frame_count;
};

static enum exit_code morph_export_check_options(const struct morph_options *pick,
                                                 const struct wishes *wishes)
{
    const int kinds = (wishes->sheet != NULL) + (wishes->obj != NULL) + (wishes->glb != NULL) +
                      (wishes->frame_count > 0);
    if (kinds != 1) {
        return morph_usage(name, "%s: one of --sheet, --obj, --glb and --frames",
                           kinds ? "too much at once" : "nothing to write");
    }
    if ((wishes->frame_count > 0) != (wishes->folder != NULL)) {
        return morph_usage(name, "--frames N and --dir D go together");
    }
    if (wishes->view && wishes->frame_count == 0) {
        return morph_usage(name, "--view is for --frames");
    }
    if (wishes->obj && !pick->has_place) {
        return morph_usage(name, "--obj needs --progress, --age-days or --length-mm");
    }
    if (!wishes->obj && pick->has_place) {
        return morph_usage(name, "--progress, --age-days and --length-mm are for --obj");
    }
    return EXIT_OK;
}

struct export_plan {
    struct morph_options pick;
    struct wishes wishes;
};

#define AT(member) .offset = offsetof(struct export_plan, member)

static const struct option options[] = {
    { "sheet", "FILE.png",
      "contact sheet of every key and nine stages between each two keys, from the left, from above "
      "and at an angle, with age, length and a scale bar",
      OPTION_TEXT, AT(wishes.sheet) },
    { "frames", "N", "number of pictures at equal steps of progress", OPTION_WHOLE,
      AT(wishes.frame_count), 2, FRAMES_MAX },
    { "dir", "D", "folder of the pictures D/SPECIES_0000.png and so on", OPTION_TEXT,
      AT(wishes.folder) },
    { "view", "VIEW", "view of the pictures: side (the default), above or aslant", OPTION_TEXT,
      AT(wishes.view), .expects = "side, above or aslant" },
    { "obj", "FILE.obj",
      "mesh at the moment that --progress, --age-days or --length-mm selects: metres, coloured "
      "vertices, one group for each part. If the fish has a length more than once, as a conger "
      "has, the youngest age is used",
      OPTION_TEXT, AT(wishes.obj) },
    { "glb", "FILE.glb",
      "glTF 2.0 of the whole life: key shapes as morph targets (solved shapes where the graph is "
      "solved), weights, size and the parts on the skin animated over 10 s, one mesh for each "
      "part, coloured vertices",
      OPTION_TEXT, AT(wishes.glb) },
};

static const struct option_table table = { options, sizeof options / sizeof options[0],
                                           &morph_options_table };

static enum exit_code morph_export_run(int argc, const char *const *argv)
{
    static struct export_plan plan;
    plan = (struct export_plan){ .wishes = { 0 } };
    const struct morph_options *pick = &plan.pick;
    const struct wishes *wishes = &plan.wishes;
    enum exit_code code = morph_options_read(
        &plan.pick, name, MORPH_REQUIRES_CURVES | MORPH_REQUIRES_PLACE, &table, argc, argv);
    if (code == EXIT_OK) {
        code = morph_export_check_options(pick, wishes);
    }
    if (code != EXIT_OK) {
        return code;
    }
    if (wishes->sheet || wishes->obj || wishes->glb) {
        return wishes->sheet ? morph_sheet_write(pick, wishes->sheet)
               : wishes->obj ? morph_obj_write(pick, wishes->obj)
                             : morph_glb_write(pick, wishes->glb);
    }
    enum fish_preview_view view = VIEW_SIDE;
    while (wishes->view && view < VIEW_COUNT &&
           strcmp(wishes->view, fish_preview_view_names[view]) != 0) {
        view++;
    }
    return view < VIEW_COUNT
               ? morph_frames_write(pick, view, wishes->frame_count, wishes->folder)
               : morph_usage(name, "--view: '%.40s' is not side, above or aslant", wishes->view);
}

const struct morph_command ctl_morph_export = {
    .name = name,
    .options = &table,
    .groups = MORPH_REQUIRES_CURVES | MORPH_REQUIRES_PLACE,
    .words = "SPECIES|FILE WHAT [--template T] [--thesis]",
    .summary = "a growing fish as pictures and as meshes",
    .usage =
        "WHAT is one of --sheet, --frames with --dir, --obj and --glb. An age or a length outside\n"
        "the drawn life is refused, and the message contains the valid range.\n"
        "If a file cannot be written completely, no file is created, and an older file is kept.\n",
    .run = morph_export_run,
};
