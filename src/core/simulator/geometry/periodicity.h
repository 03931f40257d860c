#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_PERIODICITY_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_PERIODICITY_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/core/utility/spatial/planar_grid.h>

#include <algorithm>
#include <cmath>

namespace argos {

/** One axis of the ground. If it is periodic, its two ends are the same line, the seam. */
struct SPeriodicAxis {
  Real Min = 0.0; /**< m, world frame: one end */
  Real Period = 0.0; /**< m; to the other end; 0 if the axis is not periodic */

  bool IsOn() const { return Period > 0.0; }
  /** @return how often a coordinate, m, is beyond the ends: negative below the lower one. */
  Real CountTurns(Real x) const {
    // without a rounding for what is inside
    return !IsOn() || (x >= Min && x < Min + Period) ? 0.0 : std::floor((x - Min) / Period);
  }
  /** @return the coordinate, m, of the same place between the ends: in [Min, Min + Period). */
  Real Wrap(Real x) const {
    const Real turns = CountTurns(x);
    if (turns == 0.0) {
      return x;
    }
    const Real wrapped = x - turns * Period;
    return wrapped >= Min && wrapped < Min + Period ? wrapped : Min;
  }
  /**
   * @return the shortest of the differences that two coordinates have, m: in [-Period / 2, Period /
   * 2]; exchanging the coordinates only changes the sign.
   */
  Real Shorten(Real difference) const {
    // most are short
    if (!IsOn() || std::abs(difference) <= 0.5 * Period) {
      return difference;
    }
    return difference - Period * std::nearbyint(difference / Period);
  }
  /** @return true for one of all differences that two coordinates have: no other one is shorter. */
  bool IsShortest(Real difference) const {
    return !IsOn() || (difference >= -0.5 * Period && difference < 0.5 * Period);
  }
  /** @return the multiple of the period that is nearest to a difference, m. */
  Real RoundToPeriods(Real difference) const {
    return IsOn() ? Period * std::nearbyint(difference / Period) : 0.0;
  }
};

/**
 * Which sides of the arena are joined: what leaves through one comes back through the opposite one.
 *
 * Places that differ by whole periods are one place, and the bodies there are images of one body.
 */
struct SPeriodicity {
  SPeriodicAxis X, Y;

  bool IsOn() const { return X.IsOn() || Y.IsOn(); }
  CVector3 Wrap(const CVector3& place) const {
    return CVector3(X.Wrap(place.GetX()), Y.Wrap(place.GetY()), place.GetZ());
  }
  /** @return the shortest of the vectors between two places, given one of them, m. */
  CVector3 Shorten(const CVector3& difference) const {
    return CVector3(X.Shorten(difference.GetX()), Y.Shorten(difference.GetY()), difference.GetZ());
  }
  /** @return the displacement of the image of a place that is nearest to another one, m. */
  CVector3 FindImage(const CVector3& place, const CVector3& to) const {
    return CVector3(X.RoundToPeriods(to.GetX() - place.GetX()),
                    Y.RoundToPeriods(to.GetY() - place.GetY()), 0.0);
  }
  /** @return that image; @p place itself, to the bit, if it is the nearest. */
  CVector3 FindNearest(const CVector3& place, const CVector3& to) const {
    return IsOn() ? place + FindImage(place, to) : place;
  }

  /**
   * Calls visit(dx, dy) for each displacement by whole periods, m, that moves a rectangle to where
   * it touches another one. Without periods, (0, 0) is the only one. Ends are included.
   */
  template <typename VISIT>
  void ForDisplacements(const SPlanarArea& area, const SPlanarArea& other, VISIT&& visit) const {
    const SRange alongX = FindDisplacements(X, area.MinX, area.MaxX, other.MinX, other.MaxX);
    const SRange alongY = FindDisplacements(Y, area.MinY, area.MaxY, other.MinY, other.MaxY);
    for (Real j = alongY.First; j <= alongY.Last; j += 1.0) {
      for (Real i = alongX.First; i <= alongX.Last; i += 1.0) {
        visit(i * X.Period, j * Y.Period);
      }
    }
  }

  /**
   * The same for displacements to where parts of bodies in the arena may be: these reach no farther
   * out of it than a quarter of a period.
   */
  template <typename VISIT>
  void ForDisplacements(const SPlanarArea& area, VISIT&& visit) const {
    const Real marginX = 0.25 * X.Period;
    const Real marginY = 0.25 * Y.Period;
    ForDisplacements(
        area,
        {X.Min - marginX, Y.Min - marginY, X.Min + X.Period + marginX, Y.Min + Y.Period + marginY},
        visit);
  }

 private:
  struct SRange {
    Real First, Last;  // periods
  };
  // of what is farther than this around the arena, some images are left out
  static constexpr Real kMaxTurns = 32.0;

  static SRange FindDisplacements(const SPeriodicAxis& axis, Real min, Real max, Real otherMin,
                                  Real otherMax) {
    if (!axis.IsOn()) {
      return {0.0, 0.0};
    }
    return {std::clamp(std::ceil((otherMin - max) / axis.Period), -kMaxTurns, kMaxTurns),
            std::clamp(std::floor((otherMax - min) / axis.Period), -kMaxTurns, kMaxTurns)};
  }
};

}  // namespace argos

#endif
