# The floors of the libraries, for the check of the includes and for the picture.
# The floors of each library from the ground up; floors on one line do not see each other.
set(storeys_of_common "base" "geometry config" "drawing")
set(storeys_of_blockgen "mesh" "input noding" "arrangement" "faces" "sampling" "report fit" "cut" "picture")
set(storeys_of_dda "base" "geometry linear joint hdf" "model" "block" "contact" "terms" "path trial" "solve" "analysis" "monitor" "input"
    "laboratory writers" "checkpoint" "results")
set(storeys_of_record "record")
set(storeys_of_study "statistics design csv" "plan" "folder" "table cluster" "analysis" "picture")

# The files of the large rooms from the ground up, each with its header; files on one line do not see each other.
set(levels_of_trial
    "contact_law joint_motion shear_energy shear_line step_problem"
    "contact_trial segment_strength trial_bolts"
    "segment_friction single_strength"
    "trial_contacts"
    "entrance_lines joint_dilation shear_bounds"
    "step_contacts")
set(levels_of_solve
    "augmentation balance_progress break_bonds dilation_rounds entrance_rounds gap_settling iterate limited_contacts line_search path_contact step_counts step_matrix"
    "augmentation_rounds friction_coupling interior_point patch_balance"
    "interior_coupling"
    "open_close_iteration"
    "contact_solution")
set(levels_of_analysis
    "base_motion counter_slips energy model_scale prediction"
    "energy_watch state"
    "advance_contacts bonds deepest_contact ledger lost_blocks rotation_prediction shear_sharing step_report"
    "excavate moving_block perturb run_observer step_equations"
    "step stop_limit"
    "run_stage"
    "strength_reduction"
    "run")

# Sets PREFIX_NAME, for each name on these lines, to the rank of its line.
function(set_ranks prefix)
    set(rank 0)
    foreach(line IN LISTS ARGN)
        string(REPLACE " " ";" names "${line}")
        foreach(name IN LISTS names)
            set(${prefix}_${name} ${rank} PARENT_SCOPE)
        endforeach()
        math(EXPR rank "${rank} + 1")
    endforeach()
endfunction()

foreach(room IN ITEMS trial solve analysis)
    set_ranks(level_of_${room} ${levels_of_${room}})
endforeach()
foreach(library IN ITEMS common blockgen dda record study)
    set_ranks(rank_of_${library} ${storeys_of_${library}})
endforeach()

# The library and the floor of a file or of an included header; both empty for anything else.
function(locate path library_variable floor_variable)
    string(REGEX REPLACE "^lib(blockgen|dda|common|study)/" "" inside "${path}")
    set(library "")
    set(floor "")
    if(inside MATCHES "^(common|blockgen|dda|study)/([^/]+)/")
        set(library "${CMAKE_MATCH_1}")
        set(floor "${CMAKE_MATCH_2}")
    elseif(inside MATCHES "^record/")
        set(library record)
        set(floor record)
    endif()
    set(${library_variable} "${library}" PARENT_SCOPE)
    set(${floor_variable} "${floor}" PARENT_SCOPE)
endfunction()

# All sources of the libraries and programs under ROOT, relative to it.
function(find_sources variable)
    file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/libcommon/*.[ch]pp ${ROOT}/libblockgen/*.[ch]pp
         ${ROOT}/libdda/*.[ch]pp ${ROOT}/libstudy/*.[ch]pp ${ROOT}/tools/*.[ch]pp)
    set(${variable} "${files}" PARENT_SCOPE)
endfunction()
