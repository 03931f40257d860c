#ifndef ARGOS3_PLUGINS_MEDIA_RFID_MEDIUM_H
#define ARGOS3_PLUGINS_MEDIA_RFID_MEDIUM_H

#include <argos3/core/simulator/medium/medium.h>
#include <argos3/plugins/simulator/entities/rfid_tag_entity.h>
#include <argos3/plugins/simulator/media/medium_users.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * Knows where RFID tags are, for the robots that read and write them.
 *
 * Tags are read where they are after physics, and written where they are when robots act: right
 * after the actuators, before anything has moved, in the order of the robots' insertion into the
 * space. So if two robots write to the same bytes in one tick, those of the robot that was created
 * last stay.
 */
class CRFIDMedium : public CMedium, public CRFIDTagEntity::CRegistry {
 public:
  /** A device that uses the medium; one that writes leaves its order here. */
  class CUser : public CMediumUser {
   public:
    /** @param reach how far from its place it looks for tags, m. */
    CUser(CRFIDMedium& medium, const CControllableEntity& robot, Real reach);

    Real GetReach() const { return m_reach; }

    CVector3 Place; /**< of the order: from where, m, world frame */
    size_t Offset = 0; /**< first byte to write */
    CByteArray Bytes; /**< to write */
    /** Of the order of this tick: id of the tag; empty: none in reach, or they did not fit. */
    std::string WrittenTag;

   private:
    Real m_reach;  // m
  };

  CRFIDMedium();
  ~CRFIDMedium() override;

  /** Reads `id`, `index` ("grid" or "hash") and `grid_size`. @throws CARGoSException. */
  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  /** Lets go of all tags and devices. */
  void Destroy() override;
  void TakeActs() override;
  void Update() override;

  /** Called by the tag when it is enabled and disabled. */
  void AddEntity(CRFIDTagEntity& tag) override;
  void RemoveEntity(CRFIDTagEntity& tag) override;
  CRFIDMedium& AsMedium() override { return *this; }

  /** A tag found. */
  struct SFound {
    CRFIDTagEntity* Tag;
    Real SquareDistance; /**< m^2 */
  };
  /**
   * Finds the tags within @p reach (m) of a point, where they were at the last Update(); those of
   * @p ownRoot aside. Safe on several threads at once.
   * @param found  cleared first; then in order of the tags' insertion into the space.
   */
  void FindTags(std::vector<SFound>& found, const CVector3& place, Real reach,
                const CEntity& ownRoot) const;

 private:
  struct SState;  // tags, their cells, devices

  void Refresh();
  void Write(CUser& user);

  std::unique_ptr<SState> m_state;
};

}  // namespace argos

#endif
