# Makes the headers below the folder `headers` include each other by their installed names.
file(GLOB_RECURSE files "${headers}/*.h")
foreach(file ${files})
    file(READ "${file}" text)
    string(REGEX REPLACE "#include \"((core|backend_[a-z]+|shaders)/[^\"\n]+)\""
        "#include <dirt/\\1>" text "${text}")
    file(WRITE "${file}" "${text}")
endforeach()
