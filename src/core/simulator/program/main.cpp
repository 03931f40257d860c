#include <argos3/core/simulator/program/command_line.h>

int main(int argc, char** argv) {
  return argos::RunCommandLine(argc, argv);
}
