# SPDX-License-Identifier: MIT
# cmake -D DOXYGEN=… -D SOURCE=… -D FOLDER=… -P reference_pages.cmake: makes the reference pages in FOLDER. Fails where a
# comment is not understood, and where a class or a free function says nothing about itself.
file(MAKE_DIRECTORY ${FOLDER})
set(ENV{SECONDLIGHT_REFERENCE_PAGES} ${FOLDER})
execute_process(COMMAND ${DOXYGEN} docs/Doxyfile WORKING_DIRECTORY ${SOURCE} ERROR_VARIABLE said RESULT_VARIABLE failed)
# Members are commented where name, type and unit leave something open, which no tool can tell; a sentence for each would be
# noise. What visit_fields does is said once, at FieldVisitor.
string(REGEX REPLACE "[^\n]*warning: Member [^\n]*\\((variable|enumvalue)\\) of [^\n]*\n" "" said "${said}")
string(REGEX REPLACE "[^\n]*warning: Member [^\n]* of (class|struct) [^\n]*\n" "" said "${said}")
string(REGEX REPLACE "[^\n]*warning: Member visit_fields\\([^\n]*\n" "" said "${said}")
if(failed OR said)
    message("${said}")
    message(FATAL_ERROR "doxygen docs/Doxyfile: comments are missing or not understood, see above")
endif()
message(STATUS "${FOLDER}/html/index.html")
