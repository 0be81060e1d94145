#include "viewer/loaded_libraries.h"

#include <cstddef>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <link.h>

namespace hooke::test {

void keep_loaded_libraries() {
  std::vector<std::string> names;
  const auto note = [](dl_phdr_info* library, std::size_t, void* list) {
    if (library->dlpi_name != nullptr && *library->dlpi_name != '\0')
      static_cast<std::vector<std::string>*>(list)->emplace_back(library->dlpi_name);
    return 0;
  };
  dl_iterate_phdr(note, &names);
  for (const std::string& name : names) dlopen(name.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
}

}  // namespace hooke::test
