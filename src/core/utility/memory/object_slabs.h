#ifndef ARGOS3_CORE_UTILITY_MEMORY_OBJECT_SLABS_H
#define ARGOS3_CORE_UTILITY_MEMORY_OBJECT_SLABS_H

#include <argos3/core/config.h>  // checks the language level
#include <argos3/core/utility/non_copyable.h>

#include <cstddef>
#include <memory>
#include <new>

namespace argos {

/**
 * The memory of one simulation's objects: entities, components, devices and controllers.
 *
 * Objects of one size (hence of one class, mostly) are adjacent in memory in the order of their
 * creation, which is the order of the robots. A phase that visits the same component of every robot
 * therefore reads memory nearly in sequence. Objects never move; the place of a deleted object is
 * reused for the next one of its size.
 *
 * Any thread may allocate and free.
 */
class CObjectSlabs : private CNonCopyable {
 public:
  struct SAbandon {
    void operator()(CObjectSlabs* slabs) const;
  };
  /** Owns slabs; after its destruction they are released with the last object in them. */
  using TOwner = std::unique_ptr<CObjectSlabs, SAbandon>;

  static TOwner Make();

  /**
   * Memory for an object, aligned to 16 bytes if its size is a multiple of that, else to 8, which
   * is enough: the size of an object is a multiple of its alignment.
   * @throws std::bad_alloc
   */
  void* Allocate(std::size_t bytes);
  /** Frees what Allocate() of any slabs returned for that number of bytes. */
  static void Free(void* object, std::size_t bytes) noexcept;

  /** Number of objects that have not been freed; those larger than kMaxObjectBytes do not count. */
  std::size_t GetNumObjects() const;
  /** Of these objects. */
  std::size_t GetNumBytes() const;

  /** Memory that nothing has written yet. */
  struct SBlock {
    void* Start = nullptr;
    std::size_t Bytes = 0;
  };
  /**
   * Reserves memory for objects to come, in one block; they are allocated from its beginning on.
   * @return the block, to be prepared by CPagePreparer; valid as long as an object exists. Empty if
   *         the system has none, or if it has no such blocks.
   */
  SBlock ReserveAhead(std::size_t bytes);

  /** The slabs that the calling thread allocates from; those of the process by default. */
  static CObjectSlabs& GetCurrent();
  /** @param slabs  null: those of the process. @return what was set before; perhaps null. */
  static CObjectSlabs* SetCurrent(CObjectSlabs* slabs);

  /** Bytes; larger objects are left to the global operator new. */
  static constexpr std::size_t kMaxObjectBytes = 8192;

 private:
  struct SState;
  friend struct std::default_delete<CObjectSlabs>;

  CObjectSlabs();
  ~CObjectSlabs();

  std::unique_ptr<SState> m_state;
};

/**
 * Base of the classes whose objects are in the slabs of the thread's current simulation. Classes
 * derived from it are created with `new` and deleted as usual.
 */
class CSlabObject {
 public:
  static void* operator new(std::size_t bytes) {
    return CObjectSlabs::GetCurrent().Allocate(bytes);
  }
  static void operator delete(void* object, std::size_t bytes) noexcept {
    CObjectSlabs::Free(object, bytes);
  }
  // classes that need more than the alignment of slabs are left to the global operators
  static void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return ::operator new(bytes, alignment);
  }
  static void operator delete(void* object, std::size_t, std::align_val_t alignment) noexcept {
    // the global operator that takes a size is not used: clang declares it only with an option
    ::operator delete(object, alignment);
  }
  // the operators above hide the one for placement
  static void* operator new(std::size_t, void* place) noexcept { return place; }
  static void operator delete(void*, void*) noexcept {}

 protected:
  CSlabObject() = default;
  ~CSlabObject() = default;
};

/**
 * Allocates the elements of a container from the slabs of the thread's current simulation: for
 * short arrays that every robot has and that every tick reads.
 */
template <typename T>
class CSlabAllocator {
 public:
  using value_type = T;

  CSlabAllocator() = default;
  template <typename OTHER>
  CSlabAllocator(const CSlabAllocator<OTHER>&) {}

  // T may be a pointer: then sizeof is the size of the pointer
  T* allocate(std::size_t number) {
    // NOLINTNEXTLINE(bugprone-sizeof-expression)
    return static_cast<T*>(CObjectSlabs::GetCurrent().Allocate(number * sizeof(T)));
  }
  void deallocate(T* elements, std::size_t number) noexcept {
    // NOLINTNEXTLINE(bugprone-sizeof-expression)
    CObjectSlabs::Free(elements, number * sizeof(T));
  }
  // memory that one allocator has allocated may be freed by another one
  friend bool operator==(const CSlabAllocator&, const CSlabAllocator&) { return true; }
  friend bool operator!=(const CSlabAllocator&, const CSlabAllocator&) { return false; }
};

}  // namespace argos

#endif
