# Every dependency, found as Debian packages it; why each was chosen stands in third_party/dependencies.md.

find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenCV 4.6 REQUIRED COMPONENTS core imgproc calib3d features2d aruco)
set(CMAKE_MESSAGE_LOG_LEVEL WARNING) # Debian's Imath tells at length of a missing Python library that nothing needs
find_package(OpenImageIO REQUIRED)
unset(CMAKE_MESSAGE_LOG_LEVEL)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(embree 3 REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS OpenGL EGL)
find_package(glfw3 3.3 REQUIRED)
find_package(GTest REQUIRED)
include(GoogleTest)
if(BOSK_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()

find_package(PkgConfig REQUIRED)
pkg_check_modules(zstd REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(exif REQUIRED IMPORTED_TARGET libexif)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
find_file(BOSK_FONT_FILE DejaVuSans.ttf PATHS /usr/share/fonts/truetype/dejavu REQUIRED)

find_package(Eigen3 3.4 REQUIRED NO_MODULE)

find_path(MRCAL_INCLUDE_DIR mrcal/mrcal.h REQUIRED)
find_library(MRCAL_LIBRARY mrcal REQUIRED)
add_library(mrcal::mrcal UNKNOWN IMPORTED)
set_target_properties(mrcal::mrcal PROPERTIES IMPORTED_LOCATION ${MRCAL_LIBRARY}
                                              INTERFACE_INCLUDE_DIRECTORIES ${MRCAL_INCLUDE_DIR})

find_path(MRGINGHAM_INCLUDE_DIR mrgingham/mrgingham.hh REQUIRED)
find_library(MRGINGHAM_LIBRARY mrgingham REQUIRED)
add_library(mrgingham::mrgingham UNKNOWN IMPORTED)
set_target_properties(mrgingham::mrgingham PROPERTIES IMPORTED_LOCATION ${MRGINGHAM_LIBRARY}
                                                      INTERFACE_INCLUDE_DIRECTORIES ${MRGINGHAM_INCLUDE_DIR})

find_path(SQUISH_INCLUDE_DIR squish.h REQUIRED)
find_library(SQUISH_LIBRARY squish REQUIRED)
add_library(squish::squish UNKNOWN IMPORTED)
set_target_properties(squish::squish PROPERTIES IMPORTED_LOCATION ${SQUISH_LIBRARY}
                                                INTERFACE_INCLUDE_DIRECTORIES ${SQUISH_INCLUDE_DIR})
