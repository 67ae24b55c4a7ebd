/* seats.c -- assigns sources to slots and forwards the calls of each slot to its source. */
#include "drivers/seats.h"

#include "core/base/panic.h"

/* ---- Assignment ----------------------------------------------------------------------------- */

/* Selects at most one available source for each slot, best kinds first, one bit each. Within a
 * kind, sources that have a slot come first. */
static uint32_t invited(const uint8_t seat[POI_MAX], const uint8_t *kind, uint32_t count,
                        uint32_t there)
{
    uint32_t sitting = 0;
    uint32_t guests = 0;
    uint32_t guest_count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        sitting |= seat[i] < count ? 1u << seat[i] : 0u;
    }
    for (uint32_t best = SEAT_USB; best <= SEAT_POINTER; best++) {
        for (uint32_t turn = 0; turn < 2; turn++) {
            const uint32_t some = there & (turn == 0 ? sitting : ~sitting);
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

/* Returns the best kind among the selected sources that are not assigned yet. */
static uint8_t best_kind(const uint8_t *kind, uint32_t count, uint32_t guests)
{
    uint8_t best = SEAT_POINTER;
    for (uint32_t i = 0; i < count; i++) {
        best = (guests & (1u << i)) && kind[i] < best ? kind[i] : best;
    }
    return best;
}

static uint8_t first_of(const uint8_t *kind, uint32_t count, uint32_t guests, uint8_t wanted)
{
    for (uint8_t i = 0; i < count; i++) {
        if ((guests & (1u << i)) && kind[i] == wanted) {
            return i;
        }
    }
    return SEAT_EMPTY;
}

/* Assigns a kind to each slot first, then a source. A source whose slot has the right kind
 * stays. */
void seats_share(uint8_t seat[POI_MAX], const uint8_t *kind, uint32_t count, uint32_t there)
{
    const uint32_t guests = invited(seat, kind, count, there);
    uint8_t wanted[POI_MAX];
    uint32_t standing = guests;
    for (uint32_t i = 0, left = guests; i < POI_MAX; i++) {
        wanted[i] = left ? best_kind(kind, count, left) : SEAT_EMPTY;
        left &= left ? ~(1u << first_of(kind, count, left, wanted[i])) : 0u;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t sits = seat[i];
        const int stays = sits < count && (standing & (1u << sits)) && kind[sits] == wanted[i];
        seat[i] = stays ? sits : SEAT_EMPTY;
        standing &= stays ? ~(1u << sits) : standing;
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (seat[i] == SEAT_EMPTY && wanted[i] != SEAT_EMPTY) {
            seat[i] = first_of(kind, count, standing, wanted[i]);
            standing &= ~(1u << seat[i]);
        }
    }
}

/* ---- Slots ---------------------------------------------------------------------------------- */

void seats_init(struct seats *seats, const char *empty_line)
{
    *seats = (struct seats){ .empty_line = empty_line };
    for (uint8_t i = 0; i < POI_MAX; i++) {
        seats->seat[i] = (struct seat){ .seats = seats, .index = i, .source = SEAT_EMPTY };
    }
}

int seats_add(struct seats *seats, const struct seat_source *source)
{
    CORE_ASSERT(source->poi.ops && source->kind <= SEAT_POINTER);
    if (seats->source_count == SEAT_SOURCE_MAX) {
        return -1;
    }
    seats->source[seats->source_count++] = *source;
    return 0;
}

static const struct seat_source *source_of(const struct seat *seat)
{
    return seat->source == SEAT_EMPTY ? NULL : &seat->seats->source[seat->source];
}

/* Stops the motors of a source that loses its slot. */
static void stand_up(const struct seat_source *source)
{
    static const struct poi_force nothing = { 0 };
    if (source) {
        source->poi.ops->feel(source->poi.self, &nothing);
    }
}

static uint32_t who_is_there(const struct seats *seats, uint8_t kind[SEAT_SOURCE_MAX])
{
    uint32_t there = 0;
    uint32_t stand_ins = 0;
    for (uint32_t i = 0; i < seats->source_count; i++) {
        const struct seat_source *source = &seats->source[i];
        kind[i] = source->kind;
        stand_ins |= source->stands_in ? 1u << i : 0u;
        there |= !source->is_there || source->is_there(source->self) ? 1u << i : 0u;
    }
    return there ? there : stand_ins;
}

/* Returns the slots whose missing source is available again, also during a game. */
static uint32_t who_came_back(const struct seats *seats, uint32_t there)
{
    uint32_t back = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t source = seats->seat[i].source;
        const uint32_t bit = source == SEAT_EMPTY ? 0u : 1u << source;
        back |= bit & there & ~seats->there ? 1u << i : 0u;
    }
    return back;
}

static uint32_t move_seats(struct seats *seats, const uint8_t kind[SEAT_SOURCE_MAX],
                           uint32_t there)
{
    uint8_t sits[POI_MAX];
    uint32_t moved = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        sits[i] = seats->seat[i].source;
    }
    seats_share(sits, kind, seats->source_count, there);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        struct seat *seat = &seats->seat[i];
        if (sits[i] != seat->source) {
            stand_up(source_of(seat));
            seat->source = sits[i];
            moved |= 1u << i;
        }
    }
    return moved;
}

static uint32_t who_sits(const struct seats *seats)
{
    uint32_t sitting = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t source = seats->seat[i].source;
        sitting |= source == SEAT_EMPTY ? 0u : 1u << source;
    }
    return sitting;
}

/* During a game, replaces a missing source by a free source of the same kind, which can be the
 * same controller plugged in elsewhere. */
static uint32_t take_up_others(struct seats *seats, const uint8_t kind[SEAT_SOURCE_MAX],
                               uint32_t there)
{
    uint32_t moved = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint8_t away = seats->seat[i].source;
        const uint32_t standing = there & ~who_sits(seats);
        if (away == SEAT_EMPTY || (there & (1u << away))) {
            continue;
        }
        const uint8_t other = first_of(kind, seats->source_count, standing, kind[away]);
        if (other != SEAT_EMPTY) {
            seats->seat[i].source = other;
            moved |= 1u << i;
        }
    }
    return moved;
}

static void listen(struct seats *seats, uint32_t index)
{
    const struct hal_poi *poi = &seats->source[index].poi;
    const uint32_t bit = 1u << index;
    struct poi_sample unheard[HAL_POI_SAMPLES_MAX];
    if (!(seats->idle & bit)) {
        seats->idle |= poi->ops->open(poi->self) == HAL_OK ? bit : 0u;
    } else if (poi->ops->poll(poi->self, unheard, HAL_POI_SAMPLES_MAX) == HAL_ERR_GONE) {
        seats->idle &= ~bit;
    }
}

/* Polls the sources without a slot. A stand-in is polled even if it is not available, because
 * its motion shows that a person uses it. */
static void listen_to_idle(struct seats *seats, uint32_t there)
{
    uint32_t heard = there;
    for (uint32_t i = 0; i < seats->source_count; i++) {
        heard |= seats->source[i].stands_in ? 1u << i : 0u;
    }
    heard &= ~who_sits(seats);
    seats->idle &= heard;
    for (uint32_t i = 0; i < seats->source_count; i++) {
        if (heard & (1u << i)) {
            listen(seats, i);
        }
    }
}

static uint32_t seats_arrange(void *self, int may_move)
{
    struct seats *seats = self;
    uint8_t kind[SEAT_SOURCE_MAX];
    const uint32_t there = who_is_there(seats, kind);
    uint32_t changed = who_came_back(seats, there);
    changed |= may_move ? move_seats(seats, kind, there) : take_up_others(seats, kind, there);
    listen_to_idle(seats, there);
    seats->there = there;
    return changed;
}

static int seat_open(void *self)
{
    const struct seat *seat = self;
    const struct seat_source *source = source_of(seat);
    if (!source) {
        return HAL_ERR_NONE;
    }
    const int result = source->poi.ops->open(source->poi.self);
    if (result == HAL_OK && seat->seats->has_view) {
        source->poi.ops->look(source->poi.self, &seat->seats->view, &seat->seats->showing);
    }
    return result;
}

static int seat_poll(void *self, struct poi_sample *out, uint32_t max)
{
    const struct seat_source *source = source_of(self);
    return source ? source->poi.ops->poll(source->poi.self, out, max) : (int)HAL_ERR_NONE;
}

static int seat_feel(void *self, const struct poi_force *force)
{
    const struct seat_source *source = source_of(self);
    return source ? source->poi.ops->feel(source->poi.self, force) : (int)HAL_ERR_NONE;
}

static void seat_look(void *self, const struct view *view, const struct showing *showing)
{
    const struct seat *seat = self;
    const struct seat_source *source = source_of(seat);
    seat->seats->view = *view;
    seat->seats->showing = *showing;
    seat->seats->has_view = 1;
    if (source) {
        source->poi.ops->look(source->poi.self, view, showing);
    }
}

static const char *seat_describe(void *self)
{
    const struct seat *seat = self;
    const struct seat_source *source = source_of(seat);
    return source             ? source->poi.ops->describe(source->poi.self)
           : seat->index == 0 ? seat->seats->empty_line
                              : "";
}

static const struct hal_shade *fan_of(const struct seat *seat)
{
    const struct seat_source *source = source_of(seat);
    return source && source->fan.ops ? &source->fan : NULL;
}

static int fan_open(void *self)
{
    const struct hal_shade *fan = fan_of(self);
    return fan ? fan->ops->open(fan->self) : (int)HAL_ERR_NONE;
}

static int fan_poll(void *self, struct shade_input *out)
{
    const struct hal_shade *fan = fan_of(self);
    return fan ? fan->ops->poll(fan->self, out) : (int)HAL_ERR_NONE;
}

static const char *fan_describe(void *self)
{
    const struct hal_shade *fan = fan_of(self);
    return fan ? fan->ops->describe(fan->self) : "";
}

struct hal_poi seats_poi(struct seats *seats, uint32_t seat)
{
    static const struct hal_poi_ops ops = {
        .open = seat_open,
        .poll = seat_poll,
        .feel = seat_feel,
        .look = seat_look,
        .describe = seat_describe,
    };
    CORE_ASSERT(seat < POI_MAX);
    return (struct hal_poi){ .ops = &ops, .self = &seats->seat[seat] };
}

struct hal_shade seats_fan(struct seats *seats, uint32_t seat)
{
    static const struct hal_shade_ops ops = {
        .open = fan_open,
        .poll = fan_poll,
        .describe = fan_describe,
    };
    CORE_ASSERT(seat < POI_MAX);
    return (struct hal_shade){ .ops = &ops, .self = &seats->seat[seat] };
}

struct hal_seats seats_device(struct seats *seats)
{
    static const struct hal_seats_ops ops = { .arrange = seats_arrange };
    return (struct hal_seats){ .ops = &ops, .self = seats };
}
