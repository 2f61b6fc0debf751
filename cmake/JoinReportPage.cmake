# Puts the content of an HTML page (from its navigation to its last section), styles and scripts into the frame that all pages share, and the
# whole into a C++ source file.
#   cmake -DFRAME=... -DTEMPLATE=... -DSTYLES=a.css;b.css -DCHART_JS=... -DSCRIPTS=a.js;b.js -DNAME=namespace::variable -DHEADER=page.hpp
#         -DOUTPUT=page.cpp -DCONNECTS=FALSE -P JoinReportPage.cmake
function(read_all result)
  set(all "")
  foreach(file IN LISTS ARGN)
    file(READ "${file}" text)
    string(APPEND all "${text}\n")
  endforeach()
  set(${result} "${all}" PARENT_SCOPE)
endfunction()

file(READ "${FRAME}" page)
file(READ "${TEMPLATE}" content)
file(READ "${CHART_JS}" chart_js)
read_all(style ${STYLES})
read_all(scripts ${SCRIPTS})

string(FIND "${content}" "  </nav>\n" navigation_end)
math(EXPR navigation_end "${navigation_end} + 9")
string(SUBSTRING "${content}" 0 ${navigation_end} navigation)
string(SUBSTRING "${content}" ${navigation_end} -1 sections)
foreach(part navigation sections)
  string(REPLACE "@${part}@" "${${part}}" page "${page}")
endforeach()
set(connects "")
if(CONNECTS)
  set(connects "; connect-src 'self'")
endif()
foreach(part connects style chart_js scripts)
  if("${${part}}" MATCHES "</(script|style)|<!--")
    message(FATAL_ERROR "${part} cannot stand inside an HTML element: it contains ${CMAKE_MATCH_0}")
  endif()
  string(REPLACE "@${part}@" "${${part}}" page "${page}")
endforeach()

string(FIND "${page}" ")faster_page\"" delimiter)
if(NOT delimiter EQUAL -1)
  message(FATAL_ERROR "the page contains the delimiter of the C++ string")
endif()
string(REGEX MATCH "^(.*)::([a-z_]+)$" name "${NAME}")
set(name_space "${CMAKE_MATCH_1}")
set(variable "${CMAKE_MATCH_2}")
file(WRITE "${OUTPUT}" "// Joined from the files of ${TEMPLATE}'s folder by the build.
#include \"${HEADER}\"

namespace ${name_space} {

char const* const ${variable} = R\"faster_page(${page})faster_page\";

}  // namespace ${name_space}
")
