# The oldest compilers that know what Hooke needs of C++20. An older one stops here, with a sentence, and not later with
# pages of errors.
function(hooke_needs_compiler id version)
  if(CMAKE_CXX_COMPILER_ID STREQUAL id AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS version)
    message(FATAL_ERROR "Hooke needs ${id} ${version} or newer for C++20, but ${CMAKE_CXX_COMPILER} is "
                        "${CMAKE_CXX_COMPILER_VERSION}. Name a newer one with the environment variable CXX and "
                        "configure in an empty folder.")
  endif()
endfunction()

hooke_needs_compiler(GNU 11)
hooke_needs_compiler(Clang 14)
hooke_needs_compiler(AppleClang 14)
