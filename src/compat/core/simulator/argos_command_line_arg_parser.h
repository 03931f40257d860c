#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_ARGOS_COMMAND_LINE_ARG_PARSER_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_ARGOS_COMMAND_LINE_ARG_PARSER_H

// the path that users' code includes
#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/configuration/command_line_arg_parser.h>
#include <argos3/program/argos_command_line_arg_parser.h>
#endif

#endif
