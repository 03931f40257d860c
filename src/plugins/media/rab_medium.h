#ifndef ARGOS3_PLUGINS_MEDIA_RAB_MEDIUM_H
#define ARGOS3_PLUGINS_MEDIA_RAB_MEDIUM_H

#include <argos3/core/simulator/medium/medium.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>

#include <memory>
#include <mutex>
#include <unordered_map>

namespace argos {

class CLineOfSight;

/**
 * Routes the messages of range-and-bearing devices, once a tick after physics.
 *
 * Device B receives from device A if both are enabled, their messages have equal size, |AB| < range
 * of A, and, unless `check_occlusions` is off, no third body meets the straight line between them
 * outside their own bodies.
 */
class CRABMedium : public CMedium, public CRABEquippedEntity::CRegistry {
 public:
  typedef CSet<CRABEquippedEntity*, SEntityComparator> TDevices;

  CRABMedium();
  ~CRABMedium() override;

  /**
   * Reads `id`, `index` ("grid", "hash" or "dummy"), `grid_size` and `check_occlusions`.
   * @throws CARGoSException if a value is unknown or out of range.
   */
  void Init(TConfigurationNode& tree) override;
  /** Warns if there are devices that never hear each other, because their messages differ in size.
   */
  void PostSpaceInit() override;
  /** Clears all routes until the next Update(). */
  void Reset() override;
  /** Removes all devices. */
  void Destroy() override;
  void Update() override;
  bool UsesThreadPool() const override { return true; }
  bool CanBePeriodic() const override { return true; }

  CRABMedium& AsMedium() override { return *this; }

  /**
   * The devices from which @p entity receives, as of the last Update(), in the order of their
   * insertion into the space. Created on demand, and valid until the next Update(); safe on several
   * threads at once.
   * @throws CARGoSException if @p entity is not in this medium.
   */
  const TDevices& GetRABsCommunicatingWith(CRABEquippedEntity& entity) const;

  /** Numbers of devices, ascending. */
  struct SNumbers {
    const UInt32* First;
    const UInt32* Last; /**< one after the last */
    const UInt32* begin() const { return First; }
    const UInt32* end() const { return Last; }
  };
  /** For sensors: the numbers of the devices from which @p entity receives; see GetDevice(). */
  SNumbers GetSenders(const CRABEquippedEntity& entity) const;
  /** Number of devices at the last Update(). */
  UInt32 GetNumDevices() const;
  /** Pairs of sender and receiver at the last Update(); 0 after Reset(). */
  UInt64 GetNumDelivered() const;
  /** Null if the device has left the medium since the last Update(). */
  const CRABEquippedEntity* GetDevice(UInt32 number) const;
  /** All devices by number, (GetNumDevices()), for loops; valid until the next Update(). */
  const CRABEquippedEntity* const* GetDevices() const;

 private:
  struct SState;  // devices and routes

  // called by devices when they are enabled and disabled
  void Insert(CRABEquippedEntity& entity) override;
  void Erase(CRABEquippedEntity& entity) override;
  void TakePositions(const CLineOfSight& sight);

  bool m_checkOcclusions = true;
  std::unique_ptr<SState> m_state;
  // returned to users; by receiver, never iterated
  mutable std::mutex m_setsMutex;
  mutable std::unordered_map<const CRABEquippedEntity*, TDevices> m_sets;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#endif

#endif
