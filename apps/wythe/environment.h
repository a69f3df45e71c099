// What the caller's environment may do to the libraries underneath: nothing that ends or changes a run.
#pragma once

namespace wythe::app {

// To be called first. HOME is hidden while OpenTURNS is loaded, which reads its settings then (environment.cpp).
void show_home_again();

}  // namespace wythe::app
