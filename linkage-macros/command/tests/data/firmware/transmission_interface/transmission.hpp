// The names that a transmission of ros2_control has from transmission_interface, for a test alone.
#ifndef TRANSMISSION_INTERFACE__TRANSMISSION_HPP_
#define TRANSMISSION_INTERFACE__TRANSMISSION_HPP_

#include <cstddef>
#include <string>
#include <vector>

namespace transmission_interface
{
class Handle
{
public:
  Handle(const std::string & name, const std::string & interface, double * value)
  : name_(name), interface_(interface), value_(value) {}
  const std::string & get_interface_name() const { return interface_; }
  double get_value() const { return *value_; }
  void set_value(double value) { *value_ = value; }

private:
  std::string name_, interface_;
  double * value_;
};

class JointHandle : public Handle { using Handle::Handle; };
class ActuatorHandle : public Handle { using Handle::Handle; };

class Transmission
{
public:
  virtual ~Transmission() = default;
  virtual void configure(const std::vector<JointHandle> &, const std::vector<ActuatorHandle> &) = 0;
  virtual void actuator_to_joint() = 0;
  virtual void joint_to_actuator() = 0;
  virtual std::size_t num_actuators() const = 0;
  virtual std::size_t num_joints() const = 0;
};
}  // namespace transmission_interface

#endif  // TRANSMISSION_INTERFACE__TRANSMISSION_HPP_
