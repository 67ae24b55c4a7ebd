/* poi_fields.c -- the tables of the members of the poi, its paper, its fish, and the bowl.
 *
 * The order of each table determines the hash, so the order never changes. */
#include "core/poi/poi_fields.h"

#include "core/poi/poi.h"

/* clang-format off */
#define STRUCT carried_fish
static const struct field_table carried_fish_fields = FIELD_TABLE(carried_fish,
    FIELD(fish), FIELD(state), FIELD_SIGN(side), FIELD(walled), FIELD(clear_ticks), FIELD(x_m),
    FIELD(z_m), FIELD(height_m), FIELD(slide_x_m_s), FIELD(slide_z_m_s), FIELD(heading_rad),
    FIELD(lie), FIELD(vigour), FIELD(rest_s), FIELD(slap_s), FIELD(slap_n), FIELD(slap_d_m),
    FIELD(hop_s), FIELD(fall_m_s));
#undef STRUCT

#define STRUCT sheet_load
static const struct field_table sheet_load_fields = FIELD_TABLE(sheet_load,
    FIELD(x_m), FIELD(diameter_m), FIELD(z_m), FIELD(force_n));
#undef STRUCT

/* The hash skips `stress`, which is used for display only. */
#define STRUCT sheet
const struct field_table sheet_fields = FIELD_TABLE(sheet,
    FIELD(grade), FIELD(touched), FIELD(soaked), FIELD(ideal), FIELD(radius_m), FIELD(fibre_x),
    FIELD(fibre_z), FIELD(wetness), FIELD(soak_ticks), FIELD(damage), FIELD(strength),
    FIELD_BYTES(state), FIELD(strength_min), FIELD(paper_cells), FIELD(paper_cells_new),
    FIELD(sag_m), FIELD_SKIP(stress));
#undef STRUCT

/* Members that the quick hash and the full hash of a poi read first. */
#define POI_QUICK \
    FIELD(link), FIELD(position_m), FIELD(velocity_m_s), FIELD(angles), FIELD(immersed), \
    FIELD_AGAIN(sheet.paper_cells), FIELD(carried_count), FIELD(is_in), FIELD(dips)

#define STRUCT poi
const struct field_table poi_quick_fields = FIELD_TABLE(poi, POI_QUICK);

const struct field_table poi_fields = FIELD_TABLE(poi,
    POI_QUICK, FIELD(seed), FIELD(damage_immune), FIELD(before_m), FIELD(hand_m),
    FIELD(before_m_s), FIELD(reaction), FIELD(stopped), FIELD(jam_ticks), FIELD(clings),
    FIELD(drops), FIELD(laden_ticks), FIELD(angular_velocity_rad_s), FIELD(spin_rad_s),
    FIELD(acceleration_m_s2), FIELD(jolt_m_s2), FIELD(tip_toward), FIELD(splash_m_s),
    FIELD(water_kg), FIELD(tip), FIELD(pressure_pa), FIELD(carried_kg), FIELD(before_angles),
    FIELD(pace_m_s), FIELD(drag_n_s_m), FIELD(slam_n), FIELD(added_kg), FIELD(edge_n_s_m),
    FIELD(meniscus_n), FIELD(film_kg), FIELD(pool_kg), FIELD(drip_kg), FIELD(slap_tick),
    FIELD(tear_tick), FIELD_SKIP(tear_gain), FIELD(strain), FIELD(load_count), FIELD(slap_count),
    FIELD_STRUCT_USED(carried_fish, &carried_fish_fields, carried_count),
    FIELD_STRUCT_USED(loads, &sheet_load_fields, load_count), FIELD_STRUCT(sheet, &sheet_fields));
#undef STRUCT

#define STRUCT bowl
const struct field_table bowl_fields = FIELD_TABLE(bowl,
    FIELD(present), FIELD(home_m), FIELD(position_m), FIELD(before_m), FIELD(velocity_m_s),
    FIELD(heel_x), FIELD(heel_z), FIELD(heel_x_rad_s), FIELD(heel_z_rad_s), FIELD(water_kg),
    FIELD(fish_kg), FIELD(fish_count));
#undef STRUCT
/* clang-format on */
