#include <argos3/plugins/robots/generic/simulator/pinhole_camera.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <cmath>

namespace argos {

namespace {

CVector2 ReadPositivePair(TConfigurationNode& tree, const std::string& attribute) {
  CVector2 pair;
  GetNodeAttribute(tree, attribute, pair);
  if (!(pair.GetX() > 0.0 && pair.GetY() > 0.0)) {
    THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": attribute \"" << attribute
                                       << "\" (pixels) must be two numbers > 0, got " << pair);
  }
  return pair;
}

}  // namespace

CPinholeCamera::CPinholeCamera(TConfigurationNode& tree, CEmbodiedEntity& body) {
  std::string anchor;
  GetNodeAttribute(tree, "anchor", anchor);
  try {
    m_anchor = &body.GetAnchor(anchor);
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(tree) << ": attribute \"anchor\"", error);
  }
  GetNodeAttribute(tree, "position", m_offset);
  GetNodeAttribute(tree, "orientation", m_mount);
  GetNodeAttribute(tree, "range", m_range);
  if (!(m_range.GetMin() >= 0.0 && m_range.GetMax() > m_range.GetMin() &&
        std::isfinite(m_range.GetMax()))) {
    THROW_ARGOSEXCEPTION(OwnerOf(tree)
                         << ": attribute \"range\" (m) must be \"min:max\" with "
                         << "0 <= min < max, got " << m_range.GetMin() << ":" << m_range.GetMax());
  }
  m_focalLength = ReadPositivePair(tree, "focal_length");
  GetNodeAttribute(tree, "principal_point", m_principalPoint);
  m_resolution = ReadPositivePair(tree, "resolution");
  Update();
}

void CPinholeCamera::SetInUse(bool inUse) {
  if (inUse != m_inUse) {
    UseAnchor(*m_anchor, inUse);
  }
  m_inUse = inUse;
}

void CPinholeCamera::Update() {
  m_position = m_offset;
  m_position.Rotate(m_anchor->Orientation);
  m_position += m_anchor->Position;
  m_orientation = m_anchor->Orientation * m_mount;
  m_right = CVector3::X;
  m_right.Rotate(m_orientation);
  m_down = CVector3::Y;
  m_down.Rotate(m_orientation);
  m_ahead = CVector3::Z;
  m_ahead.Rotate(m_orientation);
  const CVector2 first = -m_principalPoint;
  const CVector2 last = m_resolution - m_principalPoint;
  m_volume = CViewVolume(
      SFrustum{m_position,
               m_right,
               m_down,
               m_ahead,
               m_range,
               {first.GetX() / m_focalLength.GetX(), last.GetX() / m_focalLength.GetX()},
               {first.GetY() / m_focalLength.GetY(), last.GetY() / m_focalLength.GetY()}});
}

std::array<CVector3, 8> CPinholeCamera::ComputeCorners() const {
  const CVector2 pixels[4] = {CVector2(), CVector2(m_resolution.GetX(), 0.0), m_resolution,
                              CVector2(0.0, m_resolution.GetY())};
  std::array<CVector3, 8> corners;
  for (size_t i = 0; i < corners.size(); ++i) {
    const CVector2 fromCenter = pixels[i % 4] - m_principalPoint;
    const Real depth = i < 4 ? m_range.GetMin() : m_range.GetMax();
    corners[i] = CVector3(fromCenter.GetX() / m_focalLength.GetX(),
                          fromCenter.GetY() / m_focalLength.GetY(), 1.0) *
                 depth;
    corners[i].Rotate(m_orientation);
    corners[i] += m_position;
  }
  return corners;
}

}  // namespace argos
