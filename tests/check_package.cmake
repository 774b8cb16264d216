# Builds the Debian package, unpacks it somewhere else, and lets the program in it draw a shipped show.
#   cmake -D BUILD=<build tree> -D WORK=<scratch folder> -D USB=<HAZER_USB> -P tests/check_package.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
execute_process(COMMAND cpack -G DEB -B "${WORK}" WORKING_DIRECTORY "${BUILD}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB package "${WORK}/*.deb")
execute_process(COMMAND dpkg-deb --extract "${package}" "${WORK}/root" COMMAND_ERROR_IS_FATAL ANY)

execute_process(COMMAND dpkg-deb --field "${package}" Depends OUTPUT_VARIABLE depends COMMAND_ERROR_IS_FATAL ANY)
foreach(library libc6 libepoxy0 libopenimageio libzip libegl1)
    if(NOT depends MATCHES "${library}")
        message(SEND_ERROR "the package does not depend on ${library}: ${depends}")
    endif()
endforeach()

if(USB AND NOT (depends MATCHES "libusb" AND EXISTS "${WORK}/root/usr/lib/udev/rules.d/60-hazer-usb.rules"))
    message(SEND_ERROR "the package lacks libusb or the rule that lets people open USB interfaces: ${depends}")
elseif(NOT USB AND depends MATCHES "libusb")
    message(SEND_ERROR "the package depends on libusb, which it was built without: ${depends}")
endif()

set(draw "${WORK}/root/usr/bin/hazer" render "${WORK}/root/usr/share/hazer/app/shows/one-spot.toml"
    --size 64x36 --out "${WORK}/picture.png")
execute_process(COMMAND ${draw} COMMAND_ERROR_IS_FATAL ANY)
if(NOT EXISTS "${WORK}/picture.png")
    message(SEND_ERROR "the unpacked program drew nothing")
endif()

# It must be the unpacked shaders that were used, not those of the source tree.
file(GLOB shaders "${WORK}/root/usr/share/hazer/shaders/*.frag")
file(REMOVE ${shaders})
execute_process(COMMAND ${draw} RESULT_VARIABLE status ERROR_VARIABLE errors OUTPUT_QUIET)
if(status EQUAL 0 OR NOT errors MATCHES "${WORK}/root/usr/share/hazer/shaders")
    message(SEND_ERROR "without its own shaders the unpacked program should name the missing one, but said: ${errors}")
endif()
file(REMOVE_RECURSE "${WORK}")
