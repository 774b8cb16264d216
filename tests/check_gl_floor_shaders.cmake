# Fails on a shader that is not GLSL 4.10, the floor. Mesa compiles newer GLSL even in a 4.1 context, hence glslangValidator.
#   cmake -D SHADERS=<folder> -D EXPAND=<expand_shader> -D VALIDATOR=<glslangValidator> -P tests/check_gl_floor_shaders.cmake
# Each shader is tried plain, with each feature that its text asks about, and with all of them.
cmake_minimum_required(VERSION 3.25)

# Checks one shader with the features given after the two named arguments.
function(check_variant file stage)
    execute_process(
        COMMAND "${EXPAND}" "${SHADERS}" "${file}" ${ARGN}
        COMMAND "${VALIDATOR}" --stdin -S ${stage}
        RESULTS_VARIABLE statuses OUTPUT_VARIABLE output ERROR_VARIABLE errors)
    if(NOT statuses STREQUAL "0;0")
        list(JOIN ARGN " " features)
        message(SEND_ERROR "${file} with features [${features}]:\n${output}${errors}")
    endif()
endfunction()

file(GLOB shaders RELATIVE "${SHADERS}" "${SHADERS}/*.vert" "${SHADERS}/*.frag" "${SHADERS}/*.geom")
if(NOT shaders)
    message(FATAL_ERROR "no shaders in '${SHADERS}'")
endif()
foreach(file IN LISTS shaders)
    get_filename_component(stage "${file}" LAST_EXT)
    string(SUBSTRING "${stage}" 1 -1 stage)
    execute_process(COMMAND "${EXPAND}" "${SHADERS}" "${file}" OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
    if(NOT text MATCHES "^#version 410 core\n")
        message(SEND_ERROR "${file} must begin with '#version 410 core'")
    endif()
    string(REGEX MATCHALL "(ifdef |ifndef |defined\\()[A-Z][A-Z0-9_]*" features "${text}")
    list(TRANSFORM features REPLACE "^.*[ (]" "")
    list(REMOVE_DUPLICATES features)
    check_variant("${file}" ${stage})
    foreach(feature IN LISTS features)
        check_variant("${file}" ${stage} ${feature})
    endforeach()
    check_variant("${file}" ${stage} ${features})
endforeach()
