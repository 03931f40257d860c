#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_ARTICULATION_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_ARTICULATION_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/vector3.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace argos {

/** A joint between two links of a body; its frame is that of the body before anything moved. */
struct SJointDescription {
  enum class EKind : UInt8 {
    Hinge, /**< the child turns about Axis; the coordinate is the angle, rad */
    Slider, /**< the child moves along Axis; the coordinate is the distance, m */
    Ball /**< the child turns about Pivot; it has no coordinate and no motor */
  };

  std::string Id;
  EKind Kind = EKind::Hinge;
  UInt32 Parent = 0; /**< number of a link */
  UInt32 Child = 0; /**< number of a link: it moves by the coordinate relative to the parent */
  CVector3 Pivot; /**< m, body frame at the start */
  CVector3 Axis = CVector3::Z; /**< has unit length; body frame at the start */
  std::optional<CRange<Real>> Limits; /**< limits of the coordinate, which is 0 at the start */
  bool LinksCollide = false; /**< true if the two links collide with each other */
};

/**
 * The links of a body that joints move.
 *
 * Link 0 is the reference link: it carries the origin anchor. Joint i moves link i + 1, which is
 * its child or its parent, relative to a link with a lower number. SShapeDescription::Link says
 * which solids a link has.
 */
struct SArticulation {
  std::vector<SJointDescription> Joints; /**< has at least one entry */
  std::map<std::string, UInt32> Anchors; /**< links of the body's anchors, by id; others: link 0 */
  bool HasFixedBase = false; /**< true if link 0 is fixed to the world */

  size_t GetNumLinks() const { return Joints.size() + 1; }
};

}  // namespace argos

#endif
