// Makes standard streams safe where they are closed or cannot be written.
#pragma once

namespace wythe::app {

// To be called first. A closed standard stream would give its number to the next opened file, which would then get our
// messages; so it is opened on nothing. Lost messages (stderr) stop no computation. A lost result (stdout) is remembered
// for ended_with. A file size limit, or a reader that leaves early, does not end the program: the write reports it.
void make_streams_safe();

// The exit code of the program: 4 instead of 0 where output on standard output was lost, which is then reported.
[[nodiscard]] int ended_with(int code);

}  // namespace wythe::app
