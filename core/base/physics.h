/* physics.h -- physical constants of several modules. */
#pragma once

#define GRAVITY_M_S2 9.81f
#define WATER_KG_M3 1000.0f
