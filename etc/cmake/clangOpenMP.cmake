# Clang and LLVM's OpenMP, for the thread sanitizer: Archer tells it where
# threads wait for each other. Nobody tells it about GCC's OpenMP, with which
# every loop looks like a race.
find_program(SPH_CLANG NAMES clang++
    clang++-20 clang++-19 clang++-18 clang++-17 clang++-16 clang++-15 clang++-14
)
if(SPH_CLANG)
    execute_process(
        COMMAND ${SPH_CLANG} -print-resource-dir
        OUTPUT_VARIABLE folder OUTPUT_STRIP_TRAILING_WHITESPACE
    )
    find_library(SPH_ARCHER archer PATHS ${folder}/../.. NO_DEFAULT_PATH)
endif()
if(NOT SPH_CLANG OR NOT SPH_ARCHER)
    message(FATAL_ERROR
        "The thread sanitizer needs Clang and LLVM's OpenMP with Archer, and"
        " one of them is not here: apt-get install clang libomp-dev"
    )
endif()
set(CMAKE_CXX_COMPILER ${SPH_CLANG})
