//! The numbers that the lecture's inventory prints for F37, F38, F39 and F41, asked of the figures' own data.

use crate::asking::{figure, near, points, value};

#[test]
fn f37_the_power_of_a_regular_comb_is_n_at_the_multiples_of_the_rate_and_zero_elsewhere() {
    let figure = figure("f37-uniform", &[]);
    let power = points(&figure, "power", "power");
    assert_eq!(power.len(), 65); // ν = −2 … 2 in sixteenths
    for [nu, p] in power {
        near(p, if nu.fract() == 0.0 { 16.0 } else { 0.0 }, 1e-11);
    }
    // the tone at 13 of 16 comes back at 3 of 16, as strong
    assert_eq!(points(&figure, "spectrum", "leaked"), [[-0.1875, 0.5], [0.1875, 0.5]]);
    assert_eq!(points(&figure, "spectrum", "own"), [[-0.8125, 0.5], [0.8125, 0.5]]);
    // E33: tone and alias together have the power 2, not 1
    assert!(figure.claims[3].says.get(nyquist::text::Lang::En).contains("the power 2,"));
}

#[test]
fn f38_independent_points_have_a_spike_of_n_and_the_mean_one_elsewhere() {
    let figure = figure("f38-random", &[]);
    let pattern = points(&figure, "power", "pattern");
    near(value(&pattern, 0.0), 16.0, 1e-12);
    // 2000 patterns: five standard deviations of 1/√2000
    for [_, mean] in points(&figure, "power", "mean") {
        near(mean, 1.0, 5.0 / 2000f64.sqrt());
    }
    // exponential: a share 1 − e^{−1/4} below ¼, of 64 000 values
    let first = points(&figure, "statistics", "histogram")[0][1] * 0.25;
    near(first, 1.0 - (-0.25f64).exp(), 0.01);
    // (n + 1)/4 for the tone, ½ for the floor; their standard errors are below 0.03
    near(value(&points(&figure, "tone", "tone"), 0.8125), 4.25, 0.15);
    near(value(&points(&figure, "tone", "noise"), 0.1875), 0.5, 0.06);
}

#[test]
fn f39_the_noise_of_jitter_is_0_1894_at_a_quarter_0_5947_at_a_half_and_1_at_the_rate() {
    let figure = figure("f39-jitter", &[]);
    let theory = points(&figure, "after", "theory");
    let measured = points(&figure, "after", "noise");
    for (nu, printed) in [(0.25, 0.1894), (0.5, 0.5947), (1.0, 1.0)] {
        let at = |p: &[[f64; 2]]| {
            let after = p.iter().position(|p| p[0] >= nu - 1e-12).expect("ν is shown");
            let [[a, fa], [b, fb]] = [p[after - 1], p[after]];
            fa + (fb - fa) * (nu - a) / (b - a)
        };
        // the curve is drawn in steps of 0.0115: linear between them to 6e-5 (its second derivative is below 4)
        near(at(&theory), printed, 5e-5 + 6e-5);
        if nu < 1.0 {
            near(value(&measured, nu), printed, 5.0 * printed * (2.0f64 / 2000.0).sqrt());
        }
    }
    // all lines but the one at zero are gone
    let lines = points(&figure, "after", "residual");
    near(value(&lines, 0.0), 1.0, 1e-12);
    assert!(lines.iter().filter(|l| l[0] != 0.0).all(|l| l[1].abs() < 0.01));
}

#[test]
fn f39_half_a_cell_of_jitter_leaves_0_4053_of_the_line_at_the_rate() {
    let figure = figure("f39-jitter", &[("a", "0.5")]);
    near(value(&points(&figure, "after", "residual"), 1.0), 0.4053, 0.01);
    assert!(figure.claims[1].says.get(nyquist::text::Lang::En).contains("0.4053"));
}

#[test]
fn f41_bisection_takes_the_logarithm_of_what_uniform_samples_take() {
    let figure = figure("f41-adaptive", &[]);
    // six halvings for each of the two edges, sixteen uniform samples
    assert_eq!(points(&figure, "samples", "uniform").len(), 16);
    assert_eq!(points(&figure, "samples", "extra").len(), 2 * 6);
    let [adaptive, uniform] = ["adaptive", "uniform"].map(|layer| points(&figure, "cost", layer));
    assert!(adaptive.len() > 1 && adaptive.len() == uniform.len());
    for ([width, taken], [_, uniform]) in adaptive.into_iter().zip(uniform) {
        near(taken, 16.0 + 2.0 * (0.25 / width).log2(), 1e-9);
        near(uniform, 4.0 / width, 1e-9);
    }
    // the spike is between two of the samples, all zero
    assert!(points(&figure, "failure", "samples").iter().all(|p| p[1] == 0.0));
    assert!(points(&figure, "failure", "spike").iter().any(|p| p[1] == 1.0));
}
