# The tree of the forest is large and easily made, so it is not committed: the build makes it, beside the scene.
add_executable(make_models ${CMAKE_CURRENT_LIST_DIR}/make_models.cpp)
target_link_libraries(make_models PRIVATE common_image)
add_custom_command(OUTPUT ${CMAKE_CURRENT_LIST_DIR}/tree.obj
    COMMAND make_models tree.obj ${CMAKE_CURRENT_LIST_DIR}/tree.obj DEPENDS make_models VERBATIM)
add_custom_target(meshes_04 DEPENDS ${CMAKE_CURRENT_LIST_DIR}/tree.obj)
add_dependencies(course meshes_04)
