#include <argos3/core/simulator/visualization/povray_model.h>
#include <argos3/core/utility/text/classic_locale.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_measures.h>

namespace argos {

namespace {

// sizes besides the measures as in eyebot_appearance.cpp, which has the same parts
constexpr char kBody[] = R"(
  #local I = 0;
  #while (I < 4)
    // an arm of carbon, its motors, and two counter-rotating propellers
    union {
      object { Argos_Box(R - 0.018, 0.018, 0.012, 0.005) Argos_Plastic(srgb <0.133, 0.141, 0.157>)
        translate <0.5*(R - 0.018), 0, Hoop - 0.006> }
      object { Argos_Cylinder(0.014, 0.087, 0.004) Argos_Metal(srgb <0.35, 0.37, 0.41>)
        translate <0.142, 0, 0.118> }
      #local K = 0;
      #while (K < 2)
        union {
          sphere { 0, 1 scale <0.043, 0.008, 0.0014> rotate 9*x translate 0.043*x }
          sphere { 0, 1 scale <0.043, 0.008, 0.0014> rotate -9*x translate -0.043*x }
          Argos_Plastic(srgb <0.173, 0.18, 0.204>)
          rotate (35 - 90*K)*z
          translate <0.142, 0, 0.206 - 0.087*K>
        }
        union {
          object { Argos_Cylinder(0.011, 0.006, 0.002) }
          sphere { 0, 1 scale <0.009, 0.009, 0.008> translate 0.006*z }
          Argos_Metal(srgb <0.72, 0.73, 0.75>)
          translate <0.142, 0, 0.203 - 0.087*K>
        }
        cylinder { 0, 0.0004*z, 0.088 pigment { color srgbt <0.6, 0.66, 0.72, 0.82> }
          finish { diffuse 0.5 specular 0.3 } no_shadow translate <0.142, 0, 0.2075 - 0.087*K> }
        #local K = K + 1;
      #end
      rotate (45 + 90*I)*z
    }
    // a leg with a foot of rubber, and its strut
    union {
      cylinder { 0.006*z, Hoop*z, 0.005 Argos_Plastic(srgb <0.133, 0.141, 0.157>)
        translate 0.11*x }
      sphere { 0, 1 scale <0.012, 0.012, 0.008> Argos_Matte(srgb <0.1, 0.1, 0.11>)
        translate <0.11, 0, 0.008> }
      object { Argos_Box(0.11, 0.008, 0.006, 0.0025) Argos_Plastic(srgb <0.133, 0.141, 0.157>)
        translate <0.055, 0, Hoop - 0.005> }
      rotate 90*I*z
    }
    #local I = I + 1;
  #end
  // the hoop that carries the LEDs
  object { Argos_Ring(R - 0.009, 0.009) Argos_Plastic(srgb <0.886, 0.894, 0.91>)
    translate Hoop*z }
  object { Argos_Ring(R - 0.0175, 0.002) Argos_Metal(srgb <0.75, 0.76, 0.78>) translate Hoop*z }
  object { Argos_Box(0.018, 0.04, 0.0108, 0.003) Argos_Plastic(srgb <0.961, 0.627, 0.078>)
    translate <R - 0.009, 0, Hoop> }
  // core: electronics between collars of metal
  object { Argos_Cylinder(0.046, 0.145, 0.012) Argos_Plastic(srgb <0.227, 0.243, 0.275>)
    translate 0.09*z }
  object { Argos_Cylinder(0.049, 0.02, 0.004) Argos_Metal(srgb <0.69, 0.706, 0.73>)
    translate (Hoop - 0.01)*z }
  object { Argos_Ring(0.045, 0.003) Argos_Metal(srgb <0.69, 0.706, 0.73>) translate 0.222*z }
  object { Argos_Box(0.04, 0.016, 0.005, 0.002) Argos_Plastic(srgb <0.961, 0.627, 0.078>)
    translate <0.025, 0, 0.235> }
  // camera below: an iris in a dome of glass
  object { Argos_Cylinder(0.03, 0.022, 0.004) Argos_Plastic(srgb <0.133, 0.141, 0.157>)
    translate 0.069*z }
  sphere { 0.07*z, 0.014 Argos_Plastic(srgb <0.05, 0.06, 0.16>) }
  difference {
    sphere { 0.0688*z, 0.026 }
    sphere { 0.0688*z, 0.024 }
    plane { -z, -0.0688 }
    Argos_Glass(srgbf <0.93, 0.97, 1, 0.96>)
  }
  // mast, and the device for attaching to a ceiling
  cylinder { 0.23*z, 0.535*z, 0.009 Argos_Plastic(srgb <0.133, 0.141, 0.157>) }
  object { Argos_Cylinder(0.02, 0.03, 0.005) Argos_Plastic(srgb <0.227, 0.243, 0.275>)
    translate 0.51*z }
  object { Argos_Cylinder(0.05, Height - 0.54, 0.006) Argos_Metal(srgb <0.69, 0.706, 0.73>)
    translate 0.54*z }
}
)";

class CEyeBotPovrayModel : public CPovrayModel {
 public:
  std::vector<SPart> MakeParts() const override {
    CTextOutput text;
    text << "union {\n  #local R = " << eyebot::kBodyRadius
         << "; #local Height = " << eyebot::kBodyHeight << "; #local Hoop = "
         << 0.5 * (eyebot::kLowerLEDRingElevation + eyebot::kUpperLEDRingElevation) << ";" << kBody;
    return {{"origin", text.str()}};
  }
};

}  // namespace

REGISTER_POVRAY_MODEL(CEyeBotPovrayModel, "eye-bot", "the authors of this project", "1.0",
                      "The eye-bot in detail: propellers, hoop, dome of the camera.",
                      "Replaces all solids of the appearance.", "Usable")

}  // namespace argos
