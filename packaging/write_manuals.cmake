# Writes the manual pages of programs and their subcommands, which the programs print themselves.
#   cmake -D FOLDER=<folder> -D PROGRAMS=<list of programs> -P write_manuals.cmake
cmake_minimum_required(VERSION 3.25)

function(write_manual name)
    execute_process(COMMAND ${ARGN} --help-man OUTPUT_FILE ${FOLDER}/${name}.1 COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
foreach(program IN LISTS PROGRAMS)
    cmake_path(GET program FILENAME name)
    write_manual(${name} ${program})
    execute_process(COMMAND ${program} --help-words OUTPUT_VARIABLE words COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "\n[a-z][a-z-]* " subcommands "\n${words}")
    foreach(subcommand IN LISTS subcommands)
        string(STRIP "${subcommand}" subcommand)
        write_manual(${name}-${subcommand} ${program} ${subcommand})
    endforeach()
endforeach()
file(TOUCH ${FOLDER}/written)
