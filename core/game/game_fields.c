/* game_fields.c -- the tables of the members of the game's state. The state hash, the start state
 * of a recording and the test of the hash read the tables.
 *
 * The order of each table determines the hash, so the order never changes. A member that recordings
 * of the older format 7 lack is listed with FIELD_LATER(). */
#include "core/game/game_fields.h"

#include "core/base/hash.h"
#include "core/config.h"
#include "core/game/game.h"

/* clang-format off */
/* ---- Tables of the accounts and of the sessions ---- */

#define STRUCT balance
static const struct field_table balance_fields = FIELD_TABLE(balance,
    FIELD(units), FIELD(bonus_units), FIELD(paid), FIELD(service), FIELD(unlogged), FIELD(open),
    FIELD_LATER(returned, 1), FIELD_LATER(tickets, 2));
#undef STRUCT

#define STRUCT ledger_stand
static const struct field_table stand_fields = FIELD_TABLE(ledger_stand,
    FIELD_LATER(count, 0x51), FIELD_LATER(value, 0x52), FIELD_LATER(detail, 0x53));
#undef STRUCT

#define STRUCT ledger_start
const struct field_table ledger_start_fields = FIELD_TABLE(ledger_start,
    FIELD(last_id), FIELD(boots), FIELD_STRUCT(balance, &balance_fields),
    FIELD_STRUCT(stand, &stand_fields));
#undef STRUCT

#define STRUCT ledger
const struct field_table ledger_fields = FIELD_TABLE(ledger,
    FIELD(last_id), FIELD(saved_id), FIELD(boot), FIELD(uncommitted), FIELD(wait_ticks),
    FIELD(day), FIELD(minute), FIELD(is_healthy), FIELD_STRUCT(after, &balance_fields),
    FIELD_STRUCT(committed, &balance_fields), FIELD_STRUCT(balance, &balance_fields),
    FIELD_SINCE(9, store_came_late, 0x61));
#undef STRUCT

#define STRUCT pending_coins
static const struct field_table pending_coins_fields = FIELD_TABLE(pending_coins,
    FIELD(pulses), FIELD(units), FIELD(owed));
#undef STRUCT

#define STRUCT credit
const struct field_table credit_fields = FIELD_TABLE(credit,
    FIELD(came_back), FIELD(warnings), FIELD(metered), FIELD(shakes), FIELD(tickets),
    FIELD(coin_tick), FIELD(tilt_tick), FIELD(request_tick), FIELD(await_tick), FIELD(act_tick),
    FIELD_STRUCT(pending_coins, &pending_coins_fields), FIELD_LATER(stand_id, 1),
    FIELD_LATER(ticket_id, 2), FIELD_STRUCT(stand, &stand_fields));
#undef STRUCT

#define STRUCT rank_row
const struct field_table rank_row_fields = FIELD_TABLE(rank_row,
    FIELD(caught), FIELD(round_id), FIELD_HIGH(day, 8), FIELD(slot), FIELD(name));
#undef STRUCT

#define STRUCT ranking
const struct field_table ranking_fields = FIELD_TABLE(ranking,
    FIELD(boot), FIELD(day), FIELD(week), FIELD(week_boot),
    FIELD_PART(row[0], MODE_COUNT * sizeof FIELD_MEMBER(row[0]), FORM_STRUCTS, 0,
               &rank_row_fields, FIELD_ALL_USED, 0),
    FIELD_PART(row[MODE_COUNT], RANK_EASIER_ROWS * sizeof(struct rank_row), FORM_SKIPPED, 0, NULL,
               FIELD_ALL_USED, 0));
#undef STRUCT

#define STRUCT audits
const struct field_table audits_fields = FIELD_TABLE(audits,
    FIELD_RANGE(count[0], AUDIT_FORMAT_7_COUNT),
    FIELD_RANGE_SINCE(8, count[AUDIT_FORMAT_7_COUNT], AUDIT_FORMAT_8_COUNT - AUDIT_FORMAT_7_COUNT,
                      AUDIT_FORMAT_7_COUNT),
    FIELD_RANGE_SINCE(9, count[AUDIT_FORMAT_8_COUNT], AUDIT_COUNT - AUDIT_FORMAT_8_COUNT,
                      AUDIT_FORMAT_8_COUNT));
#undef STRUCT

#define STRUCT health_log
static const struct field_table health_log_fields = FIELD_TABLE(health_log,
    FIELD(is_written), FIELD(written_tick), FIELD(dropped_ticks), FIELD(device_faults),
    FIELD(written_shakes), FIELD_LATER(away_ticks[0], 1), FIELD_LATER(loss_tick[0], 2),
    FIELD_LATER(away_ticks[1], 3), FIELD_LATER(loss_tick[1], 4), FIELD_LATER(away_ticks[2], 5),
    FIELD_LATER(loss_tick[2], 6), FIELD_LATER(away_ticks[3], 7), FIELD_LATER(loss_tick[3], 8));
#undef STRUCT

#define STRUCT settings_edit
const struct field_table settings_edit_fields = FIELD_TABLE(settings_edit,
    FIELD(turn_tick), FIELD(entry_id), FIELD(pin_wrong), FIELD(pin_tick), FIELD_SKIP(logged));
#undef STRUCT

/* Members of struct game_session. session_hash() hashes the members in FIELD_SKIP() separately. */
#define STRUCT game_session
const struct field_table game_session_fields = FIELD_TABLE(game_session,
    FIELD(tick), FIELD(command_count), FIELD(edit_save_id), FIELD(edit_saved_id),
    FIELD_STRUCT(ledger, &ledger_fields), FIELD_STRUCT(credit, &credit_fields),
    FIELD_STRUCT(health_log, &health_log_fields), FIELD_SKIP(settings_edit),
    FIELD_SKIP(language));
#undef STRUCT

/* ---- Tables of the growth lab and of the album ---- */

#define STRUCT graph
static const struct field_table graph_fields = FIELD_TABLE(graph,
    FIELD(knot_count), FIELD(line), FIELD(solved), FIELD(knots));
#undef STRUCT

#define STRUCT lab_edit
const struct field_table lab_edit_fields = FIELD_TABLE(lab_edit,
    FIELD(template_id), FIELD(scale_knot_count), FIELD_STRUCT(graph, &graph_fields),
    FIELD(scale_knots));
#undef STRUCT

#define STRUCT species_card
const struct field_table species_card_fields = FIELD_TABLE(species_card,
    FIELD_BYTES(id), FIELD(key_count), FIELD(measure), FIELD(motion), FIELD(form),
    FIELD(thesis_key), FIELD(thesis_template), FIELD(scale_knot_count), FIELD(curve_count),
    FIELD_BYTES(key_names), FIELD(key_age_days), FIELD(key_length_m), FIELD(growth),
    FIELD(scale_knots), FIELD_BYTES(curve_names), FIELD_STRUCT(curves, &graph_fields));
#undef STRUCT

#define STRUCT lab_book
const struct field_table lab_book_fields = FIELD_TABLE(lab_book,
    FIELD(card_count), FIELD(refused), FIELD_BYTES(has_edit),
    FIELD_STRUCT(cards, &species_card_fields), FIELD_STRUCT(edits, &lab_edit_fields));
#undef STRUCT

#define STRUCT album_fish
static const struct field_table album_fish_fields = FIELD_TABLE(album_fish,
    FIELD(fish), FIELD(look), FIELD(owner), FIELD(age_days), FIELD(length_m));
#undef STRUCT

#define STRUCT album
static const struct field_table album_fields = FIELD_TABLE(album,
    FIELD(caught), FIELD(fish_count), FIELD_STRUCT(fish, &album_fish_fields));
#undef STRUCT

/* Members of struct lab without the saved edits. The hash of every tick omits the saved edits,
 * because they seldom change. */
#define STRUCT lab
static const struct field_table lab_fields = FIELD_TABLE(lab,
    FIELD(species), FIELD(layer), FIELD(playing), FIELD(compare), FIELD(path), FIELD(has_pointer),
    FIELD(presses), FIELD(points), FIELD(holds), FIELD(held_knot), FIELD(upright),
    FIELD(stir_tick), FIELD(act_tick), FIELD(rest_ticks), FIELD(start_ticks), FIELD(save_id),
    FIELD(saved_id), FIELD(requested_id), FIELD(pointer_player), FIELD(edit_refused), FIELD(x),
    FIELD(y), FIELD(stir_x), FIELD(stir_y), FIELD(progress), FIELD_STRUCT(edit, &lab_edit_fields),
    FIELD_SKIP(has_edit), FIELD_SKIP(edits));

const struct field_table lab_saved_fields = FIELD_TABLE(lab,
    FIELD_BYTES(has_edit), FIELD_STRUCT(edits, &lab_edit_fields));
#undef STRUCT

/* Members of struct core_config. core_hash() hashes `persistent`, `session` and `book` separately,
 * and no hash contains `rules` and `lanes`. */
#define STRUCT core_config
const struct field_table core_config_fields = FIELD_TABLE(core_config,
    FIELD(seed), FIELD(preset), FIELD(fish_count), FIELD(language), FIELD(round_s),
    FIELD(modes), FIELD(grade), FIELD(players), FIELD(credit_coins), FIELD(ticket_fish),
    FIELD_SINCE(9, level, 1),
    FIELD_SKIP(rules), FIELD_SKIP(lanes), FIELD_SKIP(persistent), FIELD_SKIP(session),
    FIELD_SKIP(book));
#undef STRUCT

/* ---- Tables of the bot ---- */

#define STRUCT technique
static const struct field_table technique_fields = FIELD_TABLE(technique,
    FIELD(side), FIELD(place), FIELD(lift), FIELD(hunt), FIELD(fish_max), FIELD(wet),
    FIELD(entry_deg), FIELD(glide_deg), FIELD(fish_m), FIELD(arm_m_s), FIELD(dip_m_s),
    FIELD(glide_m_s), FIELD(lift_m_s), FIELD(carry_m_s), FIELD(drain_s), FIELD(patience_s),
    FIELD(aim_m), FIELD(tremor_m), FIELD(reaction_min_s), FIELD(reaction_max_s));
#undef STRUCT

#define STRUCT snapshot_fish
static const struct field_table snapshot_fish_fields = FIELD_TABLE(snapshot_fish,
    FIELD(fish), FIELD(place), FIELD(gulps), FIELD(position_m), FIELD(velocity_m_s),
    FIELD(heading_rad), FIELD(length_m));
#undef STRUCT

#define STRUCT snapshot
static const struct field_table snapshot_fields = FIELD_TABLE(snapshot,
    FIELD(tick), FIELD(phase), FIELD(mode), FIELD(seconds_left), FIELD(tank_m),
    FIELD(poi.present), FIELD(bowl.present), FIELD(paper.holds), FIELD(paper.middle),
    FIELD(poi.position_m), FIELD(bowl.position_m), FIELD(poi.angles), FIELD(poi.radius_m),
    FIELD(poi.paper_left), FIELD(poi.water_m), FIELD(paper.wet), FIELD(paper.left),
    FIELD(paper.x_m), FIELD(paper.z_m), FIELD(bowl.radius_m), FIELD(rival_count),
    FIELD(rival_m), FIELD(carried_count), FIELD(over),
    FIELD_STRUCT(prey, &snapshot_fish_fields), FIELD(near_count),
    FIELD_STRUCT(near, &snapshot_fish_fields));
#undef STRUCT

#define STRUCT bot
const struct field_table bot_fields = FIELD_TABLE(bot,
    FIELD_STRUCT(technique, &technique_fields), FIELD(seed), FIELD(stage), FIELD(prey),
    FIELD(stage_tick), FIELD(act_tick), FIELD(tries), FIELD(yaw_rad), FIELD(miss_m),
    FIELD(goal), FIELD(speed_m_s), FIELD(ease_s), FIELD(hand),
    FIELD_STRUCT(known, &snapshot_fields), FIELD_STRUCT(seen, &snapshot_fields));
#undef STRUCT

/* ---- Tables of the operator's menu ---- */

#define STRUCT calibrate
static const struct field_table calibrate_fields = FIELD_TABLE(calibrate,
    FIELD(slot), FIELD(step), FIELD(fault), FIELD(present), FIELD(is_set), FIELD(has_before),
    FIELD(has_anchor), FIELD(must_move), FIELD(still_ticks), FIELD(sample.has_wrist),
    FIELD(before), FIELD(sample.corner_m), FIELD(anchor), FIELD(sum), FIELD(sample.water));
#undef STRUCT

#define STRUCT self_test
static const struct field_table self_test_fields = FIELD_TABLE(self_test,
    FIELD(sound_answer), FIELD(lamp_answer), FIELD(present), FIELD(has_first_m), FIELD(begin_tick),
    FIELD(entry_id), FIELD(ways[0]), FIELD(worst_age[0]), FIELD(first_m[0]), FIELD(ways[1]),
    FIELD(worst_age[1]), FIELD(first_m[1]), FIELD(ways[2]), FIELD(worst_age[2]),
    FIELD(first_m[2]), FIELD(ways[3]), FIELD(worst_age[3]), FIELD(first_m[3]));
#undef STRUCT

#define STRUCT menu
static const struct field_table menu_fields = FIELD_TABLE(menu,
    FIELD(page), FIELD(row), FIELD(upright), FIELD(file_first), FIELD(board), FIELD(score),
    FIELD(score_is_named), FIELD(is_unnaming), FIELD(scores), FIELD(chosen), FIELD(turns_down),
    FIELD(turning), FIELD(turn_count), FIELD(turn_tick), FIELD(from), FIELD(pin_count),
    FIELD(pin), FIELD(has_pointer), FIELD(pointer_player), FIELD(presses), FIELD(points),
    FIELD(held), FIELD(test_coins), FIELD(coin_tick), FIELD(command_count), FIELD(confirm_tick),
    FIELD(take_tick), FIELD(act_tick), FIELD(use_tick), FIELD_BYTES_RANGE(tag[0], MENU_UPDATE),
    FIELD_BYTES_RANGE(controllers.state[0], offsetof(struct controller_status, update)),
    FIELD_SINCE(10, tag[MENU_UPDATE], 1), FIELD_SINCE(10, controllers.update, 2),
    FIELD(pressed_count), FIELD(rest), FIELD_SKIP(rules),
    FIELD_STRUCT(calibrate, &calibrate_fields), FIELD_STRUCT(self, &self_test_fields), FIELD(x),
    FIELD(y));
#undef STRUCT

/* ---- Tables of the players and of the whole game ---- */

#define STRUCT name
static const struct field_table name_fields = FIELD_TABLE(name,
    FIELD(round_id), FIELD(ranked), FIELD(waits), FIELD(slot), FIELD(alphabet), FIELD(key),
    FIELD(points), FIELD(upright), FIELD(has_pointer), FIELD(presses), FIELD(refusals),
    FIELD(letter_count), FIELD(start_tick), FIELD(act_tick), FIELD(held_ticks), FIELD(letter),
    FIELD(x), FIELD(y), FIELD(rest_x), FIELD(rest_y));
#undef STRUCT

#define STRUCT hints
static const struct field_table hints_fields = FIELD_TABLE(hints,
    FIELD(pupil), FIELD(shown), FIELD(shown_tick), FIELD(learned), FIELD(haste_tick),
    FIELD(haste_cells), FIELD(paper_cells), FIELD(dips_before), FIELD(caught), FIELD(moved_m));
#undef STRUCT

#define STRUCT player
static const struct field_table player_fields = FIELD_TABLE(player,
    FIELD(plays), FIELD(out), FIELD(handed), FIELD(points), FIELD(fouls), FIELD(foul),
    FIELD(foul_tick), FIELD(caught), FIELD(scoops), FIELD(torn_tick), FIELD(first_torn_tick),
    FIELD(sheets_before), FIELD(lost_ticks), FIELD(waited_ticks), FIELD(stance),
    FIELD(offence_tick), FIELD(rest_x_m), FIELD(rest_z_m),
    FIELD_LATER(level, 1), FIELD_SINCE(9, has_pointer, 2), FIELD_SINCE(9, pointer, 3));
#undef STRUCT

#define STRUCT input_validation
static const struct field_table input_validation_fields = FIELD_TABLE(input_validation,
    FIELD(verdict), FIELD(has_newest), FIELD(same_ticks), FIELD(agree_ticks), FIELD(silent_ticks),
    FIELD(late_ticks), FIELD(excess_m), FIELD(spin), FIELD(newest));
#undef STRUCT

#define STRUCT control
static const struct field_table control_fields = FIELD_TABLE(control,
    FIELD(holder), FIELD(grip_tick), FIELD(target_pose), FIELD(live_y_m),
    FIELD_STRUCT(validation, &input_validation_fields), FIELD(return_ticks), FIELD(was_lost),
    FIELD(immunity_ticks), FIELD(outlier_ticks), FIELD(rest_ticks));
#undef STRUCT

/* Table entries for the members of struct game that belong to player slot `i`. */
#define GAME_SLOT(i) \
    FIELD_STRUCT(player[i], &player_fields), FIELD_STRUCT(control[i], &control_fields), \
    FIELD_STRUCT(bot[i], &bot_fields)

/* Members of struct game. core_hash() hashes the members in FIELD_SKIP() separately. */
#define STRUCT game
const struct field_table game_fields = FIELD_TABLE(game,
    FIELD(phase), FIELD(language), FIELD(mode), FIELD(lab_chosen), FIELD(bot_played),
    FIELD(played), FIELD(paused), FIELD(call), FIELD(call_tick), FIELD(phase_tick),
    FIELD(round_tick), FIELD(point_tick), FIELD(lost_ticks), FIELD(gone_tick), FIELD(round_s),
    FIELD(round_count), FIELD(waited_ticks), FIELD(turn_tick), FIELD(paused_ticks),
    GAME_SLOT(0), GAME_SLOT(1), GAME_SLOT(2), GAME_SLOT(3),
    FIELD_STRUCT(accounts.ledger, &ledger_fields),
    FIELD_STRUCT(accounts.credit, &credit_fields), FIELD_STRUCT(name, &name_fields),
    FIELD_STRUCT(health_log, &health_log_fields), FIELD_STRUCT(menu, &menu_fields),
    FIELD_STRUCT(album, &album_fields), FIELD_STRUCT(lab, &lab_fields),
    FIELD_LATER(language_until, 0), FIELD_SINCE(9, upright, 1),
    FIELD_SINCE(10, bowl_place, 2),
    FIELD_STRUCT(hints, &hints_fields), FIELD_SKIP(tick),
    FIELD_SKIP(accounts.audits), FIELD_SKIP(accounts.ranking), FIELD_SKIP(settings_edit));
#undef STRUCT
/* clang-format on */

uint64_t game_fields_hash_ranking(uint64_t hash, const struct ranking *ranking)
{
    const struct rank_row none = { 0 }, *rows = &ranking->row[MODE_COUNT][0][0];
    const uint64_t empty = field_hash(HASH_START, &rank_row_fields, &none);
    hash = field_hash(hash, &ranking_fields, ranking);
    for (uint32_t i = 0; i < RANK_EASIER_ROWS; i++) {
        const uint64_t row = field_hash(HASH_START, &rank_row_fields, &rows[i]);
        hash = row != empty ? hash_u64(hash_u32(hash, i), row) : hash;
    }
    return hash;
}
