/* tank_fields.c -- the tables of the members of the tank, the fish and the water.
 *
 * The state hash depends on the order of the members in a table, so that order never changes. */
#include "core/tank/tank_fields.h"

#include "core/tank/tank.h"

/* clang-format off */
/* Members of a fish that both state hashes read: the quick hash, which reads few members, and the
 * full hash, which reads these members first. */
#define FISH_QUICK FIELD(position_m), FIELD(angles), FIELD(gait)

#define STRUCT fish
static const struct field_table fish_quick_fields = FIELD_TABLE(fish, FISH_QUICK);

const struct field_table fish_fields = FIELD_TABLE(fish,
    FISH_QUICK, FIELD(velocity_m_s), FIELD(push_m_s), FIELD(startle_from_m), FIELD(speed_m_s),
    FIELD(climb_m_s), FIELD(yaw_rate_rad_s), FIELD(age_days), FIELD(length_m), FIELD(stamina),
    FIELD(tail_phase_rad), FIELD(tail_beat_hz), FIELD(tail_amplitude), FIELD(bend_rad),
    FIELD(gait_left_s), FIELD(heading_rad), FIELD(avoid_left_s), FIELD(avoid_turn), FIELD(brake),
    FIELD(depth_goal_m), FIELD(alarm), FIELD(room), FIELD(height_m), FIELD(width_m),
    FIELD(depth_stray), FIELD(drawn_rad), FIELD(speed_goal_m_s), FIELD(speed_up_keep),
    FIELD(slow_keep), FIELD(turn_rate_max_rad_s), FIELD(haste), FIELD(climb_goal_m_s),
    FIELD(pitch_goal_rad), FIELD(beats), FIELD(habit), FIELD(startle_s), FIELD(refractory_s),
    FIELD(escape_s), FIELD(escape_from_rad), FIELD(escape_turn_rad), FIELD(escape_course_rad),
    FIELD(bend_goal_rad), FIELD(look), FIELD(avoid_since), FIELD(avoid_with), FIELD(avoid_kind),
    FIELD_HIGH(startle, 16), FIELD_HIGH(air, 8), FIELD(falls), FIELD_HIGH(avoiding, 16),
    FIELD_HIGH(holder, 8), FIELD(thought_tick));
#undef STRUCT

#define STRUCT shade_cast
static const struct field_table shade_cast_fields = FIELD_TABLE(shade_cast,
    FIELD(present), FIELD(x_m), FIELD(z_m), FIELD(radius_m), FIELD(dark));
#undef STRUCT

#define STRUCT shade
static const struct field_table shade_fields = FIELD_TABLE(shade,
    FIELD_STRUCT(cast, &shade_cast_fields), FIELD(edge_m_s), FIELD(age_s), FIELD(still_s));
#undef STRUCT

#define STRUCT oxygen
static const struct field_table oxygen_fields = FIELD_TABLE(oxygen,
    FIELD(dissolved_mg_l), FIELD(temperature_c), FIELD(pressure_hpa), FIELD(time_compression),
    FIELD(breath_mg_h), FIELD(critical_mg), FIELD(pump));
#undef STRUCT

#define STRUCT contact
static const struct field_table contact_fields = FIELD_TABLE(contact,
    FIELD(a), FIELD(b), FIELD(gap_m));
#undef STRUCT

/* Members of struct broad_phase that the state hash reads. The hash skips the scratch memory of one
 * tick, and skips the number of fish, because the table of struct tank contains that number. */
#define STRUCT broad_phase
static const struct field_table broad_phase_fields = FIELD_TABLE(broad_phase,
    FIELD(near_count), FIELD(touch_count),
    FIELD_STRUCT_USED(contact, &contact_fields, near_count), FIELD_USED(way_m, count),
    FIELD_USED(reach_m, count), FIELD_SKIP(count), FIELD_SKIP(body), FIELD_SKIP(flags),
    FIELD_SKIP(neighbours), FIELD_SKIP(contact_count), FIELD_SKIP(overlap_count),
    FIELD_SKIP(play_m), FIELD_SKIP(narrow_phase), FIELD_SKIP(found));
#undef STRUCT

#define STRUCT water
const struct field_table water_fields = FIELD_TABLE(water, FIELD(newest), FIELD(height_m));
#undef STRUCT

/* Members of struct tank that the state hashes read. The hashes skip `lanes` and `search`, which
 * affect only speed, and `solver`, which is scratch memory. */
#define STRUCT tank
const struct field_table tank_quick_fields = FIELD_TABLE(tank,
    FIELD_STRUCT_USED(fish, &fish_quick_fields, fish_count));

const struct field_table tank_fields = FIELD_TABLE(tank,
    FIELD(seed), FIELD(preset), FIELD(size_m), FIELD(wall_height_m), FIELD(wall_follow),
    FIELD(ball_spaces), FIELD_LATER(temper, 1), FIELD(space), FIELD(fish_count),
    FIELD_STRUCT_USED(fish, &fish_fields, fish_count), FIELD_STRUCT(shade, &shade_fields),
    FIELD_STRUCT(oxygen, &oxygen_fields), FIELD(reentry_count),
    FIELD_STRUCT(broad_phase, &broad_phase_fields), FIELD_STRUCT(water, &water_fields),
    FIELD_SKIP(lanes), FIELD_SKIP(search), FIELD_SKIP(solver));
#undef STRUCT
/* clang-format on */
