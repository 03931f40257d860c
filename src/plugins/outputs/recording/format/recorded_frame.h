#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RECORDED_FRAME_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_RECORDED_FRAME_H

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/core/simulator/geometry/bounding_box.h>
#include <argos3/core/simulator/visualization/appearance.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/** What the recorded entities of a type have in common: all that is needed to draw them. */
struct SRecordedType {
  enum class EKind : UInt8 {
    Body, /**< a body with anchors, perhaps a robot */
    Place, /**< has a pose, but no body */
    Light, /**< a lamp: words are its colour and its intensity */
    Floor, /**< the coloured ground; Parameter = pixels per metre; of an image
                width + (height << kHeightShift), pixels */
    Other /**< neither pose nor appearance: only listed */
  };

  EKind Kind = EKind::Other;
  std::string Tag; /**< tag in XML: "foot-bot", "box", ... */
  bool IsRobot = false; /**< has a controller */
  bool IsMovable = false;
  bool Flies = false; /**< has propellers: views then show the height of the arena */
  bool HasAppearance = false;
  /** Bits of the parameter of a floor's image below its height. */
  static constexpr unsigned kHeightShift = 32;
  UInt64 Parameter = 0; /**< see Kind */
  UInt32 NumLEDs = 0;
  /** What the body consists of, in its frame; hulls are boxes; empty: unknown, see Box. */
  std::vector<SShapeDescription> Solids;
  SBoundingBox Box; /**< around the body at the origin, not turned, m; no extent: unknown */
  SAppearance Appearance;
  std::vector<std::string>
      Anchors; /**< ids of those, besides the origin, whose poses are recorded */

  /** Poses of an entity: its own, and one for each anchor. */
  size_t GetNumPoses() const {
    return Kind == EKind::Floor || Kind == EKind::Other ? 0 : 1 + Anchors.size();
  }
  /** Words of an entity: flags (see EEntityFlags), then a colour for each LED, or see Light. */
  size_t GetNumWords() const { return Kind == EKind::Light ? 4 : 1 + NumLEDs; }
};

/** Bits of the first word of an entity. */
enum EEntityFlags : UInt32 {
  ENTITY_IS_QUARANTINED = 1, /**< an error has stopped the robot, and it was taken out */
  ENTITY_IS_STOPPED = 2 /**< an error has stopped the robot */
};

/** A recorded entity; its number is its place in the list of all. */
struct SRecordedEntity {
  std::string Id;
  UInt32 Type = 0; /**< place in the list of types */
};

/** A ray of a sensor that pictures show, or a point (start = end). */
struct SRecordedRay {
  enum class EKind : UInt8 { Free, Obstructed, HitPoint };

  UInt32 Robot = 0; /**< number of the entity; rays are sorted by it */
  EKind Kind = EKind::Free;
  CVector3 Start; /**< m, world frame */
  CVector3 End;
};

/** Colours of the ground, three bytes a pixel, the row of the lowest y first. */
struct SRecordedFloor {
  UInt32 Width = 0; /**< pixels; 0: there is no floor */
  UInt32 Height = 0;
  std::string Pixels; /**< red, green, blue of each; (Height, Width, 3) */

  bool operator==(const SRecordedFloor& other) const = default;
};

/** A column of a field that users choose to record in addition, such as a reading. */
struct SRecordedColumn {
  std::string Field; /**< users name it so, such as "readings:proximity" */
  std::string Name; /**< name of the column, such as "proximity_1" */
  std::string Unit;
  bool IsText = false; /**< values are places in Texts */
  std::vector<Real> Values; /**< one for each entity; NaN where an entity has none */
  std::vector<std::string> Texts;
};

/** A number of the whole run. */
struct SRecordedMetric {
  std::string Name;
  std::string Unit;
  Real Value = 0.0; /**< NaN: none yet */

  bool operator==(const SRecordedMetric& other) const = default;
};

/** What a user has changed in the run, see CRunCommands. */
struct SRecordedCommand {
  UInt32 Tick = 0; /**< after which it was given; before that of the frame, or the last frame's */
  std::string Text;

  bool operator==(const SRecordedCommand& other) const = default;
};

/** What a view shows of one tick, but for the list of entities. */
struct SShownState {
  std::vector<SBodyPose> Poses; /**< poses of all entities, in their order, see GetNumPoses() */
  std::vector<UInt32> Words; /**< the same, see GetNumWords() */
  std::vector<SRecordedRay> Rays;
  std::shared_ptr<const SRecordedFloor> Floor; /**< null: none; another object if it changed */
  std::vector<SRecordedColumn> Columns;
  std::vector<SRecordedMetric> Metrics;
  std::vector<SRecordedCommand> Commands; /**< commands since the last frame */
  std::string Drawing; /**< drawings of users' code, in a form that the caller knows */
};

/**
 * All that a view shows of one tick, as a difference to the last one in the list of entities: first
 * entities are removed, then others are added at the end.
 */
struct SFrameUpdate : SShownState {
  UInt32 Tick = 0;
  bool IsRestart = false; /**< all entities and types of the last frame are forgotten */
  std::vector<SRecordedType> NewTypes; /**< added to the list of types */
  std::vector<UInt32> Removed; /**< numbers in the last frame, ascending */
  std::vector<SRecordedEntity> Added;

  /** Ready for the next tick; keeps memory. */
  void Clear();
  /** Memory in use, bytes. */
  size_t ComputeSize() const;
};

/** All that a view shows of one tick. */
struct SRecordedFrame : SShownState {
  UInt32 Tick = 0;
  std::vector<SRecordedType> Types;
  std::vector<SRecordedEntity> Entities; /**< have the order of the space */
  UInt64 EntitiesVersion = 0; /**< changes with Entities and Types */
};

/** Colour as a word. */
inline UInt32 PackColor(const CColor& color) {
  return color.GetRed() | UInt32(color.GetGreen()) << 8 | UInt32(color.GetBlue()) << 16 |
         UInt32(color.GetAlpha()) << 24;
}

inline CColor UnpackColor(UInt32 word) {
  return CColor(static_cast<UInt8>(word), static_cast<UInt8>(word >> 8),
                static_cast<UInt8>(word >> 16), static_cast<UInt8>(word >> 24));
}

}  // namespace argos

#endif
