#pragma once
#include <string_view>

namespace nipref::verify {

/// To be called before any file is opened: a standard descriptor that is closed would be given to the first file that
/// is, and what is meant for the user be written into that. It stands for a closed one with a descriptor from which
/// nothing comes: written to, standard output says that it is none, and standard error says nothing.
void occupy_standard_descriptors();

/// Whether what is written there is seen on a terminal that shows colours, and the user wants them: NO_COLOR unset or
/// empty (no-color.org).
bool standard_output_shows_colours();

/// Writes all of `text` to standard output and closes that. OutputError (output_file.hpp) if any of it could
/// not be written. A reader that has gone ends the program by SIGPIPE, as is usual.
void write_to_standard_output(std::string_view text);

}  // namespace nipref::verify
