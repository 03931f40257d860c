#include <argos3/plugins/robots/generic/simulator/described_parts.h>

#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

namespace {

// "(x,y,z)(x,y,z)..."
std::vector<CVector3> ReadPoints(TConfigurationNode& node) {
  std::string text;
  GetNodeText(node, text);
  std::vector<CVector3> points;
  size_t end = 0;
  for (size_t start = text.find('('); start != std::string::npos; start = text.find('(', end)) {
    end = text.find(')', start);
    if (end == std::string::npos) {
      THROW_ARGOSEXCEPTION("a parenthesis is missing in \"" << text << "\"");
    }
    points.push_back(FromString<CVector3>(text.substr(start + 1, end - start - 1)));
  }
  return points;
}

// LEDs or sensors
constexpr UInt64 kMaxInRing = 10000;

SShapeDescription MakeSolid(TConfigurationNode& node, const std::string& geometry) {
  if (geometry == "box") {
    CVector3 size;
    GetNodeAttribute(node, "size", size);
    return SShapeDescription::Box(size);
  }
  if (geometry == "convex_hull") {
    return SShapeDescription::Hull(ReadPoints(node));
  }
  if (geometry != "cylinder" && geometry != "sphere") {
    THROW_ARGOSEXCEPTION("unknown geometry \""
                         << geometry << "\""
                         << DidYouMean(geometry, {"box", "convex_hull", "cylinder", "sphere"}));
  }
  Real radius = 0.0;
  ReadPositive(node, "radius", "m", radius);
  if (geometry == "sphere") {
    return SShapeDescription::Sphere(radius);
  }
  Real height = 0.0;
  ReadPositive(node, "height", "m", height);
  return SShapeDescription::Cylinder(radius, height);
}

}  // namespace

SShapeDescription ReadSolid(TConfigurationNode& node) {
  std::string geometry;
  GetNodeAttribute(node, "geometry", geometry);
  try {
    return MakeSolid(node, geometry);
  } catch (CARGoSException& error) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(node) << ": wrong geometry", error);
  }
}

SDescribedRing::SDescribedRing(TConfigurationNode& node, const char* number) {
  CDegrees start;
  GetNodeAttributeOrDefault(node, "center", Center, Center);
  GetNodeAttribute(node, "radius", Radius);
  RequireNotNegative(Radius, OwnerOf(node), "attribute \"radius\" (m)");
  GetNodeAttributeOrDefault(node, "start_angle", start, start);
  Start = ToRadians(start);
  GetNodeAttribute(node, number, Number);
  RequireCount(Number, 1, kMaxInRing, OwnerOf(node), std::string("attribute \"") + number + "\"");
}

void ReadRays(TConfigurationNode& node,
              const std::function<void(TConfigurationNode&, const SSensorRay&)>& add) {
  TConfigurationNodeIterator child;
  for (child = child.begin(&node); child != child.end(); ++child) {
    SRayLayout layout;
    Real range = 0.0;
    if (child->Value() == "sensor") {
      CVector3 offset;
      CVector3 direction;
      GetNodeAttribute(*child, "offset", offset);
      GetNodeAttribute(*child, "direction", direction);
      ReadPositive(*child, "range", "m", range);
      if (!(direction.Length() > 0.0)) {
        THROW_ARGOSEXCEPTION(OwnerOf(*child) << ": attribute \"direction\" must not be zero");
      }
      layout.AddSensor(offset, direction, range);
    } else if (child->Value() == "ring") {
      const SDescribedRing ring(*child, "num_sensors");
      ReadPositive(*child, "range", "m", range);
      layout.AddSensorFan(ring.Center, ring.Radius, ring.Start, ring.Start + CRadians::TWO_PI,
                          range, ring.Number);
    } else {
      THROW_ARGOSEXCEPTION(OwnerOf(*child) << ": unknown child of <" << node.Value() << ">"
                                           << DidYouMean(child->Value(), {"ring", "sensor"}));
    }
    for (const SSensorRay& ray : layout.Rays) {
      add(*child, ray);
    }
  }
}

EMaterial ReadMaterial(TConfigurationNode& node) {
  std::string material(ToText(EMaterial::Plastic));
  GetNodeAttributeOrDefault(node, "material", material, material);
  try {
    return MaterialFromText(material);
  } catch (CARGoSException& error) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(node) << ": wrong attribute \"material\"", error);
  }
}

}  // namespace argos
