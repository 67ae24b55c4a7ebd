/* physics.h -- what the world outside a tank gives: constants that several parts share. */
#ifndef KINGYO_CORE_BASE_PHYSICS_H
#define KINGYO_CORE_BASE_PHYSICS_H

#define GRAVITY_M_S2 9.81f
#define WATER_KG_M3 1000.0f

#endif
