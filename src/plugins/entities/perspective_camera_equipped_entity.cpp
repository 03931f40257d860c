#include <argos3/plugins/simulator/entities/perspective_camera_equipped_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <cmath>

namespace argos {

namespace {

// values of ARGoS 3
constexpr Real kPerspectiveAperture = 30.0;  // degrees
constexpr Real kDefaultFocalLength = 0.035;  // m
constexpr Real kDefaultRange = 2.0;  // m
constexpr SInt32 kDefaultWidth = 640;
constexpr SInt32 kDefaultHeight = 480;

}  // namespace

CPerspectiveCameraEquippedEntity::CPerspectiveCameraEquippedEntity(CComposableEntity* parent)
    : CEntity(parent),
      m_aperture(ToRadians(CDegrees(kPerspectiveAperture))),
      m_focalLength(kDefaultFocalLength),
      m_range(kDefaultRange),
      m_width(kDefaultWidth),
      m_height(kDefaultHeight) {
  CEntity::SetEnabled(false);
}

CPerspectiveCameraEquippedEntity::CPerspectiveCameraEquippedEntity(
    CComposableEntity* parent, const std::string& id, const CRadians& aperture, Real focalLength,
    Real range, SInt32 width, SInt32 height, SAnchor& anchor)
    : CEntity(parent, id), m_anchor(&anchor) {
  SetAperture(aperture);
  SetFocalLength(focalLength);
  SetRange(range);
  SetImagePxSize(width, height);
  CEntity::SetEnabled(false);
}

std::string CPerspectiveCameraEquippedEntity::Describe() const {
  return "camera \"" + GetContext() + GetId() + "\"";
}

void CPerspectiveCameraEquippedEntity::Reset() {
  CEntity::Reset();
  SetPanTilt(CRadians(), CRadians());
}

void CPerspectiveCameraEquippedEntity::SetEnabled(bool enabled) {
  if (enabled == IsEnabled()) {
    return;
  }
  CEntity::SetEnabled(enabled);
  if (m_anchor != nullptr) {
    UseAnchor(*m_anchor, enabled);
  }
}

void CPerspectiveCameraEquippedEntity::SetAperture(const CRadians& aperture) {
  CRobotsCode::CheckOwn(*this, "SetAperture()");
  RequireAperture(aperture, Describe(), "aperture");
  KeepForReset(m_aperture);
  m_aperture = aperture;
}

void CPerspectiveCameraEquippedEntity::SetFocalLength(Real focalLength) {
  CRobotsCode::CheckOwn(*this, "SetFocalLength()");
  RequirePositive(focalLength, Describe(), "focal length (m)");
  KeepForReset(m_focalLength);
  m_focalLength = focalLength;
}

void CPerspectiveCameraEquippedEntity::SetRange(Real range) {
  CRobotsCode::CheckOwn(*this, "SetRange()");
  RequirePositive(range, Describe(), "range (m)");
  KeepForReset(m_range);
  m_range = range;
}

void CPerspectiveCameraEquippedEntity::SetImagePxSize(SInt32 width, SInt32 height) {
  CRobotsCode::CheckOwn(*this, "SetImagePxSize()");
  if (width < 1 || height < 1) {
    THROW_ARGOSEXCEPTION(Describe() << ": width and height of the image must be at least 1 pixel, "
                                    << "got " << width << " and " << height);
  }
  KeepForReset(m_width);
  KeepForReset(m_height);
  m_width = width;
  m_height = height;
}

Real CPerspectiveCameraEquippedEntity::GetImageMtWidth() const {
  return GetImageMtHeight() * m_width / m_height;
}

// the aperture reaches to the corners of the image
Real CPerspectiveCameraEquippedEntity::GetImageMtHeight() const {
  const Real aspect = static_cast<Real>(m_width) / m_height;
  return 2.0 * m_focalLength * Tan(m_aperture) / std::sqrt(1.0 + aspect * aspect);
}

const SAnchor& CPerspectiveCameraEquippedEntity::GetAnchor() const {
  if (m_anchor == nullptr) {
    THROW_ARGOSEXCEPTION(Describe() << " has no anchor");
  }
  return *m_anchor;
}

void CPerspectiveCameraEquippedEntity::SetAnchor(SAnchor& anchor) {
  CRobotsCode::CheckOwn(*this, "SetAnchor()");
  KeepForReset(&m_anchor, [this, start = m_anchor] { FixTo(start); });
  FixTo(&anchor);
}

// the anchor is in use while the camera is enabled
void CPerspectiveCameraEquippedEntity::FixTo(SAnchor* anchor) {
  const bool enabled = IsEnabled();
  SetEnabled(false);
  m_anchor = anchor;
  SetEnabled(enabled);
}

void CPerspectiveCameraEquippedEntity::SetMount(const CVector3& offset,
                                                const CQuaternion& orientation) {
  CRobotsCode::CheckOwn(*this, "SetMount()");
  KeepForReset(m_offset);
  KeepForReset(m_orientation);
  m_offset = offset;
  m_orientation = orientation;
  SetPanTilt(m_pan, m_tilt);
}

void CPerspectiveCameraEquippedEntity::SetPanTilt(const CRadians& pan, const CRadians& tilt) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "SetPanTilt()");
  }
  m_pan = pan;
  m_tilt = tilt;
  m_mountAndTurn = m_orientation * CQuaternion(pan, CVector3::Z) * CQuaternion(tilt, CVector3::Y);
}

CVector3 CPerspectiveCameraEquippedEntity::ComputePosition() const {
  const SAnchor& anchor = GetAnchor();
  CVector3 position = m_offset;
  position.Rotate(anchor.Orientation);
  return position + anchor.Position;
}

CQuaternion CPerspectiveCameraEquippedEntity::ComputeView() const {
  return GetAnchor().Orientation * m_mountAndTurn;
}

void CPerspectiveCameraEquippedEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  digest.Add(m_pan.GetValue());
  digest.Add(m_tilt.GetValue());
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CPerspectiveCameraEquippedEntity)

}  // namespace argos
