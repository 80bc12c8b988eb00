#include <cstdio>

#include "carom/scene_file.hpp"
#include "carom/session.hpp"
#include "commands.hpp"
#include "view/paint.hpp"
#include "view/text_screen.hpp"

namespace carom {

int run(const Options& options) {
  Session session(options.scenes.empty() ? builtin_scene() : read_scene(options.scenes.front()));
  session.advance_clock_to(session.scene().duration);
  Canvas canvas(options.columns, options.rows);
  paint(session.simulation().frame(), canvas);
  std::fputs(to_text(canvas, 0, session.clock()).c_str(), stdout);
  return 0;
}

}  // namespace carom
