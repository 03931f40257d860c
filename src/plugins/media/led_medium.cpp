#include <argos3/plugins/simulator/media/led_medium.h>

#include <argos3/core/simulator/space/positional_indices/hash_index.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/string_utilities.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// more cells than that make a grid no faster
constexpr Real kMaxCells = 1 << 18;

}  // namespace

CLEDMedium::CLEDMedium() = default;

CLEDMedium::~CLEDMedium() {
  CLEDMedium::Destroy();
}

void CLEDMedium::Init(TConfigurationNode& tree) {
  CMedium::Init(tree);
  std::string index;
  GetNodeAttributeOrDefault<std::string>(tree, "index", index, "grid");
  if (index == "grid") {
    m_kind = EIndex::Grid;
  } else if (index == "hash") {
    m_kind = EIndex::Hash;
  } else {
    THROW_ARGOSEXCEPTION(tree.GetLocation()
                         << ": <" << tree.Value() << " id=\"" << GetId()
                         << "\">: attribute \"index\" must be \"grid\" or \"hash\", got \"" << index
                         << "\"" << DidYouMean(index, {"grid", "hash"}));
  }
  if (NodeAttributeExists(tree, "grid_size")) {
    ReadGridSize(tree);
  }
}

void CLEDMedium::ReadGridSize(TConfigurationNode& tree) {
  std::string text;
  GetNodeAttribute(tree, "grid_size", text);
  try {
    std::istringstream stream(text);
    SetStrictParsing(stream, true);
    ParseValues<SInt32>(stream, 3, m_gridSize, ',');
    if (*std::min_element(m_gridSize, m_gridSize + 3) < 1) {
      THROW_ARGOSEXCEPTION("each number must be at least 1");
    }
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(tree.GetLocation()
                                    << ": <" << tree.Value() << " id=\"" << GetId()
                                    << "\">: attribute \"grid_size\" must be three integers, "
                                       "\"x,y,z\", got \""
                                    << text << "\"",
                                error);
  }
}

void CLEDMedium::Reset() {
  SortByEntityIndex();
  Update();
}

void CLEDMedium::Destroy() {
  class CLetGo : public CPositionalIndex<CLEDEntity>::COperation {
   public:
    bool operator()(CLEDEntity& led) override {
      led.ClearMedium();
      return true;
    }
  } letGo;
  const std::vector<CLEDEntity*> waiting = m_waiting;
  for (CLEDEntity* led : waiting) {
    letGo(*led);
  }
  if (m_index != nullptr) {
    m_index->ForAllEntities(letGo);
  }
}

void CLEDMedium::PostSpaceInit() {
  SortByEntityIndex();
  Update();
}

// LEDs that a run switched off and on have moved to the end of the list; with this the list is at
// the start of every run the same
void CLEDMedium::SortByEntityIndex() {
  class CCollect : public CPositionalIndex<CLEDEntity>::COperation {
   public:
    bool operator()(CLEDEntity& led) override {
      LEDs.push_back(&led);
      return true;
    }
    std::vector<CLEDEntity*> LEDs;
  } all;
  GetIndex().ForAllEntities(all);
  if (std::is_sorted(all.LEDs.begin(), all.LEDs.end(), SEntityComparator())) {
    return;
  }
  std::stable_sort(all.LEDs.begin(), all.LEDs.end(), SEntityComparator());
  for (CLEDEntity* led : all.LEDs) {
    m_index->RemoveEntity(*led);
    m_index->AddEntity(*led);
  }
}

void CLEDMedium::Update() {
  GetIndex().Update();
}

void CLEDMedium::AddEntity(CLEDEntity& led) {
  if (m_index != nullptr) {
    m_index->AddEntity(led);
  } else {
    m_waiting.push_back(&led);
  }
}

void CLEDMedium::RemoveEntity(CLEDEntity& led) {
  if (m_index != nullptr) {
    m_index->RemoveEntity(led);
  } else {
    m_waiting.erase(std::remove(m_waiting.begin(), m_waiting.end(), &led), m_waiting.end());
  }
}

CPositionalIndex<CLEDEntity>& CLEDMedium::GetIndex() {
  if (m_index == nullptr) {
    MakeIndex();
  }
  return *m_index;
}

void CLEDMedium::MakeIndex() {
  CVector3 extent = GetSpace().GetArenaSize();
  SInt32 size[3];
  Real numCells = 1.0;
  for (UInt32 axis = 0; axis < 3; ++axis) {
    extent[axis] = extent[axis] > 0.0 ? extent[axis] : 1.0;
    // by default cells of one metre
    size[axis] = m_gridSize[axis] > 0
                     ? m_gridSize[axis]
                     : static_cast<SInt32>(std::clamp(std::floor(extent[axis]), 1.0, kMaxCells));
    numCells *= size[axis];
  }
  if (numCells > kMaxCells) {
    const Real shrink = std::cbrt(kMaxCells / numCells);
    for (SInt32& number : size) {
      number = std::max(1, static_cast<SInt32>(number * shrink));
    }
  }
  const CVector3 half = extent * 0.5;
  if (m_kind == EIndex::Grid) {
    auto grid = std::make_unique<CGrid<CLEDEntity>>(GetSpace().GetArenaCenter() - half,
                                                    GetSpace().GetArenaCenter() + half, size[0],
                                                    size[1], size[2]);
    m_gridUpdater = std::make_unique<CLEDEntityGridUpdater>(*grid);
    grid->SetUpdateEntityOperation(m_gridUpdater.get());
    m_index = std::move(grid);
  } else {
    m_index = std::make_unique<CHashIndex<CLEDEntity, CLEDEntitySpaceHashUpdater>>(
        CVector3(extent.GetX() / size[0], extent.GetY() / size[1], extent.GetZ() / size[2]));
  }
  for (CLEDEntity* led : m_waiting) {
    m_index->AddEntity(*led);
  }
  m_waiting.clear();
}

REGISTER_MEDIUM(
    CLEDMedium, "led", "the authors of this project", "1.0",
    "Knows where LEDs and lights are, for cameras.",
    R"(Every LED and light that cameras shall see belongs to an LED medium; cameras name the medium
they look at. LEDs outside the arena count like all others.

REQUIRED XML

  <media>
    <led id="leds" />
  </media>

ATTRIBUTES

  id         text, required: unique among the media.
  index      "grid" (default) or "hash": how LEDs near a point are found. It has no effect on results;
             "hash" takes less memory where the arena is large and LEDs are few.
  grid_size  "x,y,z", integers >= 1: into how many cells the arena is divided along each axis; default
             one cell for each whole metre. It has no effect on results.

For example:

  <media>
    <led id="leds" index="grid" grid_size="20,20,1" />
  </media>
)",
    "Usable")

}  // namespace argos
