/* technique.c -- the two built-in techniques. */
#include "core/game/bot/technique.h"

#include "core/base/hash.h"
#include "core/base/panic.h"

const struct technique technique_novice = {
    .wet = 0.3f,
    .entry_deg = 10.0f,
    .glide_deg = 20.0f,
    .side = SIDE_ANY,
    .place = PLACE_CENTRE,
    .lift = LIFT_FAST,
    .hunt = HUNT_CHASE,
    .fish_max = 1,
    .fish_m = 0.040f,
    .arm_m_s = 0.50f,
    .dip_m_s = 0.35f,
    .glide_m_s = 0.40f,
    .lift_m_s = 0.60f,
    .carry_m_s = 0.55f,
    .drain_s = 0.0f,
    .patience_s = 1.0f,
    .aim_m = 0.009f,
    .tremor_m = 0.0015f,
    .reaction_min_s = 0.20f,
    .reaction_max_s = 0.25f,
};

const struct technique technique_expert = {
    .wet = 1.0f,
    .entry_deg = 40.0f,
    .glide_deg = 5.0f,
    .side = SIDE_HEAD,
    .place = PLACE_RIM,
    .lift = LIFT_DRAINED,
    .hunt = HUNT_SHADE,
    .fish_max = 3,
    .fish_m = 0.035f,
    .arm_m_s = 0.60f,
    .dip_m_s = 0.25f,
    .glide_m_s = 0.20f,
    .lift_m_s = 0.22f,
    .carry_m_s = 0.50f,
    .drain_s = 0.25f,
    .patience_s = 2.0f,
    .aim_m = 0.006f,
    .tremor_m = 0.0006f,
    .reaction_min_s = 0.15f,
    .reaction_max_s = 0.25f,
};

uint64_t technique_hash(uint64_t hash, const struct technique *technique)
{
    CORE_ASSERT(technique->side < SIDE_COUNT && technique->hunt < HUNT_COUNT);
    const float figures[] = {
        technique->wet,       technique->entry_deg,      technique->glide_deg,
        technique->fish_m,    technique->arm_m_s,        technique->dip_m_s,
        technique->glide_m_s, technique->lift_m_s,       technique->carry_m_s,
        technique->drain_s,   technique->patience_s,     technique->aim_m,
        technique->tremor_m,  technique->reaction_min_s, technique->reaction_max_s,
    };
    hash = hash_u32(hash, technique->side);
    hash = hash_u32(hash, technique->place);
    hash = hash_u32(hash, technique->lift);
    hash = hash_u32(hash, technique->hunt);
    hash = hash_u32(hash, technique->fish_max);
    return hash_floats(hash, figures, sizeof figures / sizeof figures[0]);
}
