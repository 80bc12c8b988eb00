#include "contact/joint_friction.hpp"

namespace carom::event {

template class JointFriction<double>;
template JointReport resolve_jointly(std::span<Body<double>>, std::span<const Contact<double>>,
                                     JointFriction<double>*, JointRecord<double>*, bool);

}  // namespace carom::event
