#include <argos3/core/simulator/physics_engine/space_partition.h>

#include <argos3/core/simulator/context/library_attribute.h>
#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/utility/plugins/unknown_label.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr const char* kTag = "auto_partition";
// a larger number would be slower than one engine for any swarm
constexpr UInt32 kMaxCount = 4096;

/** The division of the arena. */
struct SGrid {
  UInt32 Columns = 1, Rows = 1;  // along x, along y
  CVector3 Centre, Size;  // m, of the arena
};

// the factors of count whose cells are most nearly square; of equals, the one with fewer columns
SGrid ChooseGrid(UInt32 count, const CVector3& centre, const CVector3& size) {
  SGrid grid{1, count, centre, size};
  Real best = HUGE_VAL;
  for (UInt32 columns = 1; columns <= count; ++columns) {
    if (count % columns != 0) {
      continue;
    }
    const UInt32 rows = count / columns;
    const Real aspect = std::abs(std::log((size.GetX() / columns) / (size.GetY() / rows)));
    if (aspect < best - 1e-9) {
      best = aspect;
      grid.Columns = columns;
      grid.Rows = rows;
    }
  }
  return grid;
}

// the edges of the cells along an axis, m; the outermost ones are beyond the arena
std::vector<Real> ComputeEdges(Real centre, Real size, UInt32 cells, Real beyond) {
  std::vector<Real> edges;
  for (UInt32 i = 0; i <= cells; ++i) {
    edges.push_back(centre - 0.5 * size + size * i / cells);
  }
  edges.front() -= beyond;
  edges.back() += beyond;
  return edges;
}

std::string ToPoint(Real x, Real y) {
  CTextOutput text;
  text.precision(17);
  text << x << ',' << y;
  return text.str();
}

void AddSides(TConfigurationNode& engine, Real left, Real right, Real low, Real high) {
  if (!NodeExists(engine, "boundaries")) {
    TConfigurationNode boundaries("boundaries");
    AddChildNode(engine, boundaries);
  }
  TConfigurationNode sides("sides");
  for (const std::string& point :
       {ToPoint(left, low), ToPoint(right, low), ToPoint(right, high), ToPoint(left, high)}) {
    TConfigurationNode vertex("vertex");
    SetNodeAttribute(vertex, "point", point);
    AddChildNode(sides, vertex);
  }
  AddChildNode(GetNode(engine, "boundaries"), sides);
}

// false if the arena is invalid, which is reported when it is created
bool ReadArena(TConfigurationNode& arena, CVector3& centre, CVector3& size) {
  try {
    GetNodeAttribute(arena, "size", size);
    GetNodeAttributeOrDefault(arena, "center", centre, centre);
  } catch (const CARGoSException&) {
    return false;
  }
  return size.GetX() > 0.0 && size.GetY() > 0.0;
}

void Expand(TConfigurationNode& section, TConfigurationNode& node, TConfigurationNode& arena) {
  std::string type;
  UInt32 count = 0;
  GetNodeAttribute(node, "engine", type);
  GetNodeAttribute(node, "count", count);
  LoadLibraryOf(node);
  if (type == kTag || !CFactory<CPhysicsEngine>::Exists(type)) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": <" << kTag << ">: there is no physics engine of type <" << type
                         << ">"
                         << DescribeUnknownLabel(type, CFactory<CPhysicsEngine>::GetLabels()));
  }
  if (count < 1 || count > kMaxCount) {
    THROW_ARGOSEXCEPTION(node.GetLocation() << ": <" << kTag << ">: \"count\" must be from 1 to "
                                            << kMaxCount << ", found " << count);
  }
  if (NodeExists(node, "boundaries") && NodeExists(GetNode(node, "boundaries"), "sides")) {
    THROW_ARGOSEXCEPTION(GetNode(node, "boundaries").GetLocation()
                         << ": <" << kTag << ">: its engines get their <sides> from the size of "
                         << "the arena; only <top> and <bottom> may be given");
  }
  std::string prefix;
  GetNodeAttributeOrDefault(node, "id", prefix, type);
  CVector3 size;
  CVector3 centre;
  if (!ReadArena(arena, centre, size)) {
    throw CAlreadyReported("the arena is invalid");
  }
  const SGrid grid = ChooseGrid(count, centre, size);
  const Real beyond = std::max(size.GetX(), size.GetY());
  const std::vector<Real> xs = ComputeEdges(centre.GetX(), size.GetX(), grid.Columns, beyond);
  const std::vector<Real> ys = ComputeEdges(centre.GetY(), size.GetY(), grid.Rows, beyond);
  for (UInt32 row = 0; row < grid.Rows; ++row) {
    for (UInt32 column = 0; column < grid.Columns; ++column) {
      TConfigurationNode& engine = *section.InsertBeforeChild(node, node);
      if (row + column > 0) {
        // unused attributes are reported once, for the first engine
        MarkSubtreeRead(engine);
      }
      engine.SetValue(type);
      engine.RemoveAttribute("engine");
      engine.RemoveAttribute("count");
      SetNodeAttribute(engine, "id", prefix + "_" + ToString(column) + "_" + ToString(row));
      AddSides(engine, xs[column], xs[column + 1], ys[row], ys[row + 1]);
    }
  }
}

}  // namespace

const char* const kAutoPartitionDocumentation =
    R"(Cuts the arena into a grid of regions and gives each an engine of its own, so that engines run in parallel.

REQUIRED XML

  <physics_engines>
    <auto_partition engine="dynamics2d" count="16" />
  </physics_engines>

OPTIONAL XML

  <physics_engines>
    <auto_partition engine="dynamics2d" count="16" id="part" iterations="4">
      <friction box_linear_friction="1" />
    </auto_partition>
  </physics_engines>

ATTRIBUTES

  engine  text, required: the type of the engines.
  count   integer in [1,4096], required: how many. Columns and rows are those factors of it that make the regions
          most nearly square: 16 in a square arena are 4 x 4, 6 in one of 30 m x 20 m are 3 x 2, 7 are a strip.
  id      text, default the type: the engines are called id_column_row, counted from 0 along x and along y; so
          part_0_0 is at the smallest x and y.

All other attributes, and all children, are those of each engine. <boundaries> may give <top> and <bottom>, but no
<sides>. The outer regions reach beyond the arena, by its longer side.
)";

bool ExpandAutoPartitions(TConfigurationNode& section, TConfigurationNode& arena,
                          CLoadErrors& errors) {
  bool isGood = true;
  while (NodeExists(section, kTag)) {
    TConfigurationNode& node = GetNode(section, kTag);
    isGood = errors.Try("", [&] { Expand(section, node, arena); }) && isGood;
    section.RemoveChild(&node);
  }
  return isGood;
}

}  // namespace argos
