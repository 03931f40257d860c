#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_DESCRIBED_BODY_ENGINE_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_DESCRIBED_BODY_ENGINE_H

#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <memory>
#include <vector>

namespace argos {

class CBodyRecorder;

/** A grip that is transferred with its bodies from one engine to another of its type. */
struct SGripTransfer {
  CEmbodiedEntity* Holder;
  CEmbodiedEntity* Held;
  CVector3 Arm; /**< end of the arm, frame of the turret or, without one, of the holder, m */
  CVector3 PointOnHeld; /**< frame of the held body, m; for engines that keep it */
  Real TurretRotation; /**< rad */
};

/**
 * An engine that builds its bodies from SBodyDescription.
 *
 * Contains what all such engines share: the list of models, the order in which they enter a new
 * world, the repositioning of bodies that MoveTo() has displaced, and the transfer of bodies, with
 * what they grip, to another engine of the same type. A transferred body keeps its model, whose
 * engine changes, so that a transfer allocates no memory.
 *
 * A derived engine keeps the state of motion in a world of its own, which it may build lazily.
 */
class CDescribedBodyEngine : public CPhysicsEngine {
 public:
  CDescribedBodyEngine();
  ~CDescribedBodyEngine() override;

  /** Maximum number of substeps of a tick; with more, a tick would practically never end. */
  static constexpr UInt32 kMaxIterations = 10000;

  /** @throws CARGoSException if CPhysicsEngine does, or for more than kMaxIterations substeps. */
  void Init(TConfigurationNode& tree) override;
  size_t GetNumPhysicsModels() override { return m_models.size(); }
  /** Calls UpdateWorld(). */
  void Update() override;
  /**
   * Adds the body of a root entity if it has a description that Accepts() accepts. If the entity
   * does not describe its body, a user's model may (CBodyRecorder).
   * @throws CARGoSException if CheckBody() does, or if a user's model cannot be described.
   */
  bool AddEntity(CEntity& entity) override;
  bool RemoveEntity(CEntity& entity) override;
  /**
   * Transfers a body, with all bodies that are connected to it by grips, to the next engine if that
   * is of the same type; else removes and adds it, which ends its grips.
   */
  void TransferEntity(CEmbodiedEntity& body) override;
  /** Does nothing: all bodies are in the space's index. */
  void CheckIntersectionWithRay(TEmbodiedEntityIntersectionData&, const CRay3&) const override {}
  bool HasBodiesOutsideIndex() const override { return false; }
  /**
   * Origin of the frame in which the engine computes, m, world frame; its axes are those of the
   * world, its height is 0. Coordinates are small there, however far from the world's origin the
   * engine's region is.
   */
  const CVector3& GetFrameOrigin() const { return m_frameOrigin; }

 protected:
  using TBodies = std::vector<CEmbodiedEntity*>;

  /** One tick. After an exception, there is no world. */
  virtual void UpdateWorld() = 0;
  /**
   * Deletes the world, which an error may have left incomplete; the next tick builds a new one from
   * the entities.
   */
  virtual void DropWorld() = 0;
  /** For Reset(): resets users' models. */
  void ResetRecordedBodies();
  /** At the start of UpdateWorld(): users' models command their drives. */
  void StartRecordedBodies();
  /** At the end of UpdateWorld(): users' models follow their bodies. */
  void FinishRecordedBodies();

  /** @return false while there is no world: bodies enter it when it is built. */
  virtual bool HasWorld() const = 0;
  /** @return true if AddEntity() accepts a body that has a description. */
  virtual bool Accepts(const CEmbodiedEntity& body) const = 0;
  /** @throws CARGoSException if the description or the pose is invalid for this engine. */
  virtual void CheckBody(CEmbodiedEntity& body) const = 0;
  /** @param recorded  the user's model that describes and commands the body; null if none does. */
  virtual std::unique_ptr<CDescribedBodyModel> CreateModel(CEmbodiedEntity& body,
                                                           const CRecordedBody* recorded) = 0;
  /** A model was added to this engine: adds its body to the world, if there is one. */
  virtual void Enter(CDescribedBodyModel& model) = 0;
  /** A model is about to leave this engine: removes its body from the world, if there is one. */
  virtual void Leave(CDescribedBodyModel& model) = 0;
  /** Puts a body of the world, at rest, at the pose of its origin anchor. */
  virtual void Reposition(CDescribedBodyModel& model) = 0;

  /**
   * @return true if a body that is displaced by MoveTo() is repositioned only when the move is
   * confirmed, or in the next tick. A move that tests a place and is undone then has no effect on
   * contacts and grips.
   */
  virtual bool DefersMoves() const { return false; }
  /** @return true if the origin anchor is at the pose that the engine has written last. */
  virtual bool IsAtLastPose(const CDescribedBodyModel& /*model*/) const { return false; }
  /** For engines that defer moves, at the start of a tick: repositions displaced bodies. */
  void RepositionDisplaced();
  void ForgetDisplaced();

  /** @return false if a body that has left the region cannot be transferred in this tick. */
  virtual bool PrepareTransfer(CDescribedBodyModel& /*model*/) { return true; }
  /** @return false if the present pose of a body prevents its transfer to an engine of another
   * type. */
  virtual bool MayMoveTo(const CPhysicsEngine& /*next*/,
                         const CDescribedBodyModel& /*model*/) const {
    return true;
  }
  /** Adapts the pose of a body to an engine of another type, to which it MayMoveTo(). */
  virtual void PrepareFor(const CPhysicsEngine& /*next*/, CDescribedBodyModel& /*model*/) {}
  /**
   * Takes over a model from another engine of this type. Engines with momentum extend this by
   * transferring the state of motion.
   */
  virtual void Adopt(CDescribedBodyModel& model);
  /** Sets @p cluster to all bodies that are connected to a body by grips, itself included. */
  virtual void FindCluster(CEmbodiedEntity& body, TBodies& cluster) const {
    cluster.assign(1, &body);
  }
  /** @return true if a body has the lowest entity index of its cluster, which it then transfers. */
  bool LeadsCluster(CEmbodiedEntity& body);
  /** Sets @p grips to those whose holder is in @p cluster. */
  virtual void CopyGrips(const TBodies& /*cluster*/, std::vector<SGripTransfer>& grips) const {
    grips.clear();
  }
  /** Restores a grip of bodies that were adopted. */
  virtual void RestoreGrip(const SGripTransfer& /*grip*/) {}

  /** In no particular order. */
  const std::vector<std::unique_ptr<CDescribedBodyModel>>& GetModels() const { return m_models; }
  /**
   * Lists the models in the order in which they enter a new world: that of their entities,
   * independent of earlier transfers. Reserves memory for arrivals.
   */
  std::vector<CDescribedBodyModel*> ListModelsForWorld();
  /**
   * Chooses the frame, for a world without bodies: near the centre of the part of the arena that is
   * in the region or, where that is large, of the movable bodies, if @p useBodies is set. It is so
   * rounded that nearby places are moved from one frame to the other without a rounding error.
   * ListModelsForWorld() does it.
   */
  void ChooseFrame(bool useBodies);
  /** The same pose in the frame of the engine. */
  SPlanarPose ToFrame(SPlanarPose pose) const {
    pose.X -= m_frameOrigin.GetX();
    pose.Y -= m_frameOrigin.GetY();
    return pose;
  }
  /** A pose in the frame of the engine, in that of the world. */
  SPlanarPose ToWorld(SPlanarPose pose) const {
    pose.X += m_frameOrigin.GetX();
    pose.Y += m_frameOrigin.GetY();
    return pose;
  }
  /** @return @p bodies plus spare capacity for bodies that arrive from neighbouring engines. */
  size_t AddSpareCapacity(size_t bodies) const;
  void DestroyModels();

  /** This engine's model of a body; null if there is none, or if it is of another class. */
  CDescribedBodyModel* FindModel(const CEmbodiedEntity& body) const;

 private:
  friend class CDescribedBodyModel;
  friend class CBorderBundles;

  /*
   * For CBorderBundles.
   */
  /** A body of this engine is in a bundle in this tick: it stays here. */
  void NoteBundled(CDescribedBodyModel& model);
  /** There are no bundles. */
  void ForgetBundles();
  /**
   * Takes over bodies of another engine, with the grips between them if it is of this type, else
   * with their velocities.
   */
  void AdoptCluster(CDescribedBodyEngine& from, const TBodies& cluster);
  void AdoptFromOtherType(CDescribedBodyEngine& from, CEmbodiedEntity& body);

  void NoticeMove(CDescribedBodyModel& model);
  void NoticeConfirmedMove(CDescribedBodyModel& model);
  void ForgetDisplaced(CDescribedBodyModel& model);
  void AddModel(std::unique_ptr<CDescribedBodyModel> model);
  std::unique_ptr<CDescribedBodyModel> TakeOut(CDescribedBodyModel& model);
  CDescribedBodyEngine* FindNextOfSameType(const CEmbodiedEntity& body) const;
  std::unique_ptr<CRecordedBody> Record(CEntity& root);

  std::vector<std::unique_ptr<CDescribedBodyModel>> m_models;  // indexed by the number of the model
  std::vector<CDescribedBodyModel*> m_displaced;
  std::vector<std::unique_ptr<CBodyRecorder>> m_recorders;  // one of each registered class
  std::vector<CDescribedBodyModel*> m_recorded;  // models with a recorded body
  std::vector<CDescribedBodyModel*> m_bundled;  // models in bundles of this tick
  CVector3 m_frameOrigin;  // m, world frame
  // scratch of transfers
  TBodies m_cluster;
  std::vector<SGripTransfer> m_grips;
};

}  // namespace argos

#endif
