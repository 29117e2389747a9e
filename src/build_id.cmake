# SPDX-License-Identifier: GPL-3.0-or-later
# Run at every build: cmake -D SOURCE_DIR=... -D VERSION=... -D FILE=... -P build_id.cmake writes FILE where its text changed.
set(sources)
foreach(floor geometry solver src apps)
  file(GLOB_RECURSE of_floor ${SOURCE_DIR}/${floor}/*.cpp ${SOURCE_DIR}/${floor}/*.hpp ${SOURCE_DIR}/${floor}/*.cmake
       ${SOURCE_DIR}/${floor}/CMakeLists.txt)
  list(APPEND sources ${of_floor})
endforeach()
file(GLOB tables ${SOURCE_DIR}/CMakeLists.txt  # the compiler's options
     ${SOURCE_DIR}/data/materials/*.json ${SOURCE_DIR}/data/drafting_layers.csv
     ${SOURCE_DIR}/src/report/web/page.css ${SOURCE_DIR}/src/report/web/bundle/report.css ${SOURCE_DIR}/src/report/web/bundle/report.js)  # compiled in
list(APPEND sources ${tables})
set(all)
foreach(source IN LISTS sources)
  file(SHA1 ${source} hash)
  file(RELATIVE_PATH name ${SOURCE_DIR} ${source})
  string(APPEND all "${name} ${hash}\n")
endforeach()
string(SHA1 all "${all}")
string(SUBSTRING ${all} 0 12 id)
file(CONFIGURE OUTPUT ${FILE} CONTENT [[
// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/build_id.hpp"

namespace abut {

std::string program_build() {
    return "@VERSION@+@id@";
}

}  // namespace abut
]] @ONLY)
