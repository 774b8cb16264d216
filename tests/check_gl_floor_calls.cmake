# Fails if a library calls OpenGL functions that are newer than 4.1, the floor. Mesa does not hide them in a 4.1 context,
# so a test that merely runs there proves nothing.
#   cmake -D LIBRARY=<file> -D NM=<nm> -D HEADER=<GL/glcorearb.h> -P tests/check_gl_floor_calls.cmake
cmake_minimum_required(VERSION 3.25)

# Newer functions that are called only after a check that the context has them (KHR_debug).
set(guarded glDebugMessageCallback glDebugMessageControl glObjectLabel glPushDebugGroup glPopDebugGroup)

# The header lists functions by version, oldest first: what stands before 4.2 is the floor.
file(READ "${HEADER}" header)
string(FIND "${header}" "#ifndef GL_VERSION_4_2" end)
if(end EQUAL -1)
    message(FATAL_ERROR "'${HEADER}' has no block of OpenGL 4.2; the names of the floor cannot be read from it")
endif()
string(SUBSTRING "${header}" 0 ${end} header)
string(REGEX MATCHALL "APIENTRY gl[A-Za-z0-9]+" floor "${header}")
list(TRANSFORM floor REPLACE "^APIENTRY " "")

# libepoxy renames each function glName to a pointer epoxy_glName, which the linker has to find.
execute_process(COMMAND "${NM}" --undefined-only "${LIBRARY}" OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "epoxy_gl[A-Z][A-Za-z0-9]+" called "${symbols}")
list(TRANSFORM called REPLACE "^epoxy_" "")
list(REMOVE_DUPLICATES called)
list(LENGTH called count)
if(count EQUAL 0)
    message(FATAL_ERROR "'${LIBRARY}' calls no OpenGL function through libepoxy; is it the right file?")
endif()

list(REMOVE_ITEM called ${floor} ${guarded})
if(called)
    list(JOIN called ", " names)
    message(FATAL_ERROR "newer than OpenGL 4.1: ${names}")
endif()
message(STATUS "all ${count} OpenGL functions that are called are in OpenGL 4.1, or guarded")
