# Puts the tables of synthesized units into a C++ source file, so that the tool knows them wherever it is installed.
#   cmake -DRESOURCES=resources.csv -DTIMING=timing.csv -DOUTPUT=synthesized_units.cpp -P EmbedTable.cmake
file(READ "${RESOURCES}" resources)
file(READ "${TIMING}" timing)
file(WRITE "${OUTPUT}" "// Embedded from rtl/resources.csv and rtl/timing.csv by the build.
#include \"faster/config/synthesized_units.hpp\"

namespace faster {

std::string_view const synthesized_units_csv = R\"table(${resources})table\";
std::string_view const synthesized_paths_csv = R\"table(${timing})table\";

}  // namespace faster
")
