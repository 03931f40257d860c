#include "group_sizes.h"

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>

#include <algorithm>
#include <cmath>

using namespace argos;

namespace {

const std::string kPrefix = "shelter";
constexpr UInt32 kBeacon = 12;

CVector2 OnFloor(const CVector3& position) {
  return CVector2(position.GetX(), position.GetY());
}

/** @param sorted  not empty. Interpolates between neighbours, as numpy and R do. */
Real QuantileOf(const std::vector<Real>& sorted, Real share) {
  const Real place = share * (sorted.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - below) * (sorted[above] - sorted[below]);
}

struct SMean {
  Real Sum = 0.0;
  Real Number = 0.0;
  void Add(Real value) {
    Sum += value;
    Number += 1.0;
  }
};

}  // namespace

void CGroupSizes::Init(TConfigurationNode& node) {
  GetNodeAttributeOrDefault(node, "range", m_range, m_range);
  GetNodeAttributeOrDefault(node, "perturbed", m_perturbed, m_perturbed);
  GetNodeAttributeOrDefault(node, "reach", m_reach, m_reach);
  std::string sizes;
  GetNodeAttributeOrDefault(node, "sizes", sizes, sizes);
  std::vector<std::string> words;
  Tokenize(sizes, words, ", ");
  for (const std::string& word : words) {
    m_targets.push_back(FromString<Real>(word));
  }
  Collect();
}

void CGroupSizes::Collect() {
  auto& eyebots = GetSpace().GetEntitiesByType("eye-bot");
  m_shelters.resize(eyebots.size());
  for (auto& [id, entity] : eyebots) {
    auto& eyebot = *any_cast<CEyeBotEntity*>(entity);
    const auto number = FromString<size_t>(id.substr(kPrefix.size()));
    SShelter& shelter = m_shelters.at(number);
    shelter.LEDs = &eyebot.GetLEDEquippedEntity();
    shelter.Position = OnFloor(eyebot.GetEmbodiedEntity().GetOriginAnchor().Position);
  }
  for (size_t i = 0; i < m_shelters.size() && m_perturbed >= 0; ++i) {
    const CVector2 offset = m_shelters[i].Position - m_shelters.at(m_perturbed).Position;
    m_shelters[i].IsNear =
        std::max(std::abs(offset.GetX()), std::abs(offset.GetY())) <= m_reach + 1e-6;
  }
  for (auto& [id, entity] : GetSpace().GetEntitiesByType("foot-bot")) {
    auto& robot = *any_cast<CFootBotEntity*>(entity);
    m_robots.push_back(
        {&robot.GetLEDEquippedEntity(), &robot.GetEmbodiedEntity().GetOriginAnchor()});
  }
}

void CGroupSizes::PostStep() {
  Count();
  m_sizes.clear();
  for (size_t i = 0; i < m_shelters.size(); ++i) {
    const std::string number = std::to_string(i);
    SetMetric("size_" + number, m_shelters[i].Size);
    if (i < m_targets.size()) {
      SetMetric("ratio_" + number, m_shelters[i].Size / m_targets[i]);
    }
    const bool isActive = m_shelters[i].LEDs->GetLEDColor(0) != CColor::BLACK;
    if (isActive) {
      m_sizes.push_back(m_shelters[i].Size);
    }
  }
  if (!m_sizes.empty()) {
    RecordQuantiles();
  }
  if (m_perturbed >= 0) {
    RecordBias();
  }
}

void CGroupSizes::Count() {
  for (SShelter& shelter : m_shelters) {
    shelter.Size = 0;
  }
  UInt32 numFree = 0;
  for (const SRobot& robot : m_robots) {
    const CColor& color = robot.LEDs->GetLEDColor(kBeacon);
    numFree += color == CColor::GREEN ? 1 : 0;
    if (color != CColor::RED) {
      continue;
    }
    const CVector2 position = OnFloor(robot.Anchor->Position);
    for (SShelter& shelter : m_shelters) {
      if (SquareDistance(position, shelter.Position) <= m_range * m_range) {
        ++shelter.Size;
        break;
      }
    }
  }
  SetMetric("free", numFree);
}

void CGroupSizes::RecordQuantiles() {
  std::sort(m_sizes.begin(), m_sizes.end());
  const Real first = QuantileOf(m_sizes, 0.25);
  const Real third = QuantileOf(m_sizes, 0.75);
  SetMetric("smallest", m_sizes.front());
  SetMetric("quartile_1", first);
  SetMetric("median", QuantileOf(m_sizes, 0.5));
  SetMetric("quartile_3", third);
  SetMetric("largest", m_sizes.back());
  SetMetric("iqr", third - first);
}

void CGroupSizes::RecordBias() {
  SMean near;
  SMean far;
  for (size_t i = 0; i < m_shelters.size(); ++i) {
    if (i != static_cast<size_t>(m_perturbed)) {
      (m_shelters[i].IsNear ? near : far).Add(m_shelters[i].Size);
    }
  }
  if (near.Number > 0.0 && far.Number > 0.0) {
    SetMetric("near", near.Sum / near.Number);
    SetMetric("far", far.Sum / far.Number);
    SetMetric("bias", near.Sum / near.Number - far.Sum / far.Number);
  }
}

REGISTER_LOOP_FUNCTIONS(CGroupSizes, "group_sizes")
