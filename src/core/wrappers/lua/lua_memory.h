#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_MEMORY_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_MEMORY_H

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
 */
class CLuaMemory {
 public:
  CLuaMemory() = default;
  CLuaMemory(const CLuaMemory&) = delete;
  CLuaMemory& operator=(const CLuaMemory&) = delete;

  /** A lua_Alloc; @p memory is a CLuaMemory. */
  static void* Reallocate(void* memory, void* block, std::size_t oldSize, std::size_t newSize);

 private:
  // sizes are rounded up to multiples of this, the alignment that Lua requires
  static constexpr std::size_t kGrain = 8;
  static constexpr std::size_t kLargestSmall = 256;
  static constexpr std::size_t kChunkSize = 4096;

  struct SFree {
    SFree* Next;
  };

  static std::size_t ClassOf(std::size_t size) { return (size - 1) / kGrain; }

  void* Allocate(std::size_t size);
  void Free(void* block, std::size_t size);
  void* AllocateSmall(std::size_t sizeClass);

  std::array<SFree*, kLargestSmall / kGrain> m_free = {};  // by class
  std::vector<std::unique_ptr<std::byte[]>> m_chunks;
  std::byte* m_next = nullptr;  // unused part of the last chunk
  std::size_t m_left = 0;  // its size, bytes
};

}  // namespace argos

#endif
