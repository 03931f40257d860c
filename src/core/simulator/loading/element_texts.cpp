// What argos3 -q and schemas say of the elements of experiment files that are no plug-ins.

#include <argos3/core/utility/plugins/plugin_kind.h>

namespace argos {

namespace {

constexpr const char* kAuthor = "the authors of this project";

const CElementText kSystem("system", kAuthor, "How many threads run the simulation, and how.",
                           R"(Results are the same for all values.

OPTIONAL XML

  <framework>
    <system threads="4" method="balance_quantity" grain="auto" pin_threads_to_cores="false" />
  </framework>

ATTRIBUTES

  threads   integer in [0,1024], default 0: number of threads. 0 and 1 both mean the main thread alone. --threads
            overrides it.
  method    text, default "balance_quantity": how robots are distributed over the threads. "balance_quantity": each
            thread has as many; "balance_length": a thread that has finished takes the next ones.
  grain     "auto" or an integer > 0, default "auto": how many robots a thread updates in a row; "auto" is by the
            measured cost.
  pin_threads_to_cores  "true" or "false", default "false": each thread beside the main one stays on one core of the
            processor. It can make a run faster on a computer that does nothing else, and slower on others.
  library   text: a library to load before, for a method of its own.
)");

const CElementText kExperiment("experiment", kAuthor, "Length, ticks and seed of the run.",
                               R"(REQUIRED XML

  <framework>
    <experiment length="60" ticks_per_second="10" />
  </framework>

OPTIONAL XML

  <framework>
    <experiment length="60" ticks_per_second="10" random_seed="7" real_time="true" on_error="stop_robot"
                lenient="false" />
  </framework>

ATTRIBUTES

  ticks_per_second  integer >= 1, required: number of ticks in a simulated second.
  length       s, >= 0, default 0: simulated time after which the run ends; 0: no limit. --length overrides it.
  random_seed  integer from 0 to 4294967295, default 0: equal seeds give equal runs. 0: a seed is drawn from the
               clock; the log names it. --seed overrides it.
  real_time    "true" or "false", default "false": each tick takes at least as long as the time that it simulates; a
               warning says which took longer. The views <offscreen> and <povray> do not wait.
  on_error     text: what follows when the code of a robot fails in a run. "end_run": the run ends with status 1.
               "stop_robot": its controller is not called any more, the others go on, and a run that ends normally
               has status 3. "quarantine": as stop_robot, and the robot leaves physics and media. Default: controllers
               in C++ end the run, controllers in Lua stop their robot. An attribute of the same name of a
               controller's element, or of <params> of controllers in Lua, precedes this one.
  lenient      "true" or "false", default "false": malformed numbers are read as ARGoS 3 reads them, with a warning,
               instead of being errors.
)");

const CElementText kProfiling(
    "profiling", kAuthor, "Measures the time and the memory of a run.",
    R"(At the end of the run, a file gets the wall time, the processor time of all threads, the memory that was used at
most, page faults, and the time of each phase of the ticks.

REQUIRED XML

  <framework>
    <profiling file="profile.txt" format="human_readable" />
  </framework>

OPTIONAL XML

  <framework>
    <profiling file="profiles.tsv" format="table" truncate_file="false" />
  </framework>

ATTRIBUTES

  file           path, required.
  format         "human_readable", a report, or "table", a line of values separated by tabs, below a line of names if
                 the file is empty. Required.
  truncate_file  "true" or "false", default "true": "false" appends to the file, so several runs make one table.
)");

const CElementText kArena(
    "arena", kAuthor, "The space of the experiment, and what it contains at the start.",
    R"(Its children are entities, <walls>, <distribute>, and robots of the types in <robot_types>.

REQUIRED XML

  <arena size="4,4,2">
    <box id="wall" size="4,0.1,0.5" movable="false">
      <body position="0,2,0" orientation="0,0,0" />
    </box>
  </arena>

OPTIONAL XML

  <arena size="4,4,2" center="0,0,1" redistribute="true" walls="0.1,0.3" periodic="false">
    <distribute>
      <position method="uniform" min="-2,-2,0" max="2,2,0" />
      <orientation method="constant" values="0,0,0" />
      <entity quantity="5" max_trials="100">
        <cylinder id="puck" radius="0.05" height="0.1" movable="true" mass="0.1" />
      </entity>
    </distribute>
  </arena>

ATTRIBUTES

  size          "x,y,z", m, required: extents. They are no walls: things may be outside.
  center        "x,y,z", m, default "0,0,0".
  redistribute  "true" or "false", default "false": with "true" a reset draws the places of <distribute> from the seed
                of the new run; with "false" it restores those of the start.
  start_from    path of a recording: entities start where those of the same ids were in it, at its last state. It is
                searched in the working folder, then beside the file. doc/guide/placing.md has an example.
  start_at      a tick of that recording, such as "600", or a time, such as "60s".
  walls         "thickness,height", m: walls along the sides, within the size. Default: none. <walls> makes others.
  periodic      "true" or "x,y", "x", "y", "false", default "false": which opposite sides are joined, those across the
                x axis or the y axis. What leaves through one comes back through the other, and robots touch and sense
                each other across it. With kinematics2d or dynamics2d, one engine, and without walls="...".
  positional_index, positional_grid_size  of ARGoS 3; have no effect here, which a warning says.
)");

const CElementText kWalls(
    "walls", kAuthor, "Walls along lines, from an image or a drawing, or around the arena.",
    R"(Makes boxes that cannot move, <id>_0, <id>_1, ... doc/guide/placing.md has a picture.

REQUIRED XML

  <arena size="20,20,10">
    <walls thickness="0.1" height="0.3" />
  </arena>

OPTIONAL XML

  <arena size="20,20,10">
    <walls id="room" points="0,0 4,0 4,3" closed="false" thickness="0.1" height="0.3" base="0" />
    <walls id="map" image="plan.png" meters_per_pixel="0.05" center="0,0" threshold="0.5" height="0.3" />
    <walls id="plan" svg="plan.svg" meters_per_unit="0.01" corner="0,0" thickness="0.1" height="0.3" />
  </arena>

ATTRIBUTES

  id         text, default "walls": of which the ids of the boxes begin.
  thickness  m, > 0: of the walls; not for an image.
  height     m, > 0, required.
  base       m, default 0: height of the lower edge above the ground.
  points     "x,y x,y ...", m: corners of the line along which the walls stand. Without points, image and svg the walls
             stand along the sides of the arena, within its size.
  closed     "true" or "false", default "true": the last corner is joined to the first.
  image      path of an image whose dark pixels are walls; searched in the working folder, then beside the file.
  meters_per_pixel  m, > 0, required for an image.
  center     "x,y", m, default "0,0": place of the middle of the image.
  threshold  real in (0,1], default 0.5: a pixel whose mean of red, green and blue is below it is wall; 1 is white.
  svg        path of a drawing whose straight lines become walls: line, polyline, polygon, rect, path.
  meters_per_unit  m, > 0, required for a drawing: length of one of its units.
  corner     "x,y", m, default "0,0": place of the upper left corner of the drawing.
)");

const CElementText kDistribute(
    "distribute", kAuthor, "Places a number of entities at random or in a grid.",
    R"(Draws a place for each entity; one that overlaps others is drawn again. doc/guide/placing.md has examples.

REQUIRED XML

  <arena size="20,20,10">
    <distribute>
      <position method="uniform" min="-2,-2,0" max="2,2,0" />
      <orientation method="gaussian" mean="0,0,0" std_dev="360,0,0" />
      <entity quantity="5" max_trials="100">
        <cylinder id="puck" radius="0.05" height="0.1" movable="true" mass="0.1" />
      </entity>
    </distribute>
  </arena>

OPTIONAL XML

  <arena size="20,20,10">
    <distribute>
      <position method="grid" center="0,0,0" distances="0.5,0.5,0" layout="3,2,1" />
      <orientation method="constant" values="90,0,0" />
      <entity quantity="6" max_trials="1" base_num="10">
        <cylinder id="post" radius="0.05" height="0.3" movable="false" />
      </entity>
    </distribute>
  </arena>

ATTRIBUTES

  id               text: has no effect, which a warning says.
  position@method  "uniform", "gaussian", "constant" or "grid", required. Positions are in m and mean the centre of the
                   base; orientations are in degrees, about z, then y, then x.
  position@min, position@max    "x,y,z", required for "uniform": each coordinate is drawn evenly between them.
  position@mean, position@std_dev  "x,y,z", required for "gaussian": of the normal distribution of each coordinate.
  position@values  "x,y,z", required for "constant": the same for all.
  position@center, position@distances  "x,y,z", required for "grid": middle of the grid; distances between places
                   along x, y and z.
  position@layout  "nx,ny,nz", required for "grid": number of places along x, y and z. They are filled from the largest
                   coordinates on, along x first.
  orientation@method, @min, @max, @mean, @std_dev      as of a position, in degrees.
  orientation@values, @center, @distances, @layout     as of a position, in degrees.
  entity@quantity    integer from 0 to 10000000, required: number of entities. The element inside is their pattern.
  entity@max_trials  integer from 0 to 10000000, required: largest number of draws for each of them.
  entity@base_num    integer >= 0, default 0: number in the id of the first one: id="fb" and base_num="10" give fb10,
                     fb11, ...
)");

const CElementText kBoundaries(
    "boundaries", kAuthor, "The region of space that belongs to a physics engine.",
    R"(An upright prism. A part that is missing does not limit it. doc/space_partitioning.md describes what happens at
borders.

OPTIONAL XML

  <physics_engines>
    <dynamics3d id="hall">
      <boundaries>
        <top height="3" wall="true" />
        <bottom height="0" wall="true" />
        <sides>
          <vertex point="-5,-5" wall="true" />
          <vertex point="5,-5" wall="true" />
          <vertex point="5,5" wall="true" />
          <vertex point="-5,5" wall="true" />
        </sides>
      </boundaries>
    </dynamics3d>
  </physics_engines>

ATTRIBUTES

  top@height, bottom@height  m, required.
  top@wall, bottom@wall, vertex@wall  "true" or "false", default "false": bodies cannot pass.
  top@gate, bottom@gate, vertex@gate  text: the id of the engine to which bodies pass. Default: the first engine whose
                region contains them.
  vertex@point  "x,y", m, required: a corner of the convex polygon, counter-clockwise seen from above; wall and gate
                are those of the side from this corner to the next.
)");

}  // namespace

}  // namespace argos
