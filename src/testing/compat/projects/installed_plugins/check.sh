# shellcheck shell=bash
# into a copy of the installation, so that other projects do not get these plug-ins
cp -al "${CMAKE_PREFIX_PATH:?}" installed 2>/dev/null || cp -a "$CMAKE_PREFIX_PATH" installed
cmake --install build --prefix "$PWD/installed" >install.log
installed/bin/argos3 -z -n -c fleet.argos >run.log
grep -x 'a is an airship' run.log
grep -x 'b is an aerostat' run.log

# without the plug-in that the others need, the error says which it is and where it is looked for
rm installed/lib/argos3/libargos3plugin_simulator_zeppelin.so
if installed/bin/argos3 -z -n -c fleet.argos >run.log 2>errors; then exit 1; fi
grep 'It is linked with "libargos3plugin_simulator_zeppelin.so".*ARGOS_PLUGIN_PATH' errors
# in any folder of plug-ins it is found
ARGOS_PLUGIN_PATH="$PWD/build" installed/bin/argos3 -z -n -c fleet.argos | grep -x 'a is an airship'
