# Debian packages: `cpack -G DEB` in the build folder makes two of them, which exclude each other.
#
#   polyturn-panel    the machine's computer: everything, with systemd units for controller and full-screen HMI
#   polyturn-office   a desk: check, virtual runs, the screens; no services, no user of its own
#
# All programs stand side by side in /usr/lib/polyturn/bin, because each finds the others beside itself; /usr/bin has links to those that
# people call. Machines and jobs lie where ipc/model/files/machine_path.cpp looks for them.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)   # what is packed has been built; tests need not be
set(home lib/polyturn)
set(programs polyturn polyturn-kernel polyturn-channel polyturn-plc polyturn-toolmgmt)
set(called polyturn)
foreach(optional polyturn-hmi polyturn-presetter polyturn-cell polyturn-drives)
  if(TARGET ${optional})
    list(APPEND programs ${optional})
  endif()
endforeach()
if(TARGET polyturn-hmi)
  list(APPEND called polyturn-hmi)
endif()
foreach(component panel office)
  install(TARGETS ${programs} RUNTIME DESTINATION ${home}/bin COMPONENT ${component})
  install(TARGETS lathe_plc LIBRARY DESTINATION ${home}/bin COMPONENT ${component})
  install(DIRECTORY examples/machines examples/jobs DESTINATION ${home}/share/polyturn/examples COMPONENT ${component})
  install(DIRECTORY docs/ DESTINATION share/doc/polyturn COMPONENT ${component} PATTERN design EXCLUDE)
  install(FILES LICENSE CHANGELOG.md DESTINATION share/doc/polyturn COMPONENT ${component})
  foreach(program ${called})
    install(CODE "file(MAKE_DIRECTORY \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin\")
      file(CREATE_LINK ../${home}/bin/${program} \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin/${program}\" SYMBOLIC)" COMPONENT ${component})
  endforeach()
endforeach()
install(FILES packaging/systemd/polyturn@.service packaging/systemd/polyturn-hmi@.service packaging/systemd/polyturn-stick@.service DESTINATION lib/systemd/system COMPONENT panel)
install(PROGRAMS packaging/panel/mount_stick DESTINATION ${home} COMPONENT panel)
install(FILES packaging/panel/50-polyturn.rules DESTINATION share/polkit-1/rules.d COMPONENT panel)
install(FILES packaging/panel/70-polyturn-sticks.rules DESTINATION lib/udev/rules.d COMPONENT panel)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME polyturn)
set(CPACK_PACKAGE_VENDOR Polyturn)
set(CPACK_PACKAGE_CONTACT "Polyturn <polyturn@example.org>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL panel office)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION misc)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PANEL_PACKAGE_NAME polyturn-panel)
set(CPACK_DEBIAN_OFFICE_PACKAGE_NAME polyturn-office)
set(CPACK_DEBIAN_PANEL_PACKAGE_CONFLICTS polyturn-office)
set(CPACK_DEBIAN_OFFICE_PACKAGE_CONFLICTS polyturn-panel)
# libqt6opengl6 has the plugin that draws on the whole panel without a display server (eglfs); nothing links it. polkitd, network-manager and
# the time daemon are asked by the settings page, cups-client prints the setup sheet.
set(CPACK_DEBIAN_PANEL_PACKAGE_DEPENDS "passwd, polkitd, udev, libqt6opengl6, fonts-roboto-unhinted, fonts-dejavu-core")
set(CPACK_DEBIAN_PANEL_PACKAGE_RECOMMENDS "network-manager, systemd-timesyncd, cups-client")
set(CPACK_DEBIAN_OFFICE_PACKAGE_DEPENDS "fonts-roboto-unhinted, fonts-dejavu-core")
set(CPACK_DEBIAN_PANEL_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/packaging/deb/postinst;${PROJECT_SOURCE_DIR}/packaging/deb/prerm")
set(CPACK_COMPONENT_PANEL_DESCRIPTION "Open controller for lathes with several turrets: the machine's computer
 Controller, screens on the whole panel, and systemd units that start both.
 It replaces no hard-wired emergency stop and no safety relay.")
set(CPACK_COMPONENT_OFFICE_DESCRIPTION "Open controller for lathes with several turrets: programming and virtual runs
 Checks programs, drives jobs in virtual time, shows the screens; no services.")
include(CPack)
