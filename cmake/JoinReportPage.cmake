# Puts style and scripts into the template of an HTML page, and the whole into a C++ source file, as faster::report::NAME.
#   cmake -DNAME=... -DTEMPLATE=... -DSTYLE=... -DCHART_JS=... -DSCRIPTS=a.js;b.js -DOUTPUT=page.cpp -P JoinReportPage.cmake
file(READ "${TEMPLATE}" page)
file(READ "${STYLE}" style)
file(READ "${CHART_JS}" chart_js)
set(scripts "")
foreach(file IN LISTS SCRIPTS)
  file(READ "${file}" script)
  string(APPEND scripts "${script}\n")
endforeach()

foreach(part style chart_js scripts)
  if("${${part}}" MATCHES "</(script|style)|<!--")
    message(FATAL_ERROR "${part} cannot stand inside an HTML element: it contains ${CMAKE_MATCH_0}")
  endif()
  string(REPLACE "@${part}@" "${${part}}" page "${page}")
endforeach()

string(FIND "${page}" ")faster_page\"" delimiter)
if(NOT delimiter EQUAL -1)
  message(FATAL_ERROR "the page contains the delimiter of the C++ string")
endif()
file(WRITE "${OUTPUT}" "// Joined from the files of src/report_html/page by the build.
#include \"report_html/page.hpp\"

namespace faster::report {

char const* const ${NAME} = R\"faster_page(${page})faster_page\";

}  // namespace faster::report
")
