# SPDX-License-Identifier: GPL-3.0-or-later
# cpack -G DEB: a package of what `cmake --install` installs. What the programs are linked with is found by dpkg-shlibdeps.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME abut)
set(CPACK_PACKAGE_CONTACT "The authors of abut <abut@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "2D contact analysis of CAD assemblies with B-spline finite elements")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
