// Files and pages: model files, studies, the files of a run and of a campaign, whole folders of results, reports.
//
//   read_model(path) ──► ModelSpec          write_run_report(folder, spec, model, result) ──► report.html
#pragma once

#include "wythe/parts/drawing.h"
#include "wythe/parts/folders.h"
#include "wythe/parts/formats.h"
#include "wythe/parts/io.h"
#include "wythe/parts/new_folder.h"
#include "wythe/parts/provenance.h"
#include "wythe/parts/report.h"
#include "wythe/parts/starter.h"
#include "wythe/parts/text.h"
