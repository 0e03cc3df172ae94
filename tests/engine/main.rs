//! The engines against direct sums and closed forms, in both precisions, on any number of threads.

mod films_weigh_as_the_face_does;
mod images_are_resized_in_two_passes;
mod images_transform_in_two_passes;
mod large_transforms_are_cut_and_put_together;
mod oracle;
mod transforms_are_the_sums_they_stand_for;
