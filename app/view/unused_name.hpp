#pragma once

#include <string>

namespace carom {

/// A file of the folder that is not there yet: the name of a scene, a number, and `ending`, as in
/// "./break-1.json".
std::string unused_name(const std::string& folder, const std::string& scene,
                        const std::string& ending);

}  // namespace carom
