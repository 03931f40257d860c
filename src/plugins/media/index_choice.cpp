#include <argos3/plugins/simulator/media/index_choice.h>

#include <argos3/core/utility/string_utilities.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace argos {

namespace {

// more cells do not make a grid faster
constexpr Real kMaxCells = 1 << 18;
const char* const kNames[] = {"grid", "hash", "dummy"};  // in the order of EKind

}  // namespace

void SIndexChoice::Read(TConfigurationNode& medium, bool withDummy) {
  const std::vector<std::string> names(std::begin(kNames), std::end(kNames) - (withDummy ? 0 : 1));
  std::string index;
  GetNodeAttributeOrDefault<std::string>(medium, "index", index, kNames[0]);
  const auto found = std::find(names.begin(), names.end(), index);
  if (found == names.end()) {
    THROW_ARGOSEXCEPTION(OwnerOf(medium)
                         << ": attribute \"index\" must be "
                         << (withDummy ? "\"grid\", \"hash\" or \"dummy\"" : "\"grid\" or \"hash\"")
                         << ", got \"" << index << "\"" << DidYouMean(index, names));
  }
  Kind = static_cast<EKind>(found - names.begin());
  if (!NodeAttributeExists(medium, "grid_size")) {
    return;
  }
  std::string text;
  GetNodeAttribute(medium, "grid_size", text);
  try {
    CTextInput stream(text);
    SetStrictParsing(stream, true);
    ParseValues<SInt32>(stream, 3, GridSize, ',');
    if (*std::min_element(GridSize, GridSize + 3) < 1) {
      THROW_ARGOSEXCEPTION("each number must be at least 1");
    }
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(medium)
                                    << ": attribute \"grid_size\" must be three integers, "
                                       "\"x,y,z\", got \""
                                    << text << "\"",
                                error);
  }
}

const char* SIndexChoice::GetName() const {
  return kNames[static_cast<size_t>(Kind)];
}

SIndexChoice::SCells SIndexChoice::MakeCells(const CVector3& extent) const {
  SCells cells;
  for (UInt32 axis = 0; axis < 3; ++axis) {
    const Real length = extent[axis] > 0.0 ? extent[axis] : 1.0;
    cells.Extent[axis] = length;
    cells.Number[axis] = GridSize[axis] > 0
                             ? GridSize[axis]
                             : static_cast<SInt32>(std::clamp(std::floor(length), 1.0, kMaxCells));
  }
  const auto multiply = [&cells] {
    return static_cast<Real>(cells.Number[0]) * cells.Number[1] * cells.Number[2];
  };
  // repeated, because an axis with one cell does not shrink
  while (multiply() > kMaxCells) {
    const Real shrink = std::cbrt(kMaxCells / multiply());
    for (SInt32& number : cells.Number) {
      number = std::max(1, static_cast<SInt32>(number * shrink));
    }
  }
  return cells;
}

}  // namespace argos
