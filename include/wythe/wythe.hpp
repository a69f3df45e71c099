// All of wythe for C++ programs.
#pragma once

#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/limit.h"
#include "wythe/model.h"
#include "wythe/result.h"
#include "wythe/solve.h"
#include "wythe/spec.h"
#include "wythe/state.h"
#include "wythe/study.h"
