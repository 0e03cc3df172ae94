//! Values between samples, and power spectra of points.

use crate::{boxed, freed, on, slice, slice_mut};
use nyquist::engine::nonuniform::{PeriodicInterpolator, Placed, PlaneNufft};

/// Plan and points of the interpolant of a period.
pub struct Interpolant {
    plan: PeriodicInterpolator<f64>,
    points: Placed<1>,
}

/// A plan for `n` samples of a period to a tolerance.
#[unsafe(no_mangle)]
pub extern "C" fn interpolant_new(n: usize, tolerance: f64) -> *mut Interpolant {
    boxed(
        PeriodicInterpolator::new(n, tolerance)
            .and_then(|plan| Ok(Interpolant { points: plan.place::<f64>(&[])?, plan })),
    )
}

/// The values of the interpolant of `n` samples at `m` positions, counted in samples; positions are sorted anew in every
/// call. 0 if all went well.
///
/// # Safety
/// The plan came from `…_new` and is used by nobody else; the arrays hold `n`, `m` and `m` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn interpolant(
    plan: *mut Interpolant,
    n: usize,
    samples: *const f64,
    m: usize,
    positions: *const f64,
    values: *mut f64,
    threads: usize,
) -> i32 {
    // SAFETY: promised by the caller
    let (it, samples, positions, values) =
        unsafe { (&mut *plan, slice(samples, n), slice(positions, m), slice_mut(values, m)) };
    let work = || {
        it.plan.place_into(positions, &mut it.points)?;
        it.plan.values_into(samples, &it.points, values)
    };
    on(threads, work).is_err().into()
}

/// Plan, points, weights and one half of the power spectrum of points in the unit square.
pub struct PointPower {
    plan: PlaneNufft<f64>,
    points: Placed<2>,
    ones: Vec<f64>,
    half: Vec<f64>,
}

/// A plan for frequencies from `−reach` up to `reach` along both axes, to a tolerance.
#[unsafe(no_mangle)]
pub extern "C" fn point_power_new(reach: usize, tolerance: f64) -> *mut PointPower {
    boxed(PlaneNufft::new([reach; 2], [1; 2], tolerance).and_then(|plan| {
        let points = plan.place::<f64>(&[])?;
        Ok(PointPower { half: vec![0.0; plan.modes()], ones: Vec::new(), points, plan })
    }))
}

/// `|Σ e^{−2πi(ux + vy)}|²/n` for `−reach ≤ u, v < reach`, column `u` after column, of `n` points `x, y`, which are sorted
/// anew in every call. 0 if all went well.
///
/// # Safety
/// The plan came from `…_new` and is used by nobody else; the arrays hold `2n` and `4·reach²` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn point_power(
    plan: *mut PointPower,
    n: usize,
    points: *const [f64; 2],
    power: *mut f64,
    threads: usize,
) -> i32 {
    // SAFETY: promised by the caller
    let it = unsafe { &mut *plan };
    let reach = it.plan.degrees()[0];
    // SAFETY: promised by the caller
    let (points, power) = unsafe { (slice(points, n), slice_mut(power, 4 * reach * reach)) };
    it.ones.resize(n, 1.0);
    let work = || {
        it.plan.place_into(points, &mut it.points)?;
        it.plan.power_into(&it.points, &it.ones, &mut it.half)
    };
    let failed = on(threads, work).is_err();
    // the half with u ≥ 0 as it is, the other by symmetry
    let (gain, height) = (1.0 / n as f64, 2 * reach + 1);
    for (i, out) in power.chunks_exact_mut(2 * reach).enumerate() {
        let column = &it.half[i.abs_diff(reach) * height..][..height];
        if i < reach {
            out.iter_mut().zip(column.iter().rev()).for_each(|(out, p)| *out = gain * p);
        } else {
            out.iter_mut().zip(column).for_each(|(out, p)| *out = gain * p);
        }
    }
    failed.into()
}

freed! {
    interpolant_free: Interpolant,
    point_power_free: PointPower,
}
