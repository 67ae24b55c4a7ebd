/* day.c -- the queue of a simulated day. A round begins when at least one person wants to play, and
 * the first persons of the queue take the bowls. A person who plays again goes to the end of the
 * queue, as at a stall with a queue. All persons of a round play at the easiest level that one of
 * them chose. */
#include "tests/bench/day/day.h"

#include <string.h>

#include "core/base/panic.h"

static void count_visitor(struct day *day, struct visitor *visitor, uint8_t fate)
{
    visitor->fate = fate;
    if (day->progress) {
        progress_add(day->progress);
    }
}

/* ---- Queue ----------------------------------------------------------------------------------- */

static void append_to_queue(struct day *day, uint32_t index, double now_s)
{
    CORE_ASSERT(day->queue_length < DAY_VISITORS_MAX);
    day->visitors[index].joined_s = now_s;
    day->queue[day->queue_length++] = index;
}

/* Adds the visitors who have arrived by now to the queue, unless the price is too high for them. */
static void join_queue(struct day *day)
{
    while (day->next < day->visitor_count && day->visitors[day->next].arrival_s <= day->now_s) {
        struct visitor *visitor = &day->visitors[day->next];
        if (visitor->price_max < day->options->price) {
            count_visitor(day, visitor, VISITOR_DECLINED);
        } else {
            append_to_queue(day, day->next, visitor->arrival_s);
        }
        day->next++;
    }
}

/* Removes the visitors whose patience has ended from the queue. A visitor who waited for another
 * play counts as one who played. */
static void leave_queue(struct day *day)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < day->queue_length; i++) {
        struct visitor *visitor = &day->visitors[day->queue[i]];
        const bool has_played = visitor->plays > 0;
        if (day->now_s - visitor->joined_s > visitor->patience_s) {
            visitor->wait_s = has_played ? visitor->wait_s : visitor->patience_s;
            count_visitor(day, visitor, has_played ? VISITOR_PLAYED : VISITOR_LEFT);
        } else {
            day->queue[kept++] = day->queue[i];
        }
    }
    day->queue_length = kept;
}

/* Gives the bowls to the first visitors of the queue. The member `queue_longest` does not count a
 * visitor who has just joined an empty queue, because this visitor does not wait. */
static void fill_bowls(struct day *day)
{
    const bool is_queue =
        day->queue_length > 0 && day->visitors[day->queue[0]].joined_s < day->now_s;
    if (is_queue && day->queue_length > day->queue_longest) {
        day->queue_longest = day->queue_length;
    }
    const uint32_t bowls = day->options->bowls;
    const uint32_t taken = day->queue_length < bowls ? day->queue_length : bowls;
    for (uint32_t i = 0; i < taken; i++) {
        struct visitor *visitor = &day->visitors[day->queue[i]];
        if (visitor->plays == 0) {
            visitor->wait_s = day->now_s - visitor->arrival_s;
        }
        day->playing[i] = day->queue[i];
    }
    day->playing_count = taken;
    day->queue_length -= taken;
    memmove(day->queue, day->queue + taken, day->queue_length * sizeof day->queue[0]);
}

/* ---- Rounds ---------------------------------------------------------------------------------- */

/* Plays one round with the persons at the bowls. Afterwards the persons who play again stand in the
 * queue behind the visitors who arrived during the round. */
static bool play_round(struct day *day)
{
    const struct visitor *group[POI_MAX];
    struct day_round round = { 0 };
    uint8_t level = LEVEL_MASTER;
    for (uint32_t i = 0; i < day->playing_count; i++) {
        group[i] = &day->visitors[day->playing[i]];
        level = group[i]->level > level ? group[i]->level : level;
    }
    if (!day->kiosk.play(day->kiosk.self, group, day->playing_count, level, &round)) {
        return false;
    }
    day->now_s += round.took_s;
    day->end_s = day->now_s;
    day->busy_s += round.took_s;
    day->rounds[level]++;
    join_queue(day);
    for (uint32_t i = 0; i < day->playing_count; i++) {
        struct visitor *visitor = &day->visitors[day->playing[i]];
        visitor->plays++;
        visitor->caught += round.caught[i];
        visitor->caught_last = round.caught[i];
        if (visitor_plays_again(visitor, day->options->price)) {
            append_to_queue(day, day->playing[i], day->now_s);
        } else {
            count_visitor(day, visitor, VISITOR_PLAYED);
        }
    }
    day->playing_count = 0;
    return true;
}

/* ---- Interface ------------------------------------------------------------------------------- */

void day_init(struct day *day, const struct day_options *options, struct day_kiosk kiosk)
{
    CORE_ASSERT(options->visitors <= DAY_VISITORS_MAX);
    CORE_ASSERT(options->bowls > 0 && options->bowls <= POI_MAX);
    *day = (struct day){ .options = options, .kiosk = kiosk, .visitor_count = options->visitors };
    visitors_draw(day->visitors, options->visitors,
                  &(struct visitor_day){ .hours = (double)options->hours,
                                         .level = options->level,
                                         .seed = options->seed });
}

bool day_run(struct day *day)
{
    for (;;) {
        join_queue(day);
        leave_queue(day);
        fill_bowls(day);
        if (day->playing_count > 0) {
            if (!play_round(day)) {
                return false;
            }
        } else if (day->next < day->visitor_count) {
            const double gap_s = day->visitors[day->next].arrival_s - day->now_s;
            if (!day->kiosk.idle(day->kiosk.self, gap_s)) {
                return false;
            }
            day->now_s += gap_s;
        } else {
            return true;
        }
    }
}
