# Fails unless `program`, run with `arguments`, ends with `exit_code` and what it says matches `regex`.
execute_process(COMMAND ${program} ${arguments} OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE code)
if(NOT code STREQUAL exit_code)
  message(FATAL_ERROR "ended with ${code}, not ${exit_code}, and said: ${said}")
endif()
if(NOT said MATCHES "${regex}")
  message(FATAL_ERROR "expected \"${regex}\", got: ${said}")
endif()
