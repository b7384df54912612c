// A knee and an ankle as a transmission of ros2_control, from two motors at the knee.
//
// Rates go through the ratios of the pose and efforts through their transpose, so that both sides have one power. Where a
// pose is out of reach, or on another assembly, nothing is written: the interface has no status.
#include <map>
#include <string>
#include <vector>

#include <transmission_interface/transmission.hpp>

#include "ankle.h"

class AnkleTransmission : public transmission_interface::Transmission
{
public:
  void configure(
    const std::vector<transmission_interface::JointHandle> & joints,
    const std::vector<transmission_interface::ActuatorHandle> & actuators) override
  {
    for (const auto & handle : joints) joints_[handle.get_interface_name()].push_back(handle);
    for (const auto & handle : actuators) actuators_[handle.get_interface_name()].push_back(handle);
  }

  void actuator_to_joint() override
  {
    if (!has_two(actuators_, "position")) return;
    const AnkleMotorsInput at = input<AnkleMotorsInput>(actuators_["position"]);
    AnkleMotorsToJoints to;
    if (ankle_motors_to_joints(&at, &to, nullptr) != LINKAGE_OK) return;
    put(joints_, "position", to.coordinates.knee, to.coordinates.ankle);
    AnkleJointsInput found;
    if (has_two(actuators_, "velocity")) {
      const AnkleMotorsInput rates = input<AnkleMotorsInput>(actuators_["velocity"]);
      if (ankle_motors_to_joints_rates(&to, &rates, &found, nullptr) == LINKAGE_OK)
        put(joints_, "velocity", found.knee, found.ankle);
    }
    if (has_two(actuators_, "effort")) {
      // The efforts at the joints with the power of the motors'.
      const AnkleMotorsInput efforts = input<AnkleMotorsInput>(actuators_["effort"]);
      AnkleJointsToMotors back;
      if (
        ankle_joints_to_motors(&to.coordinates, &back, nullptr) == LINKAGE_OK &&
        ankle_joints_to_motors_efforts(&back, &efforts, &found, nullptr) == LINKAGE_OK)
        put(joints_, "effort", found.knee, found.ankle);
    }
  }

  void joint_to_actuator() override
  {
    if (!has_two(joints_, "position")) return;
    const AnkleJointsInput at = input<AnkleJointsInput>(joints_["position"]);
    AnkleJointsToMotors to;
    if (ankle_joints_to_motors(&at, &to, nullptr) != LINKAGE_OK) return;
    put(actuators_, "position", to.coordinates.knee, to.coordinates.motor);
    AnkleMotorsInput found;
    if (has_two(joints_, "velocity")) {
      const AnkleJointsInput rates = input<AnkleJointsInput>(joints_["velocity"]);
      if (ankle_joints_to_motors_rates(&to, &rates, &found, nullptr) == LINKAGE_OK)
        put(actuators_, "velocity", found.knee, found.motor);
    }
    if (has_two(joints_, "effort")) {
      const AnkleJointsInput efforts = input<AnkleJointsInput>(joints_["effort"]);
      AnkleMotorsToJoints back;
      if (
        ankle_motors_to_joints(&to.coordinates, &back, nullptr) == LINKAGE_OK &&
        ankle_motors_to_joints_efforts(&back, &efforts, &found, nullptr) == LINKAGE_OK)
        put(actuators_, "effort", found.knee, found.motor);
    }
  }

  std::size_t num_actuators() const override { return 2; }
  std::size_t num_joints() const override { return 2; }

private:
  template <class Handle>
  using Handles = std::map<std::string, std::vector<Handle>>;

  template <class Handle>
  static bool has_two(const Handles<Handle> & handles, const std::string & name)
  {
    const auto found = handles.find(name);
    return found != handles.end() && found->second.size() == 2;
  }

  template <class Input, class Handle>
  static Input input(const std::vector<Handle> & handles)
  {
    return Input{handles[0].get_value(), handles[1].get_value()};
  }

  template <class Handle>
  static void put(Handles<Handle> & handles, const std::string & name, double first, double second)
  {
    if (!has_two(handles, name)) return;
    handles[name][0].set_value(first);
    handles[name][1].set_value(second);
  }

  Handles<transmission_interface::JointHandle> joints_;
  Handles<transmission_interface::ActuatorHandle> actuators_;
};
