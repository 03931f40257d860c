#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/simulator/entities/magnet_equipped_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/add_on_manual.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_plugin.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace argos {

namespace {

// N m^4 per unit of field squared, as published with ARGoS 3: 3 mu0 / (4 pi) for moments in units
// of 1.533e-3 A m^2
constexpr Real kForceConstant = 7.0500949e-13;

CMagnetEquippedEntity* FindMagnets(CDynamics3DModel& model) {
  auto* const root = dynamic_cast<CComposableEntity*>(&model.GetEmbodiedEntity().GetRootEntity());
  if (root == nullptr) {
    return nullptr;
  }
  for (CEntity* component : root->GetExistingComponents()) {
    if (auto* const magnets = dynamic_cast<CMagnetEquippedEntity*>(component)) {
      return magnets;
    }
  }
  return nullptr;
}

}  // namespace

/**
 * Forces and torques between the magnets of different bodies, as between dipoles.
 *
 * Source: J. D. Jackson, Classical Electrodynamics, 3rd ed., 1999, sections 5.6 and 5.7. With the
 * moments m1 and m2, the distance r and the direction n from the first to the second:
 *   force on the second  K / r^4 [(m1.n) m2 + (m2.n) m1 + (m1.m2) n - 5 (m1.n) (m2.n) n]
 *   torque on it         m2 x K / (3 r^3) [3 (m1.n) n - m1]
 */
class CDynamics3DMagnetismPlugin : public CDynamics3DPlugin {
 public:
  void Init(TConfigurationNode& tree) override {
    GetNodeAttributeOrDefault(tree, "force_constant", m_forceConstant, m_forceConstant);
    RequireNotNegative(m_forceConstant, OwnerOf(tree), "attribute \"force_constant\"");
    ReadOptionalPositive(tree, "max_distance", "m", m_maxDistance);
  }

  void RegisterModel(CDynamics3DModel& model) override {
    if (CMagnetEquippedEntity* const magnets = FindMagnets(model)) {
      m_carriers.push_back({&model, magnets});
    }
  }

  void UnregisterModel(CDynamics3DModel& model) override {
    const auto isIt = [&model](const SCarrier& carrier) { return carrier.Model == &model; };
    m_carriers.erase(std::remove_if(m_carriers.begin(), m_carriers.end(), isIt), m_carriers.end());
  }

  // The order of sums must not depend on earlier additions and removals.
  void Reset() override {
    std::sort(m_carriers.begin(), m_carriers.end(), [](const SCarrier& a, const SCarrier& b) {
      return a.Model->GetEmbodiedEntity().GetIndex() < b.Model->GetEmbodiedEntity().GetIndex();
    });
  }

  void Update() override {
    Locate();
    for (size_t i = 0; i < m_dipoles.size(); ++i) {
      for (size_t j = i + 1; j < m_dipoles.size(); ++j) {
        if (m_dipoles[i].Model != m_dipoles[j].Model) {
          Interact(m_dipoles[i], m_dipoles[j]);
        }
      }
    }
  }

 private:
  struct SCarrier {
    CDynamics3DModel* Model;
    CMagnetEquippedEntity* Magnets;
  };
  struct SDipole {
    CDynamics3DModel* Model;
    UInt32 Link;
    CVector3 Position;  // m, world frame
    CVector3 Moment;  // units of field, world axes
  };

  // anchors have the poses of the last tick, so the poses of the substep are read from the bodies
  void Locate() {
    m_dipoles.clear();
    for (const SCarrier& carrier : m_carriers) {
      for (const CMagnetEquippedEntity::SInstance& instance : carrier.Magnets->GetInstances()) {
        const UInt32 link = carrier.Model->FindLink(instance.Anchor);
        const SBodyPose anchor = carrier.Model->ComputePose(instance.Anchor, link);
        m_dipoles.push_back({carrier.Model, link,
                             anchor.Position + Rotated(instance.Offset, anchor.Orientation),
                             Rotated(instance.Magnet.GetField(), anchor.Orientation)});
      }
    }
  }

  void Interact(const SDipole& first, const SDipole& second) const {
    CVector3 n = second.Position - first.Position;
    const Real r = n.Length();
    if (!(r > 0.0) || r > m_maxDistance) {
      return;
    }
    n /= r;
    const CVector3& m1 = first.Moment;
    const CVector3& m2 = second.Moment;
    const Real m1n = m1.DotProduct(n);
    const Real m2n = m2.DotProduct(n);
    const CVector3 force = (m2 * m1n + m1 * m2n + n * (m1.DotProduct(m2) - 5.0 * m1n * m2n)) *
                           (m_forceConstant / (r * r * r * r));
    const Real perVolume = m_forceConstant / (3.0 * r * r * r);
    second.Model->AddForce(force, second.Position, second.Link);
    first.Model->AddForce(-force, first.Position, first.Link);
    second.Model->AddTorque(Cross(m2, n * (3.0 * m1n) - m1) * perVolume, second.Link);
    first.Model->AddTorque(Cross(m1, n * (3.0 * m2n) - m2) * perVolume, first.Link);
  }

  Real m_forceConstant = kForceConstant;
  Real m_maxDistance = std::numeric_limits<Real>::infinity();  // m
  std::vector<SCarrier> m_carriers;
  std::vector<SDipole> m_dipoles;  // of this substep
};

REGISTER_DYNAMICS3D_PLUGIN(
    CDynamics3DMagnetismPlugin, "magnetism", "the authors of this project", "1.0",
    "Magnetism for dynamics3d.",
    R"(The magnets that robots carry (<magnets>) attract, repel and turn each other as dipoles
do. A magnet's field, passive and active by its current, is its dipole moment.
)" +
        AddOnXML(R"(<magnetism />)",
                 R"(<magnetism force_constant="7.0500949e-13" max_distance="0.5" />)") +
        R"(
ATTRIBUTES

  force_constant  >= 0, default 7.0500949e-13: K, N m^4 per unit of field squared. Two magnets of the fields a and
                  b in one line, at the distance r, pull each other with 2 K a b / r^4 N. With 3e-7, fields
                  are in A m^2.
  max_distance    m, > 0, default endless: magnets farther from each other do not act on each other.
)",
    "Usable")

}  // namespace argos
