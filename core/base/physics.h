/* physics.h -- physical constants of several modules. */
#ifndef KINGYO_CORE_BASE_PHYSICS_H
#define KINGYO_CORE_BASE_PHYSICS_H

#define GRAVITY_M_S2 9.81f
#define WATER_KG_M3 1000.0f

#endif
