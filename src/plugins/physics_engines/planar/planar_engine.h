#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_ENGINE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_ENGINE_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/core/simulator/physics_engine/described_body_engine.h>
#include <argos3/plugins/simulator/physics_engines/planar/ghost_discs.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_model.h>

#include <string>
#include <utility>
#include <vector>

namespace argos {

/**
 * Base of the 2D engines: which bodies they accept, the height of their plane, and their ghosts.
 *
 * The derived engine has a world in which bodies move. It builds the world from the models in the
 * first tick and after a reset; in between, bodies are added and removed one by one.
 */
class CPlanarEngine : public CDescribedBodyEngine {
 public:
  /**
   * Reads the parameters of all 2D engines: `iterations`, `elevation`, `velocity_lag`; ignores
   * `<spatial_hash>`.
   */
  void Init(TConfigurationNode& tree) override;

  /** Also requires that the body is on the plane: an immovable body may be lifted off it. */
  bool IsTouchedBy(const CEmbodiedEntity& body) override;
  std::string ExplainRefusal(CEntity& entity) const override;
  bool StopsAtWalls() const override { return true; }
  /** Robots that drive on this plane are obstacles for the bodies of this engine. */
  bool CanFeelGhosts() const override { return true; }
  bool CanBePeriodic() const override { return true; }
  /** The height of the plane, twice. */
  std::pair<Real, Real> GetHeightSpan() const override { return {m_elevation, m_elevation}; }

  /** Height of the plane, m. */
  Real GetElevation() const { return m_elevation; }
  Real GetVelocityLag() const override { return m_velocityLag; }

  /** For models: the gripper or the turret of their robot was added or removed. */
  virtual void UpdateManipulator(CPlanarModel& model) = 0;

 protected:
  /** Only bodies without propellers at the height of the plane. */
  bool Accepts(const CEmbodiedEntity& body) const override;
  void CheckBody(CEmbodiedEntity& body) const override;
  /** Transfers the state of motion, too. */
  void Adopt(CDescribedBodyModel& model) override;
  /** Writes the pose at the end of a tick, world frame; the engine writes the bounds. */
  void WritePose(CPlanarModel& model, CEmbodiedEntity& body, const SPlanarPose& pose) const {
    if (m_isPeriodic) {
      CountTurns(body, pose);
    }
    body.SetOriginPose(CVector3(pose.X, pose.Y, m_elevation),
                       CQuaternion(pose.HalfCos, 0.0, 0.0, pose.HalfSin));
    if (body.GetEnabledAnchors().size() > 1) {
      model.CalculateAnchors();
    }
  }
  /** Which sides of the arena are joined, in the frame of the engine. */
  SPeriodicity GetPeriod() const;
  /** Lists the ghosts of this tick. */
  const std::vector<SGhostDisc>& ListGhosts();

  bool m_isPeriodic = false;  // the arena; set when a world is built

 private:
  // the body may have left a periodic arena through a side
  void CountTurns(CEmbodiedEntity& body, const SPlanarPose& pose) const;

  Real m_elevation = 0.0;  // m
  Real m_velocityLag = 0.0;  // share of a tick
  std::vector<SGhostDisc> m_ghostDiscs;  // of this tick
};

}  // namespace argos

#endif
