#pragma once

namespace hooke::test {

/// Keeps all libraries that are loaded now until the program ends. OpenGL's drivers are unloaded with the
/// last window; a leak checker could then not tell any more that what leaked is theirs.
void keep_loaded_libraries();

}  // namespace hooke::test
