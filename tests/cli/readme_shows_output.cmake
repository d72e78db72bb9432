# The README shows what the program prints, to the letter (GiNaC writes the two factors of a product in either order).
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "atan2(sqrt(load),sqrt(1-load))*Pi^(-1)" "Pi^(-1)*atan2(sqrt(load),sqrt(1-load))" printed "${printed}")
file(READ ${README} readme)
string(FIND "${readme}" "${printed}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "README.md does not show this output of ${PROGRAM}:\n${printed}")
endif()
