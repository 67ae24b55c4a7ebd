/* lab_press.h -- what a press, a drag and a release do in the growth lab. Within core/game only. */
#ifndef KINGYO_CORE_GAME_LAB_PRESS_H
#define KINGYO_CORE_GAME_LAB_PRESS_H

#include "core/game/lab_layout.h"
#include "core/output.h"

struct core;

/* Puts a species on the table, with the stall's own edit of it where it keeps one: as a larva,
 * playing. */
void lab_take(struct core *core, uint32_t species);

/* Uses what can be pressed, as if by a hand; not LAB_LEAVE. */
void lab_use(struct core *core, enum lab_part part, struct output *output);

/* The hand comes down, moves on while it is down, and comes up or goes over something. Coming up
 * from LAB_LEAVE ends the lab: one that is still going down would dip and begin it anew. */
void lab_press(struct core *core, struct output *output);
void lab_drag(struct core *core);
void lab_release(struct core *core);

/* Whether what is on the table is the species' own, and whether it is what the stall keeps. */
int lab_is_own(const struct core *core);
int lab_is_kept(const struct core *core);

#endif
