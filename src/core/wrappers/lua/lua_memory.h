#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_MEMORY_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_MEMORY_H

#include <argos3/core/utility/memory/load_ahead.h>
#include <argos3/core/utility/non_copyable.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace argos {

/**
 * The memory of one Lua state: small blocks are adjacent in chunks, in the order of their
 * allocation, without headers.
 *
 * A robot's state has about a thousand small objects that live as long as it does. On the common
 * heap each of them would have a header, and objects that are read together would be scattered. A
 * freed block is reused for others of its size; the destructor releases all memory.
 *
 * The bytes in use are counted and limited. What is taken from the heap may be twice as much,
 * because chunks with free blocks of sizes that are not needed any more remain.
 */
class CLuaMemory : private CNonCopyable {
 public:
  /** @param limit  bytes in use; 0 = no limit. */
  explicit CLuaMemory(std::size_t limit = 0);

  /**
   * As lua_Alloc.
   * @return null if the limit or the heap is exhausted; Lua collects its garbage, tries again, and
   * raises an error. A smaller block than before is never refused because of the limit.
   */
  void* Reallocate(void* block, std::size_t oldSize, std::size_t newSize);

  /**
   * While this is on, small blocks are adjacent even if freed ones would fit: for what is read in
   * each tick, in this order.
   */
  void KeepOrder(bool isOn);
  /** Prefetches the blocks that were allocated while KeepOrder() was on. */
  void LoadAheadInOrder() const {
    for (const SRange& range : m_inOrder) {
      LoadAhead(range.First, range.Size);
    }
  }
  std::size_t GetLimit() const { return m_limit; }
  /** Bytes in use. */
  std::size_t GetUsed() const { return m_used; }
  /** Bytes in large blocks allocated since the last call; they cost time. */
  std::size_t TakeWork();

 private:
  // sizes are rounded up to multiples of this, the alignment that Lua requires
  static constexpr std::size_t kGrain = 8;
  static constexpr std::size_t kMaxSmallBytes = 256;
  static constexpr std::size_t kChunkSize = 4096;

  struct SRange {
    const std::byte* First;
    std::size_t Size;
  };
  struct SFree {
    SFree* Next;
  };

  static std::size_t ClassOf(std::size_t size) { return (size - 1) / kGrain; }

  void* Allocate(std::size_t size);
  void Free(void* block, std::size_t size);
  void* AllocateSmall(std::size_t sizeClass);
  void* AllocateLarge(std::size_t size);
  /** True if the limit has room for more bytes. */
  bool MayUse(std::size_t size) const { return size <= m_limit && m_used <= m_limit - size; }
  bool MayTake(std::size_t size) const { return m_taken / 2 + size / 2 <= m_limit; }

  std::array<SFree*, kMaxSmallBytes / kGrain> m_free = {};  // indexed by class of sizes
  std::vector<std::unique_ptr<std::byte[]>> m_chunks;
  std::byte* m_next = nullptr;  // unused part of the last chunk
  std::size_t m_left = 0;  // its size, bytes
  std::size_t m_limit;
  std::size_t m_used = 0;
  std::size_t m_taken = 0;
  std::size_t m_work = 0;
  bool m_keepsOrder = false;
  std::vector<SRange> m_inOrder;  // allocated while m_keepsOrder
};

}  // namespace argos

#endif
