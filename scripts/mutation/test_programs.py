"""Which test programs notice changes of a source: see choose_programs()."""

# scripts/digests.sh, which compares digests with pinned ones
DIGESTS = "digests"

# By the first folders of a source below src/: those that test it, then wider ones that use it. Their test cases judge a change;
# if several files are mutated, those of the programs of all of them.
PROGRAMS = {
    "campaign": "unit_campaign_design_tests unit_campaign_report_tests unit_campaign_tests scenario_campaign_tests",
    "campaign/plot": "scenario_table_tests",
    "campaign/program": "unit_campaign_design_tests scenario_campaign_tests scenario_slurm_tests",
    "campaign/slurm": "scenario_slurm_tests scenario_campaign_tests",
    "campaign/statistics": "unit_campaign_tests unit_campaign_report_tests unit_campaign_design_tests scenario_campaign_tests",
    "core": "unit_core_tests unit_thread_tests unit_demand_tests compat_tests scenario_input_tests contract_tests scenario_tests "
            "scenario_fault_tests scenario_output_tests",
    "core/control_interface": "unit_core_tests compat_tests unit_lua_tests contract_tests scenario_tests",
    "core/simulator/geometry": "unit_core_tests unit_plugin_tests contract_sensor_tests contract_partition_tests contract_tests "
                               "scenario_tests contract_rigid_tests",
    "core/simulator/images": "unit_offscreen_tests contract_sensor_tests scenario_output_tests scenario_golden_tests",
    "core/simulator/outputs": "unit_core_tests scenario_table_tests scenario_output_tests scenario_recording_tests",
    "core/simulator/physics_engine": "unit_core_tests unit_plugin_tests contract_drive_tests contract_partition_tests "
                                     "compat_tests contract_tests scenario_tests contract_rigid_tests determinism_partition_tests",
    "core/simulator/placement": "unit_core_tests compat_tests contract_partition_tests scenario_tests",
    "core/simulator/space": "unit_core_tests unit_plugin_tests contract_partition_tests contract_sensor_tests compat_tests "
                            "contract_tests scenario_table_tests scenario_tests determinism_tests",
    "core/simulator/tick": "unit_core_tests unit_thread_tests contract_tests scenario_fault_tests determinism_tests",
    "core/simulator/visualization": "unit_drawing_tests unit_core_tests unit_offscreen_tests compat_tests scenario_golden_tests",
    "core/utility/datatypes": "unit_core_tests compat_tests unit_lua_tests contract_camera_tests contract_tests",
    "core/utility/math": "unit_core_tests unit_plugin_tests compat_tests contract_sensor_tests contract_tests scenario_tests",
    "core/utility/threads": "unit_thread_tests unit_core_tests determinism_tests",
    "core/wrappers/lua": "unit_lua_tests scenario_lua_tests",
    "compat": "unit_core_tests compat_tests unit_lua_tests contract_tests scenario_tests",
    "plugins/entities": "unit_plugin_tests compat_tests contract_camera_tests contract_sensor_tests contract_tests scenario_tests",
    "plugins/images": "unit_offscreen_tests scenario_output_tests contract_sensor_tests scenario_golden_tests",
    "plugins/loop_functions": "scenario_lua_tests unit_lua_tests scenario_table_tests",
    "plugins/media": "unit_plugin_tests contract_camera_tests contract_sensor_tests contract_tests scenario_tests determinism_tests",
    "plugins/outputs/quantities": "unit_core_tests scenario_table_tests scenario_output_tests scenario_recording_tests",
    "plugins/outputs/recording": "unit_plugin_tests scenario_recording_tests scenario_output_tests unit_offscreen_tests",
    "plugins/outputs/tables": "scenario_table_tests scenario_output_tests",
    "plugins/physics_engines": "unit_plugin_tests contract_drive_tests contract_partition_tests contract_tests scenario_tests "
                               "determinism_partition_tests determinism_tests",
    "plugins/physics_engines/dynamics3d": "unit_plugin_tests contract_drive_tests contract_partition_tests contract_rigid_tests "
                                          "contract_tests scenario_tests determinism_partition_tests determinism_tests",
    "plugins/robots": "unit_plugin_tests contract_camera_tests contract_sensor_tests compat_tests scenario_lua_tests contract_tests "
                      "scenario_tests determinism_tests",
    "plugins/visualizations": "unit_offscreen_tests unit_overlay_tests unit_povray_tests scenario_golden_tests compat_tests "
                              "scenario_recording_tests",
    "plugins/visualizations/drawing": "unit_drawing_tests unit_core_tests unit_offscreen_tests compat_tests scenario_golden_tests",
    "plugins/visualizations/live": "scenario_live_tests",
    "plugins/visualizations/overlays": "unit_overlay_tests unit_offscreen_tests scenario_golden_tests",
    "plugins/visualizations/povray": "unit_povray_tests scenario_golden_tests",
    "program": "unit_core_tests unit_demand_tests scenario_input_tests scenario_tests scenario_output_tests "
               "scenario_recording_tests scenario_fault_tests",
    "run": "unit_core_tests scenario_tests scenario_fault_tests scenario_campaign_tests scenario_output_tests",
    "support": "unit_core_tests scenario_fault_tests scenario_campaign_tests scenario_output_tests",
}


def choose_programs(path: str) -> list[str]:
    """The test programs of a source, relative to the tree, in the order in which they run."""
    folder = path.rpartition("/")[0].removeprefix("src/")
    while folder not in PROGRAMS:
        if not folder:
            raise SystemExit(f"{path}: no test programs are known for its folder; add it to scripts/mutation/test_programs.py")
        folder = folder.rpartition("/")[0]
    programs = PROGRAMS[folder].split()
    # takes seconds, and sees the final state of scenes, tables, figures, scenes of POV-Ray and texts
    programs.insert(1, DIGESTS)
    return programs
