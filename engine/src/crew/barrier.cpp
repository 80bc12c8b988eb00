#include "crew/basic_barrier.hpp"
#include "crew/sleep.hpp"

namespace carom {

template class BasicBarrier<BarrierSystem>;

}  // namespace carom
