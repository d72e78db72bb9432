# touchstone_embed(TARGET FUNCTION FILE): compile the text FILE into TARGET as
#   namespace touchstone::data { std::string_view FUNCTION(); }
# so that an installed program finds what it was built with. The file stays the source.
function(touchstone_embed target function file)
  set(out "${CMAKE_CURRENT_BINARY_DIR}/embedded/${function}.cpp")
  add_custom_command(
    OUTPUT "${out}"
    COMMAND ${CMAKE_COMMAND} -DINPUT=${file} -DOUTPUT=${out} -DFUNCTION=${function}
            -P "${PROJECT_SOURCE_DIR}/cmake/embed_text_script.cmake"
    DEPENDS "${file}" "${PROJECT_SOURCE_DIR}/cmake/embed_text_script.cmake"
    VERBATIM)
  target_sources(${target} PRIVATE "${out}")
endfunction()
