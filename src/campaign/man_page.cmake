# Writes the man page of a program from its --help, and from that of its commands:
#   cmake -D PROGRAM=FILE -D BRIEF=TEXT -D COMMANDS="run status" -D OUTPUT=FILE -P man_page.cmake
get_filename_component(name "${PROGRAM}" NAME)
string(TOUPPER "${name}" title)
separate_arguments(COMMANDS)

# the text of "PROGRAM COMMAND --help" as it is, with what roff would read as its own escaped
function(append_help text command)
  execute_process(COMMAND "${PROGRAM}" ${command} --help OUTPUT_VARIABLE help RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${PROGRAM} ${command} --help has the exit status ${status}")
  endif()
  string(STRIP "${help}" help)
  string(REPLACE "\\" "\\e" help "${help}")
  string(REPLACE "-" "\\-" help "${help}")
  string(REGEX REPLACE "(^|\n)([.'])" "\\1\\\\&\\2" help "${help}")
  set(${text} "${${text}}.nf\n${help}\n.fi\n" PARENT_SCOPE)
endfunction()

set(page ".TH ${title} 1 \"\" \"argos3\" \"User Commands\"\n.SH NAME\n${name} \\- ${BRIEF}\n.SH DESCRIPTION\n")
append_help(page "")
foreach(command IN LISTS COMMANDS)
  string(TOUPPER "${command}" heading)
  string(APPEND page ".SH ${heading}\n")
  append_help(page "${command}")
endforeach()
string(APPEND page ".SH SEE ALSO\n.BR argos3 (1)\n")
file(WRITE "${OUTPUT}" "${page}")
