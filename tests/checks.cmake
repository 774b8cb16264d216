# Checks of the sources and of what is built from them, as ctest tests. A check that says no when it should is tested, too.

# As hazer_add_check, for a check that is given something wrong and must name it.
function(hazer_add_refusal name script expected)
    hazer_add_check(${name} ${script} ${ARGN})
    set_tests_properties("${name}" PROPERTIES PASS_REGULAR_EXPRESSION "${expected}")
endfunction()

hazer_add_check(include_arrows check_includes.cmake "ROOT=${PROJECT_SOURCE_DIR}")
hazer_add_check(include_arrows_refuses check_includes_test.cmake "WORK=${CMAKE_CURRENT_BINARY_DIR}/planted_includes")

find_program(CLANG_FORMAT clang-format REQUIRED)
hazer_add_check(format check_format.cmake "ROOT=${PROJECT_SOURCE_DIR}" "CLANG_FORMAT=${CLANG_FORMAT}")

find_file(GL_CORE_HEADER GL/glcorearb.h REQUIRED)
add_library(newer_gl_calls OBJECT support/newer_gl_calls.cpp)
target_link_libraries(newer_gl_calls PRIVATE hazer_options)
hazer_add_check(gl_floor_calls check_gl_floor_calls.cmake
    "LIBRARY=$<TARGET_FILE:hazer_render>" "NM=${CMAKE_NM}" "HEADER=${GL_CORE_HEADER}")
hazer_add_refusal(gl_floor_calls_refuses check_gl_floor_calls.cmake "newer than OpenGL 4.1: gl[a-zA-Z]+, gl[a-zA-Z]+"
    "LIBRARY=$<TARGET_OBJECTS:newer_gl_calls>" "NM=${CMAKE_NM}" "HEADER=${GL_CORE_HEADER}")

find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)
# Without the rest of the render library, whose many libraries would be loaded for each variant of each shader.
add_executable(expand_shader support/expand_shader.cpp "${PROJECT_SOURCE_DIR}/render/gl/shader_source.cpp")
target_link_libraries(expand_shader PRIVATE hazer_options fmt::fmt)
hazer_add_check(gl_floor_shaders check_gl_floor_shaders.cmake
    "SHADERS=${PROJECT_SOURCE_DIR}/shaders" "EXPAND=$<TARGET_FILE:expand_shader>" "VALIDATOR=${GLSLANG_VALIDATOR}")
hazer_add_refusal(gl_floor_shaders_refuses check_gl_floor_shaders.cmake "binding.*not supported"
    "SHADERS=${CMAKE_CURRENT_SOURCE_DIR}/support/newer_glsl" "EXPAND=$<TARGET_FILE:expand_shader>"
    "VALIDATOR=${GLSLANG_VALIDATOR}")

# Each header must compile alone: a source that includes it may not have to know what else to include before. Where it has a
# source of its own, that one includes it first (check_includes.cmake) and so proves it.
file(GLOB_RECURSE headers RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS
    "${PROJECT_SOURCE_DIR}/app/*.h" "${PROJECT_SOURCE_DIR}/protocol/*.h"
    "${PROJECT_SOURCE_DIR}/fixtures/*.h" "${PROJECT_SOURCE_DIR}/render/*.h")
set(lone_sources "")
foreach(header IN LISTS headers)
    string(REGEX REPLACE "\\.h$" ".cpp" own_source "${header}")
    if(EXISTS "${PROJECT_SOURCE_DIR}/${own_source}")
        continue()
    endif()
    set(source "${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${header}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "#include \"${header}\"\n" @ONLY)
    list(APPEND lone_sources "${source}")
endforeach()
add_library(headers_alone OBJECT ${lone_sources})
target_link_libraries(headers_alone PRIVATE hazer_app)
if(HAZER_WINDOW)
    pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
    target_link_libraries(headers_alone PRIVATE PkgConfig::IMGUI)
endif()
