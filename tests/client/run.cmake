# The header's test reads a table that the program has just written.
execute_process(COMMAND ${PROGRAM} table westergaard_half_width OUTPUT_FILE ${TABLE} COMMAND_ERROR_IS_FATAL ANY)
set(ENV{TOUCHSTONE_TABLE} ${TABLE})
execute_process(COMMAND ${TEST} COMMAND_ERROR_IS_FATAL ANY)
