/* hashed_fields.h -- tables of all members of the structs that core_hash() covers.
 *
 * The test of the hash reads the tables. Each table lists the members of one struct in order,
 * including the members that the hash skips. A new member of such a struct must be added to its
 * table. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_HASHED_FIELDS_H
#define KINGYO_TESTS_UNIT_SUPPORT_HASHED_FIELDS_H

#include <stddef.h>
#include <stdint.h>

#include "core/core.h"

struct field {
    const char *name;
    size_t offset, size, align;
    int skipped; /* 1 if the test does not change the member, because it is scratch memory or has
                    its own table; otherwise 0. */
};

#define FIELD_AS(type, member, is_skipped)                                                         \
    { #type "." #member, offsetof(struct type, member), sizeof(((struct type *)0)->member),        \
      __alignof__(((struct type *)0)->member), is_skipped }
#define FIELD(type, member) FIELD_AS(type, member, 0)
#define SKIP(type, member) FIELD_AS(type, member, 1)

/* clang-format off */
static const struct field core_fields[] = {
    SKIP(core, config), SKIP(core, game), SKIP(core, world),
};

static const struct field world_fields[] = {
    SKIP(world, tank), SKIP(world, poi), SKIP(world, bowl),
};

static const struct field accounts_fields[] = {
    SKIP(accounts, ledger), SKIP(accounts, credit), SKIP(accounts, audits),
    SKIP(accounts, ranking),
};

static const struct field config_fields[] = {
    FIELD(core_config, seed),     FIELD(core_config, preset),  FIELD(core_config, fish_count),
    FIELD(core_config, language), FIELD(core_config, round_s),
    FIELD(core_config, modes),    FIELD(core_config, grade),   FIELD(core_config, players),
    FIELD(core_config, credit_coins), FIELD(core_config, ticket_fish),
    SKIP(core_config, rules_7),   SKIP(core_config, lanes),   SKIP(core_config, persistent),
    SKIP(core_config, session),
    SKIP(core_config, book),
};

static const struct field book_fields[] = {
    FIELD(lab_book, card_count), FIELD(lab_book, refused), FIELD(lab_book, has_edit),
    SKIP(lab_book, cards),       SKIP(lab_book, edits),
};

static const struct field card_fields[] = {
    FIELD(species_card, id),          FIELD(species_card, key_count),
    FIELD(species_card, measure),     FIELD(species_card, motion),
    FIELD(species_card, form),        FIELD(species_card, thesis_key),
    FIELD(species_card, thesis_template),
    FIELD(species_card, key_names),   FIELD(species_card, key_age_days),
    FIELD(species_card, key_length_m), FIELD(species_card, growth),
    FIELD(species_card, scale_knot_count), FIELD(species_card, scale_knots),
    FIELD(species_card, curve_count), FIELD(species_card, curve_names),
    SKIP(species_card, curves),
};

static const struct field graph_fields[] = {
    FIELD(graph, knot_count), FIELD(graph, line), FIELD(graph, solved), FIELD(graph, knots),
};

static const struct field edit_fields[] = {
    FIELD(lab_edit, template_id), FIELD(lab_edit, scale_knot_count), SKIP(lab_edit, graph),
    FIELD(lab_edit, scale_knots),
};

static const struct field lab_fields[] = {
    FIELD(lab, species),     FIELD(lab, layer),     FIELD(lab, playing), FIELD(lab, compare),
    FIELD(lab, path),        FIELD(lab, has_hand),  FIELD(lab, presses), FIELD(lab, hand),
    FIELD(lab, points),      FIELD(lab, holds),     FIELD(lab, held_knot),
    FIELD(lab, upright),     FIELD(lab, edit_refused), FIELD(lab, has_edit),
    FIELD(lab, stir_tick),   FIELD(lab, act_tick),  FIELD(lab, rest_ticks),
    FIELD(lab, start_ticks), FIELD(lab, save_id),   FIELD(lab, saved_id), FIELD(lab, asked_id),
    FIELD(lab, x),
    FIELD(lab, y),           FIELD(lab, stir_x),    FIELD(lab, stir_y),  FIELD(lab, progress),
    SKIP(lab, edit),         SKIP(lab, edits),
};

static const struct field album_fields[] = {
    FIELD(album, caught), FIELD(album, fish_count), SKIP(album, fish),
};

static const struct field album_fish_fields[] = {
    FIELD(album_fish, fish),     FIELD(album_fish, look),     FIELD(album_fish, owner),
    FIELD(album_fish, age_days), FIELD(album_fish, length_m),
};

static const struct field game_fields[] = {
    FIELD(game, tick),        FIELD(game, phase),      FIELD(game, language),
    FIELD(game, mode),
    FIELD(game, lab_chosen),
    FIELD(game, bot_played),  FIELD(game, played),     FIELD(game, paused),
    FIELD(game, call),        FIELD(game, call_tick),  FIELD(game, phase_tick),
    FIELD(game, round_tick),  FIELD(game, paused_ticks),
    FIELD(game, point_tick), FIELD(game, lost_ticks),
    FIELD(game, waited_ticks),
    FIELD(game, gone_tick),   FIELD(game, language_until),
    FIELD(game, turn_tick),   FIELD(game, round_s),
    FIELD(game, round_count),
    SKIP(game, accounts),     SKIP(game, settings_edit),      SKIP(game, name),
    SKIP(game, player),
    FIELD(game, holder),      FIELD(game, grip_tick),  FIELD(game, hand_pose),
    FIELD(game, live_y_m),    SKIP(game, validation),       FIELD(game, return_ticks),
    FIELD(game, was_lost),    FIELD(game, immunity_ticks), FIELD(game, outlier_ticks),
    FIELD(game, rest_ticks),
    SKIP(game, hints),        SKIP(game, bot),
    SKIP(game, health_log),
    SKIP(game, menu),         SKIP(game, album),
    SKIP(game, lab),
};

static const struct field menu_fields[] = {
    FIELD(menu, page), FIELD(menu, chosen), FIELD(menu, turns_down), FIELD(menu, turning),
    FIELD(menu, from), FIELD(menu, pin_count), FIELD(menu, pin), FIELD(menu, turn_count),
    FIELD(menu, turn_tick), FIELD(menu, row), FIELD(menu, upright), FIELD(menu, file_first),
    FIELD(menu, board), FIELD(menu, score), FIELD(menu, score_is_named), FIELD(menu, score_asks),
    FIELD(menu, scores), FIELD(menu, has_hand), FIELD(menu, hand), FIELD(menu, presses),
    FIELD(menu, points), FIELD(menu, tag), FIELD(menu, controllers), FIELD(menu, pressed_count),
    FIELD(menu, held), FIELD(menu, test_coins), FIELD(menu, coin_tick), FIELD(menu, command_count),
    FIELD(menu, ask_tick), FIELD(menu, take_tick), FIELD(menu, act_tick), FIELD(menu, use_tick),
    FIELD(menu, x), FIELD(menu, y), SKIP(menu, calibrate), SKIP(menu, self), FIELD(menu, rest),
};

static const struct field calibrate_fields[] = {
    FIELD(calibrate, seat), FIELD(calibrate, step), FIELD(calibrate, fault),
    FIELD(calibrate, present), FIELD(calibrate, is_set), FIELD(calibrate, has_before),
    FIELD(calibrate, before), FIELD(calibrate, has_anchor), FIELD(calibrate, must_move),
    FIELD(calibrate, still_ticks), FIELD(calibrate, anchor), FIELD(calibrate, sum),
    SKIP(calibrate, said),
};

static const struct field calibration_said_fields[] = {
    FIELD(calibration_said, corner_m), FIELD(calibration_said, water),
    FIELD(calibration_said, has_wrist),
};

static const struct field self_test_fields[] = {
    FIELD(self_test, heard), FIELD(self_test, moved), FIELD(self_test, present),
    FIELD(self_test, ways), FIELD(self_test, worst_age), FIELD(self_test, first_m),
    FIELD(self_test, knows_first), FIELD(self_test, begin_tick), FIELD(self_test, entry_id),
};

static const struct field adjust_fields[] = {
    FIELD(settings_edit, told),      FIELD(settings_edit, turn_tick), FIELD(settings_edit,
    entry_id),
    FIELD(settings_edit, pin_wrong), FIELD(settings_edit, pin_tick),
};

static const struct field memory_fields[] = {
    SKIP(persistent_state, ledger), FIELD(persistent_state, settings), FIELD(persistent_state,
    audits), SKIP(persistent_state, ranking),
};

static const struct field ledger_start_fields[] = {
    FIELD(ledger_start, last_id), FIELD(ledger_start, boots), SKIP(ledger_start, balance),
    SKIP(ledger_start, stand),
};

static const struct field stand_fields[] = {
    FIELD(ledger_stand, count), FIELD(ledger_stand, value), FIELD(ledger_stand, detail),
};

static const struct field chapter_fields[] = {
    FIELD(game_session, tick),          FIELD(game_session, command_count), FIELD(game_session,
    edit_save_id),
    FIELD(game_session, edit_saved_id), SKIP(game_session, ledger),       SKIP(game_session,
    credit),
    SKIP(game_session, health_log),         SKIP(game_session, settings_edit),
     SKIP(game_session, language),
};

static const struct field language_choice_fields[] = {
    FIELD(language_choice, chosen), FIELD(language_choice, until_tick),
};

static const struct field purse_fields[] = {
    FIELD(balance, units),   FIELD(balance, bonus_units), FIELD(balance, paid),
    FIELD(balance, service), FIELD(balance, unlogged),      FIELD(balance, open),
    FIELD(balance, returned), FIELD(balance, tickets),
};

static const struct field ledger_fields[] = {
    FIELD(ledger, last_id), FIELD(ledger, saved_id), FIELD(ledger, boot), FIELD(ledger,
    uncommitted),
    FIELD(ledger, wait_ticks), FIELD(ledger, day), FIELD(ledger, minute),
    FIELD(ledger, is_healthy), SKIP(ledger, balance), SKIP(ledger, committed), SKIP(ledger, after),
};

static const struct field ranking_fields[] = {
    FIELD(ranking, boot), FIELD(ranking, day), FIELD(ranking, week),
    FIELD(ranking, week_boot), SKIP(ranking, row),
};

static const struct field name_fields[] = {
    FIELD(name, round_id), FIELD(name, ranked),       FIELD(name, waits),
    FIELD(name, seat),     FIELD(name, alphabet),     FIELD(name, key),
    FIELD(name, points),   FIELD(name, upright),      FIELD(name, has_hand),
    FIELD(name, presses),  FIELD(name, refusals),     FIELD(name, letter_count),
    FIELD(name, letter),   FIELD(name, seat_tick),    FIELD(name, act_tick),
    FIELD(name, held_ticks), FIELD(name, x),          FIELD(name, y),
    FIELD(name, rest_x),   FIELD(name, rest_y),
};

static const struct field rank_row_fields[] = {
    FIELD(rank_row, caught), FIELD(rank_row, round_id), FIELD(rank_row, day),
    FIELD(rank_row, seat),   FIELD(rank_row, name),
};

static const struct field credit_fields[] = {
    FIELD(credit, came_back),  FIELD(credit, warnings),   SKIP(credit, pending_coins),
    FIELD(credit, metered),    FIELD(credit, shakes),     FIELD(credit, tickets),
    FIELD(credit, coin_tick),  FIELD(credit, tilt_tick),  FIELD(credit, asked_tick),
    FIELD(credit, await_tick), FIELD(credit, act_tick),   FIELD(credit, stand_id),
    SKIP(credit, stand),       FIELD(credit, ticket_id),
};

static const struct field untold_fields[] = {
    FIELD(pending_coins, pulses), FIELD(pending_coins, units), FIELD(pending_coins, owed),
};

static const struct field upkeep_fields[] = {
    FIELD(health_log, is_told),       FIELD(health_log, told_tick),
    FIELD(health_log, dropped_ticks), FIELD(health_log, device_faults), FIELD(health_log,
    told_shakes),
    FIELD(health_log, away_ticks),    FIELD(health_log, loss_tick),
};

static const struct field player_fields[] = {
    FIELD(player, plays),      FIELD(player, out),          FIELD(player, handed),
    FIELD(player, points),     FIELD(player, fouls),        FIELD(player, foul),
    FIELD(player, foul_tick),  FIELD(player, offence_tick), FIELD(player, caught),
    FIELD(player, scoops),     FIELD(player, torn_tick),    FIELD(player, first_torn_tick),
    FIELD(player, sheets_before), FIELD(player, lost_ticks),
    FIELD(player, waited_ticks),
    FIELD(player, stance),     FIELD(player, rest_x_m),     FIELD(player, rest_z_m),
};

static const struct field trust_fields[] = {
    FIELD(input_validation, verdict),      FIELD(input_validation, knows),
     FIELD(input_validation, same_ticks),
    FIELD(input_validation, agree_ticks),  FIELD(input_validation, silent_ticks),
    FIELD(input_validation, late_ticks),
    FIELD(input_validation, excess_m),       FIELD(input_validation, spin),
     FIELD(input_validation, newest),
};

static const struct field hints_fields[] = {
    FIELD(hints, pupil), FIELD(hints, shown),      FIELD(hints, shown_tick),  FIELD(hints, learned),
    FIELD(hints, haste_tick), FIELD(hints, haste_cells), FIELD(hints, paper_cells),
    FIELD(hints, dips_before), FIELD(hints, caught), FIELD(hints, moved_m),
};

static const struct field technique_fields[] = {
    FIELD(technique, wet),        FIELD(technique, entry_deg),      FIELD(technique, glide_deg),
    FIELD(technique, side),       FIELD(technique, place),          FIELD(technique, lift),
    FIELD(technique, hunt),       FIELD(technique, fish_max),       FIELD(technique, fish_m),
    FIELD(technique, arm_m_s),
    FIELD(technique, dip_m_s),    FIELD(technique, glide_m_s),      FIELD(technique, lift_m_s),
    FIELD(technique, carry_m_s),  FIELD(technique, drain_s),        FIELD(technique, patience_s),
    FIELD(technique, aim_m),      FIELD(technique, tremor_m),
    FIELD(technique, reaction_min_s), FIELD(technique, reaction_max_s),
};

static const struct field bot_fields[] = {
    SKIP(bot, technique), FIELD(bot, seed),     FIELD(bot, stage),  FIELD(bot, prey),
    FIELD(bot, stage_tick), FIELD(bot, act_tick), FIELD(bot, tries), FIELD(bot, yaw_rad),
    FIELD(bot, miss_m),   FIELD(bot, goal),     FIELD(bot, speed_m_s), FIELD(bot, ease_s),
    FIELD(bot, hand),     SKIP(bot, known),     SKIP(bot, seen),
};

static const struct field look_fields[] = {
    FIELD(snapshot, tick),   FIELD(snapshot, phase),       FIELD(snapshot, mode),
    FIELD(snapshot, seconds_left), FIELD(snapshot, tank_m), SKIP(snapshot, poi),
    SKIP(snapshot, bowl),    SKIP(snapshot, paper),        FIELD(snapshot, rival_count),
    FIELD(snapshot, rival_m), FIELD(snapshot, carried_count),     FIELD(snapshot, over),
    SKIP(snapshot, prey),    FIELD(snapshot, near_count),  SKIP(snapshot, near),
};

static const struct field look_fish_fields[] = {
    FIELD(snapshot_fish, fish),       FIELD(snapshot_fish, place),        FIELD(snapshot_fish,
    gulps),
    FIELD(snapshot_fish, position_m), FIELD(snapshot_fish, velocity_m_s), FIELD(snapshot_fish,
    heading_rad),
    FIELD(snapshot_fish, length_m),
};

static const struct field look_paper_fields[] = {
    FIELD(snapshot_paper, wet),    FIELD(snapshot_paper, left), FIELD(snapshot_paper, holds),
    FIELD(snapshot_paper, middle), FIELD(snapshot_paper, x_m),  FIELD(snapshot_paper, z_m),
};

static const struct field sight_poi_fields[] = {
    FIELD(vision_poi, present),  FIELD(vision_poi, position_m), FIELD(vision_poi, angles),
    FIELD(vision_poi, radius_m), FIELD(vision_poi, paper_left), FIELD(vision_poi, water_m),
};

static const struct field sight_bowl_fields[] = {
    FIELD(vision_bowl, present), FIELD(vision_bowl, position_m), FIELD(vision_bowl, radius_m),
};

static const struct field poi_fields[] = {
    FIELD(poi, link),        FIELD(poi, damage_immune),   FIELD(poi, seed),
    FIELD(poi, position_m),  FIELD(poi, velocity_m_s),
    FIELD(poi, angles),      FIELD(poi, before_m),
    FIELD(poi, before_m_s),  FIELD(poi, before_angles),
    FIELD(poi, hand_m),      FIELD(poi, pace_m_s),
    FIELD(poi, reaction),        FIELD(poi, stopped), FIELD(poi, jam_ticks),
    FIELD(poi, clings),
    FIELD(poi, angular_velocity_rad_s), FIELD(poi, spin_rad_s),
    FIELD(poi, acceleration_m_s2), FIELD(poi, jolt_m_s2),
    FIELD(poi, drag_n_s_m),  FIELD(poi, slam_n), FIELD(poi, edge_n_s_m),
    FIELD(poi, added_kg),    FIELD(poi, meniscus_n),
    FIELD(poi, immersed),
    FIELD(poi, splash_m_s),  FIELD(poi, water_kg),
    FIELD(poi, film_kg),     FIELD(poi, pool_kg), FIELD(poi, drip_kg),
    FIELD(poi, drops),       FIELD(poi, laden_ticks),
    FIELD(poi, tip),         FIELD(poi, tip_toward),
    FIELD(poi, pressure_pa),
    FIELD(poi, dips),        FIELD(poi, is_in), FIELD(poi, slap_tick),
    FIELD(poi, tear_tick),   SKIP(poi, sheet),
    FIELD(poi, strain),      FIELD(poi, carried_kg),
    SKIP(poi, carried_count), /* The test changes this member separately, because the member
                                 determines how many array entries the hash reads. */
    SKIP(poi, carried_fish),       SKIP(poi, load_count), FIELD(poi, slap_count),
    SKIP(poi, loads),
};

static const struct field rider_fields[] = {
    FIELD(carried_fish, fish),        FIELD(carried_fish, state),       FIELD(carried_fish, side),
    FIELD(carried_fish, walled),      FIELD(carried_fish, clear_ticks),
    FIELD(carried_fish, x_m),         FIELD(carried_fish, z_m),         FIELD(carried_fish,
    height_m),
    FIELD(carried_fish, slide_x_m_s), FIELD(carried_fish, slide_z_m_s), FIELD(carried_fish,
    heading_rad),
    FIELD(carried_fish, lie),         FIELD(carried_fish, vigour),      FIELD(carried_fish, rest_s),
    FIELD(carried_fish, slap_s),      FIELD(carried_fish, slap_n),      FIELD(carried_fish,
    slap_d_m),
    FIELD(carried_fish, hop_s),
    FIELD(carried_fish, fall_m_s),
};

static const struct field load_fields[] = {
    FIELD(sheet_load, x_m), FIELD(sheet_load, z_m), FIELD(sheet_load, diameter_m),
    FIELD(sheet_load, force_n),
};

static const struct field sheet_fields[] = {
    FIELD(sheet, grade),    FIELD(sheet, touched),      FIELD(sheet, soaked),
    FIELD(sheet, ideal),
    FIELD(sheet, radius_m), FIELD(sheet, fibre_x),      FIELD(sheet, fibre_z),
    FIELD(sheet, wetness),  FIELD(sheet, soak_ticks),
    FIELD(sheet, damage),   FIELD(sheet, strength),
    FIELD(sheet, strength_min), FIELD(sheet, state),
    SKIP(sheet, stress),    FIELD(sheet, paper_cells),
    FIELD(sheet, paper_cells_new), FIELD(sheet, sag_m),
};

static const struct field bowl_fields[] = {
    FIELD(bowl, present),      FIELD(bowl, home_m),       FIELD(bowl, position_m),
    FIELD(bowl, before_m),     FIELD(bowl, velocity_m_s), FIELD(bowl, heel_x),
    FIELD(bowl, heel_z),       FIELD(bowl, heel_x_rad_s), FIELD(bowl, heel_z_rad_s),
    FIELD(bowl, water_kg),     FIELD(bowl, fish_kg),      FIELD(bowl, fish_count),
};

static const struct field tank_fields[] = {
    FIELD(tank, seed),          FIELD(tank, preset), SKIP(tank, lanes),
    SKIP(tank, search),         FIELD(tank, size_m),
    FIELD(tank, wall_height_m), FIELD(tank, wall_follow),
    FIELD(tank, ball_spaces), SKIP(tank, fish_count),
    SKIP(tank, fish),           FIELD(tank, space),  SKIP(tank, water),
    SKIP(tank, shade),          SKIP(tank, oxygen),  FIELD(tank, reentry_count),
    SKIP(tank, broad_phase),          SKIP(tank, solver),
};

static const struct field shade_fields[] = {
    SKIP(shade, cast), FIELD(shade, edge_m_s), FIELD(shade, age_s), FIELD(shade, still_s),
};

static const struct field cast_fields[] = {
    FIELD(shade_cast, present),  FIELD(shade_cast, x_m), FIELD(shade_cast, z_m),
    FIELD(shade_cast, radius_m), FIELD(shade_cast, dark),
};

static const struct field oxygen_fields[] = {
    FIELD(oxygen, dissolved_mg_l),   FIELD(oxygen, temperature_c), FIELD(oxygen, pressure_hpa),
    FIELD(oxygen, time_compression), FIELD(oxygen, breath_mg_h),   FIELD(oxygen, critical_mg),
    FIELD(oxygen, pump),
};

static const struct field water_fields[] = {
    FIELD(water, newest), FIELD(water, height_m),
};

static const struct field fish_fields[] = {
    FIELD(fish, position_m),     FIELD(fish, speed_m_s),
    FIELD(fish, angles),         FIELD(fish, yaw_rate_rad_s),
    FIELD(fish, push_m_s),       FIELD(fish, climb_m_s),
    FIELD(fish, heading_rad),    FIELD(fish, drawn_rad),
    FIELD(fish, brake),          FIELD(fish, room),
    FIELD(fish, speed_goal_m_s), FIELD(fish, speed_up_keep),
    FIELD(fish, slow_keep),      FIELD(fish, turn_rate_max_rad_s),
    FIELD(fish, haste),          FIELD(fish, climb_goal_m_s),
    FIELD(fish, pitch_goal_rad), FIELD(fish, beats),
    FIELD(fish, length_m),       FIELD(fish, height_m),
    FIELD(fish, width_m),        FIELD(fish, stamina),
    FIELD(fish, velocity_m_s),   FIELD(fish, bend_rad),
    FIELD(fish, tail_phase_rad), FIELD(fish, tail_beat_hz),
    FIELD(fish, tail_amplitude), FIELD(fish, bend_goal_rad),
    FIELD(fish, age_days),
    FIELD(fish, look),           FIELD(fish, gait),
    FIELD(fish, avoiding),       FIELD(fish, holder),
    FIELD(fish, thought_tick),   FIELD(fish, gait_left_s),
    FIELD(fish, avoid_left_s),   FIELD(fish, avoid_turn),
    FIELD(fish, avoid_since),    FIELD(fish, avoid_with),
    FIELD(fish, avoid_kind),
    FIELD(fish, falls),          FIELD(fish, air),
    FIELD(fish, startle),
    FIELD(fish, depth_goal_m),   FIELD(fish, depth_stray),
    FIELD(fish, alarm),
    FIELD(fish, habit),
    FIELD(fish, startle_s),      FIELD(fish, startle_from_m),
    FIELD(fish, refractory_s),   FIELD(fish, escape_s),
    FIELD(fish, escape_from_rad), FIELD(fish, escape_turn_rad),
    FIELD(fish, escape_course_rad),
};
/* clang-format on */

#endif
