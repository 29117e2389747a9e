# SPDX-License-Identifier: GPL-3.0-or-later
# abut_numerics: CHOLMOD, LAPACK and BLAS. Their archives where all of them are installed, as Debian's development packages do:
# a program without their ten shared libraries and twenty thousand symbols to resolve starts in two thirds of the time, which
# counts where an analysis takes as long. Else the shared libraries.
option(ABUT_STATIC_NUMERICS "Link CHOLMOD, LAPACK and BLAS from archives where these are installed" ON)

find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
add_library(abut_numerics INTERFACE)
target_include_directories(abut_numerics INTERFACE ${CHOLMOD_INCLUDE_DIR})

set(ABUT_ARCHIVES)
if(ABUT_STATIC_NUMERICS)
  # METIS comes without an archive; the runtime libraries of Fortran and OpenMP without a name for linkers unless their compiler
  # is installed. Of several OpenBLAS the one that may be called from several threads.
  foreach(name libcholmod.a libccolamd.a libcolamd.a libcamd.a libamd.a libsuitesparseconfig.a libmetis.so.5 libopenblas.a
               libgfortran.so.5 libgomp.so.1)
    find_library(ABUT_ARCHIVE_${name} NAMES ${name} PATH_SUFFIXES openblas-pthread)
    mark_as_advanced(ABUT_ARCHIVE_${name})
    list(APPEND ABUT_ARCHIVES ${ABUT_ARCHIVE_${name}})
  endforeach()
endif()

if(ABUT_ARCHIVES AND NOT "${ABUT_ARCHIVES}" MATCHES NOTFOUND)
  # The two symbols are called where they exist (solver/linear_algebra/blas_threads.cpp), which alone would not bring them in.
  target_link_libraries(abut_numerics INTERFACE ${ABUT_ARCHIVES} m ${CMAKE_DL_LIBS})
  target_link_options(abut_numerics INTERFACE "LINKER:-u,openblas_get_parallel,-u,openblas_set_num_threads")
  message(STATUS "CHOLMOD and OpenBLAS: from archives")
else()
  find_package(BLAS REQUIRED)
  find_package(LAPACK REQUIRED)
  find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
  set(ABUT_FIND_NUMERICS "find_dependency(BLAS)\nfind_dependency(LAPACK)")  # where the library is installed
  target_link_libraries(abut_numerics INTERFACE ${CHOLMOD_LIBRARY} LAPACK::LAPACK BLAS::BLAS)
  message(STATUS "CHOLMOD and BLAS: shared")
endif()
