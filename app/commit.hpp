#pragma once

namespace carom {

/// The commit that was checked out when the program was built, in short; empty where it is unknown.
const char* commit();

}  // namespace carom
