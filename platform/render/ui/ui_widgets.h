/* ui_widgets.h -- small widgets that several screens share. */
#ifndef KINGYO_PLATFORM_RENDER_UI_UI_WIDGETS_H
#define KINGYO_PLATFORM_RENDER_UI_UI_WIDGETS_H

#include "core/game/rules.h"
#include "core/scene.h"
#include "platform/render/ui/ui_primitives.h"
#include "platform/render/ui/ui_screens.h"

extern const uint32_t ui_player_colours[POI_MAX]; /* Colour of each player's ring. */

/* Draws a goldfish, its nose to the left, centred at (x, y). */
void ui_fish_sign(const struct ui_frame *frame, float x, float y, float width);

/* Draws a scoop with the fraction `paper_left` [0, 1] of its paper and its ring in colour `ring`,
 * centred at (x, y). */
void ui_poi_sign(const struct ui_frame *frame, float x, float y, float radius, float paper_left,
                 uint32_t ring);

/* Draws a translucent plate of night-blue cloth as a background for figures. */
void ui_plate(const struct ui_frame *frame, struct ui_box box);

/* Returns a mode's name. An unknown mode returns the festival. */
const char *ui_mode_name(uint8_t language, uint8_t mode);

/* Draws the scene's hint, if any, at the bottom. A new hint fades in. */
void ui_hint_ribbon(const struct ui_frame *frame, const struct scene *scene,
                    const struct ui_memory *memory);

/* Draws the glowing call to play, centred at height `y`. Without credit it asks for coins, and
 * without a poi for a controller. */
void ui_start_ribbon(const struct ui_frame *frame, const struct scene *scene, float y,
                     enum text_key key);

/* Draws the number of paid rounds, centred at (x, y). Draws nothing in free play. */
void ui_credits(const struct ui_frame *frame, const struct scene *scene, float x, float y);

/* Returns 1 if no slot has a controller, so that nobody can play. */
int ui_lacks_poi(const struct scene *scene);

/* Returns 1 if a coin would be returned while nothing is paid. The screen then asks for no coin,
 * and shows only the reason. */
int ui_refuses_coins(const struct scene *scene);

/* Writes how many coins a round still costs. */
void ui_coin_words(const struct scene *scene, char *out, size_t out_size);

/* Returns 1 .. 0: how recently a player without credit tried to start. */
float ui_credit_prompt(const struct scene *scene);

/* Draws the warnings over everything: the cabinet is shaken or open, or has no poi. */
void ui_warnings(const struct ui_frame *frame, const struct scene *scene);

/* Writes a line such as "Best today: 12 fish", or that there is no score yet. */
void ui_best_words(const struct scene *scene, char *out, size_t out_size);

/* Draws one word across the middle, centred at height `y`. */
void ui_big_word(const struct ui_frame *frame, enum font_id font, float y, float size_px,
                 float alpha, const char *words);

/* Return the number of players, and the index of the first player; 0 when there is none. */
uint32_t ui_player_count(const struct scene *scene);
uint32_t ui_first_player(const struct scene *scene);

/* Returns how many can play here. Players are known only after a round has begun; before it, the
 * bowls are counted. */
uint32_t ui_seat_count(const struct scene *scene);

/* Draws a player's number on a disc of the player's colour, centred at (x, y). */
void ui_player_mark(const struct ui_frame *frame, float x, float y, float radius, uint32_t player);

/* Draws three lamps, lit for fouls, the first at (x, y) and each `step` further down or right. */
void ui_foul_lamps(const struct ui_frame *frame, float x, float y, float radius, float step,
                   uint32_t fouls);

/* Draws a plate for each of several players, with number, catch, paper and fouls. The plates are in
 * one row, left of the `right_px` used by other plates, or in a second row where they do not fit.
 * Returns their lower edge in pixels. */
float ui_player_plates(const struct ui_frame *frame, const struct scene *scene,
                       const struct ui_memory *memory, float right_px);

/* Draws the players' numbers over their bowls if there are several; during a round only for those
 * who play. */
void ui_bowl_marks(const struct ui_frame *frame, const struct scene *scene, float alpha);

/* Draws over everything: the stallkeeper's call, the umpire's foul, and the pause for lost
 * controller input. */
void ui_umpire(const struct ui_frame *frame, const struct scene *scene);

/* Each function draws a whole screen. */
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
