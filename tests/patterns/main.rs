//! Sample patterns and their measures: one theorem a file, its sentences as names, its oracle outside the library.

mod nearest_points_are_found_whatever_the_points;
mod owen_scrambling_is_nested_and_uniform;
mod patterns_are_pure_functions_of_the_seed;
mod periodograms_are_the_sums_they_stand_for;
mod poisson_disks_leave_no_room;
mod star_discrepancy_is_the_worst_box;
mod void_and_cluster_orders_all_cells;
