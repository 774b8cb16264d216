# What is installed, and the Debian package made from it (`cpack` in the build folder).
# The program finds its data in share/hazer beside its own bin folder, so the tree may be put anywhere.
include(GNUInstallDirs)

install(TARGETS hazer RUNTIME)
install(DIRECTORY shaders DESTINATION ${CMAKE_INSTALL_DATADIR}/hazer)
install(DIRECTORY fixtures/library DESTINATION ${CMAKE_INSTALL_DATADIR}/hazer/fixtures)
install(DIRECTORY app/shows DESTINATION ${CMAKE_INSTALL_DATADIR}/hazer/app)
if(HAZER_USB)
    # udev reads this folder alone, whatever the machine's own library folder is called.
    install(FILES app/60-hazer-usb.rules DESTINATION lib/udev/rules.d)
endif()
install(FILES app/hazer.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "hazer maintainers <maintainers@hazer.invalid>")
set(CPACK_PACKAGE_VENDOR hazer)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The OpenGL libraries are opened at run time, so no linker finds them.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS ffmpeg)
include(CPack)
