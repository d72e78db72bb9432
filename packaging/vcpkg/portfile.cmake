# Not built here: a draft. REF and SHA512 are filled in when there is a release.
vcpkg_from_git(OUT_SOURCE_PATH SOURCE_PATH URL https://example.org/touchstone.git REF 0000000000000000000000000000000000000000)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DTOUCHSTONE_PROGRAM=OFF -DTOUCHSTONE_TESTS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/touchstone)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSES/MIT.txt")
