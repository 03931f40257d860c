#ifndef ARGOS3_CAMPAIGN_PLOT_PLOT_PROGRAM_H
#define ARGOS3_CAMPAIGN_PLOT_PLOT_PROGRAM_H

namespace argos {

/** The program argos3-plot. @return its exit status: 0, or 1 after an error, which is printed. */
int RunPlotProgram(int argc, const char* const* argv) noexcept;

}  // namespace argos

#endif
