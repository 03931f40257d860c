// scripts/mutate.sh includes this into the sources that it changes: marks which changed places a
// test reaches.
#ifndef ARGOS3_MUTATION_REACH_H
#define ARGOS3_MUTATION_REACH_H

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <cstdlib>
#include <type_traits>

namespace argos_mutation {

/** The file that ARGOS_MUTATION_MAP names, a byte for each mutant, shared with all processes. */
class CReachMap {
 public:
  CReachMap() {
    const char* name = std::getenv("ARGOS_MUTATION_MAP");
    const int file = name == nullptr ? -1 : open(name, O_RDWR | O_CLOEXEC);
    if (file < 0) {
      return;
    }
    const off_t size = lseek(file, 0, SEEK_END);
    void* map =
        mmap(nullptr, static_cast<size_t>(size), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    if (map != MAP_FAILED) {
      m_bytes = static_cast<volatile char*>(map);
      m_size = size;
    }
  }

  void Mark(int mutant) const {
    if (mutant < m_size) {
      m_bytes[mutant] = '1';
    }
  }

 private:
  volatile char* m_bytes = nullptr;
  off_t m_size = 0;
};

inline void MarkAtRunTime(int mutant) {
  static const CReachMap map;
  map.Mark(mutant);
}

constexpr void Mark(int mutant) {
  if (!std::is_constant_evaluated()) {
    MarkAtRunTime(mutant);
  }
}

}  // namespace argos_mutation

#endif
