/* morph_export.c -- `kingyoctl morph export`, which writes a fish as pictures or as meshes for
 * other programs. */
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

static enum exit_code morph_export_run(int argc, const char *const *argv)
{
    static struct morph_options pick;
    struct wishes wishes = { 0 };
    const struct morph_option options[] = {
        { .name = "--sheet", .text = &wishes.sheet },
        { .name = "--obj", .text = &wishes.obj },
        { .name = "--glb", .text = &wishes.glb },
        { .name = "--dir", .text = &wishes.folder },
        { .name = "--view", .text = &wishes.view },
        { .name = "--frames", .count = &wishes.frame_count, .min = 2, .max = FRAMES_MAX },
    };
    enum exit_code code =
        morph_options_read(&pick, name, MORPH_REQUIRES_CURVES | MORPH_REQUIRES_PLACE, options,
                           sizeof options / sizeof options[0], argc, argv);
    if (code == EXIT_OK) {
        code = morph_export_check_options(&pick, &wishes);
    }
    if (code != EXIT_OK) {
        return code;
    }
    if (wishes.sheet || wishes.obj || wishes.glb) {
        return wishes.sheet ? morph_sheet_write(&pick, wishes.sheet)
               : wishes.obj ? morph_obj_write(&pick, wishes.obj)
                            : morph_glb_write(&pick, wishes.glb);
    }
    enum fish_preview_view view = VIEW_SIDE;
    while (wishes.view && view < VIEW_COUNT &&
           strcmp(wishes.view, fish_preview_view_names[view]) != 0) {
        view++;
    }
    return view < VIEW_COUNT
               ? morph_frames_write(&pick, view, wishes.frame_count, wishes.folder)
               : morph_usage(name, "--view: '%.40s' is not side, above or aslant", wishes.view);
}

const struct morph_command ctl_morph_export = {
    .name = name,
    .words = "SPECIES|FILE WHAT [--template T] [--thesis]",
    .summary = "a growing fish as pictures and as meshes",
    .usage =
        "WHAT is one of\n"
        "  --sheet FILE.png      every key and nine in-betweens to the next, from its left,\n"
        "                        above and aslant, with age, length and a bar of true size\n"
        "  --frames N --dir D    N pictures at even steps of progress, D/SPECIES_0000.png ..;\n"
        "                        --view side (the default), above or aslant\n"
        "  --obj FILE.obj        the mesh at one moment, said by --progress P, --age-days D or\n"
        "                        --length-mm L: metres, coloured vertices, a group a part. An\n"
        "                        age or a length that the drawn life does not have is refused\n"
        "                        with the range that it has; of a length that it has more than\n"
        "                        once, as a conger has, the youngest is meant\n"
        "  --glb FILE.glb        glTF 2.0 of the whole life: key shapes as morph targets (solved\n"
        "                        ones where the graph is), weights, size and what rides on the\n"
        "                        skin animated over 10 s, a mesh a part, coloured vertices\n"
        "A file that could not be written whole is not there, or as it was before.\n",
    .run = morph_export_run,
};
