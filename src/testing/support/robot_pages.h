#ifndef ARGOS3_TESTING_SUPPORT_ROBOT_PAGES_H
#define ARGOS3_TESTING_SUPPORT_ROBOT_PAGES_H

#include <string>
#include <vector>

namespace argos {

/** The robots that have a page in doc/robots, by label. */
std::vector<std::string> RobotsWithPages();

/**
 * The page of a robot, in Markdown: what it says of itself, the devices that fit it, and what each
 * of them says of itself. A device fits if it accepts the robot in SetRobot().
 */
std::string MakeRobotPage(const std::string& label);

}  // namespace argos

#endif
