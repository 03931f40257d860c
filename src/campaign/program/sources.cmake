# the program argos3-campaign, a file for each command
target_sources(argos3campaign PRIVATE
  program/campaign_program.cpp
  program/command_options.cpp
  program/export_command.cpp
  program/live_command.cpp
  program/report_command.cpp
  program/retry_command.cpp
  program/run_command.cpp
  program/share_commands.cpp
  program/status_command.cpp
  program/submit_command.cpp)
