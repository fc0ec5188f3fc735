#pragma once

namespace searle::app {

/// Starts this program anew, by the same words, with threads that sleep while they wait. OpenMP's
/// spin, which on a machine with other work keeps those from running that they wait for: 11 000
/// spheres with films beside two other programs took 42 s for what one thread does in 3.3 s and two
/// that sleep in 2.8 s. Only the environment at the start of a program decides that. Returns where
/// OMP_WAIT_POLICY is set already, or where it cannot be done; to be called before anything is
/// written.
void restart_with_sleeping_threads();

} // namespace searle::app
