// Fields of poses.

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/anchor.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/outputs/field.h>
#include <argos3/core/simulator/outputs/root_components.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <cmath>

namespace argos {

namespace {

constexpr std::size_t kNumPose = 7;  // x, y, z, and the quaternion

/* Reads the pose of an entity with a position: a body, or a light. */
class CPoseReader : public CFieldReader {
 public:
  CPoseReader(const CVector3& position, const CQuaternion& orientation)
      : m_position(position), m_orientation(orientation) {}

  void Read(std::size_t /*index*/, SFieldRow row) override {
    row.Numbers[0] = m_position.GetX();
    row.Numbers[1] = m_position.GetY();
    row.Numbers[2] = m_position.GetZ();
    row.Numbers[3] = m_orientation.GetW();
    row.Numbers[4] = m_orientation.GetX();
    row.Numbers[5] = m_orientation.GetY();
    row.Numbers[6] = m_orientation.GetZ();
  }

 private:
  const CVector3& m_position;
  const CQuaternion& m_orientation;
};

std::unique_ptr<CFieldReader> MakePoseReader(CEntity& root) {
  if (auto* const body = FindExisting<CEmbodiedEntity>(root)) {
    const SAnchor& anchor = body->GetOriginAnchor();
    return std::make_unique<CPoseReader>(anchor.Position, anchor.Orientation);
  }
  if (auto* const placed = FindExisting<CPositionalEntity>(root)) {
    return std::make_unique<CPoseReader>(placed->GetPosition(), placed->GetOrientation());
  }
  return nullptr;
}

class CPoseField : public CField {
 public:
  SBoundField Bind(CEntity& root, const std::string& /*argument*/) const override {
    return {MakePoseReader(root), {{"x", "m"}, {"y", "m"}, {"z", "m"}, {"yaw", "rad"}}};
  }

  std::size_t GetNumRaw() const override { return kNumPose; }

  // the direction of the body's x axis over the ground
  void Derive(double* numbers) const override {
    const double w = numbers[3];
    const double x = numbers[4];
    const double y = numbers[5];
    const double z = numbers[6];
    numbers[3] = std::atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z));
  }
};

class COrientationField : public CField {
 public:
  SBoundField Bind(CEntity& root, const std::string& /*argument*/) const override {
    return {MakePoseReader(root), {{"qw", ""}, {"qx", ""}, {"qy", ""}, {"qz", ""}}};
  }

  std::size_t GetNumRaw() const override { return kNumPose; }

  void Derive(double* numbers) const override {
    for (int i = 0; i < 4; ++i) {
      numbers[i] = numbers[3 + i];
    }
  }
};

/* Reads where a body would be without periodic sides of the arena. */
class CUnwrappedReader : public CFieldReader {
 public:
  explicit CUnwrappedReader(const CEmbodiedEntity& body) : m_body(body) {}

  void Read(std::size_t /*index*/, SFieldRow row) override {
    const CVector3 place = m_body.GetUnwrappedPosition();
    row.Numbers[0] = place.GetX();
    row.Numbers[1] = place.GetY();
  }

 private:
  const CEmbodiedEntity& m_body;
};

class CUnwrappedField : public CField {
 public:
  SBoundField Bind(CEntity& root, const std::string& /*argument*/) const override {
    auto* const body = FindExisting<CEmbodiedEntity>(root);
    // a replay, which may jump, does not count how often bodies go round; it has what was recorded
    const SSimulationContext& context = CurrentContext();
    const bool isKnown = body != nullptr && !(context.IsReplay && context.Arena.Period.IsOn());
    return {isKnown ? std::make_unique<CUnwrappedReader>(*body) : nullptr,
            {{"unwrapped_x", "m"}, {"unwrapped_y", "m"}}};
  }
};

}  // namespace

REGISTER_FIELD(
    CPoseField, "pose", "the authors of this project", "1.0",
    "Position and heading: x, y, z (m), yaw (rad).",
    R"(Columns x, y, z: the origin of the body, the centre of its base, in the world frame, m.
Column yaw: the angle from the world's x axis to that of the body, seen from above,
in [-pi, pi], rad. The field "orientation" has the whole rotation. Entities: all with a body, and lights.
)",
    "Usable")
REGISTER_FIELD(
    CUnwrappedField, "unwrapped", "the authors of this project", "1.0",
    "Position as if a periodic arena went on: unwrapped_x, unwrapped_y (m).",
    R"(Columns unwrapped_x, unwrapped_y: x and y of the field "pose", plus the extent of the arena for each time that the
body has left through an upper side and minus it for each lower one, m. The difference of two rows is the displacement
between them, as a mean square displacement needs it. In an arena without periodic="..." they are x and y. A replay of a run with it has them only if they were recorded. Entities: all
with a body.
)",
    "Usable")
REGISTER_FIELD(
    COrientationField, "orientation", "the authors of this project", "1.0",
    "Orientation as a unit quaternion: qw, qx, qy, qz.",
    R"(Columns qw, qx, qy, qz: the rotation from the frame of the body to the world frame.
Entities: all with a body, and lights.
)",
    "Usable")

}  // namespace argos
