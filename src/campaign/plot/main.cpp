#include <argos3/campaign/plot/plot_program.h>

int main(int argc, char** argv) {
  return argos::RunPlotProgram(argc, argv);
}
