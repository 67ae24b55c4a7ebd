/* ui_widgets.h -- drawing functions that several screens share, such as plates, hints, signs and
 * player marks, and one function for each whole screen. */
#ifndef KINGYO_PLATFORM_RENDER_UI_UI_WIDGETS_H
#define KINGYO_PLATFORM_RENDER_UI_UI_WIDGETS_H

#include "core/game/rules.h"
#include "core/scene.h"
#include "platform/render/ui/ui_primitives.h"
#include "platform/render/ui/ui_screens.h"

extern const uint32_t ui_player_colours[POI_MAX]; /* Colour of each player's ring. */

/* Draws a goldfish with its nose to the left, centred at (x, y). */
void ui_fish_sign(const struct ui_frame *frame, float x, float y, float width);

/* Draws a poi (the paper scoop), centred at (x, y). `paper_left` in [0, 1] is the fraction of its
 * paper that is left, and `ring` is the colour of its ring. */
void ui_poi_sign(const struct ui_frame *frame, float x, float y, float radius, float paper_left,
                 uint32_t ring);

/* Draws a translucent plate of night-blue cloth as a background for figures. */
void ui_plate(const struct ui_frame *frame, struct ui_box box);

/* Returns a mode's name. Returns the festival's name for an unknown mode. */
const char *ui_mode_name(uint8_t language, uint8_t mode);

/* Draws the scene's hint, if the scene has one, at the bottom. A new hint fades in. */
void ui_hint_ribbon(const struct ui_frame *frame, const struct scene *scene,
                    const struct ui_memory *memory);

/* Draws the glowing request to start, centred at height `y`. Without credit the ribbon requests
 * coins. Without a poi the ribbon requests a controller. */
void ui_start_ribbon(const struct ui_frame *frame, const struct scene *scene, float y,
                     enum text_key key);

/* Draws the number of paid rounds, centred at (x, y). Draws nothing in free play. */
void ui_credits(const struct ui_frame *frame, const struct scene *scene, float x, float y);

/* Returns 1 if no slot has a controller, so that no player can play, otherwise 0. */
int ui_lacks_poi(const struct scene *scene);

/* Returns 1 if nothing is paid and an inserted coin would be returned, otherwise 0. If 1, the
 * screen requests no coin and shows only the reason. */
int ui_refuses_coins(const struct scene *scene);

/* Writes the number of coins that are missing for a round. */
void ui_coin_words(const struct scene *scene, char *out, size_t out_size);

/* Returns how recently a player tried to start without credit. The value falls from 1 to 0 after
 * the attempt. */
float ui_credit_prompt(const struct scene *scene);

/* Draws the warnings over all other drawings: the cabinet is shaken or open, or has no poi. */
void ui_warnings(const struct ui_frame *frame, const struct scene *scene);

/* Writes a line such as "Best today: 12 fish". If there is no score yet, writes that fact. */
void ui_best_words(const struct scene *scene, char *out, size_t out_size);

/* Draws one word in the middle of the screen's width, centred at height `y`. */
void ui_big_word(const struct ui_frame *frame, enum font_id font, float y, float size_px,
                 float alpha, const char *words);

/* Returns the number of players. */
uint32_t ui_player_count(const struct scene *scene);
/* Returns the index of the first player, or 0 if there is no player. */
uint32_t ui_first_player(const struct scene *scene);

/* Returns the number of slots that play or have a bowl. Before a round begins, no slot plays, so
 * that the bowls are counted. */
uint32_t ui_seat_count(const struct scene *scene);

/* Draws a player's number on a disc of the player's colour, centred at (x, y). */
void ui_player_mark(const struct ui_frame *frame, float x, float y, float radius, uint32_t player);

/* Draws three lamps, of which the first `fouls` are lit. The first lamp is at (x, y). Each further
 * lamp is `step` pixels to the right. */
void ui_foul_lamps(const struct ui_frame *frame, float x, float y, float radius, float step,
                   uint32_t fouls);

/* Draws a plate for each player if there are several players, with number, catch, paper and fouls.
 * The plates are in one row, left of the `right_px` that other plates occupy. If the row is too
 * narrow, the plates are in a second row. Returns the lower edge of the plates in pixels. */
float ui_player_plates(const struct ui_frame *frame, const struct scene *scene,
                       const struct ui_memory *memory, float right_px);

/* Draws the players' numbers over their bowls if there are several players. During a round, only
 * the players of the round have a number. */
void ui_bowl_marks(const struct ui_frame *frame, const struct scene *scene, float alpha);

/* Draws over all other drawings: the stallkeeper's call, the umpire's foul, and the pause after a
 * loss of controller input. */
void ui_umpire(const struct ui_frame *frame, const struct scene *scene);

/* The following functions draw one whole screen each. */
void ui_lab(const struct ui_frame *frame, const struct scene *scene, struct ui_memory *memory);
void ui_album(const struct ui_frame *frame, const struct scene *scene);
void ui_menu(const struct ui_frame *frame, const struct scene *scene);
void ui_name(const struct ui_frame *frame, const struct scene *scene);
void ui_ranking(const struct ui_frame *frame, const struct scene *scene);
void ui_attract(const struct ui_frame *frame, const struct scene *scene);
void ui_choose(const struct ui_frame *frame, const struct scene *scene,
               const struct ui_memory *memory);
void ui_ready(const struct ui_frame *frame, const struct scene *scene,
              const struct ui_memory *memory);
void ui_round(const struct ui_frame *frame, const struct scene *scene,
              const struct ui_memory *memory);
void ui_result(const struct ui_frame *frame, const struct scene *scene,
               const struct ui_memory *memory);

#endif
