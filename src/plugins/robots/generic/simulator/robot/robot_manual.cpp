#include <argos3/plugins/robots/generic/simulator/robot_manual.h>

#include <fmt/format.h>

namespace argos {

namespace {

constexpr const char* kExamples = R"(
REQUIRED XML

  <arena size="{arena}">
    <{tag} id="{id}">
      <body position="0.4,2.3,0" orientation="45,0,0" />
      <controller config="c1" />
    </{tag}>
  </arena>

OPTIONAL XML

  <arena size="{arena}">
    <{tag} id="{id}" rab_range="{rabRange}" rab_data_size="{rabDataSize}"{exampleAttributes}>
      <body position="0.4,2.3,0" />
      <controller config="c1">
        <params speed="10" />
      </controller>
      <battery discharge_model="time" delta="1e-5" start_charge="1" full_charge="1" />
    </{tag}>
  </arena>

ATTRIBUTES AND CHILDREN

  id                               text, required: unique among the entities of the arena.
  body@position                    "x,y,z", m, default "0,0,0": centre of the base, in the world frame.
  body@orientation                 "z,y,x", degrees, default "0,0,0": the x axis of the robot points ahead.
  controller@config                text, required: the id of a child of <controllers>.
  controller/params                replaces the <params> of the controller for this robot.
  rab_range                        m, >= 0, default {rabRange}: range of the messages of this robot.
  rab_data_size                    integer >= 0, default {rabDataSize}: bytes of a message.
)";

constexpr const char* kCommonChildren =
    R"(  battery                          the robot's battery; without it the charge never falls. The charge falls
                                   only if the controller has the sensor "battery".
  battery@discharge_model          "time" (default), "motion" or "time_motion", or the label of a user's model.
  battery@model, battery@factor    of ARGoS 3; have no effect, which a warning says.
  battery@start_charge             in [0, full_charge], default 1: charge at the start and after a reset.
  battery@full_charge              > 0, default 1.
  battery@delta                    of "time": >= 0, default 1e-5: charge used in each tick.
  battery@pos_delta                of "motion": >= 0, default 1e-3: charge used per m of motion.
  battery@orient_delta             of "motion": >= 0, default 1e-3: charge used per rad of rotation.
  battery@time_factor, battery@pos_factor, battery@orient_factor
                                   the same three parameters of "time_motion", which uses their sum.
  directional_leds, tags, magnets, simple_radios, rfid_tags
                                   further devices on the robot. The manuals of the media
                                   "directional_led", "tag" and "simple_radio", of the actuator "magnets"
                                   and of the entity "rfid_tag" describe them.
)";

}  // namespace

std::string MakeRobotManual(const SRobotManual& robot) {
  return robot.Summary +
         fmt::format(fmt::runtime(kExamples), fmt::arg("arena", robot.Arena),
                     fmt::arg("tag", robot.Tag), fmt::arg("id", robot.Id),
                     fmt::arg("rabRange", robot.RAB.Range),
                     fmt::arg("rabDataSize", robot.RAB.DataSize),
                     fmt::arg("exampleAttributes", robot.ExampleAttributes)) +
         robot.Attributes + kCommonChildren;
}

std::string DriveManual(Real maxForce, Real maxTorque) {
  return fmt::format(
      "\nThe wheels push the robot with at most {} N and turn it with at most {} N m, in physics "
      "engines that\n"
      "compute forces. A child that is named after a physics engine may contain settings of this "
      "robot for\n"
      "that engine, such as other limits; the manual of the engine describes them.\n",
      maxForce, maxTorque);
}

}  // namespace argos
