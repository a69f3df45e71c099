// Errors by their cause, and messages of the engine as a code with arguments.
//
//   InputError   wrong input, with all faults: file, key, value, problem, cure
//   IoError      a file or the machine
#pragma once

#include "wythe/parts/error.h"
#include "wythe/parts/message.h"
#include "wythe/parts/notes.h"
