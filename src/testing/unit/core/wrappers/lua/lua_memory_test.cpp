#include <argos3/core/wrappers/lua/lua_memory.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <cstring>

namespace lua_memory_test {

using namespace argos;

namespace {

constexpr std::size_t kSize = 48;

std::byte* Allocate(CLuaMemory& memory) {
  auto* const block = static_cast<std::byte*>(memory.Reallocate(nullptr, 0, kSize));
  std::memset(block, 1, kSize);
  return block;
}

}  // namespace

TEST_CASE("lua memory: a freed block is used again", "[lua]") {
  CLuaMemory memory;
  std::byte* const first = Allocate(memory);
  Allocate(memory);
  memory.Reallocate(first, kSize, 0);
  CHECK(Allocate(memory) == first);
  CHECK(memory.GetUsed() == 2 * kSize);
}

TEST_CASE("lua memory: what is kept in order is adjacent, whatever was freed before", "[lua]") {
  CLuaMemory memory;
  std::byte* const first = Allocate(memory);
  std::byte* const second = Allocate(memory);
  memory.Reallocate(first, kSize, 0);
  memory.KeepOrder(true);
  CHECK(Allocate(memory) == second + kSize);
  CHECK(Allocate(memory) == second + 2 * kSize);
  memory.KeepOrder(false);
  CHECK(Allocate(memory) == first);
  CHECK(Allocate(memory) == second + 3 * kSize);
  memory.LoadAheadInOrder();  // has no effect that can be seen
}

TEST_CASE("lua memory: an order of nothing may be kept, too", "[lua]") {
  CLuaMemory memory;
  memory.KeepOrder(true);
  memory.LoadAheadInOrder();
  memory.KeepOrder(false);
  memory.KeepOrder(false);
  std::byte* const first = Allocate(memory);
  CHECK(Allocate(memory) == first + kSize);
}

}  // namespace lua_memory_test
