#include <argos3/plugins/simulator/entities/observable.h>

#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

CRadians RequireObservableAngle(const CRadians& angle, const std::string& owner) {
  const Real degrees = ToDegrees(angle).GetValue();
  if (!(degrees > 0.0 && degrees <= 180.0)) {
    THROW_ARGOSEXCEPTION(owner << ": observable_angle must be above 0 and at most 180 degrees, got "
                               << degrees);
  }
  return angle;
}

CRadians ReadObservableAngle(TConfigurationNode& tree) {
  CDegrees degrees;
  GetNodeAttribute(tree, "observable_angle", degrees);
  return RequireObservableAngle(ToRadians(degrees), OwnerOf(tree));
}

CObservableCone::CObservableCone(const CRadians& angle) : m_angle(angle), m_cosine(Cos(angle)) {}

bool CObservableCone::Contains(const CPositionalEntity& entity, const CVector3& point) const {
  // all directions, independently of rounding
  if (m_angle >= CRadians::PI) {
    return true;
  }
  CVector3 normal = CVector3::Z;
  normal.Rotate(entity.GetOrientation());
  const CVector3 toPoint = point - entity.GetPosition();
  const Real ahead = normal.DotProduct(toPoint);
  // settles most cases without a root
  if (ahead < 0.0 && m_angle <= CRadians::PI_OVER_TWO) {
    return false;
  }
  return ahead >= m_cosine * toPoint.Length();
}

}  // namespace argos
