# The teapot and the cloud are large and easily made, so they are not committed: the build makes them, beside the
# scenes. The forest's tree is chapter 4's.
add_executable(make_teapot ${CMAKE_CURRENT_LIST_DIR}/make_teapot.cpp)
target_link_libraries(make_teapot PRIVATE common_image)
add_executable(make_scenes ${CMAKE_CURRENT_LIST_DIR}/make_scenes.cpp)
target_link_libraries(make_scenes PRIVATE common_image)
add_custom_command(OUTPUT ${CMAKE_CURRENT_LIST_DIR}/teapot.obj
    COMMAND make_teapot 40 ${CMAKE_CURRENT_LIST_DIR}/teapot.obj DEPENDS make_teapot VERBATIM)
add_custom_command(OUTPUT ${CMAKE_CURRENT_LIST_DIR}/cloud.obj
    COMMAND make_scenes cloud.obj ${CMAKE_CURRENT_LIST_DIR}/cloud.obj DEPENDS make_scenes VERBATIM)
add_custom_target(meshes_09 DEPENDS ${CMAKE_CURRENT_LIST_DIR}/teapot.obj ${CMAKE_CURRENT_LIST_DIR}/cloud.obj)
add_dependencies(course meshes_09)
