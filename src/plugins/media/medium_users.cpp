#include <argos3/plugins/simulator/media/medium_users.h>

#include <argos3/core/simulator/entity/controllable_entity.h>

#include <algorithm>

namespace argos {

CMediumUser::CMediumUser(CMediumUsers& users, const CControllableEntity& robot)
    : m_users(&users), m_robot(robot) {
  m_users->m_users.push_back(this);
}

CMediumUser::~CMediumUser() {
  if (m_users != nullptr) {
    std::vector<CMediumUser*>& users = m_users->m_users;
    // searched from the back, because a mass removal removes the last ones first
    users.erase(std::prev(std::find(users.rbegin(), users.rend(), this).base()));
  }
}

void CMediumUsers::RemoveAll() {
  for (CMediumUser* user : m_users) {
    user->m_users = nullptr;
  }
  m_users.clear();
}

const std::vector<CMediumUser*>& CMediumUsers::TakeOrders() {
  m_ordering.clear();
  for (size_t i = 0; i < m_users.size(); ++i) {
    // skip robots that are not in the space
    const ssize_t robot = m_users[i]->m_robot.GetIndex();
    if (m_users[i]->HasOrder && robot >= 0) {
      m_ordering.emplace_back(robot, i);
    }
    m_users[i]->HasOrder = false;
  }
  // devices are mostly created in the order of their robots
  if (!std::is_sorted(m_ordering.begin(), m_ordering.end())) {
    std::sort(m_ordering.begin(), m_ordering.end());
  }
  m_withOrders.clear();
  for (const auto& entry : m_ordering) {
    m_withOrders.push_back(m_users[entry.second]);
  }
  return m_withOrders;
}

}  // namespace argos
