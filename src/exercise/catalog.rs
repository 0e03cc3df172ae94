//! All exercises, in the order of the lecture.

use crate::error::{Error, Result, unknown};
use crate::exercise::source::Exercise;

/// Their sources, each with the name of its file.
pub const SOURCES: &[(&str, &str)] = &[
    ("01_pixel", include_str!("../../exercises/01_pixel.rs")),
    ("02_wheel", include_str!("../../exercises/02_wheel.rs")),
    ("03_moire", include_str!("../../exercises/03_moire.rs")),
    ("04_alias", include_str!("../../exercises/04_alias.rs")),
    ("05_fold", include_str!("../../exercises/05_fold.rs")),
    ("06_square", include_str!("../../exercises/06_square.rs")),
    ("07_gibbs", include_str!("../../exercises/07_gibbs.rs")),
    ("08_transform", include_str!("../../exercises/08_transform.rs")),
    ("09_shift", include_str!("../../exercises/09_shift.rs")),
    ("10_lines", include_str!("../../exercises/10_lines.rs")),
    ("11_comb", include_str!("../../exercises/11_comb.rs")),
    ("12_kernel", include_str!("../../exercises/12_kernel.rs")),
    ("13_boxes", include_str!("../../exercises/13_boxes.rs")),
    ("14_spacing", include_str!("../../exercises/14_spacing.rs")),
    ("15_replicas", include_str!("../../exercises/15_replicas.rs")),
    ("16_rate", include_str!("../../exercises/16_rate.rs")),
    ("17_chirp", include_str!("../../exercises/17_chirp.rs")),
    ("18_mean", include_str!("../../exercises/18_mean.rs")),
    ("19_supersample", include_str!("../../exercises/19_supersample.rs")),
    ("20_length", include_str!("../../exercises/20_length.rs")),
    ("21_coverage", include_str!("../../exercises/21_coverage.rs")),
    ("22_irregular", include_str!("../../exercises/22_irregular.rs")),
    ("23_jitter", include_str!("../../exercises/23_jitter.rs")),
    ("24_lens", include_str!("../../exercises/24_lens.rs")),
    ("25_variance", include_str!("../../exercises/25_variance.rs")),
    ("26_radical", include_str!("../../exercises/26_radical.rs")),
    ("27_hammersley", include_str!("../../exercises/27_hammersley.rs")),
    ("28_nets", include_str!("../../exercises/28_nets.rs")),
    ("29_film", include_str!("../../exercises/29_film.rs")),
    ("30_unity", include_str!("../../exercises/30_unity.rs")),
    ("31_mitchell", include_str!("../../exercises/31_mitchell.rs")),
    ("32_lanczos", include_str!("../../exercises/32_lanczos.rs")),
];

/// All exercises.
///
/// ```
/// use nyquist::exercise::catalog;
/// let all = catalog::all();
/// assert!(all.iter().zip(1..).all(|(exercise, number)| exercise.number == number));
/// ```
pub fn all() -> Vec<Exercise> {
    let read = |(name, source): &(&str, &str)| Exercise::read(name, source).expect("a test has read all sources");
    SOURCES.iter().map(read).collect()
}

/// The exercise of that number (`7`), name (`alias`) or file (`07_alias`).
///
/// # Errors
/// [`Error::Unknown`] with the names that there are, nearest first.
pub fn by_name(name: &str) -> Result<Exercise> {
    let all = all();
    let named = |exercise: &&Exercise| {
        exercise.id == name || exercise.file() == name.trim_end_matches(".rs") || name.parse() == Ok(exercise.number)
    };
    let found = all.iter().find(named).cloned();
    found.ok_or_else(|| -> Error { unknown("exercise", name, all.iter().map(|exercise| exercise.id.as_str())) })
}
