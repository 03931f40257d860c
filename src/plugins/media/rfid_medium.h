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
 * Medium of the RFID tags, for robots that read and write them.
 *
 * Tags are read at their positions after physics, and written at their positions when robots act:
 * directly after the actuators, before any motion, in the order of the robots' insertion into the
 * space. If two robots write to the same bytes in one tick, the one that was created last
 * overwrites the other.
 */
class CRFIDMedium : public CMedium, public CRFIDTagEntity::CRegistry {
 public:
  /** A device that uses the medium; a writing device stores its order here. */
  class CUser : public CMediumUser {
   public:
    /** @param reach largest distance from its place to a tag, m. */
    CUser(CRFIDMedium& medium, const CControllableEntity& robot, Real reach);

    Real GetReach() const { return m_reach; }

    CVector3 Place; /**< place of the device when it writes, m, world frame */
    size_t Offset = 0; /**< first byte to write */
    CByteArray Bytes; /**< are to be written */
    /**
     * Result of this tick's order: id of the tag; empty if none was in reach or the bytes did not
     * fit.
     */
    std::string WrittenTag;

   private:
    Real m_reach;  // m
  };

  CRFIDMedium();
  ~CRFIDMedium() override;

  /** Reads `id`, `index` ("grid" or "hash") and `grid_size`. @throws CARGoSException. */
  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  /** Removes all tags and devices. */
  void Destroy() override;
  void TakeActs() override;
  bool CanBePeriodic() const override { return true; }
  void Update() override;

  CRFIDMedium& AsMedium() override { return *this; }

  /** A tag found. */
  struct SFound {
    CRFIDTagEntity* Tag;
    Real SquareDistance; /**< m^2 */
  };
  /**
   * Finds the tags within @p reach (m) of a point, at their positions of the last Update(), except
   * those of @p ownRoot. Safe on several threads at once.
   * @param found  cleared, then filled in the order of the tags' insertion into the space.
   */
  void FindTags(std::vector<SFound>& found, const CVector3& place, Real reach,
                const CEntity& ownRoot) const;

 private:
  struct SState;  // tags, their cells, devices

  // called by tags when they are enabled and disabled
  void Insert(CRFIDTagEntity& tag) override;
  void Erase(CRFIDTagEntity& tag) override;
  void Refresh();
  void Write(CUser& user);

  std::unique_ptr<SState> m_state;
};

}  // namespace argos

#endif
