# The needles are easily made, so they are not committed: the build makes them, beside the scene that shows them.
add_executable(make_scenes_13 ${CMAKE_CURRENT_LIST_DIR}/make_scenes.cpp)
target_link_libraries(make_scenes_13 PRIVATE common_image)
add_custom_command(OUTPUT ${CMAKE_CURRENT_LIST_DIR}/needles.obj
    COMMAND make_scenes_13 needles.obj ${CMAKE_CURRENT_LIST_DIR}/needles.obj DEPENDS make_scenes_13 VERBATIM)
add_custom_target(meshes_13 DEPENDS ${CMAKE_CURRENT_LIST_DIR}/needles.obj)
add_dependencies(course meshes_13)
