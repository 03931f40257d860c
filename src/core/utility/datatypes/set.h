#ifndef ARGOS3_CORE_UTILITY_DATATYPES_SET_H
#define ARGOS3_CORE_UTILITY_DATATYPES_SET_H

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace argos {

/**
 * Points to an element of a CSet. It depends on the element's type only, so sets with different
 * orders share it. After an insertion or a removal it points to whatever then has its place in the
 * set.
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
 * A sorted list without duplicates. Two elements are the same if they are equal by ==; C orders
 * them, and elements that C does not order keep the order of their insertion.
 *
 * Elements lie side by side: visiting them is fast, inserting and erasing moves those behind.
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

  /** The ends of the set, which must not be empty. */
  T& first() { return m_elements.front(); }
  const T& first() const { return m_elements.front(); }
  T& last() { return m_elements.back(); }
  const T& last() const { return m_elements.back(); }

  /**
   * Does nothing if the element is there already.
   * @param comp  the order; the same at every insertion.
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

  /** Does nothing if the element is not there. */
  void erase(const T& element) {
    const std::size_t index = IndexOf(element);
    if (index < m_elements.size()) {
      m_elements.erase(m_elements.begin() + static_cast<std::ptrdiff_t>(index));
    }
  }

  /** Erases what the iterator points to; it then points to the next element. */
  void erase(iterator& it) {
    m_elements.erase(m_elements.begin() + static_cast<std::ptrdiff_t>(it.m_index));
  }

  void clear() { m_elements.clear(); }

  bool exists(const T& element) { return IndexOf(element) < m_elements.size(); }

  iterator begin() const { return iterator(&m_elements, 0); }
  iterator end() const { return iterator(&m_elements, m_elements.size()); }

  /** @return end() if the element is not there. */
  iterator find(const T& element) const { return iterator(&m_elements, IndexOf(element)); }

 private:
  std::size_t IndexOf(const T& element) const {
    // an order without state is the one the elements were inserted by
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

  // mutable, because begin() of a constant set gives access to the elements themselves
  mutable std::vector<T> m_elements;
};

}  // namespace argos

#endif
