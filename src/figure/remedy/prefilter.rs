//! A filter before sampling (slide «Пре-фильтрация»).

use crate::axis::{Axis, Edge};
use crate::error::Result;
use crate::figure::common::{PIECES, space, unmarked};
use crate::figure::params::Param;
use crate::figure::{Entry, Figure, Layer, Legend, Meaning, Panel, Scale};
use crate::kernel::Kernel;
use crate::kernel::box_kernel::BoxKernel;
use crate::kernel::ideal::Ideal;
use crate::kernel::kaiser::Kaiser;
use crate::kernel::widened::Widened;
use crate::num::quadrature::{even_breaks, integrate_pieces};
use crate::num::{cos_pi, sinc};
use crate::reconstruct::reconstruct;
use crate::residual::Residual;
use crate::sampled::Samples;
use crate::sampled::convolution::convolve;
use crate::sampled::dft::forward;
use crate::signal::lecture::LectureChirp;
use crate::signal::{Signal, from_fn};
use crate::text;
use crate::text::{Text, number};
use std::f64::consts::PI;

static RADIUS: Text =
    Text::fixed("radius of the sinc before it is widened, in steps", "радиус sinc до расширения, в шагах");

/// The figures of this family.
pub static ENTRIES: &[Entry] = &[PREFILTER];

const PREFILTER: Entry = Entry {
    id: "f32-prefilter",
    inventory: &["F32"],
    errata: &["E13"],
    title: &Text::fixed("Prefiltering", "Пре-фильтрация"),
    caption: &Text::fixed(
        "The chirp 1 + cos 4πx² passes the Nyquist frequency 4 at x = 1. Without a filter its samples show a mirror image \
         beyond. After a windowed sinc that stops everything above 4 only the mean is left there, which is true. A box over \
         the pixel, «exact area», is no such filter: of a tone at 0.9 f_{s} it leaves 0.1093, and a ghost remains.",
        "ЛЧМ-сигнал 1 + cos 4πx² проходит частоту Найквиста 4 в точке x = 1. Без фильтра за ней в отсчётах видно зеркальное \
         отражение. После sinc с окном, не пропускающего ничего выше 4, там остаётся только среднее — и это правда. \
         Усреднение по пикселю («точная площадь») — не такой фильтр: от тона 0,9 f_{s} остаётся 0,1093, и ложная волна \
         видна.",
    ),
    params: &[Param::real("radius", &RADIUS, 16.0, 6.0, 24.0, "steps")],
    build: |params| prefilter(params.real("radius")),
};

/// The step of the samples, and how many fine steps it has.
const STEP: f64 = 0.125;
const FINE: usize = 32;
/// Where the pictures end, and how far the samples go beyond them: there the filtered chirp is its mean.
const END: f64 = 4.0;
const BEYOND: f64 = 4.0;
/// Kaiser's parameter: the stop band begins −80 dB down.
const BETA: f64 = 8.0;

/// The windowed sinc that passes nothing above the Nyquist frequency. In cycles per step Kaiser's sinc falls from one to
/// nothing between ½ − w and ½ + w with `w = β/(2πr)`; made `1 + 2w` times as wide, it has fallen at ½.
fn low_pass(radius: f64) -> Result<Widened<Kaiser>> {
    Widened::new(Kaiser::new(radius, BETA)?, 1.0 + BETA / (PI * radius))
}

fn prefilter(radius: f64) -> Result<Figure> {
    let kernel = low_pass(radius)?;
    let ch = LectureChirp;
    let rate = 1.0 / STEP;
    // ch ⊗ r with r(x) = k(x/T)/T, as a sum over fine steps: exact to the filter's leakage beyond 256 − 8·END
    let reach = (kernel.radius().ceil() as usize + 1) * FINE;
    let fine = STEP / FINE as f64;
    let (before, inside) = ((BEYOND / fine) as usize + reach, ((END + BEYOND) / fine) as usize + reach);
    let record = Samples::of(&ch, Axis::new(-(before as f64) * fine, fine, before + inside + 1)?);
    let filter = from_fn(|x| kernel.at(x / STEP) / STEP);
    let whole = convolve(&record, &Samples::of(&filter, Axis::centered(fine, 2 * reach + 1)?))?;
    // where the filter has not run over the record's ends
    let kept = whole.values()[2 * reach..whole.values().len() - 2 * reach].to_vec();
    let filtered = Samples::new(Axis::new(-BEYOND, fine, kept.len())?, kept)?;
    let sampled = filtered.decimated(FINE)?;
    let back = reconstruct(&sampled, Ideal).edge(Edge::Clamp);

    // the samples of ch repeat after 16 steps, so that all of them are known
    let bare = Samples::of(&ch, Axis::new(0.0, STEP, 16)?);
    let mirrored = reconstruct(&bare, Ideal).edge(Edge::Wrap);

    let area = |x: f64| {
        let breaks = even_breaks(x - 0.5 * STEP, x + 0.5 * STEP, 0.25 * STEP);
        integrate_pieces(|x| ch.at(x), &breaks, 1e-14).value / STEP
    };
    let pixels = Axis::new(-BEYOND, STEP, ((END + 2.0 * BEYOND) / STEP) as usize + 1)?;
    let averaged = Samples::of(&from_fn(area), pixels);
    let ghost = reconstruct(&averaged, Ideal).edge(Edge::Clamp);

    let visible = |s: &Samples| s.points().filter(|[x, _]| (0.0..=END).contains(x)).collect::<Vec<_>>();
    let everywhere = (0..=(END / STEP) as i32).map(|k| f64::from(k) * STEP).map(|x| [x, ch.at(x)]);
    let curve = |name, meaning, signal: &dyn Fn(f64) -> f64, from: f64, to: f64| {
        Layer::curve(name, meaning, from, to, PIECES, signal)
    };
    let panel = |name, title, last: bool| {
        let x = if last { space(0.0, END) } else { unmarked(0.0, END) };
        Panel::new(name, title, x, unmarked(-0.35, 2.35)).span(2)
    };
    let left = [
        panel("unfiltered", text!("no filter: a mirror image", "без фильтра: зеркальное отражение"), false)
            .legend(Legend::Above)
            .with(
                Layer::curve("chirp", Meaning::Signal, 0.0, END, 5 * PIECES, |x| ch.at(x))
                    .thin()
                    .label(text!("signal", "сигнал")),
            )
            .with(
                curve("true", Meaning::Reconstructed, &|x| mirrored.at(x), 0.0, 1.0)
                    .label(text!("restored", "реконструкция")),
            )
            .with(curve("mirror", Meaning::Leaked, &|x| mirrored.at(x), 1.0, END).label(text!("alias", "алиас")))
            .with(Layer::dots("samples", Meaning::Samples, everywhere).label(text!("samples", "отсчёты"))),
        panel("filtered", text!("windowed sinc, then samples", "sinc с окном, затем отсчёты"), false)
            .with(Layer::line("prefiltered", Meaning::Signal, visible(&filtered)).dashed())
            .with(curve("back", Meaning::Reconstructed, &|x| back.at(x), 0.0, END))
            .with(Layer::dots("samples", Meaning::Samples, visible(&sampled))),
        panel("area", text!("mean over a pixel, then samples", "среднее по пикселю, затем отсчёты"), true)
            .with(curve("true", Meaning::Reconstructed, &|x| ghost.at(x), 0.0, 1.0))
            .with(curve("ghost", Meaning::Leaked, &|x| ghost.at(x), 1.0, END))
            .with(Layer::dots("samples", Meaning::Samples, visible(&averaged))),
    ];
    // the filter's gain, by FFT of its values in a longer record of zeros
    let response: Vec<[f64; 2]> =
        forward(&Samples::of(&filter, Axis::centered(fine, 16 * reach + 1)?)).magnitudes().collect();
    let right = [
        gain("gain-none", text!("gain", "усиление"), every(&|_| 1.0), false),
        gain(
            "gain-sinc",
            Text::EMPTY,
            response.iter().copied().filter(|p| (0.0..=TOP).contains(&p[0])).collect(),
            false,
        ),
        gain("gain-box", Text::EMPTY, every(&|nu| BoxKernel.response(nu * STEP)), true),
    ];
    let figure = left.into_iter().zip(right).fold(Figure::new(3), |figure, (l, r)| figure.with(l).with(r));

    let symmetric = (0..=100).map(|i| f64::from(i) / 100.0);
    let symmetric = symmetric.map(|d| (mirrored.at(1.0 + d) - mirrored.at(1.0 - d)).abs()).fold(0.0, f64::max);
    let near = |from: f64| filtered.points().filter(move |[x, _]| (from..=END).contains(x));
    let mean = kernel.response(0.0);
    let off = near(2.0).map(|[_, v]| (v - mean).abs()).fold(0.0, f64::max);
    let apart = near(0.0).step_by(5).map(|[x, v]| (v - back.at(x)).abs()).fold(0.0, f64::max);
    let bin = response[1][0] - response[0][0];
    let leak: f64 = response.iter().filter(|p| p[0] > 0.5 * rate).map(|p| p[1] * bin).sum();
    let tone = 0.9 * rate;
    let breaks = even_breaks(-0.5 * STEP, 0.5 * STEP, 0.25 * STEP);
    let left_over = integrate_pieces(|x| cos_pi(2.0 * tone * x), &breaks, 1e-15);
    Ok(figure
        .claim(
            text!(
                "without a filter the samples are mirrored about x = 1, where the local frequency is f_{{s}}/2",
                "без фильтра отсчёты зеркальны относительно x = 1, где местная частота равна f_{{s}}/2"
            ),
            // sixteen samples of at most 2 times Dirichlet's kernel, whose argument is off by 16ε at a slope of π
            Residual::at_most("f̃(1 + d) = f̃(1 − d)", symmetric, 16.0 * 2.0 * PI * 16.0 * f64::EPSILON),
        )
        .claim(
            text!(
                "after the sinc nothing but the mean is left: from x = 2 on the chirp is down to {} of its amplitude",
                "после sinc остаётся только среднее: начиная с x = 2 от колебаний остаётся {} их амплитуды",
                number(off, 2)
            ),
            Residual::at_most("prefiltered chirp = mean", off, far_from_stationary(2.0) + leak),
        )
        .claim(
            text!(
                "what was filtered comes back from the samples, up to what the filter leaks above f_{{s}}/2",
                "отфильтрованное восстанавливается по отсчётам с точностью до утечки фильтра выше f_{{s}}/2"
            ),
            // V08 for the density ½·|cos(πν²/4 − π/4)|·H; a chirp that is cut off has at most 1.35 times that (the
            // Cornu spiral is that much wider than from end to end)
            Residual::at_most("|f̃ − f| ≤ 2∫|F| beyond f_s/2 (V08)", apart, 1.35 * 2.0 * leak),
        )
        .claim(
            text!(
                "the box leaves {} of a tone at 0.9 f_{{s}}: «exact area» is not free of aliasing",
                "усреднение по пикселю оставляет {} от тона 0.9 f_{{s}}: «точная площадь» не избавляет от алиасинга",
                number(left_over.value / STEP, 4)
            ),
            Residual::near(
                "box at 0.9 f_s = sinc(0.9)",
                left_over.value / STEP,
                sinc(0.9),
                left_over.error / STEP + f64::EPSILON,
            ),
        ))
}

/// How much of `cos 4πx²`, passed by a filter that ends at frequency 4, is left at `x > 1`.
///
/// The spectrum is `½cos(πν²/4 − π/4)`, and so the rest two integrals `¼∫H·e^{iφ}` with `φ′ = 2π(x ± ν/4)`, which has no
/// zero for `|ν| < 4`: by parts each is at most `¼` of the variation of `H/φ′`, which is at most that of `H`, 2, by the
/// largest `1/φ′`, plus the variation of `1/φ′`.
fn far_from_stationary(x: f64) -> f64 {
    let (most, least) = (0.5 / (PI * (x - 1.0)), 0.5 / (PI * (x + 1.0)));
    2.0 * 0.25 * (2.0 * most + (most - least))
}

/// Where the gains end.
const TOP: f64 = 12.0;

fn every(response: &dyn Fn(f64) -> f64) -> Vec<[f64; 2]> {
    (0..=240).map(|i| TOP * f64::from(i) / 240.0).map(|nu| [nu, response(nu)]).collect()
}

/// A filter's gain over frequency, with what it lets fold back shaded.
fn gain(name: &'static str, title: Text, response: Vec<[f64; 2]>, last: bool) -> Panel {
    let half = 0.5 / STEP;
    let x = if last { Scale::linear(text!("frequency ν", "частота ν"), 0.0, TOP) } else { unmarked(0.0, TOP) };
    let y = Scale::linear(Text::EMPTY, -0.3, 1.2).ticks([0.0, 0.5, 1.0].map(|v| (v, text!("{v}", "{v}"))));
    let panel = Panel::new(name, title, x, y)
        .with(Layer::area("folding", Meaning::Leaked, response.iter().copied().filter(|p| p[0] >= half)))
        .with(Layer::line("gain", Meaning::Kernel, response).thick())
        .with(Layer::verticals("nyquist", Meaning::Guide, [half]).dashed());
    if !last {
        return panel;
    }
    let tone = [0.9 / STEP, BoxKernel.response(0.9)];
    panel.with(Layer::dots("tone", Meaning::Leaked, [tone])).with(Layer::notes(
        "left-over",
        Meaning::Leaked,
        [([tone[0] + 1.2, 0.6], text!("0.9 f_{{s}}: {}", "0.9 f_{{s}}: {}", number(tone[1], 4)))],
    ))
}
