# Demos: small programs that each show one idea of the library, in ${bin}/demos. What they share: arguments, claims,
# costs and pictures (account/), and scenes that would be too long for them (props/).
add_library(hooke_account STATIC
  ideas/account/account.cpp
  ideas/account/plot.cpp
  ideas/account/$<IF:$<BOOL:${HOOKE_HAS_PICTURES}>,show,show_absent>.cpp
  ideas/props/ball.cpp
  ideas/props/bridge.cpp
  ideas/props/skirt.cpp
  ideas/props/web.cpp)
if(HOOKE_HAS_PICTURES)
  target_link_libraries(hooke_account PRIVATE hooke_picture)
endif()
target_include_directories(hooke_account PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(hooke_account PUBLIC hooke::hooke PRIVATE hooke_program)
hooke_warnings(hooke_account)

set(HOOKE_DEMOS hello curtain rope_bridge jelly_blocks projectile spring million_springs game_loop thread_pool
                scene_editing charged_hair hung_box)
foreach(demo ${HOOKE_DEMOS})
  add_executable(demo_${demo} ideas/${demo}.cpp)
  set_target_properties(demo_${demo} PROPERTIES OUTPUT_NAME ${demo}
                                                RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin/demos)
  target_link_libraries(demo_${demo} PRIVATE hooke_account)
  hooke_warnings(demo_${demo})
endforeach()
