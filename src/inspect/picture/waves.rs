//! The gratings of a picture that are too fine for a scale.

use crate::image::Image;
use crate::inspect::picture::patch::Patch;
use crate::inspect::picture::wave::{DARKEST, Wave, upward};
use crate::parallel;

/// The gratings that were found, and how many more there are.
#[derive(Debug, Clone, PartialEq)]
pub struct Waves {
    /// The strongest ones, by contrast.
    pub strongest: Vec<Wave>,
    /// How many others of at least the contrast that was asked for.
    pub others: usize,
}

/// How many are told apart.
pub const MOST: usize = 8;

/// What a grating has of its amplitude in every part of it, at least: it counts as one as long as it is even to a fifth.
pub(super) const EVEN: f64 = 0.8;

/// The gratings of a picture beyond `limit = [U, V]`, `|u| > U` or `|v| > V` in cycles a pixel, of at least a contrast.
///
/// The picture is looked at in square patches that overlap by half, as wide as 16 pixels of the new raster, but at least 64
/// and at most 512 of the old one, under a Hann window; what stands out of a patch's spectrum like a line is a grating there.
/// Those that bend (rings, cloth) are lines in smaller patches only: patches of half the width count where seven of nine
/// neighbours have lines as well, so that the hair and the leaves of a photograph do not. Gratings of nearly one frequency
/// (1.5 bins) are one, at the place of its highest contrast. From there the patch is doubled, as long as the amplitude stays
/// within a fifth: large gratings are known more closely.
///
/// What bends even faster is [texture](crate::inspect::picture::texture).
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::inspect::picture::waves::waves;
/// let (fine, coarse) = (Grating::new([0.4, 0.1])?, Grating::new([0.05, 0.02])?);
/// let image = Image::of(&field_fn(|x, y| 0.5 + 0.2 * fine.at(x, y) + 0.2 * coarse.at(x, y)), Grid::pixels(200, 150)?);
/// let found = waves(&image, [0.25, 0.25], 0.01);
/// assert_eq!((found.strongest.len(), found.others), (1, 0));
/// assert!((found.strongest[0].frequency[0] + 0.4).abs() < 1e-6); // the opposite of (0.4, 0.1) points up
/// # Ok::<(), Error>(())
/// ```
pub fn waves(image: &Image, limit: [f64; 2], contrast: f64) -> Waves {
    let side = ((8.0 / limit[0].min(limit[1])).clamp(64.0, 512.0) as usize).next_power_of_two();
    let mut found: Vec<Wave> = patches(image, side, limit, contrast).into_iter().flatten().flatten().collect();
    found.extend(bent(patches(image, side / 2, limit, contrast)));
    found.sort_by(|a, b| b.contrast().total_cmp(&a.contrast()));
    let mut different: Vec<Wave> = Vec::new();
    for wave in found {
        if !different.iter().any(|other| same(&wave, other)) {
            different.push(wave);
        }
    }
    let others = different.len().saturating_sub(MOST);
    different.truncate(MOST);
    let strongest = parallel::map(different.len(), |i| grown(image, different[i]));
    Waves { strongest, others }
}

/// The lines in all patches of a size, row by row.
fn patches(image: &Image, side: usize, limit: [f64; 2], contrast: f64) -> Vec<Vec<Vec<Wave>>> {
    let beyond = |frequency: [f64; 2]| {
        let [u, v] = frequency.map(|nu| (nu - nu.round()).abs());
        u > limit[0] || v > limit[1]
    };
    let size = [side.min(image.width()), side.min(image.height())];
    let (across, down) = (starts(image.width(), size[0]), starts(image.height(), size[1]));
    let look = |corner: [usize; 2]| -> Vec<Wave> {
        let patch = Patch::of(image, corner, size);
        let lines = patch.lines(beyond, contrast * patch.mean.max(DARKEST));
        let wave =
            |(frequency, amplitude)| Wave { frequency: upward(frequency), amplitude, mean: patch.mean, corner, size };
        lines.into_iter().map(wave).collect()
    };
    parallel::map(down.len(), |j| across.iter().map(|&left| look([left, down[j]])).collect())
}

/// Of lines in small patches those whose neighbours have lines too.
fn bent(patches: Vec<Vec<Vec<Wave>>>) -> Vec<Wave> {
    let has = |j: usize, i: usize| patches.get(j).and_then(|row| row.get(i)).is_some_and(|lines| !lines.is_empty());
    let places = (1..patches.len()).flat_map(|j| (1..patches[j].len()).map(move |i| (j, i)));
    let among = |&(j, i): &(usize, usize)| {
        (j - 1..=j + 1).flat_map(|j| (i - 1..=i + 1).map(move |i| (j, i))).filter(|&(j, i)| has(j, i)).count() >= 7
    };
    places.filter(among).flat_map(|(j, i)| patches[j][i].iter().copied()).collect()
}

/// Whether two waves have one frequency, to 1.5 bins of the smaller patch.
fn same(a: &Wave, b: &Wave) -> bool {
    let apart = |sign: f64| {
        [0, 1].map(|i| {
            let difference = a.frequency[i] - sign * b.frequency[i];
            (difference - difference.round()).abs() * a.size[i].min(b.size[i]) as f64
        })
    };
    [apart(1.0), apart(-1.0)].iter().any(|[x, y]| x.max(*y) <= 1.5)
}

/// Where patches of `n` out of `whole` pixels start: every half of a patch, and one at the end.
fn starts(whole: usize, n: usize) -> Vec<usize> {
    let step = n.div_ceil(2).max(1);
    let regular = (0..=whole - n).step_by(step);
    let last = whole - n;
    regular.chain((!last.is_multiple_of(step)).then_some(last)).collect()
}

/// The same wave in the largest patch that it fills.
fn grown(image: &Image, first: Wave) -> Wave {
    let whole = [image.width(), image.height()];
    let mut best = first;
    loop {
        let size = [0, 1].map(|i| (2 * best.size[i]).min(whole[i]));
        if size == best.size {
            return best;
        }
        let middle = first.middle();
        let corner = [0, 1].map(|i| ((middle[i] - 0.5 * size[i] as f64).max(0.0) as usize).min(whole[i] - size[i]));
        let wider = Wave::near(image, best.frequency, corner, size);
        if wider.amplitude < EVEN * first.amplitude {
            return best;
        }
        best = wider;
    }
}
