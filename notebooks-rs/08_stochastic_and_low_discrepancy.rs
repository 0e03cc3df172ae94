//! Stochastic and low-discrepancy sampling: what noise costs and what it buys, and points better than random ones.

#![allow(clippy::print_stdout, reason = "a notebook prints")]

use nyquist::course::{display, law, prove, show};
use nyquist::figure::{Figure, Layer, Legend, Meaning, Panel, Scale};
use nyquist::laws::discrepancy::{elementary_intervals, grid_discrepancy, hammersley_discrepancy, koksma_hlawka};
use nyquist::laws::frames::{irregular_recovery, jittered_cells, random_polynomial};
use nyquist::laws::jitter::{deviations, jittered_tone};
use nyquist::laws::variance::{axis_edge, mean_square};
use nyquist::num::sinc;
use nyquist::pattern::measure::elementary::occupancy;
use nyquist::pattern::measure::integration::errors;
use nyquist::pattern::radical::radical_inverse;
use nyquist::prelude::*;
use nyquist::text;

fn main() -> Result<()> {
    // %% en
    // # 8. Stochastic and low-discrepancy sampling
    //
    // Aliasing has two sides: something wrong is added, and it is *ordered*, so that the eye finds it at once. Random
    // positions of the samples do not lessen the first. They take away the second: a false pattern becomes noise. This
    // notebook measures what that is worth: first in spectra, then in pictures, at last in the number of samples.
    // %% ru
    // # 8. Стохастическое сэмплирование и низкое расхождение
    //
    // У алиасинга две стороны: в картину добавляется неверное, и это неверное *упорядочено*, а потому сразу бросается в
    // глаза. Случайные положения отсчётов не уменьшают первого. Они отнимают второе: ложный узор становится шумом. В этой
    // тетради мы измерим, чего это стоит, — сначала по спектрам, потом по картинкам, наконец, по числу отсчётов.
    // %%
    let lang = Lang::En;

    // %% en
    // ## 1. Regular samples: the spectrum of a comb is a comb
    //
    // The power spectrum of $N$ points in the unit square is
    // $$P(u) = \frac1N\Bigl|\sum_j e^{-2\pi i\,u\cdot x_j}\Bigr|^2.$$
    // For the $n \times n$ grid it is $N = n^2$ at the multiples of $n$ and zero at all other whole frequencies. Multiplying
    // the *signal by the sampling comb* puts a copy of the signal's *spectrum* on each of these spikes (the slide
    // multiplies by «the comb of the spectrum»: E10), each as strong as the original: coherent, regular, hence visible.
    //
    // Coherent also means that powers do not add up. Two tones, 0.3 and 0.7, have the power ½ each; sampled at the rate 1
    // they fall on one another and have 2, not 1. So «the spectrum of the samples is the convolution of the power spectra»,
    // which a popular book says, is true of random combs only (E33).
    // %% ru
    // ## 1. Равномерные отсчёты: спектр гребня — гребень
    //
    // Спектр мощности $N$ точек единичного квадрата —
    // $$P(u) = \frac1N\Bigl|\sum_j e^{-2\pi i\,u\cdot x_j}\Bigr|^2.$$
    // У сетки $n \times n$ он равен $N = n^2$ на кратных $n$ и нулю на всех остальных целых частотах. Умножение *сигнала на
    // гребень отсчётов* ставит на каждый из этих пиков копию *спектра* сигнала (на слайде умножают «на гребенку
    // спектра»: E10), и каждая не слабее оригинала: артефакты когерентны, регулярны и потому заметны.
    //
    // Когерентность означает и то, что мощности не складываются. У синусоид 0,3 и 0,7 мощность по ½; с частотой
    // дискретизации 1 они ложатся друг на друга, и у суммы мощность 2, а не 1. Поэтому «спектр мощности отсчётов — свёртка
    // спектров мощности», как написано в известной книге, верно лишь для случайных гребней (E33).
    // %%
    let grid = Periodogram::of(&Regular::<2>::new([16, 16])?.points(0), 40)?;
    fn on_grid(u: [i64; 2]) -> bool {
        u[0] % 16 == 0 && u[1] % 16 == 0
    }
    let spike = grid.half().filter(|(u, _)| on_grid(*u)).map(|(_, p)| (p - 256.0).abs()).fold(0.0, f64::max);
    let between = grid.half().filter(|(u, _)| !on_grid(*u)).map(|(_, p)| p).fold(0.0, f64::max);
    // 256 phasors, each a power of up to 40 of one that is rounded: twice their relative error, times the power
    let rounding = 2.0 * 256.0 * 4.0 * f64::EPSILON * 41.0;
    let tones = [Cosine::new(0.3)?, Cosine::new(0.7)?];
    let both = (0..10).map(f64::from).map(|x| (tones[0].at(x) + tones[1].at(x)).powi(2)).sum::<f64>() / 10.0;
    prove([
        Residual::at_most("P = N, u ∈ 16ℤ²", spike, rounding),
        Residual::at_most("P = 0, u ∉ 16ℤ²", between, rounding),
        Residual::near("⟨(f₀.₃ + f₀.₇)²⟩ = 2 ≠ ½ + ½", both, 2.0, 40.0 * f64::EPSILON * 10.0),
    ])?;

    // %%
    show(lang, "f37-uniform", &[("cycles", "11")])?;

    // %% en
    // **Exercise.** For which `cycles` do the tone and its alias differ least in frequency? What would the two waves of
    // section 1 look like then, and how could you tell them apart from their samples?
    // %% ru
    // **Упражнение.** При каком `cycles` частоты синусоиды и её алиаса ближе всего? Как тогда выглядели бы две волны и
    // можно ли различить их по отсчётам?

    // %% en
    // ## 2. Independent samples: white noise
    //
    // **Theorem.** For $N$ independent points $\mathsf E\,P(u) = 1$ at every whole frequency but zero, and one pattern's power
    // is about exponentially distributed: its deviation is as large as its mean.
    //
    // That noise is *white*. The slide's argument, «the eye is less sensitive to high-frequency noise», needs noise that
    // *is* of high frequency, and independent points do not make it (E11).
    // %% ru
    // ## 2. Независимые отсчёты: белый шум
    //
    // **Теорема.** Для $N$ независимых точек $\mathsf E\,P(u) = 1$ на всех целых частотах, кроме нуля, а мощность одного
    // узора распределена примерно экспоненциально: отклонение не меньше самого среднего.
    //
    // Этот шум — *белый*. Довод слайда «зрение менее чувствительно к высокочастотному шуму» требует, чтобы шум *был*
    // высокочастотным, а независимые точки такого не дают (E11).
    // %%
    let (count, patterns) = (256, 200);
    let white = Periodogram::mean(&Random::new(count)?, 1, patterns, 20)?;
    let powers: Vec<f64> = white.half().map(|(_, p)| p).collect();
    let bins = powers.len() as f64;
    let mean = powers.iter().sum::<f64>() / bins;
    let spread = (powers.iter().map(|p| (p - mean).powi(2)).sum::<f64>() / bins).sqrt();
    // P(u) and P(v) are uncorrelated for u ≠ ±v, and each has the variance 1 − 1/N
    let allowed = deviations(1) * (1.0 / (bins * f64::from(patterns))).sqrt();
    prove([Residual::near("E P = 1", mean, 1.0, allowed)])?;
    let line = text!(
        "deviation of the mean of {patterns} patterns: {spread:.4}, expected {:.4}",
        "отклонение среднего по {patterns} узорам: {spread:.4}, ожидается {:.4}",
        (1.0 / f64::from(patterns)).sqrt()
    );
    println!("{}", line.get(lang));

    // %%
    show(lang, "f38-random", &[("seed", "5")])?;

    // %% en
    // And the slide goes too far once more: irregular samples «will not help to restore the signal exactly». They do, if
    // their positions are *known* (E12). A signal of a period with the band $B$ has finitely many coefficients; every sample
    // is a linear equation for them; the price of irregularity is the condition number of the system. One sample somewhere
    // in every cell, a signal that reaches 0.7 of the cells' Nyquist frequency:
    // %% ru
    // И ещё раз слайд сказал лишнее: нерегулярные отсчёты будто бы «не помогут восстановить исходный сигнал в точности».
    // Помогут, если их положения *известны* (E12). У периодического сигнала с полосой $B$ конечное число коэффициентов,
    // каждый отсчёт — линейное уравнение на них, а плата за нерегулярность — число обусловленности системы. Возьмём по
    // одному отсчёту где-нибудь в каждой ячейке и сигнал, доходящий до 0,7 частоты Найквиста этих ячеек:
    // %%
    let positions = jittered_cells(3, 64, 1.0);
    let signal = random_polynomial(5, 64.0, 22)?;
    let recovery = Irregular::of(&signal, 0.0..64.0, &positions)?.least_squares(signal.band(), 1000.0)?;
    println!("κ = {:.2}", recovery.condition());
    prove([irregular_recovery(&signal, &positions, signal.band(), 1000.0)?])?;

    // %%
    show(lang, "x-irregular", &[])?;

    // %% en
    // **Exercise.** Raise the degree 22 to 28 and then to 31, the most that 64 samples can carry. What happens to κ, and
    // what would noise in the samples become?
    // %% ru
    // **Упражнение.** Увеличьте степень 22 до 28, потом до 31 — больше 64 отсчёта не унесут. Что произойдёт с κ и во что
    // превратился бы шум в отсчётах?

    // %% en
    // ## 3. Jitter: order without spikes
    //
    // Move every sample at random *within its cell*. With the width $a$ of the jitter in cells the power spectrum becomes
    // $$P(\nu) = T\bigl[1 - \mathrm{sinc}^2(aT\nu)\bigr] + \sum_k \mathrm{sinc}^2(ak)\,\delta\!\left(\nu - \tfrac kT\right):$$
    // the spikes give their power to a floor of noise that begins as $(\pi aT\nu)^2T/3$, almost nothing. For $a = 1$ all
    // spikes are gone but the one at zero. So here noise does go to high frequencies. (A popular book prints
    // $\mathrm{sinc}(T\omega/2)$ beside formulas in cycles: at $\nu = \frac12$ that would be a floor of 0.02 instead of 0.59:
    // E32.)
    // %% ru
    // ## 3. Джиттер: порядок без пиков
    //
    // Сдвинем каждый отсчёт случайно *в пределах его ячейки*. Если ширина джиттера составляет $a$ ячейки, спектр мощности
    // становится
    // $$P(\nu) = T\bigl[1 - \mathrm{sinc}^2(aT\nu)\bigr] + \sum_k \mathrm{sinc}^2(ak)\,\delta\!\left(\nu - \tfrac kT\right):$$
    // пики отдают мощность шумовому фону, который начинается как $(\pi aT\nu)^2T/3$, то есть почти с нуля. При $a = 1$
    // исчезают все пики, кроме нулевого. Вот здесь шум действительно уходит на высокие частоты. (В известной книге рядом с
    // формулами в периодах напечатано $\mathrm{sinc}(T\omega/2)$: тогда при $\nu = \frac12$ фон был бы 0,02, а не 0,59: E32.)
    // %%
    let (spikes, combs) = (64, 400);
    let scale = Scale::linear(text!("power", "мощность"), 0.0, 1.2);
    let mut panel =
        Panel::new("power", Text::EMPTY, Scale::linear(Text::same("ν"), 0.0, 2.0), scale).legend(Legend::Above);
    for (i, width) in (0..).zip([0.25, 0.5, 1.0]) {
        let comb = JitteredComb::new(1.0, Jitter::Uniform { width })?;
        let found = comb.mean_periodogram(1, spikes, combs, 2);
        let [nu, half] = found[spikes / 2];
        // one pattern deviates by at most √(2P² + 4P/n)
        let floor = comb.noise(nu);
        let one = (2.0 * floor * floor + 4.0 * floor / spikes as f64).sqrt();
        let bound = deviations(3) * one / f64::from(combs).sqrt();
        prove([Residual::near(format!("a = {width}: P(½) = {floor:.4}"), half, floor, bound)])?;
        let dots = found.iter().enumerate().filter(|(m, _)| m % spikes != 0).map(|(_, point)| *point);
        panel = panel
            .with(Layer::dots("measured", Meaning::Series(i), dots).label(text!("a = {width}", "a = {width}")))
            .with(Layer::curve("theory", Meaning::Theory, 0.0, 2.0, 400, move |nu| 1.0 - sinc(width * nu).powi(2)));
    }
    let title = text!("The floor of noise, 1 − sinc²(aν)", "Шумовой фон 1 − sinc²(aν)");
    display(lang, &title, &Figure::new(1).with(panel))?;

    // %% en
    // Now the step that is easily overlooked. An image shows every value *in the middle of its pixel*, wherever it was taken.
    // Then a tone keeps $\mathrm{sinc}(a\nu)$ of its amplitude as if it had been filtered by a box, alias included, and the
    // rest comes back as noise that is white again, of the power $\frac12(1 - \mathrm{sinc}^2 a\nu)$. Nothing is removed;
    // energy only changes its form.
    // %% ru
    // Теперь шаг, который легко пропустить. Изображение показывает каждое значение *в центре пикселя*, где бы оно ни было
    // взято. Тогда от синусоиды остаётся $\mathrm{sinc}(a\nu)$ амплитуды, будто её отфильтровали прямоугольником, — и алиас
    // остаётся вместе с ней, а остальное возвращается шумом, снова белым, мощности $\frac12(1 - \mathrm{sinc}^2 a\nu)$.
    // Ничего не удалено, энергия лишь сменила вид.
    // %%
    let comb = JitteredComb::new(1.0, Jitter::Uniform { width: 1.0 })?;
    prove(jittered_tone(&comb, &comb, 1, 64, 400, 55)?)?;

    // %%
    show(lang, "f39-tone", &[])?;

    // %% en
    // **Exercise.** Half a cell of jitter, $a = \frac12$: which part of the spike at $\nu = 1$ is left? Compute it, then look
    // it up with `show(lang, "f39-jitter", &[("a", "0.5")])?;`.
    // %% ru
    // **Упражнение.** Джиттер в половину ячейки, $a = \frac12$: какая доля пика при $\nu = 1$ останется? Вычислите, потом
    // проверьте: `show(lang, "f39-jitter", &[("a", "0.5")])?;`.

    // %% en
    // ## 4. In a picture: structure goes, the error need not
    //
    // Let $p$ be the part of a cell that is white. A random sample in the cell is white with the probability $p$ and errs by
    // $p(1-p)$ in the mean square; $n^2$ cells in a pixel, one sample each,
    // $$\mathsf E\,(\text{error})^2 = \frac1{n^4}\sum_{\text{cells}} p(1-p).$$
    // Of Duff's checkerboard every $p$ is known exactly, so that the error of a jittered picture can be computed before any
    // sample is taken. For one sample a pixel it is *larger* than that of the regular picture (E11): the slides' comparison
    // is about structure, not about error. With 16 samples jitter wins in both.
    // %% ru
    // ## 4. На картинке: структура уходит, ошибка — не обязательно
    //
    // Пусть $p$ — доля белого в ячейке. Случайный отсчёт в ней белый с вероятностью $p$, и его средний квадрат ошибки
    // $p(1-p)$; если в пикселе $n^2$ ячеек и по отсчёту в каждой, то
    // $$\mathsf E\,(\text{ошибка})^2 = \frac1{n^4}\sum_{\text{ячейки}} p(1-p).$$
    // Для доски Даффа все $p$ известны точно, так что ошибку картинки с джиттером можно вычислить, не взяв ни одного отсчёта.
    // При одном отсчёте на пиксель она *больше*, чем у регулярной картинки (E11): сравнение на слайдах — о структуре, а не
    // об ошибке. При 16 отсчётах джиттер выигрывает в обоих смыслах.
    // %%
    let board = Checkerboard::lecture(128)?;
    let rows = Grid::cells(0.0..128.0, 128, 1.0..128.0, 127)?; // all but the one that touches the horizon
    let exact = Image::averaged(&board, rows);
    for n in [1, 2, 4] {
        let cells = Image::averaged(&board, Grid::cells(0.0..128.0, 128 * n, 1.0..128.0, 127 * n)?);
        let samples = (n * n) as f64;
        let (mut expected, mut variance) = (0.0, 0.0);
        for (x, y) in (0..127).flat_map(|y| (0..128).map(move |x| (x, y))) {
            let places = (0..n * n).map(|k| cells.at(x * n + k % n, y * n + k / n));
            let square = places.map(|p| p * (1.0 - p)).sum::<f64>() / (samples * samples);
            expected += square;
            // the fourth moment of a sum of independent errors: 3σ⁴ and their fourth cumulants, each at most p(1 − p)
            variance += 2.0 * square * square + square / (samples * samples);
        }
        let pixels = rows.len() as f64;
        let regular = supersample(&board, rows, &Regular::<2>::new([n, n])?, &BoxKernel, 1)?.rmse(&exact)?;
        let jittered = supersample(&board, rows, &Jittered::<2>::new([n, n])?, &BoxKernel, 1)?.rmse(&exact)?;
        let line = text!(
            "{n} × {n}: regular {regular:.4}, jittered {jittered:.4}, expected {:.4}",
            "{n} × {n}: регулярно {regular:.4}, с джиттером {jittered:.4}, ожидается {:.4}",
            (expected / pixels).sqrt()
        );
        println!("{}", line.get(lang));
        let bound = deviations(3) * variance.sqrt() / pixels;
        let name = format!("{n} × {n}: MSE = ⟨Σp(1 − p)⟩/n⁴");
        prove([Residual::near(name, jittered * jittered, expected / pixels, bound)])?;
    }

    // %%
    show(lang, "f40-jittered", &[])?;

    // %%
    show(lang, "f51-one-ray", &[])?;

    // %% en
    // **Exercise.** In which pixels is the error of one jittered sample the largest, and how large can it be? What would the
    // reference picture with 256 samples a pixel have to reckon with there?
    // %% ru
    // **Упражнение.** В каких пикселях ошибка одного отсчёта с джиттером наибольшая и какой она может быть? На что там
    // следует рассчитывать эталону с 256 отсчётами на пиксель?

    // %% en
    // ## 5. Adaptive sampling, and where one can do without
    //
    // More samples where neighbours differ: halve the interval, again and again. An edge is known to within $\delta$ after
    // $\log_2(T/\delta)$ samples more, where regular ones would have to stand $T/\delta$ times as dense. In a picture: an edge
    // of a disc, and as many jittered samples spread evenly. The catch is the second half: what lies *between* equal samples
    // gives no reason to look closer.
    // %% ru
    // ## 5. Адаптивное сэмплирование и где без него можно обойтись
    //
    // Больше отсчётов там, где соседние различаются: делим отрезок пополам снова и снова. Чтобы узнать место границы с
    // точностью $\delta$, нужно ещё $\log_2(T/\delta)$ отсчётов, а равномерные пришлось бы ставить в $T/\delta$ раз чаще. На
    // картинке — край круга и столько же отсчётов с джиттером, распределённых поровну. Подвох во второй половине: то, что
    // лежит *между* одинаковыми отсчётами, не даёт повода присмотреться.
    // %%
    let (mut low, mut high, mut more) = (0.0, 1.0 / 16.0, 0);
    let edge = 0.0437;
    while high - low > 1.0 / 1024.0 {
        let middle = 0.5 * (low + high);
        (low, high) = if middle < edge { (middle, high) } else { (low, middle) };
        more += 1;
    }
    prove([Residual::near("log₂(T/δ) = 6", f64::from(more), 6.0, 0.0)])?;

    let (disc, frame) = (Disc::new([8.0, 8.0], 5.3)?, Grid::pixels(16, 16)?);
    let truth = Image::averaged(&disc, frame);
    let found = adaptive(&disc, frame, Budget { contrast: 0.02, per_pixel: 64.0 }, 1)?;
    let evenly = Jittered::<2>::nearest(found.taken / frame.len())?;
    let even = supersample(&disc, frame, &evenly, &BoxKernel, 1)?.rmse(&truth)?;
    let line = text!(
        "{} samples: adaptive {:.5}, evenly {even:.5}",
        "отсчётов {}: адаптивно {:.5}, поровну {even:.5}",
        found.taken,
        found.image.rmse(&truth)?
    );
    println!("{}", line.get(lang));
    let speck = Disc::new([8.3, 8.6], 0.05)?;
    let missed = adaptive(&speck, frame, Budget { contrast: 0.02, per_pixel: 64.0 }, 1)?;
    prove([
        Residual::at_most("RMSE: adaptive ≤ evenly/4", found.image.rmse(&truth)?, 0.25 * even),
        Residual::near("a speck between the samples: Σ = 0", missed.image.values().iter().sum(), 0.0, 0.0),
    ])?;

    // %%
    show(lang, "f41-adaptive", &[("halvings", "8")])?;

    // %% en
    // For image synthesis the lecture draws the conclusion that prefiltering is impossible and only samples remain. In
    // general, yes: of an arbitrary $L(x, y)$ nothing is known but its values. But polygons have an exact area, textures a
    // table of means, formulas a known frequency (E14).
    // %% ru
    // Для синтеза изображений лекция делает вывод: префильтрация невозможна, остаются отсчёты. В общем случае да: о
    // произвольной $L(x, y)$ не известно ничего, кроме значений в точках. Но у многоугольников есть точная площадь, у
    // текстур — таблица средних, у формул — известная частота (E14).
    // %%
    show(lang, "f42-application", &[])?;

    // %% en
    // **Exercise.** How many samples does it take to find the speck with a probability of 95 %, if they are jittered and the
    // speck covers $\pi r^2 = 0.0079$ of its pixel?
    // %% ru
    // **Упражнение.** Сколько нужно отсчётов с джиттером, чтобы найти соринку с вероятностью 95 %, если она занимает
    // $\pi r^2 = 0{,}0079$ своего пикселя?

    // %% en
    // ## 6. Stratification: why it never hurts
    //
    // **Theorem.** Cut the domain into $N$ equal strata with one point each. Then
    // $$\mathrm{Var}_{\text{strat}} = \mathrm{Var}_{\text{random}} - \tfrac1N\,\mathrm{Var}(\text{means of the strata})
    // \le \mathrm{Var}_{\text{random}}.$$
    // How much it helps depends on the function: smooth ones give $N^{-1-2/d}$ instead of $N^{-1}$, edges $N^{-1-1/d}$. For an
    // edge along an axis of the square even the constants are known, $\frac1{6N}$ and $\frac1{6N^{3/2}}$, and $\frac1{6N^2}$
    // for patterns that stratify rows and columns as well.
    // %% ru
    // ## 6. Стратификация: почему она не вредит
    //
    // **Теорема.** Разобьём область на $N$ равных страт и возьмём по точке в каждой. Тогда
    // $$\mathrm{Var}_{\text{strat}} = \mathrm{Var}_{\text{random}} - \tfrac1N\,\mathrm{Var}(\text{средние по стратам})
    // \le \mathrm{Var}_{\text{random}}.$$
    // Насколько это помогает, зависит от функции: для гладких $N^{-1-2/d}$ вместо $N^{-1}$, для краёв $N^{-1-1/d}$. Для края
    // вдоль оси квадрата известны даже константы: $\frac1{6N}$, $\frac1{6N^{3/2}}$ и $\frac1{6N^2}$ — последняя у узоров,
    // которые стратифицируют ещё и строки со столбцами.
    // %%
    let trials = 2000;
    fn named(name: &'static str, n: f64, found: Residual) -> Residual {
        Residual { law: format!("N = {n}: {name}").into(), ..found }
    }
    for side in [4usize, 8, 16] {
        let n = (side * side) as f64;
        let random = errors(&Random::new(side * side)?, 1, trials, axis_edge::<2>)?;
        let jittered = errors(&Jittered::new([side, side])?, 1, trials, axis_edge::<2>)?;
        let multi = errors(&MultiJittered::new([side, side])?, 1, trials, axis_edge::<2>)?;
        prove([
            named("MSE(random) = 1/(6N)", n, mean_square(random, 1.0 / (6.0 * n), 0.0)),
            named("MSE(jitter) = 1/(6N^{3/2})", n, mean_square(jittered, n.powf(-1.5) / 6.0, 0.0)),
            named("MSE(multi-jitter) = 1/(6N²)", n, mean_square(multi, n.powi(-2) / 6.0, 0.0)),
        ])?;
    }
    // and the picture on the slide: how many cells stay empty
    let cells = Cells::new([16, 16])?;
    for pattern in
        [&Random::new(256)? as &dyn Pattern<2>, &Regular::<2>::new([16, 16])?, &Jittered::<2>::new([16, 16])?]
    {
        let empty = occupancy(&pattern.points(1), cells)?.into_iter().filter(|points| *points == 0).count();
        println!("{}: {empty}/256", pattern.name());
    }
    law(lang, "stratification")?;

    // %%
    show(lang, "f49-stratified", &[("seed", "3")])?;

    // %%
    show(lang, "x-convergence", &[])?;

    // %% en
    // **Exercise.** 256 independent points leave about $256/e$ cells empty. How many cells have two points or more? Check
    // your answer with `occupancy`.
    // %% ru
    // **Упражнение.** 256 независимых точек оставляют пустыми примерно $256/e$ ячеек. А в скольких ячейках две точки или
    // больше? Проверьте ответ с помощью `occupancy`.

    // %% en
    // ## 7. Low discrepancy: evenness without chance
    //
    // The star discrepancy $D^*$ of points is how wrong they can be about the area of a box at the origin. It bounds the error
    // of every mean (Koksma and Hlawka),
    // $$\Bigl|\frac1N\sum f(x_i) - \int f\Bigr| \le D^* \cdot V(f),$$
    // and there are sequences with $D^* = O((\log N)^d/N)$, where random points have $N^{-1/2}$. They are made of a child's
    // game, the *radical inverse*: write $i$ in the base $b$ and mirror the digits at the point.
    // %% ru
    // ## 7. Низкое расхождение: равномерность без случая
    //
    // Звёздное расхождение $D^*$ — это наибольшая ошибка, с которой точки определяют площадь ящика с углом в начале координат.
    // Оно ограничивает ошибку любого среднего (Коксма, Главка):
    // $$\Bigl|\frac1N\sum f(x_i) - \int f\Bigr| \le D^* \cdot V(f),$$
    // и есть последовательности с $D^* = O((\log N)^d/N)$, тогда как у случайных точек $N^{-1/2}$. Делаются они детской игрой —
    // *обращением разрядов*: запишем $i$ в системе с основанием $b$ и отразим цифры относительно точки.
    // %%
    fn mirrored(mut i: u32, base: u32) -> f64 {
        let (mut value, mut place) = (0.0, 1.0);
        while i > 0 {
            place /= f64::from(base);
            value += f64::from(i % base) * place;
            i /= base;
        }
        value
    }
    println!("11 = 1011₂ → 0.1101₂ = {}", mirrored(11, 2));
    fn worst(base: u32) -> Result<f64> {
        let off = |i| Ok((mirrored(i, base) - radical_inverse(base, i)?.value()).abs());
        (0..1000).map(off).try_fold(0.0, |most: f64, off: Result<f64>| Ok(most.max(off?)))
    }
    prove([
        Residual::at_most("Φ₂(i), i < 1000", worst(2)?, 0.0),
        // seven digits in base 3, each place rounded as often as it was divided
        Residual::at_most("Φ₃(i), i < 1000", worst(3)?, 7.0 * f64::EPSILON),
    ])?;

    // %%
    let patterns: [Box<dyn Pattern<2>>; 5] = [
        Box::new(Random::new(256)?),
        Box::new(Jittered::<2>::new([16, 16])?),
        Box::new(Halton::new(256)?),
        Box::new(Hammersley::new(256)?),
        Box::new(Sobol::new(256)?.scrambled(Scrambling::Owen)),
    ];
    for pattern in &patterns {
        println!("{}: D* = {:.4}", pattern.name(), star_discrepancy(&pattern.points(1))?);
    }
    let line: Vec<f64> = Pattern::<1>::points(&Halton::new(256)?, 1).into_iter().map(|[x]| x).collect();
    let e = std::f64::consts::E;
    prove([
        grid_discrepancy(&Regular::new([16, 16])?.points(0), 16)?,
        hammersley_discrepancy(&Hammersley::new(256)?.points(0))?,
        elementary_intervals(&Sobol::new(256)?.points(0))?,
        koksma_hlawka(&from_fn(f64::exp), e - 1.0, e - 1.0, &line)?,
    ])?;

    // %%
    show(lang, "x-elementary", &[])?;

    // %%
    show(lang, "f54-measures", &[])?;

    // %% en
    // Even is not the same as *apart*: Poisson disks keep their distance and look best, but their noise does not vanish at low
    // frequencies, and in the end they gain only a constant factor on random points. And what is even without chance has
    // spikes again. Owen's scrambling takes them away and keeps every point in its box.
    //
    // **Exercise.** The sixteen points of the figure lie one in each box of five divisions. Find the sixth division of the
    // square into 16 equal boxes, other than those, of which it is *not* true.
    // %% ru
    // Равномерно — ещё не значит *врозь*: диски Пуассона держат расстояние и выглядят лучше всех, но их шум на низких частотах
    // не исчезает, и в конце концов они выигрывают у случайных точек лишь постоянный множитель. А у того, что равномерно без
    // случая, снова есть пики. Перемешивание Оуэна убирает их и оставляет каждую точку в её ящике.
    //
    // **Упражнение.** Шестнадцать точек на рисунке лежат по одной в каждом ящике пяти разбиений. Найдите ещё одно разбиение
    // квадрата на 16 равных частей, для которого это уже *неверно*.

    Ok(())
}
