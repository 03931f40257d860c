#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_plugin.h>

#include <algorithm>
#include <vector>

using namespace argos;

/** A wind over the whole engine: the drag of the air, in proportion to the speed against it. */
class CWind : public CDynamics3DPlugin {
 public:
  void Init(TConfigurationNode& node) override {
    GetNodeAttribute(node, "velocity", m_velocity);
    GetNodeAttributeOrDefault(node, "drag", m_drag, m_drag);
  }

  // called when a body enters the engine, and when it leaves it
  void RegisterModel(CDynamics3DModel& model) override {
    if (model.GetEmbodiedEntity().IsMovable()) {
      m_models.push_back(&model);
    }
  }
  void UnregisterModel(CDynamics3DModel& model) override {
    m_models.erase(std::remove(m_models.begin(), m_models.end(), &model), m_models.end());
  }

  // called before every substep; forces act in that substep only
  void Update() override {
    for (CDynamics3DModel* model : m_models) {
      model->AddForce(m_drag * (m_velocity - model->GetVelocity()), model->GetCentreOfMass());
    }
  }

 private:
  CVector3 m_velocity;  // of the air, m/s
  Real m_drag = 1.0;  // N s/m
  std::vector<CDynamics3DModel*> m_models;  // movable ones; not owned
};

REGISTER_DYNAMICS3D_PLUGIN(CWind, "wind", "A. Student", "1.0", "A wind for dynamics3d.",
                           "  velocity  \"x,y,z\", m/s, required: of the air.\n"
                           "  drag      N s/m, default 1: force per speed against the air.",
                           "Usable")
