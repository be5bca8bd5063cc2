# The mesh that is too large to be committed: made by the build, beside the scene that shows it.
add_executable(make_mesh ${CMAKE_CURRENT_LIST_DIR}/make_mesh.cpp)
target_link_libraries(make_mesh PRIVATE common_image)
add_custom_command(OUTPUT ${CMAKE_CURRENT_LIST_DIR}/huge.obj
    COMMAND make_mesh flat 500 100 ${CMAKE_CURRENT_LIST_DIR}/huge.obj DEPENDS make_mesh VERBATIM)
add_custom_target(meshes_03 DEPENDS ${CMAKE_CURRENT_LIST_DIR}/huge.obj)
add_dependencies(course meshes_03)
