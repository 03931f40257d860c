#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OVERLAYS_COLOR_RULE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OVERLAYS_COLOR_RULE_H

#include <argos3/core/simulator/outputs/field.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/datatypes/color.h>

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace argos {

class CComposableEntity;

/**
 * How an overlay colours robots: the attribute `color_by`, which is `robot` (each has a colour of
 * its own), `type`, `team` (the id of its controller in the file), `led` (the brightest LED), or
 * the name of a field of tables, with the attributes `min` and `max`, whose values are dark blue
 * and yellow; or one colour for all, `color`.
 *
 * Source of the scale: a fit of the map "viridis" of S. van der Walt and N. Smith (2015) at nine
 * places, linear between them.
 */
class CColorRule {
 public:
  /**
   * Reads the attributes; `color` is that of all robots.
   * @param ofAll  the colour without `color` and `color_by`; none: each robot has a colour of its
   * own.
   * @throws CARGoSException if `color_by` is no rule and no field of numbers, or if `min` and `max`
   *   are not in order.
   */
  void Init(TConfigurationNode& node, const std::optional<CColor>& ofAll = {});
  /** Black, and transparent, if the robot has no value. */
  CColor Choose(CComposableEntity& robot);

 private:
  enum class ERule { All, Robot, Type, Team, LED, Field };

  size_t GetNumberOf(const std::string& name);
  CColor ReadField(CComposableEntity& robot);

  ERule m_rule = ERule::All;
  CColor m_ofAll;
  std::unordered_map<std::string, size_t>
      m_numbers;  // by robot, type or team, in the order in which they were seen
  std::optional<SFieldName> m_field;
  std::vector<double> m_row;
  CRowTexts m_texts;
  Real m_min = 0.0;
  Real m_max = 1.0;
};

/** A colour of the scale. @param share  from 0 to 1; others are as the nearest. */
CColor GetScaleColor(Real share);

}  // namespace argos

#endif
