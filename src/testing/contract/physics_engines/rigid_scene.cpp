#include <argos3/testing/contract/physics_engines/rigid_scene.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace argos {

namespace {

/** "contract_kick": see KickXml(). */
class CContractKick : public CDynamics3DPlugin {
 public:
  void Init(TConfigurationNode& tree) override {
    GetNodeAttribute(tree, "body", m_id);
    GetNodeAttribute(tree, "impulse", m_impulse);
  }
  void Reset() override { m_isDone = false; }
  void RegisterModel(CDynamics3DModel& model) override {
    if (model.GetEmbodiedEntity().GetRootEntity().GetId() == m_id) {
      m_model = &model;
    }
  }
  void UnregisterModel(CDynamics3DModel& model) override {
    m_model = m_model == &model ? nullptr : m_model;
  }
  void Update() override {
    if (m_model != nullptr && !m_isDone) {
      m_model->AddForce(m_impulse / GetEngine().GetSubstep(), m_model->GetCentreOfMass());
    }
    m_isDone = true;
  }

 private:
  std::string m_id;
  CVector3 m_impulse;  // N s
  CDynamics3DModel* m_model = nullptr;
  bool m_isDone = false;
};

REGISTER_DYNAMICS3D_PLUGIN(CContractKick, "contract_kick", "the authors of this project", "1.0",
                           "An impulse at the start.", "For tests.", "Usable")

}  // namespace

std::string RigidEngine(const std::string& attributes, const std::string& children) {
  return "<dynamics3d id='e' " + attributes + ">" + children + "</dynamics3d>";
}

std::string GroundedEngine(const std::string& attributes, const std::string& children) {
  std::ostringstream gravity;
  gravity << "<floor/><gravity g='" << kSceneGravity << "'/>";
  return RigidEngine(attributes, gravity.str() + children);
}

std::string SBoxXml::ToXml() const {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<box id='" << Id << "' size='" << Size << "' movable='"
      << (Mass > 0.0 ? "true" : "false") << "'";
  if (Mass > 0.0) {
    xml << " mass='" << Mass << "'";
  }
  xml << "><body position='" << Position << "' orientation='" << Degrees << "'/></box>\n";
  return xml.str();
}

std::string KickXml(const std::string& id, const CVector3& impulse) {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<contract_kick body='" << id << "' impulse='" << impulse
      << "'/>";
  return xml.str();
}

Real CRigidScene::Tilt(const std::string& id) {
  CVector3 up = CVector3::Z;
  up.Rotate(Orientation(id));
  return std::acos(std::min(1.0, up.GetZ()));
}

}  // namespace argos
