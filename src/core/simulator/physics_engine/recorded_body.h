#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_RECORDED_BODY_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_RECORDED_BODY_H

#include <argos3/core/simulator/physics_engine/drive_source.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <memory>

namespace argos {

class CDescribedBodyEngine;
class CEntity;
struct SBodyDescription;

/**
 * The body of an entity as a user's model describes and commands it, instead of the entity.
 *
 * The engine that has the body owns it, and calls it while no other thread does.
 */
class CRecordedBody {
 public:
  virtual ~CRecordedBody() = default;

  /** With IsRecorded. */
  virtual std::shared_ptr<const SBodyDescription> GetDescription() const = 0;
  /** What commands the drive of the description; nothing if it has none. */
  virtual CDriveSource GetDrive() const = 0;

  /** Before each tick (s): the model reads its robot's components, and commands the drive. */
  virtual void StartTick(Real tick) = 0;
  /** After each tick (s), when the entity has its new pose. */
  virtual void FinishTick(Real tick) = 0;
  /** After the entity was put at another pose, m, world frame. */
  virtual void MoveTo(const CVector3& position, const CQuaternion& orientation) = 0;
  /** After the entity was reset. */
  virtual void Reset() = 0;
};

/**
 * Base of what describes bodies of entities that have no description. Libraries register classes
 * with REGISTER_BODY_RECORDER; every engine that builds bodies from descriptions has one object of
 * each.
 */
class CBodyRecorder {
 public:
  virtual ~CBodyRecorder() = default;

  /**
   * @param engine  the one to which @p root is being added.
   * @return null if it does not know such entities.
   * @throws CARGoSException if the user's model cannot be described; names the model.
   */
  virtual std::unique_ptr<CRecordedBody> Record(CDescribedBodyEngine& engine, CEntity& root) = 0;
};

}  // namespace argos

#define REGISTER_BODY_RECORDER(CLASSNAME, LABEL, BRIEF_DESCRIPTION)                      \
  REGISTER_SYMBOL(CBodyRecorder, CLASSNAME, LABEL, "the authors of this project", "1.0", \
                  BRIEF_DESCRIPTION, "", "Usable")

#endif
