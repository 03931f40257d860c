#include <argos3/core/wrappers/lua/lua_memory.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <utility>

namespace argos {

CLuaMemory::CLuaMemory(std::size_t limit)
    : m_limit(limit > 0 ? limit : std::numeric_limits<std::size_t>::max()) {}

void* CLuaMemory::Reallocate(void* block, std::size_t oldSize, std::size_t newSize) {
  if (block == nullptr) {
    // oldSize then holds the type of the object
    return newSize > 0 ? Allocate(newSize) : nullptr;
  }
  if (newSize == 0) {
    Free(block, oldSize);
    return nullptr;
  }
  if (oldSize <= kMaxSmallBytes && newSize <= kMaxSmallBytes &&
      ClassOf(oldSize) == ClassOf(newSize)) {
    m_used += newSize - oldSize;  // wraps around if the block shrinks
    return block;
  }
  // the two blocks exist side by side for a moment only, which does not count
  m_used -= oldSize;
  void* const moved = Allocate(newSize);
  m_used += oldSize;
  if (moved != nullptr) {
    std::memcpy(moved, block, std::min(oldSize, newSize));
    Free(block, oldSize);
  }
  return moved;
}

void CLuaMemory::KeepOrder(bool isOn) {
  m_keepsOrder = isOn;
  if (isOn && m_left > 0) {
    m_inOrder.push_back({m_next, m_left});
  } else if (!isOn && !m_inOrder.empty()) {
    // the rest of the chunk is for what follows
    m_inOrder.back().Size -= m_left;
  }
}

std::size_t CLuaMemory::TakeWork() {
  return std::exchange(m_work, 0);
}

void* CLuaMemory::Allocate(std::size_t size) {
  if (!MayUse(size)) {
    return nullptr;
  }
  void* const block = size > kMaxSmallBytes ? AllocateLarge(size) : AllocateSmall(ClassOf(size));
  if (block != nullptr) {
    m_used += size;
  }
  return block;
}

void CLuaMemory::Free(void* block, std::size_t size) {
  m_used -= size;
  if (size > kMaxSmallBytes) {
    ::operator delete(block);
    m_taken -= size;
    return;
  }
  SFree*& first = m_free[ClassOf(size)];
  first = std::construct_at(static_cast<SFree*>(block), SFree{first});
}

void* CLuaMemory::AllocateLarge(std::size_t size) {
  void* const block = MayTake(size) ? ::operator new(size, std::nothrow) : nullptr;
  if (block != nullptr) {
    m_taken += size;
    m_work += size;
  }
  return block;
}

void* CLuaMemory::AllocateSmall(std::size_t sizeClass) {
  SFree* const block = m_keepsOrder ? nullptr : m_free[sizeClass];
  if (block != nullptr) {
    m_free[sizeClass] = block->Next;
    return block;
  }
  const std::size_t size = (sizeClass + 1) * kGrain;
  if (size > m_left) {
    if (!MayTake(kChunkSize)) {
      return nullptr;
    }
    try {
      m_chunks.push_back(std::make_unique_for_overwrite<std::byte[]>(kChunkSize));
    } catch (const std::bad_alloc&) {
      return nullptr;
    }
    m_next = m_chunks.back().get();
    m_left = kChunkSize;
    m_taken += kChunkSize;
    if (m_keepsOrder) {
      m_inOrder.push_back({m_next, m_left});
    }
  }
  m_left -= size;
  return std::exchange(m_next, m_next + size);
}

}  // namespace argos
