# hooke_warnings(TARGET): the warnings that all of Hooke's own code is built with. Never errors: a newer compiler's new
# warning must not stop a user's build. Hooke's own .ci/run does fail on one.
function(hooke_warnings target)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                                             -Wcast-align -Wextra-semi -Wundef)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wduplicated-cond -Wlogical-op)
    if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12 AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # False alarms of GCC 12: -Wrestrict for any "text" + std::string (its bug 105651), -Wmaybe-uninitialized for a
      # variant that is moved from a temporary and could hold a std::function.
      target_compile_options(${target} PRIVATE -Wno-restrict -Wno-maybe-uninitialized)
    endif()
  endif()
endfunction()
