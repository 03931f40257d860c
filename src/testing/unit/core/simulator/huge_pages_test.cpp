#include <argos3/core/simulator/huge_pages.h>

#include <catch2/catch.hpp>

#include <cstdint>
#include <fstream>
#include <memory>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

using namespace argos;

namespace {

constexpr size_t kBlockBytes = 1024;
constexpr size_t kNumBlocks = 100000;

using TBlock = std::vector<uint64_t>;

// blocks too small for malloc() to map each on its own
std::vector<TBlock> FillHeap() {
  std::vector<TBlock> blocks;
  for (size_t i = 0; i < kNumBlocks; ++i) {
    blocks.emplace_back(kBlockBytes / sizeof(uint64_t));
    std::iota(blocks.back().begin(), blocks.back().end(), i);
  }
  return blocks;
}

// kB of huge pages in the heap; see proc(5)
size_t ReadHugePagesOfHeap() {
  std::ifstream maps("/proc/self/smaps");
  std::string line;
  bool isHeap = false;
  size_t sum = 0;
  while (std::getline(maps, line)) {
    if (line.find('-') != std::string::npos && line.find(':') != std::string::npos &&
        line.find(" rw") != std::string::npos) {
      isHeap = line.find("[heap]") != std::string::npos;
    }
    std::istringstream words(line);
    std::string name;
    size_t number = 0;
    if (isHeap && words >> name >> number && name == "AnonHugePages:") {
      sum += number;
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("huge pages: a large heap gets huge pages and keeps its content", "[core][memory]") {
  const std::vector<TBlock> blocks = FillHeap();
  const size_t granted = BackHeapByHugePages();
  bool isUnchanged = true;
  for (size_t i = 0; i < blocks.size(); ++i) {
    for (size_t k = 0; k < blocks[i].size(); ++k) {
      isUnchanged = isUnchanged && blocks[i][k] == i + k;
    }
  }
  CHECK(isUnchanged);
  if (granted == 0) {
    WARN("this system or allocator gives no huge pages");
  } else {
    CHECK(granted > kNumBlocks * kBlockBytes / 2);
    CHECK(ReadHugePagesOfHeap() * 1024 >= granted);
  }
}

TEST_CASE("huge pages: repeated requests are harmless", "[core][memory]") {
  const std::vector<TBlock> blocks = FillHeap();
  CHECK(BackHeapByHugePages() == BackHeapByHugePages());
  CHECK(blocks.back().front() == kNumBlocks - 1);
}
