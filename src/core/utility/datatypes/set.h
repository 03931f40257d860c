#ifndef ARGOS3_CORE_UTILITY_DATATYPES_SET_H
#define ARGOS3_CORE_UTILITY_DATATYPES_SET_H

#include <argos3/core/config.h>  // checks the language level

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace argos {

/**
 * Points to an element of a CSet. Its type depends on the element type only, so sets with different
 * orders share it. An insertion or removal invalidates it: it then points to the element now at the
 * same index.
 */
template <typename T, typename REFERENCE>
class CSetIterator {
 public:
  typedef std::forward_iterator_tag iterator_category;
  typedef T value_type;
  typedef std::ptrdiff_t difference_type;
  typedef REFERENCE& reference;
  typedef REFERENCE* pointer;

  CSetIterator() = default;
  CSetIterator(std::vector<T>* elements, std::size_t index)
      : m_elements(elements), m_index(index) {}

  /** iterator to const_iterator. */
  operator CSetIterator<T, const T>() const {
    return CSetIterator<T, const T>(m_elements, m_index);
  }

  reference operator*() const { return (*m_elements)[m_index]; }
  pointer operator->() const { return &(*m_elements)[m_index]; }

  CSetIterator& operator++() {
    ++m_index;
    return *this;
  }
  CSetIterator operator++(int) {
    CSetIterator before(*this);
    ++m_index;
    return before;
  }

  bool operator==(const CSetIterator& other) const {
    return m_elements == other.m_elements && m_index == other.m_index;
  }
  bool operator!=(const CSetIterator& other) const { return !(*this == other); }

 private:
  template <class U, class C>
  friend class CSet;

  std::vector<T>* m_elements = nullptr;
  std::size_t m_index = 0;
};

/**
 * A sorted list without duplicates. Elements are compared by ==; C orders them, and elements that C
 * does not order keep their insertion order.
 *
 * Elements are contiguous in memory: iteration is fast, insertion and removal move the elements
 * behind.
 */
template <class T, class C = std::less<T>>
class CSet {
 public:
  typedef CSetIterator<T, T> iterator;
  typedef CSetIterator<T, const T> const_iterator;

  CSet() = default;
  CSet(const CSet&) = default;
  CSet& operator=(const CSet&) = default;
  ~CSet() = default;

  bool empty() const { return m_elements.empty(); }
  std::size_t size() const { return m_elements.size(); }

  /** The first and last element of a non-empty set. */
  T& first() { return m_elements.front(); }
  const T& first() const { return m_elements.front(); }
  T& last() { return m_elements.back(); }
  const T& last() const { return m_elements.back(); }

  /**
   * Inserts an element unless the set contains it.
   * @param comp  the order; must be the same for all insertions.
   */
  void insert(const T& element, C comp = C()) {
    auto place = std::lower_bound(m_elements.begin(), m_elements.end(), element, comp);
    while (place != m_elements.end() && !comp(element, *place)) {
      if (*place == element) {
        return;
      }
      ++place;
    }
    m_elements.insert(place, element);
  }

  /** Removes an element if the set contains it. */
  void erase(const T& element) {
    const std::size_t index = IndexOf(element);
    if (index < m_elements.size()) {
      m_elements.erase(m_elements.begin() + static_cast<std::ptrdiff_t>(index));
    }
  }

  /** Erases the element at the iterator, which then points to the next element. */
  void erase(iterator& it) {
    m_elements.erase(m_elements.begin() + static_cast<std::ptrdiff_t>(it.m_index));
  }

  void clear() { m_elements.clear(); }

  bool exists(const T& element) { return IndexOf(element) < m_elements.size(); }

  iterator begin() const { return iterator(&m_elements, 0); }
  iterator end() const { return iterator(&m_elements, m_elements.size()); }

  /** @return end() if the set does not contain the element. */
  iterator find(const T& element) const { return iterator(&m_elements, IndexOf(element)); }

 private:
  std::size_t IndexOf(const T& element) const {
    // a stateless order is the same for all insertions
    if constexpr (std::is_empty_v<C>) {
      const C comp{};
      auto place = std::lower_bound(m_elements.begin(), m_elements.end(), element, comp);
      for (; place != m_elements.end() && !comp(element, *place); ++place) {
        if (*place == element) {
          return static_cast<std::size_t>(place - m_elements.begin());
        }
      }
      return m_elements.size();
    } else {
      return static_cast<std::size_t>(std::find(m_elements.begin(), m_elements.end(), element) -
                                      m_elements.begin());
    }
  }

  // mutable, because begin() of a constant set returns mutable elements
  mutable std::vector<T> m_elements;
};

}  // namespace argos

#endif
