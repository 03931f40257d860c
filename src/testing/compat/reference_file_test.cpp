/* Files with every element and attribute of ARGoS 3 load without a warning. */

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace reference_file_test {

using namespace argos;

using Catch::Matchers::Contains;

namespace {

/* reads its own parameters: an attribute that is not read gives a warning */
class CReferenceController : public CCI_Controller {
 public:
  virtual void Init(TConfigurationNode& t_tree) {
    Real fParameter;
    GetNodeAttributeOrDefault(t_tree, "alpha", fParameter, 0.0);
    GetNodeAttributeOrDefault(t_tree, "delta", fParameter, 0.0);
    GetNodeAttributeOrDefault(t_tree, "velocity", fParameter, 0.0);
  }
};

REGISTER_CONTROLLER(CReferenceController, "reference_controller")

/* A folder for the files of a test. */
class CFolder {
 public:
  CFolder()
      : m_path(std::filesystem::temp_directory_path() /
               ("argos_reference_" + ToString(::getpid()))) {
    std::filesystem::create_directories(m_path);
  }
  ~CFolder() { std::filesystem::remove_all(m_path); }
  /* Fills in what stands for this folder and for the controllers. */
  std::string Fill(std::string strXml) const;
  std::string Path(const std::string& name) const { return (m_path / name).string(); }

 private:
  std::filesystem::path m_path;
};

const char* const kFootBotController = R"(
    <reference_controller id="foot">
      <actuators>
        <differential_steering implementation="default" bias_avg="0" bias_stddev="0.01" factor_avg="1" factor_stddev="0.01" />
        <leds implementation="default" medium="leds" />
        <range_and_bearing implementation="default" />
        <footbot_turret implementation="default" />
        <footbot_gripper implementation="default" />
        <footbot_distance_scanner implementation="default" />
      </actuators>
      <sensors>
        <differential_steering implementation="default" vel_noise_range="-0.1:0.1" dist_noise_range="-0.1:0.1" />
        <footbot_proximity implementation="default" show_rays="true" noise_level="0.1" />
        <footbot_light implementation="rot_z_only" show_rays="true" noise_level="0.1" />
        <footbot_base_ground implementation="rot_z_only" noise_level="0.1" />
        <footbot_motor_ground implementation="rot_z_only" noise_level="0.1" />
        <footbot_turret_encoder implementation="default" />
        <footbot_distance_scanner implementation="rot_z_only" show_rays="true" noise_range="-1:1" />
        <range_and_bearing implementation="medium" medium="rab" show_rays="true" noise_std_dev="0.1" packet_drop_prob="0.1" />
        <colored_blob_omnidirectional_camera implementation="rot_z_only" medium="leds" show_rays="true" noise_std_dev="0.1" />
        <colored_blob_perspective_camera implementation="default" medium="leds" show_rays="true" />
        <positioning implementation="default" pos_noise_range="-0.1:0.1" angle_noise_range="-1:1" axis_noise_range="-0.1:0.1" />
        <battery implementation="default" noise_range="-0.1:0.1" />
      </sensors>
      <params alpha="7.5" delta="0.1" velocity="5" />
    </reference_controller>)";

const char* const kEPuckController = R"(
    <reference_controller id="epuck">
      <actuators> <differential_steering implementation="default" /> <leds implementation="default" medium="leds" /> </actuators>
      <sensors> <differential_steering implementation="default" /> <proximity implementation="default" /> <epuck_proximity implementation="default" /> <light implementation="default" /> <ground implementation="rot_z_only" /> </sensors>
      <params />
    </reference_controller>)";

std::string CFolder::Fill(std::string strXml) const {
  Replace(strXml, "$FOLDER", m_path.string());
  Replace(strXml, "$FOOTBOT", kFootBotController);
  Replace(strXml, "$EPUCK", kEPuckController);
  return strXml;
}

/* Loads an experiment and runs it for some ticks; neither may give a warning. */
void CheckRunsWithoutWarning(const std::string& strXml, int nTicks) {
  CTestWorld cWorld(strXml);
  CHECK(TakeLogErr() == "");
  cWorld.Step(nTicks);
  CHECK(TakeLogErr() == "");
}

}  // namespace

TEST_CASE("compat: every element and attribute of a file for dynamics2d loads without a warning",
          "[compat]") {
  CFolder cFolder;
  std::ofstream(cFolder.Path("floor.ppm")) << "P3\n2 2\n255\n255 255 255 0 0 0 0 0 0 255 255 255\n";
  const std::string strXml = cFolder.Fill(R"(<?xml version="1.0" ?>
<argos-configuration>
  <framework>
    <system threads="2" method="balance_length" pin_threads_to_cores="false" />
    <experiment length="10" ticks_per_second="10" random_seed="124" real_time="false" />
    <profiling file="$FOLDER/profile.txt" format="human_readable" truncate_file="true" />
  </framework>
  <controllers>$FOOTBOT$EPUCK
  </controllers>
  <arena size="20,20,4" center="0,0,1" positional_index="grid" positional_grid_size="20,20,4">
    <floor id="floor" source="image" path="$FOLDER/floor.ppm" />
    <box id="wall" size="0.1,4,0.5" movable="false"> <body id="body_0" position="8,0,0" orientation="30,0,0" /> </box>
    <box id="crate" size="0.2,0.2,0.2" movable="true" mass="1.5">
      <body position="7,7,0" orientation="0,0,0" />
      <leds medium="leds"> <led offset="0,0,0.25" anchor="origin" color="255,0,0,255" /> </leds>
    </box>
    <cylinder id="can" radius="0.1" height="0.3" movable="true" mass="2.5"> <body position="-7,7,0" orientation="0,0,0" /> </cylinder>
    <light id="lamp" position="1,1,1" orientation="0,0,0" color="yellow" intensity="3.0" medium="leds" />
    <foot-bot id="first" rab_range="3" rab_data_size="10" omnidirectional_camera_aperture="70"
              perspective_camera_front="true" perspective_camera_aperture="30"
              perspective_camera_focal_length="0.035" perspective_camera_range="2">
      <body position="-5,0,0" orientation="90,0,0" />
      <controller config="foot"> <params alpha="7.5" delta="0.1" velocity="5" /> </controller>
      <battery discharge_model="time_motion" start_charge="1" full_charge="1" time_factor="1e-5" pos_factor="1e-3" orient_factor="1e-3" />
      <dynamics2d> <differential_steering max_force="15" max_torque="150" /> </dynamics2d>
    </foot-bot>
    <e-puck id="small" rab_range="0.8" rab_data_size="2">
      <body position="5,0,0" /> <controller config="epuck" />
      <battery discharge_model="motion" start_charge="1" full_charge="1" pos_delta="1e-3" orient_delta="1e-3" />
      <dynamics2d> <differential_steering max_force="1.5" max_torque="1.5" /> </dynamics2d>
    </e-puck>
    <distribute>
      <position method="uniform" min="-4,-4,0" max="-2,4,0" />
      <orientation method="gaussian" mean="0,0,0" std_dev="360,0,0" />
      <entity quantity="3" max_trials="100" base_num="5"> <foot-bot id="fb"> <controller config="foot" /> <battery discharge_model="time" start_charge="1" full_charge="1" delta="1e-5" /> </foot-bot> </entity>
    </distribute>
    <distribute>
      <position method="grid" center="2,0,0" distances="0.3,0.3,0" layout="2,2,1" />
      <orientation method="constant" values="0,0,0" />
      <entity quantity="4" max_trials="1"> <e-puck id="ep"> <controller config="epuck" /> </e-puck> </entity>
    </distribute>
  </arena>
  <physics_engines>
    <dynamics2d id="dyn2d" iterations="10" elevation="0" gripping_rigidity="10000">
      <friction box_linear_friction="1.49" box_angular_friction="1.49" cylinder_linear_friction="1.49" cylinder_angular_friction="1.49" />
      <spatial_hash cell_size="0.3" cell_num="100" />
      <boundaries>
        <top height="1" /> <bottom height="-1" />
        <sides> <vertex point="-10,-10" /> <vertex point="10,-10" /> <vertex point="10,10" /> <vertex point="-10,10" /> </sides>
      </boundaries>
    </dynamics2d>
  </physics_engines>
  <media>
    <led id="leds" index="grid" grid_size="20,20,4" />
    <directional_led id="directional" index="grid" grid_size="20,20,4" />
    <tag id="tags" index="grid" grid_size="20,20,4" />
    <simple_radio id="radios" index="grid" grid_size="20,20,4" />
    <range_and_bearing id="rab" index="grid" grid_size="20,20,4" check_occlusions="true" />
    <range_and_bearing id="all_pairs" index="dummy" check_occlusions="false" />
  </media>
  <visualization>
    <qt-opengl title="All" autoplay="true" lua_editor="false" invert_mouse="false" show_boundary="true">
      <camera>
        <placements>
          <placement index="0" position="-2,0,2" look_at="0,0,0" up="0,0,1" lens_focal_length="20" />
          <placement index="11" position="2,1,2" look_at="0,0,0" />
        </placements>
        <timeline loop="100"> <keyframe placement="0" step="0" /> <interpolate /> <keyframe placement="11" step="50" /> </timeline>
      </camera>
      <frame_grabbing directory="$FOLDER/" base_name="frame_" format="png" quality="-1" headless_grabbing="false" headless_frame_size="320x200" headless_frame_rate="10" />
      <user_functions label="some_user_functions" />
    </qt-opengl>
  </visualization>
</argos-configuration>)");
  CTestWorld cWorld(strXml);
  // what is accepted without effect is reported
  const std::string strWarnings = TakeLogErr();
  CHECK_THAT(strWarnings, Contains("\"positional_index\" has no effect") &&
                              Contains("\"positional_grid_size\" has no effect"));
  CHECK(std::count(strWarnings.begin(), strWarnings.end(), '\n') == 2);
  CHECK(cWorld.GetSpace().GetEntitiesByType("foot-bot").size() == 4);
  CHECK(cWorld.GetSpace().GetEntitiesByType("foot-bot").count("fb7") == 1);
  cWorld.Step(20);
  CHECK(TakeLogErr() == "");
}

TEST_CASE("compat: every element and attribute of a file for dynamics3d loads without a warning",
          "[compat]") {
  CFolder cFolder;
  const std::string strXml = cFolder.Fill(R"(<argos-configuration>
  <framework> <experiment length="1" ticks_per_second="10" random_seed="1" /> </framework>
  <controllers>$EPUCK
  </controllers>
  <arena size="10,10,4" center="0,0,1">
    <floor id="floor" source="loop_functions" pixels_per_meter="10" />
    <box id="crate" size="0.2,0.2,0.2" movable="true" mass="1.5"> <body position="1,1,0" /> </box>
    <e-puck id="small"> <body position="0,0,0" /> <controller config="epuck" /> </e-puck>
  </arena>
  <physics_engines>
    <dynamics3d id="dyn3d" iterations="25" default_friction="1" debug_file="$FOLDER/world.bullet">
      <floor friction="1" height="0" />
      <gravity g="10" />
      <magnetism force_constant="7.0500949e-13" max_distance="0.2" />
    </dynamics3d>
  </physics_engines>
  <media> <led id="leds" /> </media>
  <visualization />
</argos-configuration>)");
  CheckRunsWithoutWarning(strXml, 5);
}

TEST_CASE("compat: every element and attribute of a file for pointmass3d loads without a warning",
          "[compat]") {
  CheckRunsWithoutWarning(R"(<argos-configuration>
  <framework> <experiment length="1" ticks_per_second="10" random_seed="1" /> </framework>
  <controllers>
    <reference_controller id="fly">
      <actuators> <quadrotor_position implementation="default" /> <leds implementation="default" medium="leds" /> <range_and_bearing implementation="default" /> </actuators>
      <sensors> <eyebot_proximity implementation="default" show_rays="true" noise_level="0.1" /> <eyebot_light implementation="rot_z_only" show_rays="true" noise_level="0.1" /> <positioning implementation="default" /> <range_and_bearing implementation="medium" medium="rab" /> </sensors>
      <params />
    </reference_controller>
  </controllers>
  <arena size="10,10,6" center="0,0,3">
    <light id="lamp" position="1,1,1" color="white" intensity="1" medium="leds" />
    <eye-bot id="eb" rab_range="3" rab_data_size="10" camera_aperture="30" camera_focal_length="0.035" camera_range="2" camera_front="true">
      <body position="0,0,1" orientation="45,0,0" /> <controller config="fly" />
    </eye-bot>
  </arena>
  <physics_engines>
    <pointmass3d id="pm3d" iterations="10" gravity="-9.81">
      <boundaries> <top height="6" /> <bottom height="0" />
        <sides> <vertex point="-5,-5" /> <vertex point="5,-5" /> <vertex point="5,5" /> <vertex point="-5,5" /> </sides>
      </boundaries>
    </pointmass3d>
  </physics_engines>
  <media> <led id="leds" index="grid" /> <range_and_bearing id="rab" /> </media>
</argos-configuration>)",
                          5);
}

TEST_CASE("compat: every element and attribute of a prototype loads without a warning",
          "[compat]") {
  CheckRunsWithoutWarning(R"(<argos-configuration>
  <framework> <experiment length="1" ticks_per_second="10" random_seed="1" /> </framework>
  <controllers>
    <reference_controller id="arm">
      <actuators>
        <joints implementation="default"> <joint id="base:rod" mode="position" max_impulse="0.1" /> <joint id="base:wedge" mode="velocity" max_impulse="0.1" /> </joints>
        <directional_leds implementation="default" /> <tags implementation="default" /> <magnets implementation="default" /> <simple_radios implementation="default" />
      </actuators>
      <sensors>
        <joints implementation="default"> <joint id="base:rod" mode="position" /> <joint id="base:wedge" mode="velocity" /> </joints>
        <proximity implementation="default" show_rays="true" noise_level="0.1" /> <simple_radios implementation="default" show_rays="true" />
      </sensors>
      <params />
    </reference_controller>
  </controllers>
  <arena size="10,10,4" center="0,0,1">
    <prototype id="arm" movable="true">
      <body position="0,0,0.2" orientation="45,0,0" />
      <links ref="base">
        <link id="base" geometry="box" size="0.2,0.2,0.1" mass="1" position="0,0,0" orientation="0,0,0" />
        <link id="rod" geometry="cylinder" radius="0.02" height="0.2" mass="0.1" position="0,0,0.1" orientation="0,0,0" />
        <link id="ball" geometry="sphere" radius="0.03" mass="0.1" position="0,0,0.3" orientation="0,0,0" />
        <link id="wedge" geometry="convex_hull" mass="0.1" position="0.2,0,0" orientation="0,0,0">(0,0,0)(0.1,0,0)(0,0.1,0)(0,0,0.1)</link>
        <link id="tip" geometry="box" size="0.02,0.02,0.02" mass="0.01" position="-0.2,0,0" orientation="0,0,0" />
      </links>
      <joints>
        <joint id="base:rod" type="revolute" axis="0,0,1" limit="-90:90" disable_collision="true">
          <parent link="base" position="0,0,0.1" orientation="0,0,0" /> <child link="rod" position="0,0,0" orientation="0,0,0" />
        </joint>
        <joint id="rod:ball" type="spherical" disable_collision="true">
          <parent link="rod" position="0,0,0.2" orientation="0,0,0" /> <child link="ball" position="0,0,0" orientation="0,0,0" />
        </joint>
        <joint id="base:wedge" type="prismatic" axis="1,0,0" limit="-0.05:0.05" disable_collision="false">
          <parent link="base" position="0.2,0,0" orientation="0,0,0" /> <child link="wedge" position="0,0,0" orientation="0,0,0" />
        </joint>
        <joint id="base:tip" type="fixed" disable_collision="true">
          <parent link="base" position="-0.2,0,0" orientation="0,0,0" /> <child link="tip" position="0,0,0" orientation="0,0,0" />
        </joint>
      </joints>
      <devices>
        <leds medium="leds"> <led offset="0,0,0.1" anchor="base" color="red" /> </leds>
        <directional_leds medium="directional"> <directional_led position="0,0,0.1" orientation="0,0,0" anchor="rod" observable_angle="80" color="blue" /> </directional_leds>
        <tags medium="tags"> <tag position="0.1,0,0.05" orientation="0,90,0" anchor="base" observable_angle="75" side_length="0.02" payload="one" /> </tags>
        <simple_radios> <simple_radio position="0,0,0.1" anchor="base" range="1" medium="radios" /> </simple_radios>
        <magnets> <magnet offset="0.1,0,0.05" anchor="base" passive_field="0,0,1" active_field="0,0,2" /> </magnets>
        <proximity_sensors>
          <sensor anchor="base" offset="0.1,0,0.05" direction="1,0,0" range="0.3" />
        </proximity_sensors>
      </devices>
      <controller config="arm" />
    </prototype>
  </arena>
  <physics_engines> <dynamics3d id="dyn3d"> <floor /> <gravity g="9.81" /> <magnetism /> </dynamics3d> </physics_engines>
  <media> <led id="leds" /> <directional_led id="directional" /> <tag id="tags" /> <simple_radio id="radios" /> </media>
</argos-configuration>)",
                          5);
}

}  // namespace reference_file_test
