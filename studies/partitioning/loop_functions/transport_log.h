#ifndef TRANSPORT_LOG_H
#define TRANSPORT_LOG_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/files/output_file.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/math/vector2.h>

#include <deque>
#include <map>
#include <string>
#include <vector>

namespace argos {
class CCylinderEntity;
class CFootBotEntity;
}  // namespace argos
class CTransporter;

/**
 * Puts objects that lie in the nest back at the source, and measures.
 *
 * Metrics: delivered, objects so far; throughput, those of the last 15 minutes; lost, how often a
 * robot did not find an object where it remembered one; error, m, mean over all arrivals so far.
 *
 * The file errors.csv has a row for each arrival of a robot at the place that it remembers: where
 * the robot was, relative to where it believed to be, in m, in the frame of the robot when it
 * gripped an object there: x points ahead of it.
 */
class CTransportLog : public argos::CLoopFunctions {
 public:
  /**
   * Reads the optional attributes nest (m, objects with a smaller y are in the nest), source (m, y
   * of its centre; x is 0), radius (m, of the source) and output (name of the file of errors).
   */
  void Init(argos::TConfigurationNode& node) override;
  void Reset() override;
  void Destroy() override;
  argos::CColor GetFloorColor(const argos::CVector2& position) override;
  void PostStep() override;

 private:
  struct SRobot {
    argos::CFootBotEntity* Entity;
    CTransporter* Controller;
    argos::UInt32 NumGrips;
    argos::UInt32 NumArrivals;
    argos::CVector2 Place;  // of the last grip, m
    argos::CRadians Heading;
  };

  void Start();
  void PutBackDelivered();
  bool IsHeld(const argos::CCylinderEntity& object) const;
  void Follow(SRobot& robot);

  argos::CRandom::CRNG* m_rng = nullptr;
  argos::Real m_nest = -2.0;
  argos::Real m_source = 2.0;
  argos::Real m_radius = 0.4;
  std::string m_fileName = "errors.csv";
  argos::COutputFile m_file;

  std::vector<SRobot> m_robots;
  std::vector<argos::CCylinderEntity*> m_objects;
  std::deque<argos::UInt32> m_deliveries;  // ticks, of the last 15 minutes
  argos::UInt32 m_delivered = 0;
  argos::Real m_sumOfErrors = 0.0;
  argos::UInt32 m_numErrors = 0;
};

#endif
