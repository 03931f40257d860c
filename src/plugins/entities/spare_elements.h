#ifndef ARGOS3_PLUGINS_ENTITIES_SPARE_ELEMENTS_H
#define ARGOS3_PLUGINS_ENTITIES_SPARE_ELEMENTS_H

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace argos {

/**
 * Keeps unused elements of lists together with the memory that they own: lists of messages that
 * change their length from tick to tick allocate only when they exceed their longest length so far.
 */
template <typename T>
class CSpareElements {
 public:
  /**
   * Appends a spare element to @p list, with its previous contents.
   * @param prepare  void(T&): called for each newly created element.
   */
  template <typename PREPARE>
  T& Append(std::vector<T>& list, PREPARE&& prepare) {
    if (m_spare.empty()) {
      MakeElements(list, prepare);
    }
    if (list.size() == list.capacity()) {
      list.reserve(m_numMade);
    }
    list.push_back(std::move(m_spare.back()));
    m_spare.pop_back();
    return list.back();
  }
  T& Append(std::vector<T>& list) {
    return Append(list, [](T&) {});
  }

  /** Calls use(T&) for each spare element. */
  template <typename USE>
  void ForEach(USE&& use) {
    std::for_each(m_spare.begin(), m_spare.end(), use);
  }

  /** Moves the last elements of @p list to the spare elements until @p size are left. */
  void Shrink(std::vector<T>& list, std::size_t size) {
    while (list.size() > size) {
      m_spare.push_back(std::move(list.back()));
      list.pop_back();
    }
  }

 private:
  static constexpr std::size_t kFirstCapacity = 8;  // doubled from then on

  template <typename PREPARE>
  void MakeElements(const std::vector<T>& list, PREPARE&& prepare) {
    const std::size_t more = std::max(kFirstCapacity, 2 * list.size()) - list.size();
    m_numMade += more;
    // reserve space for the elements of all lists
    m_spare.reserve(m_numMade);
    for (std::size_t i = 0; i < more; ++i) {
      m_spare.emplace_back();
      prepare(m_spare.back());
    }
  }

  std::vector<T> m_spare;
  std::size_t m_numMade = 0;
};

}  // namespace argos

#endif
