# shellcheck shell=bash
export ARGOS_PLUGIN_PATH="$PWD/build"
argos3 -c trails.argos
# the robots of each of the frames 0, 5 and 10, in their order
wc -l <drawn.txt | expect 'number of robots drawn' 1 6 0
[[ "$(sed -n 5,6p drawn.txt)" == $'10 fb_0\n10 fb_1' ]]
# a disc of 0.5 m seen from 2 m: 120 pixels a metre, 11310 pixels, of which those of the border are paler; 24-bit BMP
tail -c +55 frame_0000000010.bmp | od -An -v -tu1 -w3 | grep -c '^ *0 *0 *255$' | expect 'red pixels' 1 11100 300
