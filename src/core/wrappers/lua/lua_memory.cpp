#include <argos3/core/wrappers/lua/lua_memory.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>

namespace argos {

void* CLuaMemory::Reallocate(void* memory, void* block, std::size_t oldSize, std::size_t newSize) {
  auto& self = *static_cast<CLuaMemory*>(memory);
  if (block == nullptr) {
    // oldSize then holds the type of the object
    return newSize > 0 ? self.Allocate(newSize) : nullptr;
  }
  if (newSize == 0) {
    self.Free(block, oldSize);
    return nullptr;
  }
  if (oldSize <= kLargestSmall && newSize <= kLargestSmall &&
      ClassOf(oldSize) == ClassOf(newSize)) {
    return block;
  }
  void* const moved = self.Allocate(newSize);
  if (moved != nullptr) {
    std::memcpy(moved, block, std::min(oldSize, newSize));
    self.Free(block, oldSize);
  }
  return moved;
}

void* CLuaMemory::Allocate(std::size_t size) {
  return size > kLargestSmall ? ::operator new(size, std::nothrow) : AllocateSmall(ClassOf(size));
}

void CLuaMemory::Free(void* block, std::size_t size) {
  if (size > kLargestSmall) {
    ::operator delete(block);
    return;
  }
  SFree*& first = m_free[ClassOf(size)];
  first = std::construct_at(static_cast<SFree*>(block), SFree{first});
}

void* CLuaMemory::AllocateSmall(std::size_t sizeClass) {
  if (SFree* const block = m_free[sizeClass]) {
    m_free[sizeClass] = block->Next;
    return block;
  }
  const std::size_t size = (sizeClass + 1) * kGrain;
  if (size > m_left) {
    try {
      m_chunks.push_back(std::make_unique_for_overwrite<std::byte[]>(kChunkSize));
    } catch (const std::bad_alloc&) {
      return nullptr;  // Lua collects its garbage, tries again, and raises an error
    }
    m_next = m_chunks.back().get();
    m_left = kChunkSize;
  }
  void* const block = m_next;
  m_next += size;
  m_left -= size;
  return block;
}

}  // namespace argos
