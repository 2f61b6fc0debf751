# Components of OpenCV, each the target opencv_COMPONENT. Debian has OpenCV's own package file for CMake in libopencv-dev,
# which brings 180 packages and 600 MB (video, Qt, VTK) that nothing here uses, so it is done without if it is not there.
find_package(OpenCV QUIET CONFIG COMPONENTS ${OpenCV_FIND_COMPONENTS})
if(NOT OpenCV_FOUND)
  find_path(OpenCV_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4)
  foreach(component IN LISTS OpenCV_FIND_COMPONENTS)
    find_library(OpenCV_${component}_LIBRARY opencv_${component})
    if(OpenCV_INCLUDE_DIR AND OpenCV_${component}_LIBRARY)
      set(OpenCV_${component}_FOUND TRUE)
      if(NOT TARGET opencv_${component})
        add_library(opencv_${component} UNKNOWN IMPORTED)
        set_target_properties(opencv_${component} PROPERTIES
          IMPORTED_LOCATION ${OpenCV_${component}_LIBRARY}
          INTERFACE_INCLUDE_DIRECTORIES ${OpenCV_INCLUDE_DIR})
      endif()
    endif()
  endforeach()
  include(FindPackageHandleStandardArgs)
  find_package_handle_standard_args(OpenCV REQUIRED_VARS OpenCV_INCLUDE_DIR HANDLE_COMPONENTS)
endif()
