#include <argos3/plugins/simulator/visualizations/overlays/color_rule.h>

#include <argos3/core/simulator/entity/existing_component.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/visualizations/overlays/robots_in_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace argos {

namespace {

const CColor kNone(0, 0, 0, 0);

/* The id of the robot's controller in <controllers>; of a replay's robot, its type. */
std::string FindTeam(CComposableEntity& robot) {
  TConfigurationNode* const node = robot.GetConfigurationNode();
  std::string team = robot.GetTypeDescription();
  if (node != nullptr && NodeExists(*node, "controller")) {
    GetNodeAttributeOrDefault(GetNode(*node, "controller"), "config", team, team);
  }
  return team;
}

CColor FindBrightestLED(CComposableEntity& robot) {
  CColor brightest = kNone;
  UInt32 brightness = 0;
  if (auto* const leds = FindExistingComponent<CLEDEquippedEntity>(robot)) {
    for (UInt32 i = 0; i < leds->GetNumLEDs(); ++i) {
      const CColor& color = leds->GetLEDColor(i);
      const UInt32 sum = color.GetRed() + color.GetGreen() + color.GetBlue();
      if (sum > brightness) {
        brightness = sum;
        brightest = color;
      }
    }
  }
  return brightest;
}

}  // namespace

CColor GetScaleColor(Real share) {
  static const std::array<CColor, 9> kColors = {
      CColor(68, 1, 84),    CColor(71, 44, 122),  CColor(59, 81, 139),
      CColor(44, 113, 142), CColor(33, 144, 141), CColor(39, 173, 129),
      CColor(92, 200, 99),  CColor(170, 220, 50), CColor(253, 231, 37)};
  const Real place = std::clamp(share, 0.0, 1.0) * (kColors.size() - 1);
  const auto below = std::min(static_cast<size_t>(place), kColors.size() - 2);
  const Real weight = place - static_cast<Real>(below);
  const auto mix = [&](UInt8 first, UInt8 second) {
    return static_cast<UInt8>(std::lround((1.0 - weight) * first + weight * second));
  };
  const CColor& first = kColors[below];
  const CColor& second = kColors[below + 1];
  return CColor(mix(first.GetRed(), second.GetRed()), mix(first.GetGreen(), second.GetGreen()),
                mix(first.GetBlue(), second.GetBlue()));
}

void CColorRule::Init(TConfigurationNode& node, const std::optional<CColor>& ofAll) {
  m_ofAll = ofAll.value_or(CColor::BLACK);
  const bool hasColor = NodeAttributeExists(node, "color");
  GetNodeAttributeOrDefault(node, "color", m_ofAll, m_ofAll);
  if (!NodeAttributeExists(node, "color_by")) {
    m_rule = hasColor || ofAll ? ERule::All : ERule::Robot;
    return;
  }
  if (hasColor) {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attributes \"color\" and \"color_by\" cannot be given "
                                          "together");
  }
  std::string name;
  GetNodeAttribute(node, "color_by", name);
  if (name == "robot") {
    m_rule = ERule::Robot;
  } else if (name == "type") {
    m_rule = ERule::Type;
  } else if (name == "team") {
    m_rule = ERule::Team;
  } else if (name == "led") {
    m_rule = ERule::LED;
  } else {
    m_rule = ERule::Field;
    try {
      m_field.emplace(name);
    } catch (CARGoSException& ex) {
      THROW_ARGOSEXCEPTION_NESTED(OwnerOf(node)
                                      << ": attribute \"color_by\" is neither robot, type, "
                                         "team or led, nor a field of tables",
                                  ex);
    }
    GetNodeAttributeOrDefault(node, "min", m_min, m_min);
    GetNodeAttributeOrDefault(node, "max", m_max, m_max);
    // numbers of files are finite, and at most 1e12
    if (!(m_min < m_max)) {
      THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attribute \"min\" must be below \"max\", got "
                                         << m_min << " and " << m_max);
    }
  }
}

size_t CColorRule::GetNumberOf(const std::string& name) {
  return m_numbers.try_emplace(name, m_numbers.size()).first->second;
}

CColor CColorRule::ReadField(CComposableEntity& robot) {
  // the field is bound in each picture, because robots are added and removed during a run
  const SBoundField bound = m_field->Bind(robot);
  if (bound.Reader == nullptr || bound.Columns.empty() ||
      bound.Columns[0].Kind == EColumnKind::Text || bound.Reader->CountRows() == 0) {
    return kNone;
  }
  m_row.assign(std::max(bound.Columns.size(), m_field->Field->GetNumRaw()),
               std::numeric_limits<double>::quiet_NaN());
  m_texts.Clear();
  bound.Reader->Read(0, {m_row.data(), m_texts, bound.Columns.data()});
  if (m_field->Field->GetNumRaw() > 0) {
    m_field->Field->Derive(m_row.data());
  }
  return std::isnan(m_row[0]) ? kNone : GetScaleColor((m_row[0] - m_min) / (m_max - m_min));
}

CColor CColorRule::Choose(CComposableEntity& robot) {
  switch (m_rule) {
    case ERule::Robot:
      return GetPaletteColor(GetNumberOf(robot.GetId()));
    case ERule::Type:
      return GetPaletteColor(GetNumberOf(robot.GetTypeDescription()));
    case ERule::Team:
      return GetPaletteColor(GetNumberOf(FindTeam(robot)));
    case ERule::LED:
      return FindBrightestLED(robot);
    case ERule::Field:
      return ReadField(robot);
    case ERule::All:
      break;
  }
  return m_ofAll;
}

}  // namespace argos
