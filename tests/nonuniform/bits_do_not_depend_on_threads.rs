//! One thread or five: the same bits; and so for memory that has been used before.

use crate::{numbers, positions};
use num_complex::Complex;
use nyquist::engine::nonuniform::{Nufft, PeriodicInterpolator, PlaneNufft};
use nyquist::error::Result;

fn all() -> Result<Vec<u64>> {
    let n = 150_000; // more than one chunk
    let (line, plane) = (Nufft::<f64>::new(9000, 1, 1e-9)?, PlaneNufft::<f64>::new([70, 90], [1, 1], 1e-7)?);
    let (x, y, weights) = (positions(1, n, 1), positions(2, n, 1), numbers(3, n));
    let pairs: Vec<[(i64, f64); 2]> = x.iter().zip(&y).map(|(x, y)| [*x, *y]).collect();
    let (on_line, on_plane) = (line.place(&x)?, plane.place(&pairs)?);
    let (of_line, of_plane) = (line.spectrum(&on_line, &weights)?, plane.spectrum(&on_plane, &weights)?);
    let between = PeriodicInterpolator::new(9000, 1e-9)?;
    let values = [
        line.values(&of_line, &on_line)?,
        plane.values(&of_plane, &on_plane)?,
        between.values(&numbers(4, 9000), &between.place(&positions(5, n, 9000))?)?,
    ];
    let parts = of_line.iter().chain(&of_plane).flat_map(|c| [c.re, c.im]);
    Ok(parts.chain(values.into_iter().flatten()).map(f64::to_bits).collect())
}

#[test]
fn any_number_of_threads() {
    let on =
        |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(all).unwrap();
    let one = on(1);
    assert!([2, 5].into_iter().all(|threads| on(threads) == one));
}

#[test]
fn memory_that_was_used_before() {
    let nufft = Nufft::<f64>::new(300, 1, 1e-8).unwrap();
    let mut placed = nufft.place(&[(0, 0.5); 3]).unwrap();
    let mut spectrum = vec![Complex::new(f64::NAN, 1.0); 301];
    for n in [1000, 10, 500] {
        let (points, weights) = (positions(n, n as usize, 1), numbers(n, n as usize));
        nufft.place_into(&points, &mut placed).unwrap();
        nufft.spectrum_into(&placed, &weights, &mut spectrum).unwrap();
        assert_eq!(spectrum, nufft.spectrum(&nufft.place(&points).unwrap(), &weights).unwrap());
        let mut values = vec![f64::NAN; n as usize];
        nufft.values_into(&spectrum, &placed, &mut values).unwrap();
        assert_eq!(values, nufft.values(&spectrum, &placed).unwrap());
    }
}

#[test]
fn plans_and_points_are_values_that_threads_may_share() {
    fn shared<T: Send + Sync>() {}
    shared::<Nufft<f32>>();
    shared::<PlaneNufft<f64>>();
    shared::<PeriodicInterpolator<f64>>();
    shared::<nyquist::engine::nonuniform::Placed<2>>();
}
