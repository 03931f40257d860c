#include <argos3/campaign/program/campaign_program.h>
#include <argos3/support/failed_writes.h>

int main(int argc, char** argv) {
  argos::SurviveFailedWrites();
  return argos::RunCampaignProgram(argc, argv);
}
