#ifndef ARGOS3_CORE_UTILITY_DATATYPES_SPARE_ELEMENTS_H
#define ARGOS3_CORE_UTILITY_DATATYPES_SPARE_ELEMENTS_H

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace argos {

/**
 * Keeps the elements that a list does not need now, with the memory that they own: lists of
 * messages that grow and shrink from tick to tick allocate nothing unless they are longer than
 * ever.
 */
template <typename T>
class CSpareElements {
 public:
  /**
   * Appends an element to @p list, with whatever it held when it was last used.
   * @param prepare  void(T&): called for elements that are made, some in advance.
   */
  template <typename PREPARE>
  T& Append(std::vector<T>& list, PREPARE&& prepare) {
    if (m_spare.empty()) {
      MakeRoom(list, prepare);
    }
    list.push_back(std::move(m_spare.back()));
    m_spare.pop_back();
    return list.back();
  }
  T& Append(std::vector<T>& list) {
    return Append(list, [](T&) {});
  }

  /** Takes the last elements of @p list, so that @p size are left. */
  void Shrink(std::vector<T>& list, std::size_t size) {
    while (list.size() > size) {
      m_spare.push_back(std::move(list.back()));
      list.pop_back();
    }
  }

 private:
  static constexpr std::size_t kFirstRoom = 8;  // then twice as many

  template <typename PREPARE>
  void MakeRoom(std::vector<T>& list, PREPARE&& prepare) {
    const std::size_t room = std::max(kFirstRoom, 2 * list.size());
    list.reserve(room);
    m_spare.reserve(room);
    while (list.size() + m_spare.size() < room) {
      m_spare.emplace_back();
      prepare(m_spare.back());
    }
  }

  std::vector<T> m_spare;
};

}  // namespace argos

#endif
