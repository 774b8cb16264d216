# Fails on an #include that follows an arrow which the architecture does not have (docs/architecture.md).
#   cmake -D ROOT=<source tree> -P tests/check_includes.cmake
# Includes are written from the root, so the first folder of an include names the module that it reaches into.
cmake_minimum_required(VERSION 3.25)

set(modules app protocol fixtures render shaders tests)
set(app_may_include protocol fixtures render)
set(protocol_may_include "")
set(fixtures_may_include "")
set(render_may_include shaders)
set(shaders_may_include "")
set(tests_may_include app protocol fixtures render shaders)
# A shader includes its neighbours by their names in shaders/; only render and the tests compile shaders/include as C++.

set(include_pattern "^[ \t]*#[ \t]*include[ \t]*[\"<]([^\">]+)[\">]")

# Appends to `violations` each forbidden include of one file.
function(check_file file module)
    file(STRINGS "${ROOT}/${file}" lines REGEX "${include_pattern}")
    foreach(line IN LISTS lines)
        string(REGEX MATCH "${include_pattern}" _ "${line}")
        set(included "${CMAKE_MATCH_1}")
        if(included MATCHES "(^|/)\\.\\./")
            list(APPEND violations "${file} includes \"${included}\": write includes from the root, without ..")
            continue()
        endif()
        string(REGEX MATCH "^[^/]+" target "${included}")
        if(target IN_LIST modules AND NOT target STREQUAL module AND NOT target IN_LIST ${module}_may_include)
            list(APPEND violations "${file} includes \"${included}\": ${module} must not know ${target}")
        endif()
    endforeach()
    set(violations "${violations}" PARENT_SCOPE)
endfunction()

set(violations "")
set(checked 0)
foreach(module IN LISTS modules)
    file(GLOB_RECURSE files RELATIVE "${ROOT}" "${ROOT}/${module}/*")
    list(FILTER files INCLUDE REGEX "\\.(h|cpp|glsl|vert|frag|geom|tesc|tese)$")
    foreach(file IN LISTS files)
        check_file("${file}" "${module}")
        math(EXPR checked "${checked} + 1")
    endforeach()
endforeach()

if(checked EQUAL 0)
    message(FATAL_ERROR "no sources found under '${ROOT}'")
endif()
if(violations)
    list(JOIN violations "\n  " text)
    message(FATAL_ERROR "includes against the architecture:\n  ${text}")
endif()
message(STATUS "${checked} files follow the architecture's arrows")
