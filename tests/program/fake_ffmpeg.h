#pragma once

#include <filesystem>
#include <string>

#include "program/files.h"

namespace hooke::test {

/// Puts an ffmpeg into a folder that does what a shell script says.
inline void write_ffmpeg(const TemporaryFolder& folder, const std::string& script) {
  write_file(folder / "ffmpeg", "#!/bin/sh\n" + script + "\n");
  std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
}

/// Takes a picture where it is only tried, with no file to write. Otherwise leaves half a file and gives up.
inline const std::string ffmpeg_that_fails_midway = R"(
for word; do :; done
if [ "$word" = - ]; then
  while read -r _; do :; done
  exit 0
fi
echo half > "${word#file:}"
echo No space left >&2
exit 1)";

}  // namespace hooke::test
