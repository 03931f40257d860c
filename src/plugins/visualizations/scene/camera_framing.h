#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_CAMERA_FRAMING_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_SCENE_CAMERA_FRAMING_H

#include <argos3/plugins/simulator/visualizations/scene/camera.h>

#include <Eigen/Core>

#include <array>
#include <string>

namespace argos {

/** A direction of sight with a name, and the lens for it. */
struct SView {
  Eigen::Vector3d ToEye = Eigen::Vector3d::UnitZ(); /**< direction from what is seen, unit vector */
  Eigen::Vector3d Up = Eigen::Vector3d::UnitZ();
  double FocalLength = 50.0; /**< mm; a long lens keeps parallels nearly parallel */
  bool IsOrthographic = false;

  /**
   * @param name  "oblique" (from negative y, 52 degrees above the horizon), "top" (x to the right,
   * y upwards), "side" (from negative y, horizontally), "front" (from positive x, horizontally) or
   * "corner" (from negative x and y; isometric if orthographic).
   * @throws CARGoSException listing the names, with the nearest.
   */
  static SView FromName(const std::string& name);
};

/**
 * Finds the camera of a given direction that just contains points: the nearest one in perspective,
 * the largest scale in orthographic projection.
 *
 * Closed form: with right r, up u, forward f and the tangents t of the half angles of view, a point
 * p is seen from e if |r(p - e)| <= t f(p - e). So the greatest values of +-rp - t fp over all
 * points, and the same for u, give the nearest f e, and then the interval of r e.
 */
class CCameraFraming {
 public:
  /**
   * @param aspectRatio  width of the picture over its height, > 0.
   * @param margin       share of the picture that stays free around the points, >= 0.
   */
  CCameraFraming(const SView& view, double aspectRatio, double margin);

  /** Makes the picture contain a point of the world, m. */
  void Extend(const Eigen::Vector3d& point);
  /** Makes it contain a box, given by two opposite corners. */
  void Extend(const Eigen::Vector3d& least, const Eigen::Vector3d& most);

  /** The camera; a view of a cube of 0.1 m around the origin without points. */
  SCameraPlacement ComputePlacement() const;

 private:
  // a side of the picture, and its points that are farthest out at three slopes of the line of
  // sight
  struct SSide {
    Eigen::Vector3d Outward;  // direction across the line of sight, unit vector
    double Slope;  // tangent of half the angle of view, with the margin; 0: orthographic
    std::array<double, 3> Supports;  // greatest Outward.p - slope f.p, slope = Slope, 1/2 Slope, 0
    std::array<Eigen::Vector3d, 3> Points;  // the points with these supports
  };
  // position of the eye across the line of sight, between two opposite sides
  double ComputeAcross(const SSide& high, const SSide& low, double depth) const;
  SCameraPlacement ComputeParallel(SCameraPlacement placement) const;

  SView m_view;
  double m_aspectRatio;
  double m_margin;
  Eigen::Vector3d m_forward;
  std::array<SSide, 4> m_sides;  // right, left, up, down
  double m_least = 0.0;  // depths of all points, m
  double m_most = 0.0;
  bool m_isEmpty = true;
};

}  // namespace argos

#endif
