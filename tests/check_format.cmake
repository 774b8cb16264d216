# Fails if a source file is not formatted as .clang-format says. Changes nothing.
#   cmake -D ROOT=<source tree> -D CLANG_FORMAT=<clang-format> -P tests/check_format.cmake
cmake_minimum_required(VERSION 3.25)

set(files "")
foreach(module app protocol fixtures render tests)
    file(GLOB_RECURSE found "${ROOT}/${module}/*.h" "${ROOT}/${module}/*.cpp")
    list(APPEND files ${found})
endforeach()
if(NOT files)
    message(FATAL_ERROR "no sources found under '${ROOT}'")
endif()
execute_process(COMMAND "${CLANG_FORMAT}" --dry-run --Werror --ferror-limit=1 ${files} RESULT_VARIABLE status ERROR_VARIABLE errors)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "not formatted; run clang-format -i on these files\n${errors}")
endif()
