#include <argos3/core/simulator/visualization/povray_model.h>
#include <argos3/core/utility/text/classic_locale.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>

namespace argos {

namespace {

// sizes besides the measures as in footbot_appearance.cpp, which has the same parts
constexpr char kBody[] = R"(
  // tracks with ribs, and wheels with hubs
  #local Side = -1;
  #while (Side < 2)
    union {
      object { Argos_Box(0.11, 0.02, 0.04, 0.009) translate <0, Side*(Wheel_Y - 0.03), 0.002> }
      #local Rib = -4;
      #while (Rib < 5)
        box { <-0.002, -0.0104, 0.0012>, <0.002, 0.0104, 0.0428>
          translate <Rib*0.0105, Side*(Wheel_Y - 0.03), 0> }
        #local Rib = Rib + 1;
      #end
      Argos_Matte(srgb <0.085, 0.085, 0.09>)
    }
    union {
      torus { Wheel_R - 0.006, 0.006 Argos_Matte(srgb <0.08, 0.08, 0.085>) }
      cylinder { -0.005*y, 0.005*y, Wheel_R - 0.008 Argos_Metal(srgb <0.66, 0.68, 0.70>) }
      sphere { 0, 0.007 Argos_Metal(srgb <0.8, 0.81, 0.83>) translate Side*0.004*y }
      translate <0, Side*Wheel_Y, Wheel_R>
    }
    #local Side = Side + 2;
  #end
  // base, and the ring of sensors with its windows
  object { Argos_Cylinder(R - 0.004, 0.022, 0.004) Argos_Plastic(srgb <0.15, 0.157, 0.173>)
    translate 0.03*z }
  object { Argos_Cylinder(R, 0.018, 0.003) Argos_Plastic(srgb <0.84, 0.847, 0.863>)
    translate 0.052*z }
  #local I = 0;
  #while (I < 24)
    sphere { 0, 1 scale <0.0022, 0.005, 0.005> Argos_Plastic(srgb <0.05, 0.02, 0.04>)
      translate <R - 0.0005, 0, 0.061> rotate (I*15 + 7.5)*z }
    #local I = I + 1;
  #end
  object { Argos_Cylinder(R - 0.006, 0.008, 0.002) Argos_Plastic(srgb <0.15, 0.157, 0.173>)
    translate 0.07*z }
  // electronics between plates of metal
  object { Argos_Cylinder(R - 0.012, 0.035, 0.005) Argos_Plastic(srgb <0.15, 0.157, 0.173>)
    translate 0.093*z }
  object { Argos_Ring(R - 0.0115, 0.0018) Argos_Metal(srgb <0.72, 0.73, 0.75>)
    translate 0.11*z }
  object { Argos_Cylinder(R - 0.006, 0.004, 0.0015) Argos_Metal(srgb <0.67, 0.68, 0.7>)
    translate 0.128*z }
  #local I = 0;
  #while (I < 6)
    sphere { 0, 0.0035 Argos_Metal(srgb <0.78, 0.79, 0.81>)
      translate <R - 0.013, 0, 0.1325> rotate (I*60 + 30)*z }
    #local I = I + 1;
  #end
  object { Argos_Cylinder(R - 0.02, Height - 0.132, 0.005)
    Argos_Plastic(srgb <0.15, 0.157, 0.173>) translate 0.132*z }
  // mark of the heading
  object { Argos_Box(0.05, 0.016, 0.004, 0.0015) Argos_Plastic(srgb <0.961, 0.627, 0.078>)
    translate <0.047, 0, Height> }
  // camera: a hollow tube of glass, and a mirror that it looks at
  object { Argos_Cylinder(0.022, 0.0091, 0.002) Argos_Metal(srgb <0.67, 0.68, 0.7>)
    translate Height*z }
  difference {
    cylinder { 0.1562*z, (Camera - 0.0202)*z, 0.016 }
    cylinder { 0.15*z, Camera*z, 0.0145 }
    Argos_Glass(srgbf <0.93, 0.97, 0.98, 0.96>)
  }
  sphere { 0, 0.0125 scale <1, 1, 0.8> Argos_Metal(srgb <0.9, 0.91, 0.93>)
    translate (Camera - 0.021)*z }
  object { Argos_Cylinder(0.02, 0.02, 0.004) Argos_Plastic(srgb <0.15, 0.157, 0.173>)
    translate (Camera - 0.02)*z }
}
)";

class CFootBotPovrayModel : public CPovrayModel {
 public:
  std::vector<SPart> MakeParts() const override {
    CTextOutput text;
    text << "union {\n  #local R = " << footbot::kBodyRadius
         << "; #local Height = " << footbot::kBodyHeight
         << ";\n  #local Wheel_R = " << footbot::kWheelRadius
         << "; #local Wheel_Y = " << 0.5 * footbot::kInterwheelDistance
         << "; #local Camera = " << footbot::kOmnidirectionalCameraElevation << ";" << kBody;
    return {{"origin", text.str()}};
  }
};

}  // namespace

REGISTER_POVRAY_MODEL(CFootBotPovrayModel, "foot-bot", "the authors of this project", "1.0",
                      "The foot-bot in detail: tracks, wheels, glass of the camera.",
                      "Replaces the solids of the body; the turret keeps the appearance's.",
                      "Usable")

}  // namespace argos
