# a campaign as an array job of Slurm: shares of its runs, job scripts, merging
target_sources(argos3campaign PRIVATE
  slurm/job_scripts.cpp
  slurm/part_merging.cpp
  slurm/run_share.cpp
  slurm/slurm_client.cpp
  slurm/submission.cpp
  slurm/submission_files.cpp)
