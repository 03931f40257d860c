#include <argos3/plugins/simulator/visualizations/povray/scene_file.h>

#include <fmt/format.h>

namespace argos {

namespace {

// Light comes from everywhere; the quality decides if radiosity computes it.
const char* MakeRadiosity(EPovrayQuality quality) {
  switch (quality) {
    case EPovrayQuality::Draft:
      return "";
    case EPovrayQuality::Good:
      return "  radiosity { pretrace_start 0.08 pretrace_end 0.04 count 50 nearest_count 6\n"
             "    error_bound 0.9 recursion_limit 1 gray_threshold 0.4 brightness 0.5 }\n";
    case EPovrayQuality::Best:
      return "  radiosity { pretrace_start 0.08 pretrace_end 0.01 count 180 nearest_count 10\n"
             "    error_bound 0.35 low_error_factor 0.5 recursion_limit 2 gray_threshold 0.2 "
             "brightness 0.5 }\n";
  }
  return "";
}

// SDL; doc/povray.md lists those for models
constexpr char kMacros[] = R"(
// materials
#macro Argos_Plastic(C)
  texture { pigment { color C } finish { diffuse 0.8 specular 0.3 roughness 0.012
    reflection { 0.01, 0.14 falloff 3 } conserve_energy } }
#end
#macro Argos_Matte(C)
  texture { pigment { color C } finish { diffuse 0.78 specular 0.04 roughness 0.15 } }
#end
#macro Argos_Metal(C)
  texture { pigment { color C } finish { diffuse 0.28 brilliance 2 specular 0.7 roughness 0.008
    metallic reflection { 0.5, 0.8 metallic } conserve_energy } }
#end
#macro Argos_Glass(C)
  material {
    texture { pigment { color C } finish { diffuse 0.04 specular 0.9 roughness 0.001
      reflection { 0.02, 0.7 fresnel on } conserve_energy } }
    interior { ior 1.5 }
  }
#end
// even colour, which no light changes
#macro Argos_Flat(C)
  texture { pigment { color C } finish { ambient 0 diffuse 0 emission 1 } }
  no_shadow no_radiosity
#end

// solids that stand on z = 0, sizes in m; B = radius of rounded edges, 0 = sharp
#macro Argos_Box(SX, SY, SZ, B)
  #if (B <= 0)
    box { <-SX/2, -SY/2, 0>, <SX/2, SY/2, SZ> }
  #else
    #local X = SX/2 - B; #local Y = SY/2 - B; #local Z = SZ - B;
    union {
      box { <-SX/2, -Y, B>, <SX/2, Y, Z> }
      box { <-X, -SY/2, B>, <X, SY/2, Z> }
      box { <-X, -Y, 0>, <X, Y, SZ> }
      #local I = -1;
      #while (I < 2)
        #local J = -1;
        #while (J < 2)
          cylinder { <I*X, J*Y, B>, <I*X, J*Y, Z>, B }
          sphere { <I*X, J*Y, B>, B }
          sphere { <I*X, J*Y, Z>, B }
          #local K = (J < 0 ? B : Z);
          cylinder { <I*X, -Y, K>, <I*X, Y, K>, B }
          cylinder { <-X, I*Y, K>, <X, I*Y, K>, B }
          #local J = J + 2;
        #end
        #local I = I + 2;
      #end
    }
  #end
#end
#macro Argos_Cylinder(R, H, B)
  #if (B <= 0)
    cylinder { <0, 0, 0>, <0, 0, H>, R }
  #else
    union {
      cylinder { <0, 0, B>, <0, 0, H - B>, R }
      cylinder { <0, 0, 0>, <0, 0, H>, R - B }
      torus { R - B, B rotate x*90 translate B*z }
      torus { R - B, B rotate x*90 translate (H - B)*z }
    }
  #end
#end
// around z; R = radius of the middle of the tube, T = radius of the tube
#macro Argos_Ring(R, T)
  torus { R, T rotate x*90 }
#end
)";

}  // namespace

std::string MakePrologue(const SPovraySettings& settings) {
  const bool isDraft = settings.Quality == EPovrayQuality::Draft;
  return fmt::format(
      "#version 3.7;\n"
      "// A state of an ARGoS experiment, as the view <povray> shows it: m, z up.\n"
      "// povray +I<this file> +O<picture>.png +W{} +H{} +A0.1 -D\n"
      "global_settings {{\n  assumed_gamma 1.0\n  charset utf8\n  max_trace_level 12\n{}}}\n"
      "#default {{ finish {{ ambient {} }} }}\n{}\n",
      settings.Width, settings.Height, MakeRadiosity(settings.Quality),
      isDraft ? (settings.IsDark ? 0.1 : 0.22) : 0.0, kMacros);
}

}  // namespace argos
