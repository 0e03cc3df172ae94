//! Comb and replication: sampling copies the spectrum.
#![allow(clippy::print_stdout, reason = "a notebook prints")]

use nyquist::course::{law, prove, show};
use nyquist::laws::poisson::{comb_pairing, copies_by_fft, poisson_summation, raised_cosine_tail, sum_rounding};
use nyquist::prelude::*;
use nyquist::signal::lecture::SPIKES;

fn main() -> Result<()> {
    // %% en
    // # 4. Comb and replication
    //
    // Sampling is a product with the Dirac comb. By the theorems of notebook 3 its spectrum is then a convolution with the
    // comb's transform, and that is all it takes to see what sampling does: it copies the spectrum.
    // %% ru
    // # 4. Гребень Дирака и размножение спектра
    //
    // Дискретизация — это умножение на гребень Дирака. По теоремам тетради 3 спектр при этом сворачивается с преобразованием
    // гребня, и этого достаточно, чтобы увидеть, что делает дискретизация: она размножает спектр.
    // %%
    let lang = Lang::En;

    // %% en
    // ## Samples are weights
    //
    // $$Ш_T(x) = T\sum_i \delta(x - iT), \qquad Ш_T(x)\,f(x) = T\sum_i f(iT)\,\delta(x - iT).$$
    // An impulse has no height, only a place and a weight, the area under it: $T$ for the comb, $T f(iT)$ for the product.
    // With the factor $T$ in front the comb has the mean value 1, whatever its step.
    // %% ru
    // ## Отсчёты — это веса
    //
    // $$Ш_T(x) = T\sum_i \delta(x - iT), \qquad Ш_T(x)\,f(x) = T\sum_i f(iT)\,\delta(x - iT).$$
    // У импульса нет высоты, только место и вес — площадь под ним: $T$ у гребня, $T f(iT)$ у произведения. Благодаря
    // множителю $T$ среднее значение гребня равно 1 при любом шаге.
    // %%
    let curve = Spline::natural(Axis::new(0.0, 1.0, 9)?, &SPIKES)?; // through the spikes of the lecture's figure
    for step in [1.0, 0.5] {
        let weights = Comb::new(step)?.times(&curve, 2..=5);
        let shown: Vec<String> = weights.iter().map(|w| format!("w({}) = {:.4}", w.at, w.weight.re)).collect();
        println!("T = {step}: {}", shown.join(", "));
        let errors = weights.iter().map(|w| (w.weight.re - step * curve.at(w.at)).abs());
        prove([Residual::at_most("w = T·f(iT)", errors.fold(0.0, f64::max), 0.0)])?;
    }

    // %%
    show(lang, "f14-comb", &[("T", "1")])?;

    // %% en
    // **Exercise.** What happens to the weights when the step is halved, and what to their sum?
    // %% ru
    // **Упражнение.** Что станет с весами, если шаг уменьшить вдвое, а что — с их суммой?

    // %% en
    // ## What the weights add up to
    //
    // **Theorem.** $T\sum_i f(iT) = \sum_k F(k/T)$. The left side is the trapezoid rule for $\int f$; the right side begins
    // with $F(0) = \int f$. So the rule is *exact* as soon as $F(k/T) = 0$ for all $k \ne 0$: for a band-limited signal, as
    // soon as $1/T > B$. That is half the rate that restoring the signal takes: to know a mean is easier than to know a
    // function.
    //
    // RC(1) has $F(0) = 1$ and ends at $B = 1$. At $T = 1.5$ the lines $k = \pm1$ fall into its band:
    // $1 + 2\cos^2\tfrac\pi3 = 1.5$.
    // %% ru
    // ## Чему равна сумма весов
    //
    // **Теорема.** $T\sum_i f(iT) = \sum_k F(k/T)$. Слева — формула трапеций для $\int f$, справа первое слагаемое
    // $F(0) = \int f$. Поэтому формула *точна*, как только $F(k/T) = 0$ при всех $k \ne 0$, а для сигнала с ограниченной
    // полосой — как только $1/T > B$. Это вдвое меньше, чем нужно для восстановления сигнала: узнать среднее проще, чем
    // узнать функцию.
    //
    // У RC(1) $F(0) = 1$, и спектр кончается на $B = 1$. При $T = 1{,}5$ в полосу попадают линии $k = \pm1$:
    // $1 + 2\cos^2\tfrac\pi3 = 1{,}5$.
    // %%
    let rc = RaisedCosine::new(1.0)?;
    for step in [0.3, 0.6, 0.9, 1.1, 1.5] {
        let sum: f64 = Comb::new(step)?.times(&rc, -4000..=4000).iter().map(|w| w.weight.re).sum();
        let lines: f64 = (-2..=2).map(|k| rc.spectrum().density(f64::from(k) / step).re).sum();
        println!("1/T = {:.2}: T·Σf = {sum:.6}, ΣF(k/T) = {lines:.6}", 1.0 / step);
        let bound = raised_cosine_tail(1.0, step, 4000) + sum_rounding(8001, 2.0);
        prove([Residual::near("T·Σf = ΣF(k/T)", sum, lines, bound)])?;
    }
    law(lang, "trapezoid-exact")?;

    // %%
    show(lang, "f14-weights", &[("T", "1.5")])?;

    // %% en
    // **Exercise.** The mean of $\cos^2 x$ over its period is to be computed from $n$ equally spaced values. Which is the
    // smallest $n$ that is exact? Which $n$ is exact for $\cos^{10} x$?
    // %% ru
    // **Упражнение.** Среднее $\cos^2 x$ за период вычисляют по $n$ равноотстоящим значениям. При каком наименьшем $n$ ответ
    // точен? А для $\cos^{10} x$?

    // %% en
    // ## The comb's transform is a comb
    //
    // **Theorem.** $Ш_T = T\sum_i \delta(x - iT) \;\leftrightarrow\; \sum_k \delta(\nu - k/T)$: lines one rate apart, each of
    // weight 1. The printed table gives them the weight $1/T$ (E02). A quick test: the mean of $Ш_T$ is 1, so its line at
    // zero must weigh 1.
    //
    // A thorough test is the pairing with a test function $\varphi$: $T\sum_i\varphi(iT)$ must equal
    // $w\sum_k\hat\varphi(k/T)$. With $w = 1$ it does, for every step; with $w = 1/T$ only for $T = 1$.
    // %% ru
    // ## Преобразование гребня — гребень
    //
    // **Теорема.** $Ш_T = T\sum_i \delta(x - iT) \;\leftrightarrow\; \sum_k \delta(\nu - k/T)$: линии через $1/T$, каждая веса
    // 1. В печатной таблице у них вес $1/T$ (E02). Быстрая проверка: среднее $Ш_T$ равно 1, значит, линия в нуле весит 1.
    //
    // Строгая проверка — спаривание с пробной функцией $\varphi$: $T\sum_i\varphi(iT)$ должно равняться
    // $w\sum_k\hat\varphi(k/T)$. При $w = 1$ это так для любого шага, при $w = 1/T$ — только для $T = 1$.
    // %%
    let phi = Gaussian::new(0.6)?;
    for step in [0.5, 1.0, 1.7, 2.5] {
        let comb = Comb::new(step)?;
        let left: f64 = comb.times(&phi, -60..=60).iter().map(|w| w.weight.re).sum();
        let right: f64 = (-60..=60).map(|k| phi.spectrum().density(comb.line(k).at).re).sum();
        println!("T = {step}: {left:.5} = {right:.5}; w = 1/T: {:.5}", right / step);
        prove([comb_pairing(&phi, step, 60, 1.0)?])?;
    }
    {
        // the printed weight, and that it fails: a law that cannot be broken proves nothing
        let broken = comb_pairing(&phi, 0.5, 60, 1.0 / 0.5)?;
        println!("✗ T = 0.5, w = 1/T: {:.5} > {:.0e}", broken.measured, broken.bound);
        assert!(!broken.holds());
    }
    law(lang, "comb-pairing")?;

    // %%
    show(lang, "f18-ingredients", &[("T", "0.8"), ("B", "0.35")])?;

    // %% en
    // **Exercise.** Where are the lines of a comb that is moved by half a step, and what has become of their weights? Compare
    // with `Comb::new(1.0)?.shifted(0.5)?.line(1)`.
    // %% ru
    // **Упражнение.** Где линии гребня, сдвинутого на полшага, и что стало с их весами? Сравните с
    // `Comb::new(1.0)?.shifted(0.5)?.line(1)`.

    // %% en
    // ## Sampling copies the spectrum
    //
    // **Theorem** (Poisson). The product with the comb is a convolution with its lines, and convolution with
    // $\delta(\nu - k/T)$ moves a spectrum to $k/T$ (E19):
    // $$T\sum_j f(jT)\,e^{-i2\pi\nu jT} = \sum_k F(\nu - k/T).$$
    // On the left stand only samples, on the right only copies of the true spectrum, of gain 1. What is multiplied by the
    // comb is the signal, *in space*; the slide's “product of the signal with the comb of the spectrum” mixes the two (E10).
    // %% ru
    // ## Дискретизация размножает спектр
    //
    // **Теорема** (Пуассон). Произведение с гребнем — это свёртка с его линиями, а свёртка с $\delta(\nu - k/T)$ переносит
    // спектр в $k/T$ (E19):
    // $$T\sum_j f(jT)\,e^{-i2\pi\nu jT} = \sum_k F(\nu - k/T).$$
    // Слева — только отсчёты, справа — только копии настоящего спектра с усилением 1. Умножается сигнал на гребень, и
    // происходит это *в пространстве*; «произведение сигнала на гребенку спектра» на слайде смешивает одно с другим (E10).
    // %%
    let g50 = Gaussian::with_spectrum(50.0)?; // the lecture's: F = e^{−50ν²}, copies one apart
    let samples = Samples::of(&g50, Axis::centered(1.0, 41)?);
    for nu in [0.0, 0.1, 0.9, 1.0, 2.1] {
        let (of_samples, of_signal) = (dtft(&samples, nu).re, g50.spectrum().density(nu).re);
        let copies = g50.spectrum().replicated(1.0, 4)?.density(nu).re;
        println!("ν = {nu:.1}: T·Σfe = {of_samples:.6}, ΣF(ν − k/T) = {copies:.6}, F = {of_signal:.6}");
    }
    prove([
        poisson_summation(&g50, 1.0, 20, 4, &[0.0, 0.1, 0.5, 0.9, 2.1], 0.0)?,
        copies_by_fft(&g50, Axis::centered(1.0, 512)?, 4, 0.0)?,
    ])?;
    law(lang, "poisson-summation")?;

    // %%
    show(lang, "f19-replicas", &[("T", "1")])?;

    // %% en
    // So a spectrum computed from samples is periodic, and an FFT shows one period of it. Whatever it shows beyond the
    // Nyquist frequency is a copy.
    //
    // **Exercise.** Draw the figure for `("T", "2")`. What is the height at $\nu = \tfrac14$, where two copies meet?
    // %% ru
    // Значит, спектр, вычисленный по отсчётам, периодичен, и БПФ показывает один его период. Всё, что оно показывает за
    // частотой Найквиста, — копия.
    //
    // **Упражнение.** Постройте рисунок для `("T", "2")`. Какова высота в точке $\nu = \tfrac14$, где встречаются две копии?

    // %% en
    // ## Where the comb stands
    //
    // **Theorem.** Samples at $x_0 + jT$ have the same copies, each turned by its own phase:
    // $$T\sum_j f(x_0 + jT)\,e^{-i2\pi\nu(x_0 + jT)} = \sum_k e^{-i2\pi k x_0/T}\,F(\nu - k/T).$$
    // Where copies do not overlap, nothing of this is seen. Where they do, the sum depends on where the comb stands: pixels
    // are sampled at their middles, $x_0 = T/2$, and every odd copy comes back with its sign turned over.
    // %% ru
    // ## Где стоит гребень
    //
    // **Теорема.** У отсчётов в точках $x_0 + jT$ те же копии, но каждая повёрнута на свою фазу:
    // $$T\sum_j f(x_0 + jT)\,e^{-i2\pi\nu(x_0 + jT)} = \sum_k e^{-i2\pi k x_0/T}\,F(\nu - k/T).$$
    // Там, где копии не перекрываются, этого не видно. Там, где перекрываются, сумма зависит от положения гребня: отсчёты
    // пикселей берутся в их серединах, $x_0 = T/2$, и каждая нечётная копия возвращается с обратным знаком.
    // %%
    let g8 = Gaussian::with_spectrum(8.0)?; // copies one apart overlap
    for offset in [0.0, 0.25, 0.5] {
        let comb = Comb::new(1.0)?.shifted(offset)?;
        let seen = dtft(&Samples::of(&g8, comb.axis(-20..=20)?), 0.5);
        let copies = g8.spectrum().convolved(&comb.spectrum(4))?.density(0.5);
        println!("x₀ = {offset}: |F(½)| = {:.5}", seen.norm());
        prove([Residual::at_most("F ⊗ Ш", (seen - copies).norm(), sum_rounding(41, 2.0))])?;
    }

    // %% en
    // **Exercise.** At $x_0 = \tfrac12$ nothing is left at the Nyquist frequency. Which tone is it whose samples vanish
    // there, and why?
    // %% ru
    // **Упражнение.** При $x_0 = \tfrac12$ на частоте Найквиста не остаётся ничего. Отсчёты какого тона там равны нулю и
    // почему?

    // %% en
    // ## The larger the step, the closer the copies
    //
    // Copies stand $1/T$ apart and each is $2B$ wide. They keep clear of each other exactly as long as $1/T > 2B$; from
    // $1/T < 2B$ on they overlap on $1/T - B < |\nu| < B$. `Verdict` says so of any spectrum and any rate. (The slide after
    // next says they overlap when “$T$ is not large enough”: it is the other way round, E07.)
    // %% ru
    // ## Чем больше шаг, тем ближе копии
    //
    // Копии отстоят друг от друга на $1/T$, ширина каждой $2B$. Они не касаются друг друга ровно до тех пор, пока
    // $1/T > 2B$; при $1/T < 2B$ они перекрываются на $1/T - B < |\nu| < B$. `Verdict` говорит это о любом спектре и любой
    // частоте. (Через слайд сказано, что они накладываются, «если $T$ недостаточно большой»: должно быть наоборот, E07.)
    // %%
    for rate in [4.0, 2.5, 2.0, 1.25] {
        println!("1/T = {rate}: {:?}", Verdict::on(&rc.spectrum(), rate)?);
        // asked of the copies: is the spectrum still the signal's everywhere inside its band?
        let copies = rc.spectrum().replicated(rate, 2)?;
        let inside = (0..=100).map(|i| f64::from(i) / 100.0);
        let worst = inside.map(|nu| (copies.density(nu) - rc.spectrum().density(nu)).norm()).fold(0.0, f64::max);
        // at the very edge of the band RC is zero to the rounding of π/2
        let clear = worst <= f64::EPSILON;
        println!("          max|ΣF(ν − k/T) − F| = {worst:.3}");
        assert_eq!(clear, Verdict::on(&rc.spectrum(), rate)?.recoverable());
    }

    // %%
    show(lang, "f20-closer", &[("B", "0.4")])?;

    // %% en
    // **Exercise.** A signal has its band between 21 and 24. Must the rate be above 48, or is there a slower one at which its
    // copies miss each other? Draw them on paper; notebook 6 has the answer.
    // %% ru
    // **Упражнение.** Полоса сигнала лежит между 21 и 24. Обязательно ли частота дискретизации должна быть больше 48, или есть
    // меньшая, при которой копии не задевают друг друга? Нарисуйте их на бумаге; ответ — в тетради 6.

    Ok(())
}
