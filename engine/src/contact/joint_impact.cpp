#include "contact/joint_impact.hpp"

namespace carom::event {

template class JointImpact<double>;

}  // namespace carom::event
