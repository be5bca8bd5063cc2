# Draws scenes without the rest of the program, which would take long to build.
add_executable(draw_toys ${CMAKE_CURRENT_LIST_DIR}/draw.cpp)
target_link_libraries(draw_toys PRIVATE common_povray)
course_link(draw_toys)
