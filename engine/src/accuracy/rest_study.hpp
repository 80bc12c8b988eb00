#pragma once

#include "carom/accuracy.hpp"
#include "carom/scene.hpp"

namespace carom::accuracy {

/// Runs the scene from several starts in every way that can take it, and asks of each end how far
/// it is from an equilibrium, how much still moves, and what contacts cost in overlap. Errors:
/// SceneError where a fill finds no room; a run that fails is a row that says so.
AccuracyStudy study_rest(const Scene& scene, const AccuracyRequest& request);

}  // namespace carom::accuracy
