#version 3.7;
// A state of an ARGoS experiment, as the view <povray> shows it: m, z up.
// povray +I<this file> +O<picture>.png +W160 +H120 +A0.1 -D
global_settings {
  assumed_gamma 1.0
  charset utf8
  max_trace_level 12
  radiosity { pretrace_start 0.08 pretrace_end 0.04 count 50 nearest_count 6
    error_bound 0.9 recursion_limit 1 gray_threshold 0.4 brightness 0.5 }
}
#default { finish { ambient 0 } }

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

camera {
  perspective
  location <0,-3,2>
  direction <0,0.8320502943378437,-0.5547001962252291>
  right <1.44,-0,0>
  up <0,0.5990762119232476,0.8986143178848712>
}
sky_sphere {
  pigment { function { min(1, max(0, z)) } color_map { [0 srgb <0.07,0.08,0.095>] [0.2 srgb <0.13,0.15,0.18>] [1 srgb <0.20,0.23,0.29>] } }
  pigment { function { max(0, 0.5513801778287941*x + -0.45112923640537694*y + 0.7017565899639197*z) } color_map { [0.86 srgbt <1,1,1,1>] [0.90 rgbt <1.1,1.1,1.1,0>] [1 rgbt <1.1,1.1,1.1,0>] } }
}
background { color srgb <0.07059,0.07843,0.09412> }
light_source { <-6.444348916688649,-5.83060140081354,14.57650350203385> srgb <1,0.985,0.95>*0.26
  area_light <-1.821724266113189,2.0134847151777353,0>, <-1.729439821004968,-1.5647312666235422,-1.3904869538305606>, 5, 5 adaptive 1 jitter circular }
sphere { <0,-0.5,0.1>, 0.009999999776482582 Argos_Flat(srgb <0.8627,0.1176,0.1176>) }
disc { <0,0,0>, <0,-0.7961621943517142,0.6050832672327532>, 0.035999998241663 pigment { spherical color_map { [0 srgbt <0.8627,0.1176,0.1176,1>] [0.45 srgbt <0.8627,0.1176,0.1176,0.8824>] [1 srgbt <0.8627,0.1176,0.1176,0.4>] } scale 0.035999998241663 } finish { ambient 0 diffuse 0 emission 1 } no_shadow no_reflection no_radiosity translate <0,-0.5095539461186732,0.10726100053461318> }
union {
  sphere { <0,0,0>, 0.029999999329447746 Argos_Glass(srgbf <0.1176,0.7843,0.1176,0.95>) hollow no_shadow }
  sphere { <0,0,0>, 0.013499999698251487 scale <1,1,1.3> texture { pigment { color srgb <0.1176,0.7843,0.1176> } finish { ambient 0 diffuse 0 emission 1.6 } } no_shadow }
  object { Argos_Cylinder(0.012599999718368053, 0.0239999994635582, 0.0014999999664723875) Argos_Metal(srgb <0.72,0.73,0.75>) translate 0.026399999409914016*z no_shadow }
  translate <0.5,-0.5,0.6000000238418579>
}
light_source { <0.5,-0.5,0.6000000238418579> color srgb <0.1176,0.7843,0.1176>*1.1 fade_distance 0.48000001907348633 fade_power 2 area_light 0.05999999865889549*x, 0.05999999865889549*y, 3, 3 adaptive 1 jitter circular orient }
sphere { <0.1,-0.5,0.1>, 0.021154878727960347 Argos_Plastic(srgb <0.1804,0.1882,0.2118>) }
sphere { <0.2,-0.5,0.1>, 0.0705162624265345 Argos_Flat(srgb <0.1569,0.1569,0.8824>) }
sphere { <1,-0.5,0.1>, 0.009999999776482582 Argos_Flat(srgb <0.1176,0.7843,0.1176>) }
disc { <0,0,0>, <-0.3034485645963118,-0.7586214114907794,0.5765522722808188>, 0.035999998241663 pigment { spherical color_map { [0 srgbt <0.1176,0.7843,0.1176,1>] [0.45 srgbt <0.1176,0.7843,0.1176,0.8824>] [1 srgbt <0.1176,0.7843,0.1176,0.4>] } scale 0.035999998241663 } finish { ambient 0 diffuse 0 emission 1 } no_shadow no_reflection no_radiosity translate <0.9963586173062355,-0.5091034567344113,0.10691862860284257> }
light_source { <0,-0.5,0.11500000115483999> color srgb <0.8627,0.1176,0.1176>*1.1 fade_distance 0.03 fade_power 2 }
light_source { <1.0127279217768665,-0.5127279217768667,0.10000000149011612> color srgb <0.1176,0.7843,0.1176>*1.1 fade_distance 0.03 fade_power 2 }
sphere { <0,-0.5,0.1>, 0.008814532803316812 Argos_Flat(srgb <0.4784,0.7451,1>) }
disc { <0,0,-0.0004>, z, 14.142135623730951
  texture { pigment { spherical color_map { [0 srgbt <0.102,0.1098,0.1294,1>] [0.6 srgb <0.102,0.1098,0.1294>] [1 srgb <0.102,0.1098,0.1294>] } scale 14.142135623730951 translate <0,0,0> } finish { diffuse 0.85 } }
  texture { pigment { gradient x color_map { [0 srgbt <0.4078,0.4392,0.4863,0.4902>] [0.04218494992292868 srgbt <0.4078,0.4392,0.4863,0.4902>] [0.04218494992292868 srgbt <0.4078,0.4392,0.4863,1>] [1 srgbt <0.4078,0.4392,0.4863,1>] } scale 1 translate -0.02109247496146434*x } finish { diffuse 0.8 } }
  texture { pigment { gradient y color_map { [0 srgbt <0.4078,0.4392,0.4863,0.4902>] [0.04218494992292868 srgbt <0.4078,0.4392,0.4863,0.4902>] [0.04218494992292868 srgbt <0.4078,0.4392,0.4863,1>] [1 srgbt <0.4078,0.4392,0.4863,1>] } scale 1 translate -0.02109247496146434*y } finish { diffuse 0.8 } }
  texture { pigment { gradient x color_map { [0 srgbt <0.4078,0.4392,0.4863,0.2549>] [0.004218494992292867 srgbt <0.4078,0.4392,0.4863,0.2549>] [0.004218494992292867 srgbt <0.4078,0.4392,0.4863,1>] [1 srgbt <0.4078,0.4392,0.4863,1>] } scale 10 translate -0.02109247496146434*x } finish { diffuse 0.8 } }
  texture { pigment { gradient y color_map { [0 srgbt <0.4078,0.4392,0.4863,0.2549>] [0.004218494992292867 srgbt <0.4078,0.4392,0.4863,0.2549>] [0.004218494992292867 srgbt <0.4078,0.4392,0.4863,1>] [1 srgbt <0.4078,0.4392,0.4863,1>] } scale 10 translate -0.02109247496146434*y } finish { diffuse 0.8 } }
}
box { <-2,-2,-0.0008>, <2,2,0>
  texture { pigment { image_map { ppm "floor.ppm" gamma srgb once } scale <4,4,1> translate <-2,-2,0> } finish { diffuse 0.8 specular 0.06 roughness 0.06 } }
  texture { pigment { gradient x color_map { [0 srgbt <0.4078,0.4392,0.4863,0.4902>] [0.04218494992292868 srgbt <0.4078,0.4392,0.4863,0.4902>] [0.04218494992292868 srgbt <0.4078,0.4392,0.4863,1>] [1 srgbt <0.4078,0.4392,0.4863,1>] } scale 1 translate -0.02109247496146434*x } finish { diffuse 0.8 } }
  texture { pigment { gradient y color_map { [0 srgbt <0.4078,0.4392,0.4863,0.4902>] [0.04218494992292868 srgbt <0.4078,0.4392,0.4863,0.4902>] [0.04218494992292868 srgbt <0.4078,0.4392,0.4863,1>] [1 srgbt <0.4078,0.4392,0.4863,1>] } scale 1 translate -0.02109247496146434*y } finish { diffuse 0.8 } }
  texture { pigment { gradient x color_map { [0 srgbt <0.4078,0.4392,0.4863,0.2549>] [0.004218494992292867 srgbt <0.4078,0.4392,0.4863,0.2549>] [0.004218494992292867 srgbt <0.4078,0.4392,0.4863,1>] [1 srgbt <0.4078,0.4392,0.4863,1>] } scale 10 translate -0.02109247496146434*x } finish { diffuse 0.8 } }
  texture { pigment { gradient y color_map { [0 srgbt <0.4078,0.4392,0.4863,0.2549>] [0.004218494992292867 srgbt <0.4078,0.4392,0.4863,0.2549>] [0.004218494992292867 srgbt <0.4078,0.4392,0.4863,1>] [1 srgbt <0.4078,0.4392,0.4863,1>] } scale 10 translate -0.02109247496146434*y } finish { diffuse 0.8 } }
}
box { <-2.0421849499229285,-2.0421849499229285,0>, <2.0421849499229285,-1.9578150500770712,0.0002> Argos_Matte(srgb <0.6902,0.7216,0.7686>) no_shadow }
box { <-2.0421849499229285,1.9578150500770712,0>, <2.0421849499229285,2.0421849499229285,0.0002> Argos_Matte(srgb <0.6902,0.7216,0.7686>) no_shadow }
box { <-2.0421849499229285,-2.0421849499229285,0>, <-1.9578150500770712,2.0421849499229285,0.0002> Argos_Matte(srgb <0.6902,0.7216,0.7686>) no_shadow }
box { <1.9578150500770712,-2.0421849499229285,0>, <2.0421849499229285,2.0421849499229285,0.0002> Argos_Matte(srgb <0.6902,0.7216,0.7686>) no_shadow }
object { Argos_Box(0.3, 0.6, 0.4, 0.002) Argos_Matte(srgb <0.8627,0.1176,0.1176>) matrix <1,0,0,0,1,0,0,0,1,-0.6,0.3,0> }
object { Argos_Box(0.15, 0.1, 0.12, 0.002) Argos_Plastic(srgb <0.1176,0.7843,0.1176>) matrix <1,0,0,0,1,0,0,0,1,-1.5,1,0.2> }
object { Argos_Box(0.15, 0.1, 0.12, 0) Argos_Matte(srgbt <0.1176,0.7843,0.1176,0.6078>) matrix <1,0,0,0,1,0,0,0,1,-1.2,1,0.2> }
object { Argos_Box(0.15, 0.1, 0.12, 0.002) Argos_Metal(srgb <0.1176,0.7843,0.1176>) matrix <1,0,0,0,1,0,0,0,1,-0.9,1,0.2> }
object { Argos_Box(0.15, 0.1, 0.11976, 0) Argos_Glass(srgbf <0.1176,0.7843,0.1176,0.93>) matrix <1,0,0,0,1,0,0,0,1,-0.6,1,0.20012> }
object { Argos_Cylinder(0.15, 0.5, 0.002) Argos_Matte(srgb <0.1569,0.1569,0.8824>) matrix <1,0,0,0,1,0,0,0,1,0.3,-0.5,0.1> }
cone { <0,0,0>, 0.075, <0,0,0.12>, 0 scale <1,0.6666666,1> Argos_Plastic(srgb <0.1176,0.7843,0.1176>) matrix <1,0,0,0,1,0,0,0,1,-1.5,1.2,0.2> }
cone { <0,0,0>, 0.075, <0,0,0.12>, 0 scale <1,0.6666666,1> Argos_Matte(srgbt <0.1176,0.7843,0.1176,0.6078>) matrix <1,0,0,0,1,0,0,0,1,-1.2,1.2,0.2> }
cone { <0,0,0>, 0.075, <0,0,0.12>, 0 scale <1,0.6666666,1> Argos_Metal(srgb <0.1176,0.7843,0.1176>) matrix <1,0,0,0,1,0,0,0,1,-0.9,1.2,0.2> }
cone { <0,0,0>, 0.075, <0,0,0.11976>, 0 scale <1,0.6666666,1> Argos_Glass(srgbf <0.1176,0.7843,0.1176,0.93>) matrix <1,0,0,0,1,0,0,0,1,-0.6,1.2,0.20012> }
sphere { <0,0,0>, 0.5 scale <0.5,0.5,0.5> Argos_Matte(srgb <0.1176,0.7843,0.1176>) matrix <1,0,0,0,1,0,0,0,1,0.6,0.4,0.3> }
sphere { <0,0,0>, 0.5 scale <0.15,0.1,0.12> Argos_Plastic(srgb <0.1176,0.7843,0.1176>) matrix <1,0,0,0,1,0,0,0,1,-1.5,1.4,0.2> }
sphere { <0,0,0>, 0.5 scale <0.15,0.1,0.12> Argos_Matte(srgbt <0.1176,0.7843,0.1176,0.6078>) matrix <1,0,0,0,1,0,0,0,1,-1.2,1.4,0.2> }
sphere { <0,0,0>, 0.5 scale <0.15,0.1,0.12> Argos_Metal(srgb <0.1176,0.7843,0.1176>) matrix <1,0,0,0,1,0,0,0,1,-0.9,1.4,0.2> }
sphere { <0,0,0>, 0.5 scale <0.15,0.1,0.12> Argos_Glass(srgbf <0.1176,0.7843,0.1176,0.93>) matrix <1,0,0,0,1,0,0,0,1,-0.6,1.4,0.2> }
object { Argos_Ring(0.45, 0.05) scale <0.5,0.5,0.5> Argos_Plastic(srgb <0.8627,0.1176,0.1176>) matrix <1,0,0,0,1,0,0,0,1,0,0,0.4> }
object { Argos_Ring(0.35, 0.15) scale <0.15,0.1,0.12> Argos_Plastic(srgb <0.1176,0.7843,0.1176>) matrix <1,0,0,0,1,0,0,0,1,-1.5,1.6,0.2> }
object { Argos_Ring(0.35, 0.15) scale <0.15,0.1,0.12> Argos_Matte(srgbt <0.1176,0.7843,0.1176,0.6078>) matrix <1,0,0,0,1,0,0,0,1,-1.2,1.6,0.2> }
object { Argos_Ring(0.35, 0.15) scale <0.15,0.1,0.12> Argos_Metal(srgb <0.1176,0.7843,0.1176>) matrix <1,0,0,0,1,0,0,0,1,-0.9,1.6,0.2> }
object { Argos_Ring(0.35, 0.15) scale <0.15,0.1,0.12> Argos_Glass(srgbf <0.1176,0.7843,0.1176,0.93>) matrix <1,0,0,0,1,0,0,0,1,-0.6,1.6,0.2> }
cone { <0,0,0.5>, 0.029953810596162377, <1,0,0.5>, 0.029953810596162377 Argos_Flat(srgbt <0.7843,0,0,0.5294>) }
mesh {
  triangle { <0,-0.003000000142492354,0.0020000000949949026>, <0.4994999999762513,-0.003000000142492354,0.0020000000949949026>, <0,0.4964999998337589,0.0020000000949949026> }
  Argos_Flat(srgb <0.8627,0.1176,0.1176>) }
mesh {
  triangle { <0,-0.003000000142492354,0.0020000000949949026>, <0.4994999999762513,-0.003000000142492354,0.0020000000949949026>, <0,0.4964999998337589,0.0020000000949949026> }
  Argos_Flat(srgbt <0,0,0.7843,0.6471>) }
#declare Argos_Line = text { internal 3 "id\"}\\ #declare" 0.01, 0 scale <16,16,1> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -0.5*max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,-0.00011700000000000078,-2.9885950597533752,1.9936713270794213> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -0.5*max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,-0.00011700000000000078,-2.988724859599292,1.9934766273105462> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -0.5*max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,0.00011700000000000078,-2.988724859599292,1.9934766273105462> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -0.5*max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,0.00011700000000000078,-2.9885950597533752,1.9936713270794213> }
object { Argos_Line Argos_Flat(srgb <0.8627,0.1176,0.1176>) translate -0.5*max_extent(Argos_Line).x*x matrix <0.00010800000000000001,-0,0,0,5.990762119232475e-05,8.986143178848713e-05,-0,-8.986143178848713e-05,5.990762119232475e-05,0,-2.9895322704704617,1.9940682866415236> }
#declare Argos_Line = text { internal 3 "ä" 0.01, 0 scale <16,16,1> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -0.5*max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,-0.00011700000000000078,-2.9923332953157766,1.9880639737358197> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -0.5*max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,-0.00011700000000000078,-2.992463095161693,1.9878692739669446> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -0.5*max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,0.00011700000000000078,-2.992463095161693,1.9878692739669446> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -0.5*max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,0.00011700000000000078,-2.9923332953157766,1.9880639737358197> }
object { Argos_Line Argos_Flat(srgb <0.8627,0.1176,0.1176>) translate -0.5*max_extent(Argos_Line).x*x matrix <0.00010800000000000001,-0,0,0,5.990762119232475e-05,8.986143178848713e-05,-0,-8.986143178848713e-05,5.990762119232475e-05,0,-2.9929829494511395,1.9888922681705068> }
mesh {
  triangle { <-0.01386,-2.9776677700999725,1.9974428320954016>, <-0.010260000000000002,-2.9776677700999725,1.9974428320954016>, <-0.01386,-2.9796646908063833,1.9944474510357855> }
  Argos_Flat(srgb <0.1176,0.7843,0.1176>) }
#declare Argos_Line = text { internal 1 "\\" 0.01, 0 scale <16,16,1> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,-0.008892000000000002,-2.9865224493323157,1.9967802427110106> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,-0.008892000000000002,-2.9866522491782326,1.9965855429421355> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,-0.008658000000000002,-2.9866522491782326,1.9965855429421355> }
object { Argos_Line Argos_Flat(srgb <1,1,1>) translate -max_extent(Argos_Line).x*x matrix <0.00011700000000000002,-0,0,0,6.489992295835183e-05,9.734988443752774e-05,-0,-9.734988443752774e-05,6.489992295835183e-05,-0.008658000000000002,-2.9865224493323157,1.9967802427110106> }
object { Argos_Line Argos_Flat(srgb <0,0,0>) translate -max_extent(Argos_Line).x*x matrix <0.00010800000000000001,-0,0,0,5.990762119232475e-05,8.986143178848713e-05,-0,-8.986143178848713e-05,5.990762119232475e-05,-0.0081,-2.9876190916202527,1.996938054916837> }
