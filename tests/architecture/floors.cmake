# The floors of the libraries, for the check of the includes and for the picture.
# The floors of each library from the ground up; floors on one line do not see each other.
set(storeys_of_common "base" "geometry config" "drawing")
set(storeys_of_blockgen "mesh" "input noding" "arrangement" "faces" "sampling" "report fit" "cut" "picture")
set(storeys_of_dda "base" "geometry linear joint hdf" "model" "block" "contact" "terms" "solve" "analysis" "monitor" "input"
    "laboratory writers" "checkpoint" "results")
set(storeys_of_record "record")
set(storeys_of_study "statistics design csv" "plan" "folder" "table cluster" "analysis" "picture")

# The files of dda/analysis from the ground up, each with its header; files on one line do not see each other.
set(levels_of_analysis
    "base_motion contact_law energy joint_motion model_scale path_contact shear_energy step_counts step_problem"
    "advance_contacts counter_slips energy_watch iterate prediction segment_strength shear_sharing state"
    "bonds deepest_contact lost_blocks segment_friction step_equations step_report"
    "moving_block run_observer trial_contacts"
    "augmentation augmentation_rounds dilation_rounds entrance_rounds line_search shear_line step_matrix trial_bounds trial_dilation"
    "friction_coupling gap_settling interior_point limited_contacts"
    "interior_coupling patch_balance"
    "open_close_iteration"
    "ledger rotation_prediction"
    "excavate perturb step stop_limit"
    "run_stage"
    "strength_reduction"
    "run")
set(rank 0)
foreach(level IN LISTS levels_of_analysis)
    string(REPLACE " " ";" stems "${level}")
    foreach(stem IN LISTS stems)
        set(level_of_analysis_${stem} ${rank})
    endforeach()
    math(EXPR rank "${rank} + 1")
endforeach()

foreach(library IN ITEMS common blockgen dda record study)
    set(rank 0)
    foreach(storey IN LISTS storeys_of_${library})
        string(REPLACE " " ";" floors "${storey}")
        foreach(floor IN LISTS floors)
            set(rank_of_${library}_${floor} ${rank})
        endforeach()
        math(EXPR rank "${rank} + 1")
    endforeach()
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
