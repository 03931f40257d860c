#ifndef ARGOS3_CORE_SIMULATOR_REPLAY_REPLAY_H
#define ARGOS3_CORE_SIMULATOR_REPLAY_REPLAY_H

#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/plugins/factory.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace argos {

class CLoopFunctions;
class CSpace;

/** A time of a recorded run. */
struct SReplayTime {
  Real Value = 0.0; /**< >= 0 */
  bool IsInSeconds = false; /**< otherwise in ticks */
};

/** Of "100", a tick, or "12.5s", a time; nothing if it is neither. */
std::optional<SReplayTime> ParseReplayTime(const std::string& text);

/** Where something was in a state of a recorded run. */
struct SRecordedPose {
  std::string Id;
  SBodyPose Pose; /**< pose of the origin, m, world frame; rounded as the recording is */
};

/** What is to be replayed. */
struct SReplayRequest {
  std::string File; /**< the recording */
  std::string ViewsFile; /**< experiment file with other views and outputs; empty: the recorded */
  std::optional<SReplayTime> From; /**< unset: the first state */
  std::optional<SReplayTime> To; /**< unset: the last state */
  UInt32 Every = 1; /**< ticks from state to state, from the first one on; > 0 */
};

/**
 * Gives the space the states of a recorded run, one after another. In a replay it takes the place
 * of controllers, engines, media and loop functions, none of which exist.
 */
class CReplay {
 public:
  virtual ~CReplay() = default;

  /** Opens the recording. @throws CARGoSException if it cannot be read, or has no such part. */
  virtual void Open(const SReplayRequest& request) = 0;

  /** The seed of the run that a recording contains. @throws CARGoSException as Open() */
  virtual UInt32 ReadSeed(const std::string& file) const = 0;

  /**
   * Poses of all entities that have one.
   * @param at  of a state, or after one that was recorded last; unset: the last one
   * @throws CARGoSException as Open()
   */
  virtual std::vector<SRecordedPose> ReadPoses(const std::string& file,
                                               const std::optional<SReplayTime>& at) const = 0;

  /** The XML of the experiment that was recorded. */
  virtual const std::string& GetExperiment() const = 0;
  /** Its file, for messages. */
  virtual const std::string& GetExperimentFile() const = 0;
  virtual UInt32 GetSeed() const = 0;
  /** Of the run, s. */
  virtual Real GetTickLength() const = 0;
  /** @return true if poses have all the bits of the run. */
  virtual bool IsExact() const = 0;
  /** Not less than the tick of the last state. */
  virtual UInt32 GetLastTick() const = 0;

  /** Loop functions that draw and colour the floor as those of the run did. Outlived by this. */
  virtual std::unique_ptr<CLoopFunctions> MakeLoopFunctions() = 0;
  /** Sets the first state: adds entities, and sets the clock. */
  virtual void Begin(CSpace& space) = 0;
  /** Sets the next state. Does nothing at the end. @throws CARGoSException */
  virtual void Advance(CSpace& space) = 0;
  /** Sets the first state at @p tick or later, at most the last one. @throws CARGoSException */
  virtual void Seek(CSpace& space, UInt32 tick) = 0;
  /** @return true if there is no further state. */
  virtual bool IsAtEnd() const = 0;
};

}  // namespace argos

#define REGISTER_REPLAY(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, LONG_DESCRIPTION,    \
                        STATUS)                                                                    \
  REGISTER_SYMBOL(CReplay, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, LONG_DESCRIPTION, \
                  STATUS)

#endif
