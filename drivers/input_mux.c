/* input_mux.c -- implements the input multiplexers: assigns sources to slots, polls the sources
 * that have no slot, and merges the samples of the button devices. */
#include "drivers/input_mux.h"

#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "drivers/null.h"

/* ---- Assignment of sources to slots --------------------------------------------------------- */

/* Returns the sources that have a slot, one bit for each source. */
static uint32_t assigned_sources(const uint8_t slot[POI_MAX])
{
    uint32_t assigned = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        CORE_ASSERT(slot[i] == SLOT_NONE || slot[i] < INPUT_SOURCE_MAX);
        assigned |= slot[i] == SLOT_NONE ? 0u : 1u << slot[i];
    }
    return assigned;
}

/* Returns the first source of the kind `wanted` in the bit set `sources`, or SLOT_NONE if there is
 * none. */
static uint8_t first_of(const uint8_t *kind, uint32_t count, uint32_t sources, uint8_t wanted)
{
    CORE_ASSERT(count <= INPUT_SOURCE_MAX);
    for (uint32_t i = 0; i < count; i++) {
        if ((sources & (1u << i)) && kind[i] == wanted) {
            return (uint8_t)i;
        }
    }
    return SLOT_NONE;
}

void input_mux_assign(uint8_t slot[POI_MAX], const uint8_t *kind, uint32_t count, uint32_t present)
{
    CORE_ASSERT(count <= INPUT_SOURCE_MAX && present >> count == 0);
    /* Selects at most POI_MAX available sources, best kinds first. Among sources of one kind,
     * sources that already have a slot are selected first. Slot i gets the kind of the i-th
     * selected source. */
    const uint32_t assigned = assigned_sources(slot);
    uint32_t selected = 0, selected_count = 0;
    uint8_t wanted[POI_MAX];
    memset(wanted, SLOT_NONE, sizeof wanted);
    for (uint32_t best = INPUT_KIND_USB; best <= INPUT_KIND_POINTER; best++) {
        for (uint32_t i = 0; i < 2u * count && selected_count < POI_MAX; i++) {
            const uint32_t bit = 1u << i % count;
            const uint32_t candidates = present & (i < count ? assigned : ~assigned);
            if (kind[i % count] == best && (candidates & bit)) {
                selected |= bit;
                wanted[selected_count++] = (uint8_t)best;
            }
        }
    }
    /* A source stays in its slot if the new kind of the slot is still the kind of the source. */
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t source = slot[i];
        const bool stays =
            source < count && (selected & (1u << source)) && kind[source] == wanted[i];
        slot[i] = stays ? source : SLOT_NONE;
        selected &= stays ? ~(1u << source) : selected;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (slot[i] == SLOT_NONE && wanted[i] != SLOT_NONE) {
            slot[i] = first_of(kind, count, selected, wanted[i]);
            CORE_ASSERT(slot[i] != SLOT_NONE);
            selected &= ~(1u << slot[i]);
        }
    }
}

/* Used during a game: replaces each missing source by a free source of the same kind. The free
 * source can be the same controller in a different USB port. */
static void replace_missing(uint8_t slot[POI_MAX], const uint8_t *kind, uint32_t count,
                            uint32_t present)
{
    CORE_ASSERT(present >> count == 0);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (slot[i] != SLOT_NONE && !(present & (1u << slot[i]))) {
            const uint32_t free = present & ~assigned_sources(slot);
            const uint8_t other = first_of(kind, count, free, kind[slot[i]]);
            slot[i] = other != SLOT_NONE ? other : slot[i];
        }
    }
}

/* ---- Devices of the slots -------------------------------------------------------------------- */

_Static_assert(SHADE_MAX == POI_MAX, "each slot has a poi and a fan");

/* Gives a slot to `source`, which may be SLOT_NONE. Stops the motors of the previous source. */
static void set_slot(struct input_mux *mux, uint32_t slot, uint8_t source)
{
    static const struct poi_force nothing = { 0 };
    const struct hal none = null_hal(NULL);
    struct hal_poi *poi = &mux->hal->poi[slot];
    CORE_ASSERT(slot < POI_MAX);
    CORE_ASSERT(source == SLOT_NONE || source < mux->source_count);
    if (mux->slot[slot] != SLOT_NONE) {
        poi->ops->set_force(poi->self, &nothing);
    }
    mux->slot[slot] = source;
    mux->hal->fan[slot] = none.fan[0];
    if (source == SLOT_NONE) {
        *poi = slot == 0 ? null_hal(mux->empty_line).poi[0] : none.poi[0];
        return;
    }
    *poi = mux->source[source].poi;
    if (mux->source[source].fan.ops) {
        mux->hal->fan[slot] = mux->source[source].fan;
    }
}

/* Polls the sources that have no slot. A source with `stands_in` is polled even while its
 * is_present() returns false, because its motion shows that a person uses it. */
static void poll_idle(struct input_mux *mux, uint32_t sources)
{
    struct poi_sample unused[HAL_POI_SAMPLES_MAX];
    CORE_ASSERT(sources >> mux->source_count == 0);
    mux->idle &= sources;
    for (uint32_t i = 0; i < mux->source_count; i++) {
        const struct hal_poi *poi = &mux->source[i].poi;
        const uint32_t bit = 1u << i;
        if (sources & ~mux->idle & bit) {
            mux->idle |= poi->ops->open(poi->self) == HAL_OK ? bit : 0u;
        } else if ((sources & bit) &&
                   poi->ops->poll(poi->self, unused, HAL_POI_SAMPLES_MAX) == HAL_ERR_GONE) {
            mux->idle &= ~bit;
        }
    }
}

static uint32_t arrange(void *self, bool may_move)
{
    struct input_mux *mux = self;
    uint8_t kind[INPUT_SOURCE_MAX], slot[POI_MAX];
    uint32_t present = 0, stand_ins = 0, changed = 0;
    for (uint32_t i = 0; i < mux->source_count; i++) {
        const struct input_source *source = &mux->source[i];
        kind[i] = source->kind;
        stand_ins |= source->stands_in ? 1u << i : 0u;
        present |= !source->is_present || source->is_present(source->self) ? 1u << i : 0u;
    }
    present = present ? present : stand_ins;
    memcpy(slot, mux->slot, sizeof slot);
    if (may_move) {
        input_mux_assign(slot, kind, mux->source_count, present);
    } else {
        replace_missing(slot, kind, mux->source_count, present);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint32_t bit = slot[i] == SLOT_NONE ? 0u : 1u << slot[i];
        const bool is_moved = slot[i] != mux->slot[i];
        const bool is_back = (bit & present & ~mux->present) != 0;
        if (is_moved) {
            set_slot(mux, i, slot[i]);
        }
        changed |= is_moved || is_back ? 1u << i : 0u;
    }
    poll_idle(mux, (present | stand_ins) & ~assigned_sources(slot));
    mux->present = present;
    return changed;
}

struct hal_slots input_mux_init(struct input_mux *mux, struct hal *hal, const char *empty_line)
{
    static const struct hal_slots_ops ops = { .arrange = arrange };
    CORE_ASSERT(empty_line);
    *mux = (struct input_mux){ .hal = hal, .empty_line = empty_line };
    memset(mux->slot, SLOT_NONE, sizeof mux->slot);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        set_slot(mux, i, SLOT_NONE);
    }
    return (struct hal_slots){ .ops = &ops, .self = mux };
}

int input_mux_add(struct input_mux *mux, const struct input_source *source)
{
    CORE_ASSERT(source->poi.ops && source->kind <= INPUT_KIND_POINTER);
    if (mux->source_count == INPUT_SOURCE_MAX) {
        return -1;
    }
    mux->source[mux->source_count++] = *source;
    return 0;
}

/* ---- Merged buttons -------------------------------------------------------------------------- */

int input_buttons_add(struct input_buttons *buttons, struct hal_buttons part)
{
    CORE_ASSERT(part.ops);
    if (buttons->part_count == INPUT_BUTTONS_MAX) {
        return -1;
    }
    buttons->part[buttons->part_count++] = part;
    return 0;
}

/* Polls all parts. Returns HAL_OK if at least one part is present, otherwise HAL_ERR_ABSENT. The
 * sample of a part whose poll fails is merged too. */
static int buttons_poll(void *self, struct button_sample *out)
{
    const struct input_buttons *buttons = self;
    CORE_ASSERT(out && buttons->part_count <= INPUT_BUTTONS_MAX);
    int result = HAL_ERR_ABSENT;
    *out = (struct button_sample){ 0 };
    for (uint32_t i = 0; i < buttons->part_count; i++) {
        struct button_sample part = { 0 };
        if (buttons->part[i].ops->poll(buttons->part[i].self, &part) != HAL_ERR_ABSENT) {
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
static const char *buttons_describe(void *self)
{
    struct input_buttons *buttons = self;
    const char *before = "";
    size_t length = 0;
    buttons->text[0] = '\0';
    for (uint32_t i = 0; i < buttons->part_count && length + 1 < sizeof buttons->text; i++) {
        const char *line = buttons->part[i].ops->describe(buttons->part[i].self);
        if (line[0] && strcmp(line, before) != 0) {
            before = line;
            snprintf(buttons->text + length, sizeof buttons->text - length, "%s%s",
                     length ? "; " : "", line);
            length = strlen(buttons->text);
        }
    }
    return buttons->text;
}

struct hal_buttons input_buttons_device(struct input_buttons *buttons)
{
    CORE_ASSERT(buttons->part_count <= INPUT_BUTTONS_MAX);
    static const struct hal_buttons_ops ops = { .poll = buttons_poll,
                                                .describe = buttons_describe };
    return (struct hal_buttons){ .ops = &ops, .self = buttons };
}
