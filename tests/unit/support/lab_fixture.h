/* lab_fixture.h -- test fixture of the growth lab. A poi operates the page of the lab. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_LAB_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_LAB_FIXTURE_H

#include "tests/unit/support/core_fixture.h"

#define ALL ((1u << CHOICE_COUNT) - 1u)
/* Height in metres of a poi that a mouse holds above the water. */
#define UP_M 0.035f
#define DOWN_M (-0.01f)

/* Returns the description (card) of the selected species. */
static inline const struct species_card *card(void)
{
    return lab_book_card(&core.config.book, core.game.lab.species);
}

/* Returns the middle of a control on the lab page. */
static inline struct layout_point middle_of(enum lab_part part)
{
    const struct layout_box box = lab_box(core.game.lab.upright, card()->key_count, part);
    return (struct layout_point){ box.x + 0.5f * box.width, box.y + 0.5f * box.height };
}

/* Moves the poi over a point of the lab page. */
static inline void hover(struct layout_point at)
{
    const struct layout_point canvas = pointer_layout_size(core.game.lab.upright);
    hold(0, v3((at.x / canvas.x - 0.5f) * core.world.tank.size_m.x, UP_M,
               (at.y / canvas.y - 0.5f) * core.world.tank.size_m.z));
    tick();
}

/* Lowers the poi below the water. */
static inline void go_down(void)
{
    input.poi[0].target.position_m.y = DOWN_M;
    tick();
}

/* Lifts the poi above the water. */
static inline void come_up(void)
{
    input.poi[0].target.position_m.y = UP_M;
    tick();
}

/* Presses a control by dipping the poi over its middle. */
static inline void tap(enum lab_part part)
{
    hover(middle_of(part));
    go_down();
    come_up();
}

/* Dips the poi at `from`, moves the poi to `to`, and lifts the poi. */
static inline void drag_down(struct layout_point from, struct layout_point to)
{
    const struct layout_point canvas = pointer_layout_size(core.game.lab.upright);
    hover(from);
    go_down();
    for (uint32_t i = 1; i <= 10; i++) {
        const float share = 0.1f * (float)i;
        const float x = f_lerp(from.x, to.x, share), y = f_lerp(from.y, to.y, share);
        hold(0, v3((x / canvas.x - 0.5f) * core.world.tank.size_m.x, DOWN_M,
                   (y / canvas.y - 0.5f) * core.world.tank.size_m.z));
        tick();
    }
    come_up();
}

/* Returns the point of the lab page at which the curve of `key` has the knot `knot`. */
static inline struct layout_point knot_at(uint32_t knot, uint32_t key)
{
    const struct layout_box plot = lab_box(core.game.lab.upright, card()->key_count, LAB_PLOT);
    const struct graph_knot *at = &core.game.lab.edit.graph.knots[knot];
    return (struct layout_point){ plot.x + at->progress * plot.width,
                                  plot.y + (1.0f - at->weight[key]) * plot.height };
}

/* Opens the growth lab in a core that has no other mode; a cmocka setup function. */
static inline int open_lab(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 5, .fish_count = 12, .modes = 1u << CHOICE_LAB };
    open_core(&config);
    assert_int_equal(core.game.phase, PHASE_LAB);
    return 0;
}

#endif
