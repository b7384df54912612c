// Poses, rates and efforts there and back through the transmission.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "ankle_transmission.cpp"

int main()
{
  const char * kinds[3] = {"position", "velocity", "effort"};
  double joint[3][2] = {}, motor[3][2] = {};
  std::vector<transmission_interface::JointHandle> joints;
  std::vector<transmission_interface::ActuatorHandle> actuators;
  for (int kind = 0; kind < 3; ++kind)
    for (int nth = 0; nth < 2; ++nth) {
      joints.emplace_back(nth ? "ankle" : "knee", kinds[kind], &joint[kind][nth]);
      actuators.emplace_back(nth ? "motor" : "knee", kinds[kind], &motor[kind][nth]);
    }
  AnkleTransmission transmission;
  transmission.configure(joints, actuators);
  const auto unit = [] { return std::rand() / static_cast<double>(RAND_MAX) * 2.0 - 1.0; };
  double back = 0.0, power = 0.0;
  for (int turn = 0; turn < 20000; ++turn) {
    double before[3][2];
    for (int kind = 0; kind < 3; ++kind)
      for (int nth = 0; nth < 2; ++nth) before[kind][nth] = joint[kind][nth] = 0.6 * unit();
    transmission.joint_to_actuator();
    double difference = 0.0, size = 1e-3;
    for (int nth = 0; nth < 2; ++nth) {
      difference += joint[1][nth] * joint[2][nth] - motor[1][nth] * motor[2][nth];
      size += std::fabs(joint[1][nth] * joint[2][nth]) + std::fabs(motor[1][nth] * motor[2][nth]);
    }
    power = std::fmax(power, std::fabs(difference) / size);
    transmission.actuator_to_joint();
    for (int kind = 0; kind < 3; ++kind)
      for (int nth = 0; nth < 2; ++nth) back = std::fmax(back, std::fabs(joint[kind][nth] - before[kind][nth]));
  }
  std::printf("%zu %zu %.3e %.3e\n", transmission.num_joints(), transmission.num_actuators(), back, power);
  return 0;
}
