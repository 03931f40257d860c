#include <argos3/core/utility/memory/object_slabs.h>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <utility>
#include <vector>

namespace argos {

namespace {

// AddressSanitizer finds the use of a freed object only if each has memory of its own
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kUseSlabs = false;
#elif defined(__has_feature)
constexpr bool kUseSlabs = !__has_feature(address_sanitizer);
#else
constexpr bool kUseSlabs = true;
#endif

// sizes differ by this many bytes
constexpr std::size_t kAlignment = 8;
constexpr std::size_t kNumSizes = CObjectSlabs::kMaxObjectBytes / kAlignment + 1;
// bytes; a slab holds objects of one size. Slabs are aligned to their size, so the address of an
// object gives that of its slab
constexpr std::size_t kSlab = std::size_t(64) << 10;
// bytes; slabs are allocated in regions of the size of a huge page
constexpr std::size_t kRegion = std::size_t(2) << 20;
// simulations with more memory than that gain from huge pages, smaller ones would waste it
constexpr std::size_t kRegionsOfSmallPages = 16;

// stands at the beginning of each slab
struct SSlabHeader {
  CObjectSlabs* Owner;
};
constexpr std::size_t kHeader = 64;
static_assert(sizeof(SSlabHeader) <= kHeader);

// takes the place of an object that was freed
struct SFreePlace {
  SFreePlace* Next;
};

// the objects of one size
struct SSizeClass {
  SFreePlace* Free = nullptr;  // freed last first
  std::byte* Next = nullptr;  // the place after the last one used of the newest slab
  std::byte* End = nullptr;  // end of that slab
};

struct SFreeRegion {
  // NOLINTNEXTLINE(cppcoreguidelines-no-malloc): what std::aligned_alloc() returned
  void operator()(std::byte* region) const { std::free(region); }
};
using TRegion = std::unique_ptr<std::byte[], SFreeRegion>;

// The region that was released last, for any slabs; null if it is in use. Mapping one and touching
// its pages takes longer than making a few robots, and some programs make and delete one small
// simulation after the other.
std::atomic<std::byte*> spareRegion = nullptr;

// regions that ReserveAhead() has mapped together
class CArea {
 public:
  // @param bytes  a multiple of kRegion
  explicit CArea(std::size_t bytes) : m_bytes(bytes) {
#ifdef __linux__
    // larger, so that an aligned part of it is large enough
    const std::size_t mapped = bytes + kRegion;
    void* const start = mmap(nullptr, mapped, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (start == MAP_FAILED) {
      return;
    }
    auto* const first = static_cast<std::byte*>(start);
    const auto address = reinterpret_cast<std::uintptr_t>(first);
    const std::size_t before = (kRegion - address % kRegion) % kRegion;
    m_start = first + before;
    if (before > 0) {
      munmap(first, before);
    }
    munmap(m_start + bytes, kRegion - before);
#ifdef MADV_HUGEPAGE
    // a refusal costs speed only, so it is not an error
    madvise(m_start, bytes, MADV_HUGEPAGE);
#endif
#endif
  }
  ~CArea() {
#ifdef __linux__
    if (m_start != nullptr) {
      munmap(m_start, m_bytes);
    }
#endif
  }
  CArea(CArea&& other) noexcept
      : m_start(std::exchange(other.m_start, nullptr)), m_bytes(other.m_bytes) {}
  CArea& operator=(CArea&&) = delete;

  // null if the system has no such memory
  std::byte* GetStart() const {
    return m_start;
  }

 private:
  std::byte* m_start = nullptr;
  std::size_t m_bytes;
};

thread_local CObjectSlabs* currentSlabs = nullptr;

}  // namespace

struct CObjectSlabs::SState {
  mutable std::mutex Mutex;
  std::array<SSizeClass, kNumSizes> Sizes;  // indexed by size / kAlignment
  std::vector<TRegion> Regions;
  std::vector<CArea> Areas;
  std::byte* NextSlab = nullptr;  // lies in a region or an area
  std::byte* EndOfSlabs = nullptr;
  std::size_t NumObjects = 0;
  std::size_t NumBytes = 0;
  bool IsAbandoned = false;

  std::byte* TakeSlab();
  void ReleaseAll();
};

std::byte* CObjectSlabs::SState::TakeSlab() {
  if (NextSlab == EndOfSlabs) {
    TRegion region(spareRegion.exchange(nullptr));
    if (region == nullptr) {
      region.reset(static_cast<std::byte*>(std::aligned_alloc(kRegion, kRegion)));
    }
    if (region == nullptr) {
      throw std::bad_alloc();
    }
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    if (Regions.size() >= kRegionsOfSmallPages) {
      // a refusal costs speed only, so it is not an error
      madvise(region.get(), kRegion, MADV_HUGEPAGE);
    }
#endif
    Regions.push_back(std::move(region));
    NextSlab = Regions.back().get();
    EndOfSlabs = NextSlab + kRegion;
  }
  return std::exchange(NextSlab, NextSlab + kSlab);
}

// called when no object is left
void CObjectSlabs::SState::ReleaseAll() {
  Sizes.fill(SSizeClass());
  Areas.clear();
  NextSlab = EndOfSlabs = nullptr;
  if (!Regions.empty()) {
    const TRegion previous(spareRegion.exchange(Regions.front().release()));
  }
  Regions.clear();
}

CObjectSlabs::CObjectSlabs() : m_state(std::make_unique<SState>()) {}

CObjectSlabs::~CObjectSlabs() = default;

CObjectSlabs::TOwner CObjectSlabs::Make() {
  return TOwner(new CObjectSlabs);
}

void CObjectSlabs::SAbandon::operator()(CObjectSlabs* slabs) const {
  {
    const std::lock_guard<std::mutex> lock(slabs->m_state->Mutex);
    slabs->m_state->IsAbandoned = true;
    if (slabs->m_state->NumObjects > 0) {
      return;
    }
  }
  std::default_delete<CObjectSlabs>()(slabs);
}

void* CObjectSlabs::Allocate(std::size_t bytes) {
  if (!kUseSlabs || bytes > kMaxObjectBytes) {
    return ::operator new(bytes);
  }
  const std::size_t number = (bytes + kAlignment - 1) / kAlignment;
  SState& state = *m_state;
  const std::lock_guard<std::mutex> lock(state.Mutex);
  SSizeClass& size = state.Sizes[number];
  void* place = size.Free;
  if (size.Free != nullptr) {
    size.Free = size.Free->Next;
  } else {
    const std::size_t rounded = number * kAlignment;
    if (static_cast<std::size_t>(size.End - size.Next) < rounded) {
      std::byte* const slab = state.TakeSlab();
      new (slab) SSlabHeader{this};
      size.Next = slab + kHeader;
      size.End = slab + kSlab;
    }
    place = size.Next;
    size.Next += rounded;
  }
  ++state.NumObjects;
  state.NumBytes += number * kAlignment;
  return place;
}

void CObjectSlabs::Free(void* object, std::size_t bytes) noexcept {
  if (!kUseSlabs || bytes > kMaxObjectBytes) {
    ::operator delete(object);
    return;
  }
  if (object == nullptr) {
    return;
  }
  const auto address = reinterpret_cast<std::uintptr_t>(object);
  CObjectSlabs& owner = *reinterpret_cast<SSlabHeader*>(address / kSlab * kSlab)->Owner;
  SState& state = *owner.m_state;
  bool isLast = false;
  {
    const std::lock_guard<std::mutex> lock(state.Mutex);
    const std::size_t number = (bytes + kAlignment - 1) / kAlignment;
    SSizeClass& size = state.Sizes[number];
    size.Free = new (object) SFreePlace{size.Free};
    state.NumBytes -= number * kAlignment;
    if (--state.NumObjects == 0) {
      state.ReleaseAll();
      isLast = state.IsAbandoned;
    }
  }
  if (isLast) {
    std::default_delete<CObjectSlabs>()(&owner);
  }
}

std::size_t CObjectSlabs::GetNumObjects() const {
  const std::lock_guard<std::mutex> lock(m_state->Mutex);
  return m_state->NumObjects;
}

std::size_t CObjectSlabs::GetNumBytes() const {
  const std::lock_guard<std::mutex> lock(m_state->Mutex);
  return m_state->NumBytes;
}

CObjectSlabs::SBlock CObjectSlabs::ReserveAhead(std::size_t bytes) {
  const std::size_t rounded = (bytes + kRegion - 1) / kRegion * kRegion;
  const std::lock_guard<std::mutex> lock(m_state->Mutex);
  // if there is no object, nothing would release the block
  if (!kUseSlabs || rounded == 0 || m_state->NumObjects == 0) {
    return {};
  }
  m_state->Areas.reserve(m_state->Areas.size() + 1);
  CArea area(rounded);
  if (area.GetStart() == nullptr) {
    return {};
  }
  // the rest of the present region is not used
  m_state->NextSlab = area.GetStart();
  m_state->EndOfSlabs = area.GetStart() + rounded;
  m_state->Areas.push_back(std::move(area));
  return {m_state->NextSlab, rounded};
}

CObjectSlabs& CObjectSlabs::GetCurrent() {
  if (currentSlabs != nullptr) {
    return *currentSlabs;
  }
  // never deleted: objects that were made outside of any simulation may live until the process ends
  static CObjectSlabs* const ofProcess = Make().release();
  return *ofProcess;
}

CObjectSlabs* CObjectSlabs::SetCurrent(CObjectSlabs* slabs) {
  CObjectSlabs* const before = currentSlabs;
  currentSlabs = slabs;
  return before;
}

}  // namespace argos
