#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_EMBODIED_ENTITY_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_EMBODIED_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/entity/physics_model.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <map>
#include <memory>
#include <vector>

namespace argos {

class CBodyIndex;
struct SPeriodicity;
struct SBodyDescription;

/**
 * A solid body with a pose. A movable body is in one physics engine, an immovable one in one or
 * more.
 *
 * The origin anchor is the centre of the body's base; only the engine writes its pose.
 */
class CEmbodiedEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  explicit CEmbodiedEntity(CComposableEntity* parent);
  CEmbodiedEntity(CComposableEntity* parent, const std::string& id,
                  const CVector3& position = CVector3(),
                  const CQuaternion& orientation = CQuaternion(), bool movable = true);
  ~CEmbodiedEntity() override;
  CEmbodiedEntity(const CEmbodiedEntity&) = delete;

  /** Reads `position` (m) and `orientation` (z,y,x in degrees), both optional. */
  void Init(TConfigurationNode& tree) override;
  /** Moves the body to its initial pose, at rest, whatever is there; anchors are recomputed. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "body"; }
  /** Also notes how often each anchor is in use. */
  void MarkStart() override;
  void ReturnToStart() override;

  bool IsMovable() const { return m_bMovable; }
  void SetMovable(bool movable);

  const SAnchor& GetOriginAnchor() const { return *m_psOriginAnchor; }
  SAnchor& GetOriginAnchor() { return *m_psOriginAnchor; }
  const CVector3& GetInitPosition() const { return m_cInitOriginPosition; }
  const CQuaternion& GetInitOrientation() const { return m_cInitOriginOrientation; }
  /** Changes the pose that Reset() restores, m, world frame. @throws CARGoSException if not finite.
   */
  void SetInitPose(const CVector3& position, const CQuaternion& orientation);

  /**
   * Adds a frame fixed to the body.
   * @param offset, relativeOrientation  in the frame of the origin anchor, m.
   * @throws CARGoSException if the id is taken.
   */
  SAnchor& AddAnchor(const std::string& id, const CVector3& offset = CVector3(),
                     const CQuaternion& relativeOrientation = CQuaternion());
  void EnableAnchor(const std::string& id);
  void DisableAnchor(const std::string& id);
  bool IsAnchorEnabled(const std::string& id);
  /** @throws CARGoSException that lists the anchors there are, if the id is unknown. */
  const SAnchor& GetAnchor(const std::string& id) const;
  SAnchor& GetAnchor(const std::string& id);
  std::map<std::string, SAnchor*>& GetAnchors() { return m_mapAnchors; }
  std::vector<SAnchor*>& GetEnabledAnchors() { return m_vecEnabledAnchors; }

  /** Axis-aligned box around the body, as of its last move, m. @throws if in no engine. */
  const SBoundingBox& GetBoundingBox() const;
  void CalculateBoundingBox();

  UInt32 GetPhysicsModelsNum() const;
  virtual void AddPhysicsModel(const std::string& engineId, CPhysicsModel& model);
  void RemovePhysicsModel(const std::string& engineId);
  /**
   * The same as RemovePhysicsModel(@p from) and AddPhysicsModel(@p to, @p model), but does not
   * allocate: for bodies that change engines in a tick.
   */
  void MovePhysicsModel(const std::string& from, const std::string& to, CPhysicsModel& model);
  const CPhysicsModel& GetPhysicsModel(size_t index) const;
  CPhysicsModel& GetPhysicsModel(size_t index);
  const CPhysicsModel& GetPhysicsModel(const std::string& engineId) const;
  CPhysicsModel& GetPhysicsModel(const std::string& engineId);

  /**
   * Moves the body to another pose.
   * @param position, orientation  new pose of the origin anchor, m, world frame.
   * @param checkOnly  only test whether the place is free; the pose is always restored.
   * @param ignoreCollisions  move even if the body overlaps another one there.
   * @return true if the body overlaps no other one there, or @p ignoreCollisions is set; otherwise
   *         the old pose is restored. With @p checkOnly, only if it does not touch another one
   *         either, see IsCollidingWithSomething().
   *
   * An engine that moves bodies in a plane only puts them there, upright: the height of @p position
   * and the tilt of @p orientation have no effect.
   */
  virtual bool MoveTo(const CVector3& position, const CQuaternion& orientation,
                      bool checkOnly = false, bool ignoreCollisions = false);
  /**
   * True if the body now overlaps or touches another one: if they are closer than 1 mm, because
   * engines leave gaps between bodies that press against each other. It is found from the solids
   * that describe the bodies, in the same way for all engines and for the metric "collisions".
   */
  virtual bool IsCollidingWithSomething() const;

  /** The description from which engines build this body; null if only one engine can build it. */
  const SBodyDescription* GetBodyDescription() const { return m_description.get(); }
  const std::shared_ptr<const SBodyDescription>& GetSharedBodyDescription() const {
    return m_description;
  }
  /**
   * Sets the description. Before the body is added to an engine, or followed by re-adding it.
   *
   * Shared ownership: all robots of a type with equal parameters hold one description.
   */
  void SetBodyDescription(std::shared_ptr<const SBodyDescription> description);

  /**
   * Engines only: writes the pose of the origin anchor. The space's index reads it from there at
   * its next rebuild; anchors that are enabled follow in CPhysicsModel::CalculateAnchors().
   */
  void SetOriginPose(const CVector3& position, const CQuaternion& orientation);

  /**
   * Where the body would be without periodic sides of the arena, from where it started, m: its
   * position, and a period for each time that it has left through a side. What MoveTo() skips is
   * not counted.
   */
  CVector3 GetUnwrappedPosition() const;
  /**
   * Engines only, in a periodic arena, before SetOriginPose(@p next): counts the sides through
   * which the body leaves on its way there, which is shorter than half of a period.
   */
  void CountTurns(const CVector3& next, const SPeriodicity& period);
  /** Puts a body that is outside of a periodic arena at the same place inside, before it is added.
   */
  void WrapIntoArena();

  /**
   * Poses of the links of an articulated body in the frame of the origin anchor, by number of the
   * link; null for rigid bodies. Pose i is that of the body frame if the whole body moved with
   * link i: position 0 and no rotation at the start, and always for link 0.
   */
  const SBodyPose* GetLinkPoses() const {
    return m_links != nullptr ? m_links->Poses.data() : nullptr;
  }
  /** Engines only: writes the pose of a link; its anchors follow in CalculateAnchors(). */
  void SetLinkPose(UInt32 link, const SBodyPose& pose);
  /** Mounts an anchor, besides the origin, on a link of an articulated body. */
  void MountOnLink(SAnchor& anchor, UInt32 link);

  /**
   * True if the root entity's Update() must be called after each move of the body: because the
   * root entity itself needs it (the default), or because a component that follows is enabled.
   */
  bool HasFollowers() const { return m_rootFollows || m_numFollowers > 0; }
  void SetRootFollows(bool follows) { m_rootFollows = follows; }
  /** A component that Update() moves along with the body has been enabled or disabled. */
  void CountFollower(bool enabled) { m_numFollowers += enabled ? 1 : -1; }

  /** Number of this body in the space's index, or CBodyIndex::kNoBody. */
  UInt32 GetBodyNumber() const { return m_bodyNumber; }
  /** Where it is stored, to prefetch it. */
  const UInt32* GetBodyNumberAddress() const { return &m_bodyNumber; }
  /** Adds the body, which has a description and is in no index, to the space's index. */
  void EnterIndex(CBodyIndex& index);
  /** Removes it from there; does nothing if it is in none. */
  void LeaveIndex();

  void UpdateDigest(CDigest& digest) const override;

 protected:
  CPhysicsModel::TMap m_tPhysicsModelMap;
  CPhysicsModel::TVector m_tPhysicsModelVector;
  SBoundingBox* m_sBoundingBox = nullptr;
  std::map<std::string, SAnchor*> m_mapAnchors;
  CVector3 m_cInitOriginPosition;
  CQuaternion m_cInitOriginOrientation;

 private:
  [[noreturn]] void ThrowNotFinite(const CVector3& position, const CQuaternion& orientation) const;
  friend struct SAnchor;
  SBodyPose FindPossiblePose(const SBodyPose& pose) const;
  void MoveModelsTo(const CVector3& position, const CQuaternion& orientation);
  void ConfirmMove();
  bool IsOverlappingSomething() const;
  void NotifyIndex();
  void ResetWithoutEngines();
  void ResetLinks();

  struct SLinks {
    // an anchor that moves with a link
    struct SMounted {
      UInt32 Link;
      SAnchor* Anchor;
      SBodyPose Offset;  // pose in the body frame at the start
    };

    std::vector<SBodyPose> Poses;  // indexed by link
    std::vector<SMounted> Anchors;
  };

  std::unique_ptr<SLinks> m_links;  // null unless the body is articulated
  std::shared_ptr<const SBodyDescription> m_description;
  CBodyIndex* m_bodyIndex = nullptr;
  UInt32 m_bodyNumber = ~UInt32(0);

 protected:
  bool m_bMovable;
  bool m_rootFollows = true;
  SInt16 m_numFollowers = 0;
  SInt32 m_turnsX = 0, m_turnsY = 0;  // through the sides of a periodic arena
  SAnchor* m_psOriginAnchor = nullptr;
  std::vector<SAnchor*> m_vecEnabledAnchors;

 private:
  std::vector<std::unique_ptr<SAnchor>, CSlabAllocator<std::unique_ptr<SAnchor>>>
      m_anchors;  // indexed by anchor
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/space/positional_indices/grid.h>
#include <argos3/core/simulator/space/positional_indices/space_hash.h>
#include <argos3/core/simulator/space/space.h>
#endif

#endif
