#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

namespace positional_entity_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

TEST_CASE("positional entity: reads its pose, moves, and returns on reset", "[core][entity]") {
  CConfigurationDocument document;
  document.Parse("<lamp id='l' position='1,2,3' orientation='90,0,0' />");
  CPositionalEntity entity(nullptr);
  entity.Init(document.GetRoot());
  CHECK(entity.GetPosition() == CVector3(1.0, 2.0, 3.0));
  CHECK(entity.GetInitPosition() == CVector3(1.0, 2.0, 3.0));
  CVector3 ahead = CVector3::X;
  ahead.Rotate(entity.GetOrientation());
  // tolerance of a few roundings after a quarter turn
  CHECK_THAT(ahead.GetY(), WithinAbs(1.0, 1e-15));
  const CQuaternion init = entity.GetInitOrientation();
  entity.MoveTo(CVector3(-1.0, 0.0, 0.0), CQuaternion(0.0, 1.0, 0.0, 0.0));
  CHECK(entity.GetPosition() == CVector3(-1.0, 0.0, 0.0));
  CHECK(entity.GetOrientation().GetX() == 1.0);
  entity.Reset();
  CHECK(entity.GetPosition() == CVector3(1.0, 2.0, 3.0));
  CHECK(entity.GetOrientation().GetZ() == init.GetZ());
  entity.SetInitPosition(CVector3(5.0, 0.0, 0.0));
  entity.SetInitOrientation(CQuaternion());
  entity.Reset();
  CHECK(entity.GetPosition() == CVector3(5.0, 0.0, 0.0));
  CHECK(entity.GetOrientation().GetW() == 1.0);
}

TEST_CASE("positional entity: its pose is optional", "[core][entity]") {
  CConfigurationDocument document;
  document.Parse("<lamp id='l' />");
  CPositionalEntity entity(nullptr);
  entity.Init(document.GetRoot());
  CHECK(entity.GetPosition() == CVector3());
  CHECK(entity.GetOrientation().GetW() == 1.0);
}

TEST_CASE("positional entity: a malformed pose is an error with its line", "[core][entity]") {
  CConfigurationDocument document;
  document.Parse("<lamp id='l' position='1,2' />", "file.argos");
  CPositionalEntity entity(nullptr);
  CHECK_THROWS_WITH(entity.Init(document.GetRoot()),
                    Contains("file.argos:1") && Contains("position"));
}

}  // namespace positional_entity_test
