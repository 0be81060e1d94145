#include "model/cache_size.h"

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace hooke {

std::size_t second_level_cache_bytes() {
#ifdef _SC_LEVEL2_CACHE_SIZE
  const long bytes = sysconf(_SC_LEVEL2_CACHE_SIZE);
  if (bytes > 0) return std::size_t(bytes);
#endif
  return 512 * 1024;
}

}  // namespace hooke
