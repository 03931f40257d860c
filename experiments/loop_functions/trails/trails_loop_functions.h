#ifndef TRAILS_LOOP_FUNCTIONS_H
#define TRAILS_LOOP_FUNCTIONS_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/math/vector2.h>

#include <fstream>
#include <string>
#include <vector>

namespace argos {
class CPheromoneMedium;
}

/**
 * Food that never ends, a nest, and the trails between them, all painted on the ground.
 *
 * A data file tells for each tick how many robots carry food, what was delivered so far, and how
 * much of the trail there is.
 */
class CTrailsLoopFunctions : public argos::CLoopFunctions {
 public:
  /**
   * Reads the attributes medium (id of the pheromone medium with the layer "trail"), full (1/m^2:
   * the concentration with the strongest colour) and output (name of the data file; without it
   * there is none) of `<trails>`, and of its children `<nest>` and `<food>`, any number of these:
   * position
   * ("x,y", m) and radius (m).
   */
  void Init(argos::TConfigurationNode& node) override;
  void Reset() override;
  void Destroy() override;
  argos::CColor GetFloorColor(const argos::CVector2& position) override;
  void PostStep() override;

 private:
  struct SDisc {
    argos::CVector2 Center;  // m
    argos::Real Radius = 0.0;  // m

    void Read(argos::TConfigurationNode& node);
    bool Contains(const argos::CVector2& position) const;
  };

  argos::CPheromoneMedium* m_medium = nullptr;
  size_t m_layer = 0;
  argos::Real m_full = 100.0;  // 1/m^2
  SDisc m_nest;
  std::vector<SDisc> m_food;
  std::string m_fileName;
  std::ofstream m_data;
};

#endif
