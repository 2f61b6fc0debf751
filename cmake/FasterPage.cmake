# An HTML page made of real files: template, style, scripts, and Debian's Chart.js. The build joins them to one C++ string.
find_file(FASTER_CHART_JS chart.min.js PATHS /usr/share/javascript/chart.js NO_DEFAULT_PATH
  DOC "Minified Chart.js 3.9 (Debian: libjs-chart.js)")
if(NOT FASTER_CHART_JS)
  message(FATAL_ERROR "Chart.js not found: install libjs-chart.js, or set FASTER_CHART_JS to chart.min.js 3.9")
endif()
set(FASTER_PAGE_JOINER ${CMAKE_CURRENT_LIST_DIR}/JoinReportPage.cmake)
set(FASTER_PAGE_PARTS ${PROJECT_SOURCE_DIR}/src/dataflow/tools/report/html/page)
set(FASTER_PAGE_FRAME ${FASTER_PAGE_PARTS}/frame.html)
set(FASTER_PAGE_STYLE ${FASTER_PAGE_PARTS}/report.css)
# What every page's scripts use: elements, charts and tables.
set(FASTER_PAGE_ELEMENTS ${FASTER_PAGE_PARTS}/elements.js ${FASTER_PAGE_PARTS}/charts.js ${FASTER_PAGE_PARTS}/tables.js)

# faster_join_page(OUTPUT TEMPLATE file STYLES files... SCRIPTS files... NAME namespace::variable HEADER header [CONNECTS])
# OUTPUT is set to the C++ source; HEADER declares the variable, of type char const* const. CONNECTS: the page may ask the
# server that it comes from.
function(faster_join_page output)
  cmake_parse_arguments(ARG "CONNECTS" "TEMPLATE;NAME;HEADER" "STYLES;SCRIPTS" ${ARGN})
  cmake_path(GET ARG_TEMPLATE STEM stem)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/page_of_${stem}.cpp)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DTEMPLATE=${ARG_TEMPLATE} "-DSTYLES=${ARG_STYLES}" -DCHART_JS=${FASTER_CHART_JS}
      "-DSCRIPTS=${ARG_SCRIPTS}" -DNAME=${ARG_NAME} -DHEADER=${ARG_HEADER} -DOUTPUT=${source} -DCONNECTS=${ARG_CONNECTS} -DFRAME=${FASTER_PAGE_FRAME} -P ${FASTER_PAGE_JOINER}
    DEPENDS ${FASTER_PAGE_FRAME} ${ARG_TEMPLATE} ${ARG_STYLES} ${ARG_SCRIPTS} ${FASTER_CHART_JS} ${FASTER_PAGE_JOINER}
    COMMENT "Joining the page ${stem}.html"
    VERBATIM)
  set(${output} ${source} PARENT_SCOPE)
endfunction()
