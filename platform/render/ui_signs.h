/* ui_signs.h -- the small signs that several screens share. */
#ifndef KINGYO_PLATFORM_RENDER_UI_SIGNS_H
#define KINGYO_PLATFORM_RENDER_UI_SIGNS_H

#include "core/game/rules.h"
#include "core/scene.h"
#include "platform/render/ui_parts.h"
#include "platform/render/ui_screens.h"

extern const uint32_t ui_player_colours[POI_MAX]; /* Of each player's ring. */

/* A goldfish, its nose to the left, centred at (x, y). */
void ui_fish_sign(const struct ui_frame *frame, float x, float y, float width);

/* A scoop with that much paper, [0, 1], and its ring in `ring`, centred at (x, y). */
void ui_poi_sign(const struct ui_frame *frame, float x, float y, float radius, float paper_left,
                 uint32_t ring);

/* Night-blue cloth that lets the tank through: what figures stand on. */
void ui_plate(const struct ui_frame *frame, struct ui_box box);

/* What a mode is called; an unknown one is the festival. */
const char *ui_mode_name(uint8_t language, uint8_t mode);

/* The scene's hint at the bottom, if there is one; eases in while it is young. */
void ui_hint_ribbon(const struct ui_frame *frame, const struct scene *scene,
                    const struct ui_memory *memory);

/* The glowing call to play, centred at height `y`; or, where nobody has paid, for coins,
 * and where there is no poi, for one. */
void ui_start_ribbon(const struct ui_frame *frame, const struct scene *scene, float y,
                     enum text_key key);

/* How many rounds are paid for, centred at (x, y); nothing where the play is free. */
void ui_credits(const struct ui_frame *frame, const struct scene *scene, float x, float y);

/* Nobody could play: no seat has a controller. */
int ui_lacks_poi(const struct scene *scene);

/* A coin would come back while nothing is paid: then nobody is asked for one, and the sign that
 * says why stands alone. */
int ui_refuses_coins(const struct scene *scene);

/* How many coins a round still costs. */
void ui_coin_words(const struct scene *scene, char *out, size_t out_size);

/* 1 .. 0: how lately somebody wanted to play who has not paid. */
float ui_asking(const struct scene *scene);

/* Over everything: the cabinet is shaken or open, or has no poi. */
void ui_warnings(const struct ui_frame *frame, const struct scene *scene);

/* "Best today: 12 fish", or that there is none yet. */
void ui_best_words(const struct scene *scene, char *out, size_t out_size);

/* One word across the middle, centred at height `y`. */
void ui_big_word(const struct ui_frame *frame, enum font_id font, float y, float size_px,
                 float alpha, const char *words);

/* How many play, and the first of them; 0 when none does. */
uint32_t ui_player_count(const struct scene *scene);
uint32_t ui_first_player(const struct scene *scene);

/* How many may play here: who plays shows only once a round has begun, and bowls before. */
uint32_t ui_seat_count(const struct scene *scene);

/* A player's number on a round of their colour, centred at (x, y). */
void ui_player_mark(const struct ui_frame *frame, float x, float y, float radius, uint32_t player);

/* Three lamps, lit for fouls, the first at (x, y) and each `step` further down or right. */
void ui_foul_lamps(const struct ui_frame *frame, float x, float y, float radius, float step,
                   uint32_t fouls);

/* Several players' plates, each with number, catch, paper and fouls: in one row, beside what takes
 * `right_px` of it, or in a second row where they do not fit. Returns where they end, downward. */
float ui_player_plates(const struct ui_frame *frame, const struct scene *scene,
                      const struct ui_memory *memory, float right_px);

/* Of several bowls: whose is whose, in numbers over them; once a round runs, of those who play. */
void ui_bowl_marks(const struct ui_frame *frame, const struct scene *scene, float alpha);

/* Over everything: the keeper's call, the umpire's foul, and the wait for a hand that is lost. */
void ui_umpire(const struct ui_frame *frame, const struct scene *scene);

/* A whole screen each. */
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
