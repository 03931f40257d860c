#ifndef ARGOS3_PLUGINS_ENTITIES_MEDIUM_MEMBER_H
#define ARGOS3_PLUGINS_ENTITIES_MEDIUM_MEMBER_H

#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/utility/configuration/argos_exception.h>

#include <string>

namespace argos {

/**
 * Base of LEDs, tags, radios and range-and-bearing devices: an entity with a pose that a medium
 * contains exactly while the entity is enabled.
 *
 * Starts disabled. A derived class calls ClearMedium() in its destructor.
 * @tparam ENTITY  the derived class. @tparam MEDIUM  may be incomplete.
 */
template <class ENTITY, class MEDIUM>
class CMediumMember : public CPositionalEntity {
 public:
  /**
   * The interface of a medium that these entities need.
   *
   * Declared here, because the media library depends on this one.
   */
  class CRegistry {
   public:
    /** For users: the entity gets this medium, leaves its former one if any, and is enabled. */
    void AddEntity(ENTITY& entity) {
      CRobotsCode::CheckShared("AddEntity() of a medium");
      entity.SetMedium(*this);
      entity.SetEnabled(true);
    }
    /** For users: the entity leaves this medium; does nothing if it has another one or none. */
    void RemoveEntity(ENTITY& entity) {
      CRobotsCode::CheckShared("RemoveEntity() of a medium");
      if (static_cast<CMediumMember&>(entity).m_medium == this) {
        entity.ClearMedium();
      }
    }
    /** The medium itself. */
    virtual MEDIUM& AsMedium() = 0;

    /** For entities: one that is not contained is contained from now on. */
    virtual void Insert(ENTITY& entity) = 0;
    /** For entities: one that is contained is not contained any more. */
    virtual void Erase(ENTITY& entity) = 0;

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
  /** Copies are disabled and have no medium. */
  CMediumMember(const CMediumMember& other) : CPositionalEntity(other) {
    CPositionalEntity::SetEnabled(false);
  }

  CMediumMember& operator=(const CMediumMember& other) {
    if (this != &other) {
      ClearMedium();
      CPositionalEntity::operator=(other);
      CPositionalEntity::SetEnabled(false);
    }
    return *this;
  }

  /** Leaves the medium. */
  void Destroy() override {
    CPositionalEntity::Destroy();
    ClearMedium();
  }

  /** By code of its own robot: takes effect when all robots have been controlled (CRobotsCode). */
  void SetEnabled(bool enabled) override {
    if (EnablesLater(*this, enabled)) {
      return;
    }
    if (enabled != IsEnabled() && m_medium != nullptr) {
      // first: if the medium has no memory for it, the entity remains disabled
      enabled ? Join() : Leave();
    }
    CPositionalEntity::SetEnabled(enabled);
  }

  /** Joins the medium if robots' code has enabled the entity before it was in the space. */
  void MarkStart() override {
    CPositionalEntity::MarkStart();
    if (IsEnabled() && m_medium != nullptr && !m_isMember) {
      Join();
    }
  }

  /** @return true if cameras and devices find it in the cells of its medium while it is enabled. */
  bool IsInCells() const { return true; }
  bool HasMedium() const { return m_medium != nullptr; }
  /** @throws CARGoSException if the entity has no medium. */
  MEDIUM& GetMedium() const {
    if (m_medium == nullptr) {
      THROW_ARGOSEXCEPTION(GetTypeDescription()
                           << " \"" << GetContext() << GetId() << "\" has no medium");
    }
    return m_medium->AsMedium();
  }
  /** Moves the entity to @p medium, a MEDIUM. */
  void SetMedium(CRegistry& medium) {
    CRobotsCode::CheckShared(*this, "SetMedium()");
    if (m_medium == &medium) {
      return;
    }
    KeepForReset(&m_medium, [this, start = m_medium] {
      start != nullptr ? SetMedium(*start) : ClearMedium();
    });
    ClearMedium();
    m_medium = &medium;
    if (IsEnabled()) {
      Join();
    }
  }
  /** Removes the entity from its medium, if any. */
  void ClearMedium() {
    Leave();
    m_medium = nullptr;
  }

 private:
  void Join() {
    if (CRobotsCode::IsRunning()) {
      // media must not change now: MarkStart() does this
      return;
    }
    m_medium->Insert(AsEntity());
    m_isMember = true;
  }
  void Leave() {
    if (m_isMember) {
      m_medium->Erase(AsEntity());
      m_isMember = false;
    }
  }
  ENTITY& AsEntity() { return static_cast<ENTITY&>(*this); }

  bool m_isMember = false;  // contained in the medium
  CRegistry* m_medium = nullptr;  // both sides are unlinked when either is destroyed
};

}  // namespace argos

#endif
