#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_STAND_INS_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_STAND_INS_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>
#include <argos3/plugins/simulator/outputs/recording/replayed_fields.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace argos {

class CControllableEntity;
class CFloorEntity;
class CLEDEquippedEntity;
class CLightEntity;
class CSpace;
struct SAnchor;

/** State of one entity in a frame. */
struct SRecordedState {
  std::span<const SBodyPose> Poses; /**< see SRecordedType::GetNumPoses() */
  std::span<const UInt32> Words; /**< see SRecordedType::GetNumWords() */
};

/** The body of a CStandInEntity: in no engine, but with a bounding box. */
class CStandInBody : public CEmbodiedEntity {
 public:
  CStandInBody(CComposableEntity* parent, const SRecordedType& type);
  void SetPose(const SBodyPose& pose);

 private:
  SBoundingBox m_boxAtOrigin;
  SBoundingBox m_box;  // does not turn with the body
};

/**
 * A body of a recording: stands for an entity of any class in a replay, with its type, id and
 * appearance, but without controller, devices, and the code of that class. It is in no engine.
 */
class CStandInEntity : public CComposableEntity, public CFieldSource {
 public:
  ENABLE_VTABLE();

  CStandInEntity(const std::string& id, std::shared_ptr<const SRecordedType> type);

  std::string GetTypeDescription() const override { return m_type->Tag; }
  const SAppearance* GetAppearance() const override;

  /** Null if it is no robot. */
  CControllableEntity* GetRobot() const { return m_robot; }
  CStandInBody& GetBody() const { return *m_body; }
  CLEDEquippedEntity* GetLEDs() const { return m_leds; }

  void SetState(const SRecordedState& state);

  CReplayedFields& GetFields() { return m_fields; }
  SBoundField BindField(const std::string& name) const override { return m_fields.Bind(name); }
  void ListFields(std::vector<std::string>& names) const override { m_fields.List(names); }

 private:
  void AddParts();

  std::shared_ptr<const SRecordedType> m_type;  // shared by its entities
  CStandInBody* m_body = nullptr;  // components, which the base owns
  CControllableEntity* m_robot = nullptr;
  CLEDEquippedEntity* m_leds = nullptr;
  std::vector<SAnchor*> m_anchors;  // anchors of the type
  CReplayedFields m_fields;
};

/** The same for an entity with a pose and without a body, or with neither. */
class CStandInPlace : public CPositionalEntity {
 public:
  ENABLE_VTABLE();

  CStandInPlace(const std::string& id, std::shared_ptr<const SRecordedType> type);

  std::string GetTypeDescription() const override { return m_type->Tag; }
  const SAppearance* GetAppearance() const override;

  void SetState(const SRecordedState& state);

 private:
  std::shared_ptr<const SRecordedType> m_type;
};

/** An entity that a replay has added to the space, which owns it. */
class CReplayedEntity {
 public:
  /** Creates the entity and adds it to the space. @throws CARGoSException if the id is taken. */
  CReplayedEntity(CSpace& space, const SRecordedEntity& entity,
                  const std::shared_ptr<const SRecordedType>& type);

  const std::string& GetId() const { return m_entity->GetId(); }
  const std::shared_ptr<const SRecordedType>& GetType() const { return m_type; }
  CEntity& GetEntity() const { return *m_entity; }
  /** Null if it is no robot. */
  CControllableEntity* GetRobot() const;
  /** Null if it can have none. */
  CReplayedFields* GetFields() const;
  /** Null if it is no floor. */
  CFloorEntity* GetFloor() const { return m_floor; }
  void SetState(const SRecordedState& state) const;

 private:
  std::unique_ptr<CEntity> Make(const std::string& id);

  std::shared_ptr<const SRecordedType> m_type;
  CEntity* m_entity = nullptr;
  // the same entity by its class; null: another class
  CStandInEntity* m_body = nullptr;
  CStandInPlace* m_place = nullptr;
  CLightEntity* m_light = nullptr;
  CFloorEntity* m_floor = nullptr;
};

}  // namespace argos

#endif
