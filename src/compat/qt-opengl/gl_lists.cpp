#include "gl_lists.h"

#include <algorithm>
#include <limits>

namespace argos {

namespace {

// of all lists: some 200 MB
constexpr std::size_t kMaxCommands = 5000000;
// what an empty list counts as
constexpr std::size_t kListSize = 4;

}  // namespace

// A static object of users that makes a list in its constructor ends before this one.
CGlLists& CGlLists::Get() {
  static CGlLists lists;
  return lists;
}

GLuint CGlLists::Reserve(GLsizei count) {
  const std::lock_guard lock(m_mutex);
  if (count <= 0 || static_cast<GLuint>(count) > std::numeric_limits<GLuint>::max() - m_next) {
    return 0;
  }
  const GLuint first = m_next;
  m_next += static_cast<GLuint>(count);
  return first;
}

bool CGlLists::Set(GLuint number, TGlList list) {
  const std::lock_guard lock(m_mutex);
  if (const auto place = m_lists.find(number); place != m_lists.end()) {
    Remove(place);
  }
  if (m_size + list.size() + kListSize > kMaxCommands) {
    return false;
  }
  m_size += list.size() + kListSize;
  // numbers that users choose are not given to others
  m_next = std::max(m_next, number < std::numeric_limits<GLuint>::max() ? number + 1 : number);
  list.shrink_to_fit();
  m_lists[number] = std::make_shared<const TGlList>(std::move(list));
  return true;
}

std::shared_ptr<const TGlList> CGlLists::Find(GLuint number) const {
  const std::lock_guard lock(m_mutex);
  const auto place = m_lists.find(number);
  return place == m_lists.end() ? nullptr : place->second;
}

void CGlLists::Delete(GLuint first, GLsizei count) {
  const std::lock_guard lock(m_mutex);
  const UInt64 end = UInt64{first} + static_cast<UInt64>(std::max<GLsizei>(count, 0));
  for (auto place = m_lists.lower_bound(first); place != m_lists.end() && place->first < end;) {
    Remove(place++);
  }
}

void CGlLists::Remove(std::map<GLuint, std::shared_ptr<const TGlList>>::iterator place) {
  m_size -= place->second->size() + kListSize;
  m_lists.erase(place);
}

}  // namespace argos
