#ifndef TRAILS_LOOP_FUNCTIONS_H
#define TRAILS_LOOP_FUNCTIONS_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/files/output_file.h>
#include <argos3/core/utility/math/vector2.h>

#include <string>
#include <vector>

namespace argos {
class CPheromoneMedium;
}

/**
 * Unlimited food, a nest, and the trails between them, painted on the ground.
 *
 * A data file lists for each tick how many robots carry food, how much was delivered so far, and
 * the total amount of trail.
 */
class CTrailsLoopFunctions : public argos::CLoopFunctions {
 public:
  /**
   * Reads the attributes medium (id of the pheromone medium with the layer "trail"), full (1/m^2:
   * the concentration with the strongest colour) and output (name of the data file; without it none
   * is written) of `<trails>`, and position ("x,y", m) and radius (m) of its children `<nest>` and
   * `<food>`, of which there may be several.
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
  argos::COutputFile m_data;
};

#endif
