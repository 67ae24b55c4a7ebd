/* input_mux.c -- implements the input multiplexer: assigns sources to slots and forwards the calls
 * of each slot to its source. */
#include "drivers/input_mux.h"

#include "core/base/panic.h"

/* ---- Assignment of sources to slots --------------------------------------------------------- */

/* Selects at most POI_MAX available sources (controllers), best kinds first. Among sources of one
 * kind, sources that already have a slot are selected first. Returns one bit for each selected
 * source. */
static uint32_t invited(const uint8_t seat[POI_MAX], const uint8_t *kind, uint32_t count,
                        uint32_t there)
{
    CORE_ASSERT(count <= INPUT_SOURCE_MAX && there >> count == 0);
    uint32_t attachment = 0;
    uint32_t guests = 0;
    uint32_t guest_count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        attachment |= seat[i] < count ? 1u << seat[i] : 0u;
    }
    for (uint32_t best = INPUT_KIND_USB; best <= INPUT_KIND_POINTER; best++) {
        for (uint32_t turn = 0; turn < 2; turn++) {
            const uint32_t some = there & (turn == 0 ? attachment : ~attachment);
            for (uint32_t i = 0; i < count && guest_count < POI_MAX; i++) {
                if (kind[i] == best && (some & (1u << i))) {
                    guests |= 1u << i;
                    guest_count++;
                }
            }
        }
    }
    return guests;
}

/* Returns the best kind among the selected sources that are not assigned to a slot yet. */
static uint8_t best_kind(const uint8_t *kind, uint32_t count, uint32_t guests)
{
    CORE_ASSERT(guests != 0 && count <= INPUT_SOURCE_MAX);
    uint8_t best = INPUT_KIND_POINTER;
    for (uint32_t i = 0; i < count; i++) {
        best = (guests & (1u << i)) && kind[i] < best ? kind[i] : best;
    }
    return best;
}

static uint8_t first_of(const uint8_t *kind, uint32_t count, uint32_t guests, uint8_t wanted)
{
    CORE_ASSERT(count <= INPUT_SOURCE_MAX);
    for (uint8_t i = 0; i < count; i++) {
        if ((guests & (1u << i)) && kind[i] == wanted) {
            return i;
        }
    }
    return SLOT_NONE;
}

/* Assigns a kind to each slot first, and then a source of that kind. A source stays in its slot if
 * the slot keeps the kind. */
void input_mux_assign(uint8_t seat[POI_MAX], const uint8_t *kind, uint32_t count, uint32_t there)
{
    CORE_ASSERT(count <= INPUT_SOURCE_MAX);
    const uint32_t guests = invited(seat, kind, count, there);
    uint8_t wanted[POI_MAX];
    uint32_t standing = guests;
    for (uint32_t i = 0, left = guests; i < POI_MAX; i++) {
        wanted[i] = left ? best_kind(kind, count, left) : SLOT_NONE;
        left &= left ? ~(1u << first_of(kind, count, left, wanted[i])) : 0u;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t sits = seat[i];
        const int stays = sits < count && (standing & (1u << sits)) && kind[sits] == wanted[i];
        seat[i] = stays ? sits : SLOT_NONE;
        standing &= stays ? ~(1u << sits) : standing;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (seat[i] == SLOT_NONE && wanted[i] != SLOT_NONE) {
            seat[i] = first_of(kind, count, standing, wanted[i]);
            standing &= ~(1u << seat[i]);
        }
    }
}

/* ---- Slots and the devices of each slot ----------------------------------------------------- */

void input_mux_init(struct input_mux *mux, const char *empty_line)
{
    CORE_ASSERT(empty_line);
    *mux = (struct input_mux){ .empty_line = empty_line };
    for (uint8_t i = 0; i < POI_MAX; i++) {
        mux->seat[i] = (struct seat){ .mux = mux, .index = i, .source = SLOT_NONE };
    }
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

static const struct input_source *source_of(const struct seat *seat)
{
    CORE_ASSERT(seat->source == SLOT_NONE || seat->source < seat->mux->source_count);
    return seat->source == SLOT_NONE ? NULL : &seat->mux->source[seat->source];
}

/* Stops the motors of a source that loses its slot. `source` may be null. */
static void stand_up(const struct input_source *source)
{
    static const struct poi_force nothing = { 0 };
    if (source) {
        source->poi.ops->set_force(source->poi.self, &nothing);
    }
}

static uint32_t who_is_there(const struct input_mux *mux, uint8_t kind[INPUT_SOURCE_MAX])
{
    CORE_ASSERT(mux->source_count <= INPUT_SOURCE_MAX);
    uint32_t there = 0;
    uint32_t stand_ins = 0;
    for (uint32_t i = 0; i < mux->source_count; i++) {
        const struct input_source *source = &mux->source[i];
        kind[i] = source->kind;
        stand_ins |= source->stands_in ? 1u << i : 0u;
        there |= !source->is_there || source->is_there(source->self) ? 1u << i : 0u;
    }
    return there ? there : stand_ins;
}

/* Returns one bit for each slot whose source was missing and is available again. The function is
 * called during games too. */
static uint32_t who_came_back(const struct input_mux *mux, uint32_t there)
{
    CORE_ASSERT(there >> mux->source_count == 0);
    uint32_t back = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t source = mux->seat[i].source;
        const uint32_t bit = source == SLOT_NONE ? 0u : 1u << source;
        back |= bit & there & ~mux->there ? 1u << i : 0u;
    }
    return back;
}

static uint32_t move_seats(struct input_mux *mux, const uint8_t kind[INPUT_SOURCE_MAX],
                           uint32_t there)
{
    CORE_ASSERT(there >> mux->source_count == 0);
    uint8_t sits[POI_MAX];
    uint32_t moved = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        sits[i] = mux->seat[i].source;
    }
    input_mux_assign(sits, kind, mux->source_count, there);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct seat *seat = &mux->seat[i];
        if (sits[i] != seat->source) {
            stand_up(source_of(seat));
            seat->source = sits[i];
            moved |= 1u << i;
        }
    }
    return moved;
}

static uint32_t who_sits(const struct input_mux *mux)
{
    uint32_t attachment = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t source = mux->seat[i].source;
        attachment |= source == SLOT_NONE ? 0u : 1u << source;
    }
    return attachment;
}

/* Used during a game: replaces each missing source by a free source of the same kind. The free
 * source can be the same controller in a different USB port. */
static uint32_t take_up_others(struct input_mux *mux, const uint8_t kind[INPUT_SOURCE_MAX],
                               uint32_t there)
{
    CORE_ASSERT(there >> mux->source_count == 0);
    uint32_t moved = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t away = mux->seat[i].source;
        const uint32_t standing = there & ~who_sits(mux);
        if (away == SLOT_NONE || (there & (1u << away))) {
            continue;
        }
        const uint8_t other = first_of(kind, mux->source_count, standing, kind[away]);
        if (other != SLOT_NONE) {
            mux->seat[i].source = other;
            moved |= 1u << i;
        }
    }
    return moved;
}

static void listen(struct input_mux *mux, uint32_t index)
{
    const struct hal_poi *poi = &mux->source[index].poi;
    CORE_ASSERT(index < mux->source_count);
    const uint32_t bit = 1u << index;
    struct poi_sample unheard[HAL_POI_SAMPLES_MAX];
    if (!(mux->idle & bit)) {
        mux->idle |= poi->ops->open(poi->self) == HAL_OK ? bit : 0u;
    } else if (poi->ops->poll(poi->self, unheard, HAL_POI_SAMPLES_MAX) == HAL_ERR_GONE) {
        mux->idle &= ~bit;
    }
}

/* Polls the sources that have no slot. A stand-in is polled even while is_there() returns 0,
 * because its motion shows that a person uses it. */
static void listen_to_idle(struct input_mux *mux, uint32_t there)
{
    CORE_ASSERT(there >> mux->source_count == 0);
    uint32_t heard = there;
    for (uint32_t i = 0; i < mux->source_count; i++) {
        heard |= mux->source[i].stands_in ? 1u << i : 0u;
    }
    heard &= ~who_sits(mux);
    mux->idle &= heard;
    for (uint32_t i = 0; i < mux->source_count; i++) {
        if (heard & (1u << i)) {
            listen(mux, i);
        }
    }
}

static uint32_t seats_arrange(void *self, int may_move)
{
    struct input_mux *mux = self;
    uint8_t kind[INPUT_SOURCE_MAX];
    const uint32_t there = who_is_there(mux, kind);
    uint32_t changed = who_came_back(mux, there);
    changed |= may_move ? move_seats(mux, kind, there) : take_up_others(mux, kind, there);
    listen_to_idle(mux, there);
    mux->there = there;
    return changed;
}

static int seat_open(void *self)
{
    const struct seat *seat = self;
    const struct input_source *source = source_of(seat);
    if (!source) {
        return HAL_ERR_ABSENT;
    }
    const int result = source->poi.ops->open(source->poi.self);
    if (result == HAL_OK && seat->mux->has_view) {
        source->poi.ops->set_view(source->poi.self, &seat->mux->view, &seat->mux->display_settings);
    }
    return result;
}

static int seat_poll(void *self, struct poi_sample *out, uint32_t max)
{
    CORE_ASSERT(out || max == 0);
    const struct input_source *source = source_of(self);
    return source ? source->poi.ops->poll(source->poi.self, out, max) : (int)HAL_ERR_ABSENT;
}

static int seat_set_force(void *self, const struct poi_force *force)
{
    CORE_ASSERT(force);
    const struct input_source *source = source_of(self);
    return source ? source->poi.ops->set_force(source->poi.self, force) : (int)HAL_ERR_ABSENT;
}

static void seat_set_view(void *self, const struct view *view,
                          const struct display_settings *display_settings)
{
    const struct seat *seat = self;
    CORE_ASSERT(view && display_settings);
    const struct input_source *source = source_of(seat);
    seat->mux->view = *view;
    seat->mux->display_settings = *display_settings;
    seat->mux->has_view = 1;
    if (source) {
        source->poi.ops->set_view(source->poi.self, view, display_settings);
    }
}

static const char *seat_describe(void *self)
{
    const struct seat *seat = self;
    const struct input_source *source = source_of(seat);
    return source             ? source->poi.ops->describe(source->poi.self)
           : seat->index == 0 ? seat->mux->empty_line
                              : "";
}

static const struct hal_fan *fan_of(const struct seat *seat)
{
    const struct input_source *source = source_of(seat);
    return source && source->fan.ops ? &source->fan : NULL;
}

static int input_mux_fan_open(void *self)
{
    const struct hal_fan *fan = fan_of(self);
    return fan ? fan->ops->open(fan->self) : (int)HAL_ERR_ABSENT;
}

static int input_mux_fan_poll(void *self, struct shade_input *out)
{
    const struct hal_fan *fan = fan_of(self);
    return fan ? fan->ops->poll(fan->self, out) : (int)HAL_ERR_ABSENT;
}

static const char *input_mux_fan_describe(void *self)
{
    const struct hal_fan *fan = fan_of(self);
    return fan ? fan->ops->describe(fan->self) : "";
}

struct hal_poi input_mux_poi(struct input_mux *mux, uint32_t seat)
{
    static const struct hal_poi_ops ops = {
        .open = seat_open,
        .poll = seat_poll,
        .set_force = seat_set_force,
        .set_view = seat_set_view,
        .describe = seat_describe,
    };
    CORE_ASSERT(seat < POI_MAX);
    return (struct hal_poi){ .ops = &ops, .self = &mux->seat[seat] };
}

struct hal_fan input_mux_fan(struct input_mux *mux, uint32_t seat)
{
    static const struct hal_fan_ops ops = {
        .open = input_mux_fan_open,
        .poll = input_mux_fan_poll,
        .describe = input_mux_fan_describe,
    };
    CORE_ASSERT(seat < POI_MAX);
    return (struct hal_fan){ .ops = &ops, .self = &mux->seat[seat] };
}

struct hal_seats input_mux_device(struct input_mux *mux)
{
    CORE_ASSERT(mux);
    static const struct hal_seats_ops ops = { .arrange = seats_arrange };
    return (struct hal_seats){ .ops = &ops, .self = mux };
}
