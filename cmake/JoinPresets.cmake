# Puts the files of configs/architectures into a C++ source file, so that the tool knows them wherever it is installed.
#   cmake "-DFILES=a.yaml;b.yaml" -DOUTPUT=preset_files.cpp -P JoinPresets.cmake
set(entries "")
foreach(file IN LISTS FILES)
  file(READ "${file}" text)
  get_filename_component(name "${file}" NAME_WE)
  if(text MATCHES "\\)preset\"")
    message(FATAL_ERROR "${file} contains the delimiter of the C++ string")
  endif()
  string(APPEND entries "        {\"${name}\", R\"preset(${text})preset\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Joined from configs/architectures by the build.
#include \"faster/config/faster_presets.hpp\"

namespace faster {

std::vector<Preset> const& faster_presets() {
    static std::vector<Preset> const all{
${entries}    };
    return all;
}

}  // namespace faster
")
