/* ui_widgets.h -- drawing functions that several screens share, such as plates, hints, signs and
 * player marks, the leaderboard, and one function for each whole screen. */
#pragma once

#include "core/game/rules.h"
#include "core/scene.h"
#include "platform/render/ui/ui_primitives.h"
#include "platform/render/ui/ui_screens.h"

extern const uint32_t ui_player_colours[POI_MAX]; /* Colour of each player's ring, 0xRRGGBBAA. */

/* Draws a goldfish with its nose to the left, centred at (x, y). */
void ui_fish_sign(const struct ui_frame *frame, float x, float y, float width);

/* Draws a poi (the paper scoop), centred at (x, y). `paper_left` in [0, 1] is the fraction of the
 * paper that is not torn, and `ring` is the colour of the poi's ring. */
void ui_poi_sign(const struct ui_frame *frame, float x, float y, float radius, float paper_left,
                 uint32_t ring);

/* Draws a bow of ribbon, the sign of a present. The knot is at (x, y), and the bow is `width`
 * pixels wide. */
void ui_bow(const struct ui_frame *frame, float x, float y, float width);

/* Draws the pointer of a player, a ring without paper, so that the text below the ring stays
 * readable. The ring is smaller while `presses` is true. The frame is a canvas (ui_canvas()), and
 * (`x`, `y`) is in canvas units. */
void ui_pointer(const struct ui_frame *canvas, float x, float y, bool presses, uint32_t ring);

/* Draws a translucent plate of night-blue cloth as the background of numbers. */
void ui_plate(const struct ui_frame *frame, struct ui_box box);

/* Returns a mode's name. Returns the name of the festival mode if `mode` is unknown. */
const char *ui_mode_name(uint8_t language, uint8_t mode);

/* Draws the hint of the scene at the bottom of the screen. Draws nothing if the scene has no hint.
 * A new hint fades in. */
void ui_hint_ribbon(const struct ui_frame *frame);

/* Draws the glowing ribbon with the request to start (text `key`), centred at height `y`.
 * Without credit, the ribbon requests coins. If no slot has a controller, the ribbon requests a
 * controller. Draws nothing if no round is paid and an inserted coin would be returned. */
void ui_start_ribbon(const struct ui_frame *frame, float y, enum text_key key);

/* Draws the number of paid rounds (credits), centred at (x, y). Draws nothing in free play. */
void ui_credits(const struct ui_frame *frame, float x, float y);

/* Draws the active warnings over all other drawings, for example that the cabinet is shaken, that
 * its door is open, or that no controller is present. */
void ui_warnings(const struct ui_frame *frame);

/* Writes a line such as "Best today: 12 fish". If no score exists yet, writes a line that states
 * this. */
void ui_best_words(const struct scene *scene, char *out, size_t out_size);

/* Draws a ribbon with the best score of the day, centred at height `y`. */
void ui_best_ribbon(const struct ui_frame *frame, float y, float size_px);

/* Returns the name of a level (enum level). */
const char *ui_level_name(uint8_t language, uint8_t level);

/* Draws the picture of a level (enum level): a child, an adult or a champion. The feet are at
 * (x, y), and an adult is `height` pixels tall. */
void ui_level_figure(const struct ui_frame *frame, float x, float y, float height, uint8_t level);

/* Draws a small wooden tag with the picture of a level in `box`. */
void ui_level_tag(const struct ui_frame *frame, struct ui_box box, uint8_t level);

/* Draws one word in the horizontal middle of the screen, centred at height `y`. */
void ui_big_word(const struct ui_frame *frame, enum font_id font, float y, float size_px,
                 float alpha, const char *words);

/* Returns the number of players. */
uint32_t ui_player_count(const struct scene *scene);
/* Returns the index of the first player, or 0 if there is no player. */
uint32_t ui_first_player(const struct scene *scene);

/* Returns the number of slots that play or have a bowl. Before a round begins, no slot plays, so
 * that only the slots with a bowl are counted. */
uint32_t ui_bowl_count(const struct scene *scene);

/* Records the numbers of caught fish of `scene`. For each fish that was caught since the last call,
 * a paper tag begins to fly from the bowl to the counter (the displayed number of fish). */
void ui_catch_notice(struct ui_memory *memory, const struct scene *scene);
/* Returns the number of a player's caught fish whose tags have arrived at the counter. */
uint32_t ui_catch_shown(const struct ui_frame *frame, uint32_t player);
/* Returns the strength of the emphasis on a player's number of caught fish, [0, 1]. The strength is
 * 1 immediately after a tag has arrived at the counter, and decreases to 0. */
float ui_catch_pop(const struct ui_frame *frame, uint32_t player);
/* Draws the tags of a player that fly from the bowl to the point `counter`. */
void ui_catch_flights(const struct ui_frame *frame, uint32_t player, struct ui_point counter);
/* Returns true while a word is shown over the poi of `player` because the poi narrowly missed a
 * fish. */
bool ui_shows_near_miss(const struct scene *scene, uint32_t player);
/* Draws the word for a near miss over each poi for which ui_shows_near_miss() returns true. */
void ui_near_misses(const struct ui_frame *frame);

/* Draws a player's number on a disc of the player's colour, centred at (x, y). */
void ui_player_mark(const struct ui_frame *frame, float x, float y, float radius, uint32_t player);

/* Draws three lamps, of which the first `fouls` are lit. The first lamp is at (x, y). Each further
 * lamp is `step` pixels to the right. */
void ui_foul_lamps(const struct ui_frame *frame, float x, float y, float radius, float step,
                   uint32_t fouls);

/* Draws a plate for each player with number, catch, paper and fouls. Draws nothing if there is only
 * one player. At the right edge of the top row, other plates occupy `right_px` pixels. The players'
 * plates are to the left of these plates, or in a second row below if the top row is too narrow.
 * Returns the lower edge of the players' plates in pixels. */
float ui_player_plates(const struct ui_frame *frame, float right_px);

/* Draws the players' numbers over their bowls if there are several players. During a round, only
 * the players of the round have a number. */
void ui_bowl_marks(const struct ui_frame *frame, float alpha);

/* If there are several players, draws each player's number on the handle of the player's poi, so
 * that players can find their poi without its colour. */
void ui_handle_marks(const struct ui_frame *frame);

/* Draws the lessons of all players into the tank: ghosts (translucent pois that demonstrate a
 * motion), rings around fish, arrows to the bowls, and hints beside the pois. */
void ui_lessons(const struct ui_frame *frame);

/* Draws the hint of `player` beside the player's poi, as a picture and, for a single player, as a
 * line of words. Draws nothing if the player has no hint. */
void ui_poi_hint(const struct ui_frame *frame, uint32_t player);

/* Returns the words of a hint (enum scene_hint), which must not be HINT_NONE. */
const char *ui_hint_words(const struct ui_frame *frame, uint8_t hint);

/* Draws the stallkeeper's announcements, the umpire's foul signs, and the pause after a loss of
 * controller input over all other drawings. */
void ui_umpire(const struct ui_frame *frame);

/* Returns the player whose slow motion of a tear is shown, or POI_MAX if no paper tore. Several
 * players are shown one after another. */
uint32_t ui_torn_player(const struct scene *scene);
/* Shows in `box` why the paper of `player` tore: the slow motion of the first tear, a picture of
 * the cause, and words. The three parts are side by side if the box is wider than high. */
void ui_tear(const struct ui_frame *frame, uint32_t player, struct ui_box box);

/* Declarations of functions that each draw one whole screen. */
void ui_lab(const struct ui_frame *frame);
void ui_album(const struct ui_frame *frame);
void ui_menu(const struct ui_frame *frame);
void ui_name(const struct ui_frame *frame);
void ui_ranking(const struct ui_frame *frame);
void ui_attract(const struct ui_frame *frame);
void ui_choose(const struct ui_frame *frame);
void ui_ready(const struct ui_frame *frame);
void ui_round(const struct ui_frame *frame);
void ui_result(const struct ui_frame *frame);

/* Returns the opacity, [0, 1], of the leaderboard `board`, which fades in and out. 0 means that the
 * leaderboard is hidden. */
float ui_leaderboard_in(const struct scene_leaderboard *board);

/* Draws the leaderboard, vertically centred between `top` and `bottom` in pixels. Draws nothing
 * while the leaderboard is hidden. */
void ui_leaderboard(const struct ui_frame *frame, float top, float bottom);

/* Draws the seal "Genuine", which means that the recording of a round is stored and can verify the
 * score. The seal is centred at (x, y) and is `size` pixels wide and high. */
void ui_genuine_seal(const struct ui_frame *frame, float x, float y, float size);

/* Draws a score such as "12 fish". The text ends at `right` pixels. The number has the style
 * `digits`, and the word has the style `unit`. The words "12" and "fish" are `gap` pixels apart.
 * The digits are vertically centred on `y`. Returns the right end of the number in pixels. */
float ui_score(const struct ui_frame *frame, struct ui_text digits, struct ui_text unit,
               float right, float y, float gap, uint32_t caught);

/* Texts of a leaderboard period (enum rank_period). */
struct ui_period {
    enum text_key title; /* Text such as "Today's best". */
    enum text_key place; /* Text such as "No. {} today". */
};
/* Returns the name of the shown leaderboard's mode, followed by its level if the mode has levels.
 * `out` is memory that the function may use for the result. */
const char *ui_leaderboard_name(const struct ui_frame *frame, char out[TEXT_LINE_MAX]);

/* Returns the texts of a leaderboard period. Returns the texts of the all-time leaderboard
 * (RANK_EVER) if `period` is unknown. */
const struct ui_period *ui_leaderboard_period(uint8_t period);
