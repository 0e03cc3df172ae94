//! The figures asked for their data: everything claimed holds, and the numbers are the published ones.

mod asking;
mod claims_hold;
mod claims_hold_over_their_ranges;
mod numbers_aliasing;
mod numbers_checkerboard;
mod numbers_edges_and_filters;
mod numbers_formal;
mod numbers_further;
mod numbers_images;
mod numbers_patterns;
mod numbers_problem;
mod numbers_scene;
mod numbers_stochastic;
