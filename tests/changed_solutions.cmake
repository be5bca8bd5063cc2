# Chapters whose solution is changed by `.mistake` and `.variant` files (CONTRIBUTING.md), and their test programs.

# Program `target`: the tests of a chapter and its solution with the changes in the files given as further
# arguments.
function(course_changed_program target number)
    set(name ${name_${number}})
    course_chapter_program(${target} tests_${number})
    set(files "")  # of the solution, those that are changed
    foreach(change IN LISTS ARGN)
        file(STRINGS ${change} line REGEX "^file " LIMIT_COUNT 1)
        string(REGEX REPLACE "^file +" "" file "${line}")
        list(APPEND files ${file})
        list(APPEND changes_${file} ${change})
    endforeach()
    list(REMOVE_DUPLICATES files)

    set(objects $<TARGET_OBJECTS:solution_${number}>)
    foreach(file IN LISTS files)
        set(made ${CMAKE_BINARY_DIR}/mistakes/${name}/${target}/${file})
        add_custom_command(OUTPUT ${made}
            COMMAND course-tool change ${changes_${file}} ${CMAKE_SOURCE_DIR}/solutions/${name} ${made}
            DEPENDS course-tool ${changes_${file}} ${CMAKE_SOURCE_DIR}/solutions/${name}/${file} VERBATIM)
        target_sources(${target} PRIVATE ${made})
        set(objects $<FILTER:${objects},EXCLUDE,/${file}\\.o$>)
    endforeach()
    target_sources(${target} PRIVATE ${objects})
    foreach(other IN LISTS all_numbers)
        if(NOT other STREQUAL number)
            target_link_libraries(${target} PRIVATE solution_${other})
        endif()
    endforeach()
    target_link_libraries(${target} PRIVATE common_render)

    target_compile_options(${target} PRIVATE -w)  # a mistake may leave a parameter unused
    # Most of the time that so small a file takes goes into headers that all of them include; the first program
    # compiles these for the others.
    get_property(first GLOBAL PROPERTY course_first_changed)
    if(first)
        target_precompile_headers(${target} REUSE_FROM ${first})
    else()
        target_precompile_headers(${target} PRIVATE ${CMAKE_SOURCE_DIR}/common/world/query.hpp)
        set_property(GLOBAL PROPERTY course_first_changed ${target})
    endif()
endfunction()

# A program mistake_NN.S_what for each known mistake of the chapter.
function(course_mistakes number)
    file(GLOB mistakes CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${name_${number}}/mistakes/*.mistake)
    foreach(mistake IN LISTS mistakes)
        get_filename_component(stem ${mistake} NAME)
        string(REGEX REPLACE "\\.mistake$" "" stem ${stem})
        course_changed_program(mistake_${stem} ${number} ${mistake})
        add_dependencies(mistakes mistake_${stem})
    endforeach()
endfunction()

# Programs variants_NN_k with the k-th variant of every step: right steps do not disturb one another.
function(course_variants number)
    file(GLOB variants CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${name_${number}}/variants/*.variant)
    set(last_step "")
    set(most 0)
    foreach(variant IN LISTS variants)  # sorted by name, hence by step
        get_filename_component(stem ${variant} NAME)
        string(REGEX REPLACE "_.*" "" step ${stem})
        if(NOT step STREQUAL last_step)
            set(k 0)
            set(last_step ${step})
        endif()
        math(EXPR k "${k} + 1")
        list(APPEND variants_${k} ${variant})
        if(k GREATER most)
            set(most ${k})
        endif()
    endforeach()
    if(most GREATER 0)
        foreach(k RANGE 1 ${most})
            course_changed_program(variants_${number}_${k} ${number} ${variants_${k}})
            add_dependencies(variants variants_${number}_${k})
        endforeach()
    endif()
endfunction()
