#include <argos3/core/simulator/physics_engine/space_partition.h>

#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/simulator/geometry/region_geometry.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <typeinfo>

namespace argos {

namespace {

// m; regions may overlap by this, because coordinates are rounded
constexpr Real kTolerance = 1e-6;
// m; planes at this distance or less count as one
constexpr Real kSamePlane = 1e-4;
// m; a side is a border if another engine is this near to it
constexpr Real kNear = 1.0;

Real ComputePerimeter(const TPolygon& polygon) {
  Real length = 0.0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    length += Distance(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return length;
}

/** Heights that two engines share, m. */
struct SSpan {
  Real Low, High;
  bool IsShared;
};

SSpan IntersectHeights(const CPhysicsEngine& a, const CPhysicsEngine& b) {
  const auto [lowA, highA] = a.GetHeightSpan();
  const auto [lowB, highB] = b.GetHeightSpan();
  SSpan span = {std::max(lowA, lowB), std::min(highA, highB), false};
  const bool isPlane = lowA == highA || lowB == highB;
  span.IsShared = isPlane ? span.High - span.Low >= -kSamePlane : span.High - span.Low > kTolerance;
  return span;
}

std::string DescribeHeights(const SSpan& span) {
  CTextOutput text;
  if (span.High - span.Low <= kSamePlane) {
    text << "at z = " << span.Low << " m";
  } else if (std::isinf(span.Low) && std::isinf(span.High)) {
    text << "at all heights";
  } else if (std::isinf(span.High)) {
    text << "from z = " << span.Low << " m up";
  } else if (std::isinf(span.Low)) {
    text << "up to z = " << span.High << " m";
  } else {
    text << "from z = " << span.Low << " to " << span.High << " m";
  }
  return text.str();
}

// throws if the regions of two engines of one type overlap
void CheckPair(const CPhysicsEngine& a, const CPhysicsEngine& b) {
  if (typeid(a) != typeid(b) || !a.GetVolume().IsActive() || !b.GetVolume().IsActive()) {
    return;
  }
  const SSpan heights = IntersectHeights(a, b);
  if (!heights.IsShared) {
    return;
  }
  const TPolygon mine = a.GetVolume().GetCorners();
  const TPolygon other = b.GetVolume().GetCorners();
  CTextOutput what;
  if (mine.empty() && other.empty()) {
    what << "everything " << DescribeHeights(heights);
  } else {
    const TPolygon shared = mine.empty() ? other : other.empty() ? mine : Intersect(mine, other);
    const Real area = 0.5 * ComputeTwiceArea(shared);
    if (!(area > kTolerance * ComputePerimeter(shared))) {
      return;
    }
    what << area << " m^2 with the corners " << ListCorners(shared) << ", "
         << DescribeHeights(heights);
  }
  THROW_ARGOSEXCEPTION(a.GetOrigin()
                       << ": its region and that of " << b.GetOrigin() << " share " << what.str()
                       << "; regions of engines of one type must not overlap");
}

// how far a gate is from the region of its engine; an empty text if it leads into it
std::string DescribeMiss(const SVerticalFace& face, const CPhysicsEngine& from,
                         const CPhysicsEngine& to) {
  const TPolygon corners = to.GetVolume().GetCorners();
  CTextOutput text;
  if (!IntersectHeights(from, to).IsShared) {
    const auto [low, high] = to.GetHeightSpan();
    text << "which is " << DescribeHeights({low, high, true});
  } else if (!corners.empty()) {
    const std::optional<CRay2> common = Clip(face.BaseSegment, corners, kTolerance);
    if (!common || !(common->GetLength() > 10.0 * kTolerance)) {
      Real distance = HUGE_VAL;
      for (const CVector2& end : {face.BaseSegment.GetStart(), face.BaseSegment.GetEnd()}) {
        distance = std::min(distance, ComputeDistance(corners, end));
      }
      for (const CVector2& corner : corners) {
        distance = std::min(distance, Distance(FindNearest(face.BaseSegment, corner), corner));
      }
      text << "which is " << distance << " m from it, with the corners " << ListCorners(corners);
    }
  }
  return text.str();
}

std::string DescribeMiss(const SHorizontalFace& face, const CPhysicsEngine& from,
                         const CPhysicsEngine& to) {
  const auto [low, high] = to.GetHeightSpan();
  CTextOutput text;
  if (face.Height < low - kSamePlane || face.Height > high + kSamePlane) {
    text << "which is " << DescribeHeights({low, high, true});
    return text.str();
  }
  const TPolygon mine = from.GetVolume().GetCorners();
  const TPolygon other = to.GetVolume().GetCorners();
  if (!mine.empty() && !other.empty()) {
    const TPolygon shared = Intersect(mine, other);
    if (!(0.5 * ComputeTwiceArea(shared) > kTolerance * ComputePerimeter(shared))) {
      text << "which is beside it, with the corners " << ListCorners(other);
    }
  }
  return text.str();
}

template <typename FACE>
void CheckGate(const FACE& face, const std::string& name, const CPhysicsEngine& from,
               const CPhysicsEngine::TVector& engines) {
  if (face.Gate.empty()) {
    return;
  }
  const auto found = std::ranges::find(engines, face.Gate, &CPhysicsEngine::GetId);
  if (found == engines.end()) {
    std::vector<std::string> ids;
    for (const CPhysicsEngine* engine : engines) {
      if (engine != &from) {
        ids.push_back(engine->GetId());
      }
    }
    THROW_ARGOSEXCEPTION(from.GetOrigin()
                         << ": " << name << " is a gate to \"" << face.Gate
                         << "\", which is not an engine" << DidYouMean(face.Gate, ids));
  }
  if (*found == &from) {
    THROW_ARGOSEXCEPTION(from.GetOrigin() << ": " << name << " is a gate to its own engine");
  }
  const std::string miss = DescribeMiss(face, from, **found);
  if (!miss.empty()) {
    THROW_ARGOSEXCEPTION(from.GetOrigin()
                         << ": " << name << " is a gate that does not lead into the region of "
                         << (*found)->GetOrigin() << ", " << miss);
  }
}

// the parts of the sides of a region that are in the arena or near it
std::vector<CRay2> ClipSides(const CPhysicsEngine& engine, const TPolygon& arena) {
  std::vector<CRay2> sides;
  for (const SVerticalFace* face : engine.GetVolume().SideFaces) {
    if (const std::optional<CRay2> side = Clip(face->BaseSegment, arena, kNear)) {
      sides.push_back(*side);
    }
  }
  return sides;
}

// @return true if the region of another engine is behind a side, or near it.
bool LeadsToAnother(const CRay2& side, const CPhysicsEngine& owner,
                    const CPhysicsEngine::TVector& engines) {
  return std::any_of(engines.begin(), engines.end(), [&](const CPhysicsEngine* other) {
    const TPolygon corners = other->GetVolume().GetCorners();
    return other != &owner && (corners.empty() || Clip(side, corners, kNear));
  });
}

}  // namespace

void CheckPartition(const CPhysicsEngine::TVector& engines, CLoadErrors& errors) {
  for (size_t i = 0; i < engines.size(); ++i) {
    for (size_t j = i + 1; j < engines.size(); ++j) {
      errors.Try("", [&] { CheckPair(*engines[i], *engines[j]); });
    }
  }
  for (const CPhysicsEngine* engine : engines) {
    const SVolume& region = engine->GetVolume();
    if (region.TopFace != nullptr) {
      errors.Try("", [&] { CheckGate(*region.TopFace, "its top", *engine, engines); });
    }
    if (region.BottomFace != nullptr) {
      errors.Try("", [&] { CheckGate(*region.BottomFace, "its bottom", *engine, engines); });
    }
    for (const SVerticalFace* face : region.SideFaces) {
      const CRay2& side = face->BaseSegment;
      const std::string name = "its side from \"" + ToString(side.GetStart()) + "\" to \"" +
                               ToString(side.GetEnd()) + '"';
      errors.Try("", [&] { CheckGate(*face, name, *engine, engines); });
    }
  }
}

void FindBorders(const CPhysicsEngine::TVector& engines, const CRange<CVector3>& arena) {
  const CVector3& low = arena.GetMin();
  const CVector3& high = arena.GetMax();
  const TPolygon inside = {CVector2(low.GetX(), low.GetY()), CVector2(high.GetX(), low.GetY()),
                           CVector2(high.GetX(), high.GetY()), CVector2(low.GetX(), high.GetY())};
  for (CPhysicsEngine* engine : engines) {
    std::vector<CRay2> borders;
    if (engine->GetVolume().SideFaces.empty()) {
      // the sides of the others
      for (const CPhysicsEngine* other : engines) {
        const std::vector<CRay2> sides = ClipSides(*other, inside);
        borders.insert(borders.end(), sides.begin(), sides.end());
      }
    } else {
      for (const CRay2& side : ClipSides(*engine, inside)) {
        if (LeadsToAnother(side, *engine, engines)) {
          borders.push_back(side);
        }
      }
    }
    engine->SetBorders(std::move(borders));
  }
}

}  // namespace argos
