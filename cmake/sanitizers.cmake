# HOOKE_SANITIZE=address,undefined (or thread) builds everything with these sanitizers.
set(HOOKE_SANITIZE "" CACHE STRING "Sanitizers to build with, such as address,undefined or thread")
if(HOOKE_SANITIZE)
  add_compile_options(-fsanitize=${HOOKE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${HOOKE_SANITIZE})
endif()

# hooke_tbb_source(TARGET SOURCE): the one source that includes oneTBB. The system's oneTBB is not built with the
# thread sanitizer, so the parts of it that are compiled here must not be either: seeing only half of how its threads
# hand tasks to each other, the sanitizer would report races that are none. The source itself says what order it keeps.
function(hooke_tbb_source target source)
  if(HOOKE_SANITIZE MATCHES "thread")
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES
      COMPILE_OPTIONS -fno-sanitize=thread COMPILE_DEFINITIONS HOOKE_SANITIZES_THREADS)
  endif()
endfunction()
