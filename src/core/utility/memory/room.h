#ifndef ARGOS3_CORE_UTILITY_MEMORY_ROOM_H
#define ARGOS3_CORE_UTILITY_MEMORY_ROOM_H

namespace argos {

/**
 * Makes room for one more element of a vector, growing it as push_back() does: afterwards, nothing
 * fails between changes that belong together.
 * @throws std::bad_alloc; the vector is then unchanged.
 */
template <typename VECTOR>
void ReserveOneMore(VECTOR& vector) {
  if (vector.size() == vector.capacity()) {
    vector.reserve(2 * vector.size() + 1);
  }
}

}  // namespace argos

#endif
