# find_package(halftone): the emulated frame buffer, for the tests of its drivers.
#   halftone::device    C++20, <halftone/device/port.h>
#   halftone::c         C, <halftone/c/m508.h>
#   halftone::protocol  encoder and decoder, <halftone/protocol/message.h>
include(CMakeFindDependencyMacro)
find_dependency(ZLIB)
include(${CMAKE_CURRENT_LIST_DIR}/halftone-targets.cmake)
