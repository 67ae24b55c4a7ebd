/* buttons_mux.c -- implements the merged button device: polls every part and merges the samples. */
#include "drivers/buttons_mux.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"

int buttons_mux_add(struct buttons_mux *join, struct hal_buttons part)
{
    CORE_ASSERT(part.ops);
    if (join->part_count == BUTTONS_MUX_MAX) {
        return -1;
    }
    join->part[join->part_count++] = part;
    return 0;
}

/* Polls all parts. Returns HAL_OK if at least one part is present, otherwise HAL_ERR_ABSENT. The
 * sample of a part whose poll fails is merged too. */
static int join_poll(void *self, struct button_sample *out)
{
    const struct buttons_mux *join = self;
    CORE_ASSERT(out && join->part_count <= BUTTONS_MUX_MAX);
    int result = HAL_ERR_ABSENT;
    *out = (struct button_sample){ 0 };
    for (uint32_t i = 0; i < join->part_count; i++) {
        struct button_sample part = { 0 };
        if (join->part[i].ops->poll(join->part[i].self, &part) != HAL_ERR_ABSENT) {
            result = HAL_OK;
        }
        out->held |= part.held;
        out->pressed |= part.pressed;
        out->raw |= part.raw;
        out->missing |= part.missing;
        out->quit |= part.quit;
        out->full_screen |= part.full_screen;
        out->faults += part.faults;
        for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
            out->coin_count[line] += part.coin_count[line];
        }
        for (uint32_t line = 0; line < HAL_LINE_COUNT; line++) {
            out->line[line].edges += part.line[line].edges;
            out->line[line].faults += part.line[line].faults;
        }
    }
    return result;
}

/* Joins the descriptions of the parts with "; ". If consecutive parts have equal descriptions, the
 * description is written only once. For example, four controllers may have equal descriptions. */
static const char *join_describe(void *self)
{
    struct buttons_mux *join = self;
    const char *before = "";
    size_t length = 0;
    join->text[0] = '\0';
    for (uint32_t i = 0; i < join->part_count && length + 1 < sizeof join->text; i++) {
        const char *line = join->part[i].ops->describe(join->part[i].self);
        if (line[0] && strcmp(line, before) != 0) {
            before = line;
            snprintf(join->text + length, sizeof join->text - length, "%s%s", length ? "; " : "",
                     line);
            length = strlen(join->text);
        }
    }
    return join->text;
}

struct hal_buttons buttons_mux_device(struct buttons_mux *join)
{
    CORE_ASSERT(join->part_count <= BUTTONS_MUX_MAX);
    static const struct hal_buttons_ops ops = { .poll = join_poll, .describe = join_describe };
    return (struct hal_buttons){ .ops = &ops, .self = join };
}
