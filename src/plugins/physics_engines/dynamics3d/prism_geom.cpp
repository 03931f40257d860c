#include <argos3/plugins/simulator/physics_engines/dynamics3d/prism_geom.h>

#include <argos3/core/simulator/geometry/convex_polygon.h>

#include <cmath>

namespace argos {

namespace {

struct SPrismData {
  const std::vector<CVector2>* Base;
  dReal Height;  // m
};

const SPrismData& GetPrismData(dGeomID prism) {
  return *static_cast<const SPrismData*>(dGeomGetClassData(prism));
}

void ComputePrismBounds(dGeomID prism, dReal bounds[6]) {
  const SPrismData& data = GetPrismData(prism);
  const dReal* const position = dGeomGetPosition(prism);
  const dReal* const rotation = dGeomGetRotation(prism);
  for (int axis = 0; axis < 3; ++axis) {
    const CVector2 direction(rotation[4 * axis], rotation[4 * axis + 1]);
    const Real up = 0.5 * data.Height * std::abs(rotation[4 * axis + 2]);
    const auto reach = [&](const CVector2& towards) {
      return direction.DotProduct((*data.Base)[FindFarthestCorner(*data.Base, towards)]);
    };
    bounds[2 * axis] = position[axis] + reach(-direction) - up;
    bounds[2 * axis + 1] = position[axis] + reach(direction) + up;
  }
}

int GetPrismClass() {
  // ODE has few classes for users, for the whole process
  static const int number = [] {
    dGeomClass prism{};
    prism.bytes = sizeof(SPrismData);
    prism.collider = [](int) -> dColliderFn* { return nullptr; };
    prism.aabb = &ComputePrismBounds;
    return dCreateGeomClass(&prism);
  }();
  return number;
}

}  // namespace

dGeomID CreatePrism(const std::vector<CVector2>& base, dReal height) {
  const dGeomID prism = dCreateGeom(GetPrismClass());
  *static_cast<SPrismData*>(dGeomGetClassData(prism)) = {&base, height};
  return prism;
}

bool IsPrism(dGeomID geom) {
  return dGeomGetClass(geom) >= dFirstUserClass;
}

const std::vector<CVector2>& GetPrismBase(dGeomID prism) {
  return *GetPrismData(prism).Base;
}

dReal GetPrismHeight(dGeomID prism) {
  return GetPrismData(prism).Height;
}

}  // namespace argos
