#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_GRIP_TIES_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_GRIP_TIES_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_grips.h>
#include <argos3/plugins/simulator/physics_engines/planar/body_forest.h>

#include <vector>

namespace argos {

/**
 * Finds robots that grip each other and whose drives balance, and gives them their common speed.
 *
 * If the greatest forces of drives add up to nothing along the line of their pull, mechanics leaves
 * the speed of the group undetermined: at each speed between those that the two sides want, both
 * sides slip with the same force. The group then moves at the mean of the speeds that its robots
 * want, by mass: what inelastic impact gives to robots that push each other at these speeds.
 * Without this, the speed would be what is left of the momentum with which the balance began, which
 * depends on the stretching of the grips and on the substeps.
 */
class CGripTies {
 public:
  /** Allocates for so many robots in grips. */
  void Reserve(size_t robots);
  /**
   * After the robots were planned: changes the velocities of groups that balanced in the last tick.
   * A group that holds an object or pressed another body is left alone: it is not balanced by its
   * drives only.
   */
  void Settle(CPlanarStore& store, const CPlanarGrips& grips,
              const std::vector<SGripTouch>& touches);

 private:
  void FindGroups(const CPlanarGrips& grips);
  void FindLoaded(const CPlanarGrips& grips, const std::vector<SGripTouch>& touches);
  UInt32 NumberOf(UInt32 slot) const;
  SPlanarVector ComputeChange(const CPlanarStore& store, size_t begin, size_t end) const;

  std::vector<UInt32> m_slots;  // of the robots in grips with each other, ascending
  // by number in m_slots
  TBodyForest m_parents;
  std::vector<UInt8> m_isLoaded;  // by the group's root
  std::vector<UInt32> m_members;  // by group
};

}  // namespace argos

#endif
