#ifndef ARGOS3_PLUGINS_MEDIA_RAB_ROUTING_H
#define ARGOS3_PLUGINS_MEDIA_RAB_ROUTING_H

#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/plugins/simulator/media/line_of_sight.h>
#include <argos3/plugins/simulator/media/point_cells.h>
#include <argos3/plugins/simulator/media/sight_fan.h>

#include <vector>

namespace argos {

class CThreadPool;

/**
 * Computes which devices receive from which, on packed arrays; for the sources of media.
 *
 * Device B receives from device A if A's messages are as long as B's, |AB| < range of A, and no
 * body is between them. Every pair of devices with one in the range of the other is examined once.
 * The result does not depend on the cells nor on the number of threads. A call allocates only if
 * there are more devices, or more pairs, than in all previous calls.
 */
class CRABRouting {
 public:
  /** The devices, in the order of their numbers. One array for each property, (devices). */
  struct SDevices {
    std::vector<Real> X, Y, Z; /**< m, world frame; a device at a non-finite position neither sends
                                  nor receives */
    std::vector<Real> Range; /**< m, >= 0 */
    std::vector<UInt32> MessageSize; /**< bytes */
    std::vector<Real> Reach; /**< see CSightFan::SEnd; only for occlusion */
    std::vector<CLineOfSight::SEnd> Bodies;

    size_t GetSize() const { return X.size(); }
    void Resize(size_t size);
  };

  /** Numbers of devices, ascending. */
  struct SNumbers {
    const UInt32* First;
    const UInt32* Last; /**< one after the last */

    const UInt32* begin() const { return First; }
    const UInt32* end() const { return Last; }
    size_t size() const { return static_cast<size_t>(Last - First); }
  };

  void SetOptions(const SIndexChoice& options, const CRange<CVector3>& arena) {
    m_cells.SetOptions(options, arena);
  }
  /** Joins sides of the arena: devices hear the nearest image of each other. */
  void SetPeriod(const SPeriodicity& period) { m_period = period; }
  /** To be filled before Route(). */
  SDevices& GetDevices() { return m_devices; }
  /** @param sight  null: no occlusion. */
  void Route(CThreadPool& pool, const CLineOfSight* sight);
  /** Removes all devices. */
  void Clear();

  /** Pairs of sender and receiver at the last Route(). */
  size_t GetNumHearings() const { return m_senderStart.empty() ? 0 : m_senderStart.back(); }

  /** The senders that a device receives from; empty if it was added after the last Route(). */
  SNumbers GetSenders(UInt32 device) const {
    if (device + size_t(1) >= m_senderStart.size()) {
      return {nullptr, nullptr};
    }
    ARGOS_ASSERT(m_senderStart[device] <= m_senderStart[device + 1] &&
                     m_senderStart[device + 1] <= m_senders.size(),
                 "the senders of device " << device << " are not in the list of senders");
    return {m_senders.data() + m_senderStart[device], m_senders.data() + m_senderStart[device + 1]};
  }

 private:
  // data of a device, in cell order
  struct SPlaced {
    CSightFan::SEnd End;
    Real Range;
    UInt32 Device;
    UInt32 MessageSize;
  };
  // memory of each thread
  struct SScratch {
    std::vector<UInt32> Pairs;  // places of the other devices
    std::vector<CSightFan::SEnd> Ends;  // their nearest images; only in a periodic arena
    CSightFan Fan;
  };
  // A pair of which one device has the number, and the other one examines. The former receives; the
  // latter, if kMutual is set.
  typedef UInt32 THearing;
  static constexpr THearing kMutual = THearing(1) << 31;

  void SortByCell(CThreadPool& pool);
  template <typename VISIT>
  void ForRangesNear(size_t place, VISIT&& visit) const;
  template <typename VISIT>
  void ForRangesOfImages(size_t place, VISIT&& visit) const;
  CSightFan::SEnd MakeNearest(const CSightFan::SEnd& end, const CSightFan::SEnd& to) const;
  void CountPairs(CThreadPool& pool);
  void ReserveScratch(CThreadPool& pool);
  void ExaminePairs(CThreadPool& pool, const CLineOfSight* sight);
  void ExaminePairsOf(size_t place, SScratch& scratch, const CLineOfSight* sight);
  Real ComputeSquareDistance(const SPlaced& device, const SPlaced& other) const;
  size_t FindPairs(size_t place, std::vector<UInt32>& pairs) const;
  template <typename VISIT>
  void ForHearings(VISIT&& visit) const;
  void CollectByReceiver(CThreadPool& pool);

  SDevices m_devices;
  CPointCells m_cells;
  SPeriodicity m_period;
  std::vector<Real> m_x, m_y;  // (finite devices), m; for m_cells
  std::vector<UInt32> m_finite;  // (finite devices), numbers
  bool m_areRangesEqual = true;
  std::vector<UInt32> m_placeOf;  // (devices), of finite ones
  // (placed devices), in cell order
  std::vector<SPlaced> m_placed;
  std::vector<Real> m_placedX, m_placedY;  // m
  std::vector<Real> m_rank;  // a device examines those of higher rank
  std::vector<size_t> m_pairStart;  // (placed devices + 1): ranges in m_hearings
  std::vector<UInt32> m_numHearings;  // (placed devices)
  std::vector<THearing> m_hearings;  // contain at most one per pair
  std::vector<SScratch> m_scratch;  // (threads)
  std::vector<UInt32> m_senderStart;  // (devices + 1): ranges in m_senders
  std::vector<UInt32> m_cursor;  // (devices), scratch
  std::vector<UInt32> m_senders;  // are sorted by receiver, ascending
};

}  // namespace argos

#endif
