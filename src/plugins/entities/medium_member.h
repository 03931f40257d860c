#ifndef ARGOS3_PLUGINS_ENTITIES_MEDIUM_MEMBER_H
#define ARGOS3_PLUGINS_ENTITIES_MEDIUM_MEMBER_H

#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/utility/configuration/argos_exception.h>

#include <string>

namespace argos {

/**
 * An entity with a pose that a medium knows exactly while it is enabled: what LEDs and tags have in
 * common.
 *
 * Starts disabled. A derived class calls ClearMedium() in its destructor.
 * @tparam ENTITY  the derived class. @tparam MEDIUM  may be incomplete.
 */
template <class ENTITY, class MEDIUM>
class CMediumMember : public CPositionalEntity {
 public:
  /**
   * What knows the entities: the side of the medium that they need.
   *
   * Declared here, because the media library is built on this one.
   */
  class CRegistry {
   public:
    virtual void AddEntity(ENTITY& entity) = 0;
    virtual void RemoveEntity(ENTITY& entity) = 0;
    /** Itself. */
    virtual MEDIUM& AsMedium() = 0;

   protected:
    ~CRegistry() = default;
  };

  explicit CMediumMember(CComposableEntity* parent) : CPositionalEntity(parent) {
    CPositionalEntity::SetEnabled(false);
  }
  /** @param position, orientation m, world frame. */
  CMediumMember(CComposableEntity* parent, const std::string& id, const CVector3& position,
                const CQuaternion& orientation = CQuaternion())
      : CPositionalEntity(parent, id, position, orientation) {
    CPositionalEntity::SetEnabled(false);
  }

  /** Leaves the medium. */
  void Destroy() override {
    CPositionalEntity::Destroy();
    ClearMedium();
  }

  void SetEnabled(bool enabled) override {
    const bool changed = enabled != IsEnabled();
    CPositionalEntity::SetEnabled(enabled);
    if (!changed || m_medium == nullptr) {
      return;
    }
    if (enabled) {
      m_medium->AddEntity(AsEntity());
    } else {
      m_medium->RemoveEntity(AsEntity());
    }
  }

  bool HasMedium() const { return m_medium != nullptr; }
  /** @throws CARGoSException if there is none. */
  MEDIUM& GetMedium() const {
    if (m_medium == nullptr) {
      THROW_ARGOSEXCEPTION(GetTypeDescription()
                           << " \"" << GetContext() << GetId() << "\" has no medium");
    }
    return m_medium->AsMedium();
  }
  /** Puts the entity in the care of @p medium, a MEDIUM, and no other. */
  void SetMedium(CRegistry& medium) {
    if (m_medium == &medium) {
      return;
    }
    ClearMedium();
    m_medium = &medium;
    if (IsEnabled()) {
      m_medium->AddEntity(AsEntity());
    }
  }
  /** Takes the entity out of its medium, if it has one. */
  void ClearMedium() {
    if (m_medium != nullptr && IsEnabled()) {
      m_medium->RemoveEntity(AsEntity());
    }
    m_medium = nullptr;
  }

 private:
  ENTITY& AsEntity() { return static_cast<ENTITY&>(*this); }

  CRegistry* m_medium = nullptr;  // it forgets this entity, or this entity it, before either ends
};

}  // namespace argos

#endif
