#ifndef ARGOS3_PLUGINS_MEDIA_MEDIUM_USERS_H
#define ARGOS3_PLUGINS_MEDIA_MEDIUM_USERS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <sys/types.h>

#include <utility>
#include <vector>

namespace argos {

class CControllableEntity;
class CMediumUsers;

/**
 * A device that uses a medium: each is unlinked when the other is destroyed. Actuators store orders
 * here, which the medium executes in its TakeActs().
 */
class CMediumUser : private CNonCopyable {
 public:
  CMediumUser(CMediumUsers& users, const CControllableEntity& robot);
  virtual ~CMediumUser();

  const CControllableEntity& GetRobot() const { return m_robot; }

  bool HasOrder = false; /**< an order waits, to be executed once */

 private:
  friend class CMediumUsers;
  CMediumUsers* m_users;  // null once the medium was destroyed
  const CControllableEntity& m_robot;
};

/** The devices that use a medium; for the sources of media. */
class CMediumUsers : private CNonCopyable {
 public:
  CMediumUsers() = default;
  /** Removes all devices. */
  ~CMediumUsers() { RemoveAll(); }

  /** All devices, in the order of registration; not owned. */
  const std::vector<CMediumUser*>& Get() const { return m_users; }
  void RemoveAll();

  /**
   * Returns and clears all orders of robots in the space, in the order of the robots' insertion
   * into it, independently of the order of the devices' creation.
   * @return not owned; valid until the next call.
   */
  const std::vector<CMediumUser*>& TakeOrders();

 private:
  friend class CMediumUser;

  std::vector<CMediumUser*> m_users;
  std::vector<std::pair<ssize_t, size_t>> m_ordering;  // scratch: robot, place in m_users
  std::vector<CMediumUser*> m_withOrders;
};

}  // namespace argos

#endif
