#ifndef ARGOS3_PLUGINS_ENTITIES_MOUNTED_ENTITIES_H
#define ARGOS3_PLUGINS_ENTITIES_MOUNTED_ENTITIES_H

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace argos {

/** A mounted entity and its place; specialized where ARGoS 3 publishes other names. */
template <class ENTITY>
struct SMountedInstance {
  ENTITY& Entity;
  CVector3 PositionOffset; /**< offset in the anchor's frame, m */
  CQuaternion OrientationOffset; /**< offset in the anchor's frame */
  SAnchor& Anchor;

  typedef std::vector<SMountedInstance> TVector;

  ENTITY& GetEntity() const { return Entity; }
  const CVector3& GetPositionOffset() const { return PositionOffset; }
};

/**
 * Base of directional LEDs, tags and radios on a body: entities with a pose of their own that
 * belong to a medium.
 *
 * Starts disabled: the entities are then invisible to sensors.
 * @tparam ENTITY  a CMediumMember.
 */
template <class ENTITY>
class CMountedEntities : public CComposableEntity {
 public:
  using SInstance = SMountedInstance<ENTITY>;

  explicit CMountedEntities(CComposableEntity* parent, const std::string& id = std::string())
      : CComposableEntity(parent, id) {
    CComposableEntity::SetEnabled(false);
  }

  /** Restores the initial states; moves the entities to the current poses of their anchors. */
  void Reset() override {
    CComposableEntity::Reset();
    UpdateComponents();
  }
  /** Moves the entities to the current poses of their anchors. */
  void UpdateComponents() override {
    for (const SInstance& instance : m_instances) {
      Place(instance);
    }
  }
  /**
   * Also enables or disables the use of the anchors; enabled entities move to their anchors' poses.
   */
  void SetEnabled(bool enabled) override {
    if (enabled == IsEnabled() || EnablesLater(*this, enabled)) {
      return;
    }
    CComposableEntity::SetEnabled(enabled);
    CountFollower(*this, enabled);
    for (const SInstance& instance : m_instances) {
      UseAnchor(instance.Anchor, enabled);
    }
    if (enabled) {
      UpdateComponents();
    }
  }
  virtual void Enable() { CComposableEntity::Enable(); }
  virtual void Disable() { CComposableEntity::Disable(); }

  /**
   * All instances, in the order of addition. Changes of the offsets take effect in the next tick.
   */
  typename SInstance::TVector& GetInstances() { return m_instances; }
  const typename SInstance::TVector& GetInstances() const { return m_instances; }

  /** Adds all entities, including later ones, to a medium. */
  void SetMedium(typename ENTITY::CRegistry& medium) {
    KeepForReset(m_medium);
    m_medium = &medium;
    for (const SInstance& instance : m_instances) {
      instance.GetEntity().SetMedium(medium);
    }
  }

 protected:
  /** Takes ownership of an entity and places it. */
  ENTITY& Mount(std::unique_ptr<ENTITY> entity, const CVector3& positionOffset,
                const CQuaternion& orientationOffset, SAnchor& anchor) {
    ENTITY& mounted = *entity;
    AddComponent(*entity.release());
    m_instances.push_back({mounted, positionOffset, orientationOffset, anchor});
    MountOnAnchor(anchor, *this);
    Place(m_instances.back());
    if (m_medium != nullptr) {
      mounted.SetMedium(*m_medium);
    }
    mounted.SetEnabled(IsEnabled());
    mounted.SetEnabledAtStart(IsEnabledAtStart());
    if (GetIndex() >= 0) {
      CallEntityOperation<CSpaceOperationAddEntity, CSpace, void>(CurrentSpace(), mounted);
    }
    return mounted;
  }

  /**
   * Mounts an entity for each child @p tag: the pose in the frame of the body's `anchor`, and the
   * attributes of ENTITY::Init(). The parent must have a "body".
   * @param defaultAnchor  anchor of a child without the attribute; empty: the attribute is
   *   required.
   */
  void InitInstances(TConfigurationNode& tree, const std::string& tag,
                     const std::string& defaultAnchor = "") {
    InitInstances(tree, tag, defaultAnchor, [](ENTITY&, TConfigurationNode&) {});
  }
  /**
   * Init() of entities with one medium: reads `medium` and the children @p tag, and enables them.
   *
   * Defined in mounted_entities_impl.h, for sources.
   * @param kind  of the medium, for messages: "an LED medium".
   */
  void InitInMedium(TConfigurationNode& tree, const std::string& kind, const std::string& tag,
                    const std::string& defaultAnchor = "");
  /** @param prepare  void(ENTITY&, TConfigurationNode& child), called before each mount. */
  template <typename PREPARE>
  void InitInstances(TConfigurationNode& tree, const std::string& tag,
                     const std::string& defaultAnchor, PREPARE&& prepare) {
    CComposableEntity& parent = GetParent();
    auto& body = parent.GetComponent<CEmbodiedEntity>("body");
    TConfigurationNodeIterator child(tag);
    for (child = child.begin(&tree); child != child.end(); ++child) {
      std::string anchor;
      if (defaultAnchor.empty()) {
        GetNodeAttribute(*child, "anchor", anchor);
      } else {
        GetNodeAttributeOrDefault(*child, "anchor", anchor, defaultAnchor);
      }
      auto entity = std::make_unique<ENTITY>(this);
      entity->Init(*child);
      prepare(*entity, *child);
      // the pose in the file is relative to the anchor
      const CVector3 position = entity->GetPosition();
      const CQuaternion orientation = entity->GetOrientation();
      Mount(std::move(entity), position, orientation, body.GetAnchor(anchor));
    }
  }

  /**
   * Calls set(ENTITY&, value) for each entity with its value.
   * @param owner, what  for the message: "tags", "payloads".
   * @throws CARGoSException if the numbers of values and of entities differ.
   */
  template <typename VALUE, typename SET>
  void SetEach(const std::vector<VALUE>& values, const char* owner, const char* what, SET&& set) {
    if (values.size() != m_instances.size()) {
      THROW_ARGOSEXCEPTION(owner << " \"" << GetContext() << GetId() << "\": got " << values.size()
                                 << " " << what << " for " << m_instances.size() << " " << owner);
    }
    for (size_t i = 0; i < values.size(); ++i) {
      set(m_instances[i].GetEntity(), values[i]);
    }
  }
  /** @param what "LED", for the message. @throws CARGoSException if the index is out of range. */
  ENTITY& GetEntity(size_t index, const char* what) const {
    if (index >= m_instances.size()) {
      THROW_ARGOSEXCEPTION("\"" << GetContext() << GetId() << "\": no " << what << " " << index
                                << "; there are " << m_instances.size() << ", numbered from 0");
    }
    return m_instances[index].GetEntity();
  }

 private:
  static void Place(const SInstance& instance) {
    CVector3 position = instance.GetPositionOffset();
    position.Rotate(instance.Anchor.Orientation);
    instance.GetEntity().MoveTo(position + instance.Anchor.Position,
                                instance.Anchor.Orientation * instance.OrientationOffset);
  }

  typename SInstance::TVector m_instances;
  typename ENTITY::CRegistry* m_medium = nullptr;
};

}  // namespace argos

#endif
