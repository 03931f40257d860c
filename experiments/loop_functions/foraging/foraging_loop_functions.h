#ifndef FORAGING_LOOP_FUNCTIONS_H
#define FORAGING_LOOP_FUNCTIONS_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/rng.h>

#include <fstream>
#include <string>
#include <vector>

class CFootBotForaging;

/**
 * Food that robots fetch into a nest.
 *
 * The nest is the half x < 0 of the arena, grey on the ground; food lies in the other half as black
 * discs. A robot that explores and comes over a disc takes it; in the nest the food is eaten, and
 * grows anew somewhere else. A data file tells for each tick how many robots are out, how many
 * rest, and what was delivered.
 */
class CForagingLoopFunctions : public argos::CLoopFunctions {
 public:
  /**
   * Reads the attributes items (number of discs), radius (m), area_x and area_y (m, "min:max",
   * where food grows) of `<foraging>`, and output, the name of the data file; without it there is
   * none.
   */
  void Init(argos::TConfigurationNode& node) override;
  void Reset() override;
  void Destroy() override;
  argos::CColor GetFloorColor(const argos::CVector2& position) override;
  void PreStep() override;

 private:
  void Grow(argos::CVector2& item);
  void OpenData();
  /** @return true if a disc was taken or food delivered. */
  bool TakeOrDeliver(CFootBotForaging& controller, const argos::CVector2& position);

  argos::CRandom::CRNG* m_rng = nullptr;
  argos::Real m_radius = 0.1;  // m
  argos::CRange<argos::Real> m_areaX{0.5, 2.0}, m_areaY{-1.5, 1.5};  // m
  std::vector<argos::CVector2> m_items;  // centres of the discs, m
  std::string m_fileName;
  std::ofstream m_data;
  argos::UInt64 m_delivered = 0;
};

#endif
