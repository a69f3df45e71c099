// Standard streams that cannot harm: what the caller closed, and what no longer takes a byte.
#pragma once

namespace wythe::app {

// To be called first. A closed standard stream would give its number to the next file that is opened, a store or a table, which then
// took our messages: it is opened on nothing. Messages (stderr) that do not arrive are lost and stop no computation; a result (stdout)
// that does not arrive is remembered for ended_with. A limit on the size of files ends no program: the write says it. Nor does a reader of ours that has left, before the work is done.
void make_streams_safe();

// The exit code of the program: 4 in the place of 0 where what was printed on standard output did not arrive, which is said then.
[[nodiscard]] int ended_with(int code);

}  // namespace wythe::app
