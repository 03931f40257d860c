#ifndef GROUP_SIZES_H
#define GROUP_SIZES_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/math/vector2.h>

#include <vector>

namespace argos {
class CLEDEquippedEntity;
struct SAnchor;
}  // namespace argos

/**
 * Measures the groups under the shelters: the red robots within the range of each. Reads colours
 * and places only, so the controllers may be in C++ or in Lua.
 *
 * Metrics: size_<number> of each shelter; over the active ones smallest, quartile_1, median,
 * quartile_3, largest, and iqr, the quartiles' difference; free, the robots that are green. With
 * target sizes also ratio_<number>, the size divided by the target. With a perturbed shelter also
 * near and far, the mean sizes of the active shelters within and beyond the reach of its reset
 * signal, and bias, their difference.
 */
class CGroupSizes : public argos::CLoopFunctions {
 public:
  /**
   * Reads the optional attributes range (m); sizes (targets, separated by commas); and perturbed
   * (number of a shelter, -1 for none) and reach (m, in x and in y: other shelters that are not
   * farther from it are near).
   */
  void Init(argos::TConfigurationNode& node) override;
  void PostStep() override;

 private:
  struct SShelter {
    argos::CLEDEquippedEntity* LEDs;
    argos::CVector2 Position;  // m
    bool IsNear;
    argos::UInt32 Size;
  };
  struct SRobot {
    argos::CLEDEquippedEntity* LEDs;
    const argos::SAnchor* Anchor;
  };

  void Collect();
  void Count();
  void RecordQuantiles();
  void RecordBias();

  argos::Real m_range = 0.8;  // m
  argos::SInt32 m_perturbed = -1;
  argos::Real m_reach = 0.0;  // m
  std::vector<argos::Real> m_targets;  // of the first shelters

  std::vector<SShelter> m_shelters;  // by their numbers
  std::vector<SRobot> m_robots;
  std::vector<argos::Real> m_sizes;  // of the active shelters, sorted
};

#endif
