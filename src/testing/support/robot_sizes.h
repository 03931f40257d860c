#ifndef ARGOS3_TESTING_SUPPORT_ROBOT_SIZES_H
#define ARGOS3_TESTING_SUPPORT_ROBOT_SIZES_H

#include <argos3/plugins/robots/e-puck/simulator/epuck_measures.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>

namespace argos {

// radii of bodies, m; robot_components_test.cpp compares them with the published numbers
constexpr Real kFootBotRadius = footbot::kBodyRadius;
constexpr Real kEPuckRadius = epuck::kBodyRadius;

}  // namespace argos

#endif
