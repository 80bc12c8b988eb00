#include "solvers/overlap/work.hpp"

#include <algorithm>

namespace carom::overlap {

void Work::inherit(Work& gone) {
  impacts.ball_ball += gone.impacts.ball_ball;
  impacts.ball_wall += gone.impacts.ball_wall;
  impacts.missed += gone.impacts.missed;
  impacts.friction_seconds += gone.impacts.friction_seconds;
  lasting.ball_ball += gone.lasting.ball_ball;
  lasting.ball_wall += gone.lasting.ball_wall;
  lasting.jammed += gone.lasting.jammed;
  lasting.deepest = std::max(lasting.deepest, gone.lasting.deepest);
  deepest = std::max(deepest, gone.deepest);
  seconds += gone.seconds;
  gone.impacts.log.move_to(impacts.log.impacts);
}

}  // namespace carom::overlap
