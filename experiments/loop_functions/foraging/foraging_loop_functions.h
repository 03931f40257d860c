#ifndef FORAGING_LOOP_FUNCTIONS_H
#define FORAGING_LOOP_FUNCTIONS_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/files/output_file.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/rng.h>

#include <string>
#include <vector>

class CFootBotForaging;

/**
 * Food that robots transport to a nest.
 *
 * The nest is the half x < 0 of the arena, grey on the ground; food items are black discs in the
 * other half. An exploring robot that drives over a disc takes it; delivery in the nest consumes
 * the food, and a new item appears at a random place. A data file lists for each tick how many
 * robots are active and resting, and how much was delivered.
 */
class CForagingLoopFunctions : public argos::CLoopFunctions {
 public:
  /**
   * Reads the attributes items (number of discs), radius (m), area_x and area_y (m, "min:max", area
   * of the food) of `<foraging>`, and output (name of the data file; without it none is written).
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
  argos::COutputFile m_data;
  argos::UInt64 m_delivered = 0;
};

#endif
