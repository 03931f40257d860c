#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_ENGINE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_ENGINE_H

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/simulator/physics_engines/planar/ghost_discs.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_model.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * An engine whose bodies stand on a horizontal plane: whom it houses, and how they come and go.
 *
 * How bodies move is up to the world of the engine that derives from this. It is built from the
 * models at the first tick and after a reset; between, bodies enter and leave it one by one.
 */
class CPlanarEngine : public CPhysicsEngine {
 public:
  /** Reads what all planes have: `iterations`, `elevation`; `<spatial_hash>` is ignored. */
  void Init(TConfigurationNode& tree) override;

  size_t GetNumPhysicsModels() override { return m_models.size(); }
  /**
   * Adds the body of a root entity, if it has a description.
   * @return false if it has none, or is not at the height of this plane: another engine may take
   * it.
   * @throws CARGoSException if the description is of no possible body; if a robot has a drive but
   * no wheels.
   */
  bool AddEntity(CEntity& entity) override;
  std::string ExplainRefusal(CEntity& entity) const override;
  bool RemoveEntity(CEntity& entity) override;
  bool StopsAtWalls() const override { return true; }
  /** Those that drive on this plane are in the way of what is here. */
  bool CanFeelGhosts() const override { return true; }
  /** The plane. */
  std::pair<Real, Real> GetHeightSpan() const override { return {m_elevation, m_elevation}; }
  /** Nothing: all bodies are in the space's index. */
  void CheckIntersectionWithRay(TEmbodiedEntityIntersectionData&, const CRay3&) const override {}
  bool HasBodiesOutsideIndex() const override { return false; }

  /** Height of the plane, m. */
  Real GetElevation() const { return m_elevation; }

  /** For models: their robot has got, or lost, a gripper or turret. */
  virtual void UpdateManipulator(CPlanarModel& model) = 0;

 protected:
  /** In no particular order. */
  const std::vector<std::unique_ptr<CPlanarModel>>& GetModels() const { return m_models; }
  /**
   * In the order of their entities, whatever happened before: that in which they are to enter a new
   * world. Makes room for those that may come from other engines.
   */
  std::vector<CPlanarModel*> ListModelsForWorld();
  /** So many bodies and, if there may be such, those that may come from other engines. */
  size_t WithComers(size_t bodies) const;
  void DropModels() { m_models.clear(); }

  /**
   * The engine that would take a body which has left, if it is of the same type and certain to;
   * else null.
   */
  CPlanarEngine* FindNext(const CEmbodiedEntity& body) const;
  /** Takes a movable body over from another engine of this type; asks for no memory. */
  void TakeOver(CPlanarModel& model);
  /** The ghosts that are felt in this tick. */
  const std::vector<SGhostDisc>& TakeGhosts();

  virtual std::unique_ptr<CPlanarModel> MakeModel(CEmbodiedEntity& body, const Real* wheels) = 0;
  /** Makes a model of another engine of this type anew, where it is in memory, as one of this. */
  virtual void RemakeModel(CPlanarModel& model, CEmbodiedEntity& body, const Real* wheels) = 0;
  /** A new model of this engine: puts it into the world, if there is one. */
  virtual void Enter(CPlanarModel& model) = 0;
  /** One that leaves: takes it out of the world and all lists. */
  virtual void Leave(CPlanarModel& model) = 0;

 private:
  void AddModel(std::unique_ptr<CPlanarModel> model);
  std::unique_ptr<CPlanarModel> TakeOut(CPlanarModel& model);

  Real m_elevation = 0.0;  // m
  std::vector<std::unique_ptr<CPlanarModel>> m_models;
  std::vector<SGhostDisc> m_ghostDiscs;  // of this tick
};

}  // namespace argos

#endif
