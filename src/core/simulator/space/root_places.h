#ifndef ARGOS3_CORE_SIMULATOR_SPACE_ROOT_PLACES_H
#define ARGOS3_CORE_SIMULATOR_SPACE_ROOT_PLACES_H

#include <argos3/core/simulator/entity/entity.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace argos {

/** Finds the places of root entities in a list of their indices. */
class CRootPlaces {
 public:
  explicit CRootPlaces(const std::vector<ssize_t>& indices) : m_size(indices.size()) {
    m_places.reserve(m_size);
    for (const ssize_t index : indices) {
      m_places.push_back({index, m_places.size()});
    }
    std::sort(m_places.begin(), m_places.end(), IsBefore);
  }

  /** @return the length of the list if the entity is not in it. */
  size_t Find(const CEntity& root) const {
    const SPlace wanted{root.GetIndex(), 0};
    const auto found = std::lower_bound(m_places.begin(), m_places.end(), wanted, IsBefore);
    return found != m_places.end() && found->Index == wanted.Index ? found->Place : m_size;
  }
  size_t GetSize() const { return m_size; }

 private:
  struct SPlace {
    ssize_t Index;
    size_t Place;
  };
  static bool IsBefore(const SPlace& a, const SPlace& b) { return a.Index < b.Index; }

  size_t m_size;
  std::vector<SPlace> m_places;  // is indexed by the index of the root
};

}  // namespace argos

#endif
