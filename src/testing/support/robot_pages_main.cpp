// Writes the pages of the robots. Usage: robot_pages <folder>

#include <argos3/testing/support/robot_pages.h>

#include <filesystem>
#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: " << argv[0] << " <folder>\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  for (const std::string& robot : argos::RobotsWithPages()) {
    const std::filesystem::path file = folder / (robot + ".md");
    std::ofstream page(file);
    page << argos::MakeRobotPage(robot);
    if (!page.flush()) {
      std::cerr << "cannot write " << file << '\n';
      return 1;
    }
    std::cout << file.string() << '\n';
  }
  return 0;
}
