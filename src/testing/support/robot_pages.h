#ifndef ARGOS3_TESTING_SUPPORT_ROBOT_PAGES_H
#define ARGOS3_TESTING_SUPPORT_ROBOT_PAGES_H

#include <string>
#include <vector>

namespace argos {

/** The robots that have a page in doc/robots, by label. */
std::vector<std::string> RobotsWithPages();

/**
 * The page of a robot in Markdown: its description, the devices that it supports, and their
 * descriptions. A device is supported if it accepts the robot in SetRobot().
 */
std::string MakeRobotPage(const std::string& label);

}  // namespace argos

#endif
