# Writes what tb/program_commit.hpp declares, unless the file says so already.
#   cmake -DSOURCES=folder -DOUTPUT=program_commit.cpp -P WriteCommit.cmake
# A folder below somebody else's clone is no clone of ours.
set(commit "")
set(date "")
find_program(GIT git)
function(ask_git result)
  execute_process(COMMAND ${GIT} -C ${SOURCES} ${ARGN} OUTPUT_VARIABLE answer ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(${result} "${answer}" PARENT_SCOPE)
endfunction()
if(GIT)
  ask_git(root rev-parse --show-toplevel)
  file(REAL_PATH "${SOURCES}" sources)
  if(root STREQUAL sources)
    ask_git(commit describe --always --dirty --exclude=* --abbrev=12)
    ask_git(date show -s --format=%cs HEAD)
  endif()
endif()
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT [[
#include "tb/program_commit.hpp"

namespace faster {

char const* const program_commit = "@commit@";
char const* const program_commit_date = "@date@";

}  // namespace faster
]] @ONLY)
