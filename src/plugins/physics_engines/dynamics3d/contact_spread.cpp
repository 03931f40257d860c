#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_spread.h>

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace argos {

namespace {

CVector3 PointOf(const dContactGeom& contact) {
  return FromODE(contact.pos);
}

// the contact for which measure(contact) is greatest; of equals, the first
template <typename MEASURE>
int FindGreatest(const dContactGeom* contacts, int count, MEASURE&& measure) {
  int best = 0;
  Real greatest = -HUGE_VAL;
  for (int i = 0; i < count; ++i) {
    const Real value = measure(contacts[i]);
    if (value > greatest) {
      best = i;
      greatest = value;
    }
  }
  return best;
}

// Selects four contacts that support the body as all of them do: the deepest one, the one farthest
// from it, and the ones farthest from their line on both sides.
std::array<int, 4> ChooseSpread(const dContactGeom* contacts, int count) {
  const int deepest =
      FindGreatest(contacts, count, [](const dContactGeom& each) { return each.depth; });
  const CVector3 start = PointOf(contacts[deepest]);
  const int farthest = FindGreatest(contacts, count, [&start](const dContactGeom& each) {
    return (PointOf(each) - start).SquareLength();
  });
  const CVector3 across =
      Cross(PointOf(contacts[farthest]) - start, FromODE(contacts[deepest].normal));
  const auto measureSide = [&](Real side) {
    return FindGreatest(contacts, count, [&](const dContactGeom& each) {
      return side * across.DotProduct(PointOf(each) - start);
    });
  };
  return {deepest, farthest, measureSide(1.0), measureSide(-1.0)};
}

}  // namespace

int KeepSpread(const dContactGeom* contacts, int count, int most, dContactGeom* kept, int skip) {
  std::array<int, 4> chosen = {0, 1, 2, 3};
  if (count > most || count > 4) {
    chosen = ChooseSpread(contacts, count);
  }
  int number = 0;
  for (int i = 0; i < std::min({count, most, 4}); ++i) {
    // if they are in a line, one may be selected twice
    if (std::find(chosen.begin(), chosen.begin() + i, chosen[i]) == chosen.begin() + i) {
      ContactAt(kept, number++, skip) = contacts[chosen[i]];
    }
  }
  return number;
}

}  // namespace argos
