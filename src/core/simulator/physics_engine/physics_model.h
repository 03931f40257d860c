#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PHYSICS_MODEL_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PHYSICS_MODEL_H

// the path that users' code includes
#include <argos3/core/simulator/entity/physics_model.h>

#endif
