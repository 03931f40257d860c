#include <argos3/plugins/simulator/entities/light_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/simulator/entities/lights.h>
#include <argos3/plugins/simulator/entities/read_medium.h>

#include <cmath>

namespace argos {

namespace {

constexpr Real kBulbDiameter = 0.1;  // m; only drawn

}  // namespace

CLightEntity::CLightEntity() : CLEDEntity(nullptr) {
  MakeAppearance();
}

CLightEntity::CLightEntity(const std::string& id, const CVector3& position, const CColor& color,
                           Real intensity)
    : CLEDEntity(nullptr, id, position, color) {
  SetIntensity(intensity);
  MakeAppearance();
}

void CLightEntity::Init(TConfigurationNode& tree) {
  CLEDEntity::Init(tree);
  GetNodeAttribute(tree, "intensity", m_intensity);
  SetMedium(ReadMedium<CLEDEntity::CRegistry>(tree, CurrentSimulator(), "an LED medium"));
  Enable();
  MakeAppearance();
}

void CLightEntity::SetIntensity(Real intensity) {
  CRobotsCode::CheckShared(*this, "SetIntensity()");
  if (!std::isfinite(intensity)) {
    THROW_ARGOSEXCEPTION("light \"" << GetId() << "\": the intensity must be finite, got "
                                    << intensity);
  }
  KeepForReset(m_intensity);
  m_intensity = intensity;
}

void CLightEntity::SetColor(const CColor& color) {
  CRobotsCode::CheckShared(*this, "SetColor()");
  CLEDEntity::SetColor(color);
  MakeAppearance();
}

void CLightEntity::MakeAppearance() {
  m_appearance.Parts.resize(1);
  SVisualPart& bulb = m_appearance.Parts.front();
  bulb.Kind = SVisualPart::EKind::Sphere;
  bulb.Size = CVector3(kBulbDiameter, kBulbDiameter, kBulbDiameter);
  bulb.Material = EMaterial::Glass;
  bulb.Color = GetColor();
}

void CLightEntity::UpdateDigest(CDigest& digest) const {
  CLEDEntity::UpdateDigest(digest);
  digest.Add(m_intensity);
}

namespace {

class CSpaceOperationAddCLightEntity : public CSpaceOperationAddEntity {
 public:
  void ApplyTo(CSpace& space, CLightEntity& light) {
    space.AddEntity(light);
    space.GetExtension<CLights>().Add(light);
  }
};

class CSpaceOperationRemoveCLightEntity : public CSpaceOperationRemoveEntity {
 public:
  void ApplyTo(CSpace& space, CLightEntity& light) {
    space.GetExtension<CLights>().Remove(light);
    space.RemoveEntity(light);
  }
};

}  // namespace

REGISTER_SPACE_OPERATION(CSpaceOperationAddEntity, CSpaceOperationAddCLightEntity, CLightEntity)
REGISTER_SPACE_OPERATION(CSpaceOperationRemoveEntity, CSpaceOperationRemoveCLightEntity,
                         CLightEntity)

REGISTER_ENTITY(
    CLightEntity, "light", "the authors of this project", "1.0",
    "A lamp for light sensors and cameras.",
    R"(A point of light without a body: it neither collides with bodies nor occludes them.
Light sensors measure its intensity; cameras see it as an LED.

REQUIRED XML

  <arena size="10,10,2">
    <light id="lamp" position="0.4,2.3,0.25" color="yellow" intensity="1.0" medium="leds" />
  </arena>

with its LED medium:

  <media>
    <led id="leds" />
  </media>

ATTRIBUTES

  id           text, required: unique among the entities of the arena.
  position     "x,y,z", m, default "0,0,0": the centre, in the world frame.
  orientation  "z,y,x", degrees, default "0,0,0": ignored.
  color        a colour name or "R,G,B,A" with integers 0-255, required: seen by cameras.
  intensity    real number, required: the distance, in m, at which the generic light sensor reads 1.
               With 0 or less the lamp is off for light sensors and in pictures; cameras ignore
               the intensity.
  medium       text, required: the id of an LED medium.
)",
    "Usable")

}  // namespace argos
