#include <algorithm>
#include <variant>

#include "carom/scene.hpp"

namespace carom {

bool loses_energy(const Scene& scene) {
  return loses_energy(scene.effects) ||
         std::any_of(scene.script.begin(), scene.script.end(), [](const ScriptLine& line) {
           const auto* set = std::get_if<command::SetEffects>(&line.command);
           return set != nullptr && loses_energy(set->effects);
         });
}

}  // namespace carom
