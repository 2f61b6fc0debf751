# Which commit of the sources this is, in one small file that only programs link: a commit compiles nothing else again.
# It is asked at every build, and the file written when the answer is another one. Outside of a git clone it is empty.
set(faster_commit_source ${CMAKE_BINARY_DIR}/commit/program_commit.cpp)
add_custom_target(faster_ask_for_commit
  COMMAND ${CMAKE_COMMAND} -DSOURCES=${PROJECT_SOURCE_DIR} -DOUTPUT=${faster_commit_source} -P ${CMAKE_CURRENT_LIST_DIR}/WriteCommit.cmake
  BYPRODUCTS ${faster_commit_source}
  COMMENT ""
  VERBATIM)
add_library(faster_commit STATIC ${faster_commit_source})
add_library(faster::commit ALIAS faster_commit)
add_dependencies(faster_commit faster_ask_for_commit)
target_link_libraries(faster_commit PUBLIC faster_options)
