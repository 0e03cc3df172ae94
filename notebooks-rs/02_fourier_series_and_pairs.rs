//! Fourier series and pairs: a function seen as the sum of its frequencies.
#![allow(clippy::print_stdout, reason = "a notebook prints")]

use nyquist::course::{display, law, prove, show};
use nyquist::figure::{Figure, Layer, Meaning, Panel, Scale};
use nyquist::laws::gibbs::wilbraham_gibbs;
use nyquist::laws::poisson::sum_rounding;
use nyquist::laws::theorems::pair_by_quadrature;
use nyquist::num::extremum::maximum;
use nyquist::num::quadrature::{even_breaks, integrate_pieces};
use nyquist::num::special::si;
use nyquist::num::{cos_pi, sin_pi};
use nyquist::prelude::*;
use nyquist::text;
use std::f64::consts::PI;

fn main() -> Result<()> {
    // %% en
    // # 2. Fourier series and pairs
    //
    // To say how much is lost by sampling we need the other description of a function: how much of every frequency it
    // holds. This notebook builds it, from sums of waves to the table of pairs that everything later rests on.
    // %% ru
    // # 2. Ряды Фурье и пары преобразований
    //
    // Чтобы оценить, сколько теряется при дискретизации, нужно второе описание функции: сколько в ней каждой частоты. В этой
    // тетради мы его построим — от сумм волн до таблицы пар, на которой держится всё дальнейшее.
    // %%
    let lang = Lang::En;

    // %% en
    // ## Slow and fast functions
    //
    // The lecture begins with two functions and their spectra,
    // $$F_{\text{low}}(\nu) = 16\nu^2 - 64\nu^4\ \ (|\nu| \le \tfrac12), \qquad
    // F_{\text{high}}(\nu) = 1 - \tfrac{\nu^8}{16}\ \ (|\nu| \le \sqrt2).$$
    // The further out a spectrum reaches, the faster the function may vary. Both end: they are *band-limited*, with
    // $B = \tfrac12$ and $B = \sqrt2$.
    //
    // From samples alone the spectrum comes back by `forward`, the discrete transform; what is missing is what the record
    // leaves out. The slow function falls like $\tfrac{32}{(2\pi x)^2}$, so a record of $\pm X$ leaves out at most about
    // $\tfrac{16}{\pi^2X}$ of any value of its spectrum.
    // %% ru
    // ## Медленные и быстрые функции
    //
    // Лекция начинает с двух функций и их спектров,
    // $$F_{\text{low}}(\nu) = 16\nu^2 - 64\nu^4\ \ (|\nu| \le \tfrac12), \qquad
    // F_{\text{high}}(\nu) = 1 - \tfrac{\nu^8}{16}\ \ (|\nu| \le \sqrt2).$$
    // Чем дальше тянется спектр, тем быстрее может меняться функция. Оба спектра кончаются: это функции *с ограниченной
    // полосой*, $B = \tfrac12$ и $B = \sqrt2$.
    //
    // По одним отсчётам спектр восстанавливает `forward`, дискретное преобразование; не хватает лишь того, что не попало в
    // запись. Медленная функция убывает как $\tfrac{32}{(2\pi x)^2}$, поэтому запись $\pm X$ теряет в любом значении
    // спектра не больше примерно $\tfrac{16}{\pi^2X}$.
    // %%
    let (low, high) = (LowBump.spectrum(), HighBump.spectrum());
    println!("B = {:.4}, {:.4}", low.band(), high.band());
    {
        let peak = maximum(|nu| low.density(nu).re, 0.0, 0.5, 16);
        println!("max F: ν = {:.4}", peak.at);
        let record = Samples::of(&LowBump, Axis::centered(0.5, 1601)?); // ±400
        let bins = forward(&record);
        let errors = bins.axis().iter().zip(bins.values()).map(|(nu, v)| (v - low.density(nu)).norm());
        // 32/(2πx)² and the next term, 320/(2πx)³, which is below a fiftieth of it here
        let left_out = 1.02 * 16.0 / (PI * PI * 400.0);
        prove([Residual::at_most("|forward(f) − F|", errors.fold(0.0, f64::max), left_out)])?;
    }

    // %%
    show(lang, "f09-functions", &[("c", "1")])?;

    // %%
    show(lang, "f10-spectra", &[("X", "100")])?;

    // %% en
    // (In the book the slide was taken from, the right-hand curve is not the transform of the spectrum that is printed for
    // it, E31. Here both are true pairs.)
    //
    // **Exercise.** Stretch the functions with `("c", "2")` in the first figure. Predict what happens to both bands.
    // %% ru
    // (В книге, откуда взят слайд, правая кривая не является преобразованием напечатанного рядом спектра, E31. Здесь обе
    // пары настоящие.)
    //
    // **Упражнение.** Растяните функции: `("c", "2")` на первом рисунке. Предскажите, что станет с обеими полосами.

    // %% en
    // ## A square wave, harmonic by harmonic
    //
    // **Theorem** (Fourier). The square wave of period 1 is the sum of its odd harmonics,
    // $$q(x) = \frac4\pi\sum_{k=1}^\infty \frac{\sin 2\pi(2k-1)x}{2k-1}.$$
    // The amplitudes belong to it: the slide's labels $f + 3f + 5f + \dots$ leave them out, and with equal amplitudes the
    // sum is a train of spikes (E16). What is still missing after $N$ terms is, in the mean square, the power of all the
    // harmonics left out (Parseval): $\int_0^1 (q - S_N)^2\,dx = 1 - \tfrac12\sum_{k\le N} a_k^2$.
    // %% ru
    // ## Прямоугольная волна из гармоник
    //
    // **Теорема** (Фурье). Прямоугольная волна с периодом 1 есть сумма своих нечётных гармоник,
    // $$q(x) = \frac4\pi\sum_{k=1}^\infty \frac{\sin 2\pi(2k-1)x}{2k-1}.$$
    // Амплитуды здесь обязательны: в подписях слайда $f + 3f + 5f + \dots$ они пропущены, а с равными амплитудами
    // получается череда всплесков (E16). Чего не хватает после $N$ членов, в среднем квадратичном равно мощности всех
    // отброшенных гармоник (Парсеваль): $\int_0^1 (q - S_N)^2\,dx = 1 - \tfrac12\sum_{k\le N} a_k^2$.
    // %%
    for n in [1, 2, 3, 8] {
        let sum = PartialSum::new(Wave::Square, n, 1.0)?;
        let missing = integrate_pieces(|x| (1.0 - sum.at(x)).powi(2), &even_breaks(0.0, 0.5, 0.01), 1e-14);
        let power: f64 = (1..=n).map(|k| 0.5 * Wave::Square.term(k).1.powi(2)).sum();
        let peak = maximum(|x| sum.at(x), 0.0, 0.5 / f64::from(n), 16).value;
        println!("N = {n}: max S = {peak:.6}, ∫(q − S)² = {:.5}", 2.0 * missing.value);
        let bound = 2.0 * missing.error + sum_rounding(n as usize, 1.0);
        prove([Residual::near("∫(q − S)² = 1 − ½Σa²", 2.0 * missing.value, 1.0 - power, bound)])?;
    }
    {
        let literal = |x: f64| (1..=8).map(|k| sin_pi(2.0 * f64::from(2 * k - 1) * x)).sum::<f64>();
        println!("Σsin 2π(2k − 1)x, N = 8: max = {:.3}", maximum(literal, 0.0, 0.1, 32).value);
    }

    // %%
    show(lang, "f11-series", &[("N", "8")])?;

    // %%
    show(lang, "f11-unweighted", &[("N", "8")])?;

    // %% en
    // **Exercise.** `Wave::Triangle` has amplitudes like $1/(2k-1)^2$. How many terms does it need for the mean square error
    // that the square wave has after 8? Guess, then replace the wave in the cell (and the value `1.0 - …` by the triangle's).
    // %% ru
    // **Упражнение.** У `Wave::Triangle` амплитуды порядка $1/(2k-1)^2$. Сколько членов ей нужно для той же
    // среднеквадратичной ошибки, что у прямоугольной волны после 8? Угадайте, потом замените волну в ячейке (и значение
    // `1.0 - …` на значение треугольной волны).

    // %% en
    // ## The overshoot that does not shrink
    //
    // **Theorem** (Wilbraham 1848, Gibbs 1899). The partial sums of a wave with a jump overshoot it by 8.949 % of the jump,
    // however many terms there are: near the jump $S_N(u/N) \to \tfrac2\pi\mathrm{Si}(4\pi u)$, whose greatest value is
    // $\tfrac2\pi\mathrm{Si}(\pi) = 1.178980$. The error gets *narrower*, not lower, which is why its mean square still
    // tends to zero.
    // %% ru
    // ## Выброс, который не уменьшается
    //
    // **Теорема** (Уилбрэм, 1848; Гиббс, 1899). Частичные суммы волны со скачком превышают её на 8,949 % скачка при любом
    // числе членов: вблизи скачка $S_N(u/N) \to \tfrac2\pi\mathrm{Si}(4\pi u)$, и наибольшее значение этой функции равно
    // $\tfrac2\pi\mathrm{Si}(\pi) = 1{,}178980$. Ошибка становится *уже*, а не ниже, поэтому её средний квадрат всё же
    // стремится к нулю.
    // %%
    println!("2/π·Si(π) = {:.6}", wilbraham_gibbs());
    law(lang, "gibbs")?;

    // %% en
    // The three sums below are drawn over $u = Nx$, each in its own scale of $x$. With growing $N$ they settle on one curve,
    // and its peak keeps its height.
    // %% ru
    // Три суммы ниже нарисованы в зависимости от $u = Nx$, каждая в своём масштабе по $x$. С ростом $N$ они ложатся на одну
    // кривую, и высота её пика не меняется.
    // %%
    {
        let limit = |u: f64| 2.0 / PI * si(4.0 * PI * u);
        let (x, y) = (Scale::linear(text!("u = Nx", "u = Nx"), 0.0, 1.0), Scale::linear(Text::same("S_{N}"), 0.0, 1.3));
        let mut panel = Panel::new("jump", Text::EMPTY, x, y).with(
            Layer::curve("limit", Meaning::Theory, 0.0, 1.0, 200, limit)
                .dashed()
                .label(text!("2/π·Si(4πu)", "2/π·Si(4πu)")),
        );
        for (i, n) in [3, 8, 64].into_iter().enumerate() {
            let sum = PartialSum::new(Wave::Square, n, 1.0)?;
            let curve = |u: f64| sum.at(u / f64::from(n));
            let layer = Layer::curve("sum", Meaning::Series(i as u8), 0.0, 1.0, 200, curve);
            panel = panel.with(layer.label(text!("N = {n}", "N = {n}")));
            // S_N(u/N) is the midpoint rule of step h = 4πu/N for 2/π·∫₀^{4πu} sin t/t dt, and |(sin t/t)″| ≤ ⅓
            let error =
                |u: f64| (curve(u) - limit(u)).abs() / (2.0 / PI * (4.0 * PI * u).powi(3) / f64::from(72 * n * n));
            let worst = (1..=100).map(|i| error(0.01 * f64::from(i))).fold(0.0, f64::max);
            prove([Residual::at_most(format!("|S_N(u/N) − 2/π·Si(4πu)|·72N²/(2/π·(4πu)³), N = {n}"), worst, 1.0)])?;
        }
        let title = text!("One overshoot for all N", "Один выброс на все N");
        display(lang, &title, &Figure::new(1).with(panel))?;
    }

    // %% en
    // **Exercise.** Fejér's means weigh the $k$-th term by $1 - (k-1)/N$. Draw them into the same panel: is there still an
    // overshoot, and what is paid for it?
    // %% ru
    // **Упражнение.** Средние Фейера берут $k$-й член с весом $1 - (k-1)/N$. Нарисуйте их на той же панели: остался ли
    // выброс и какой ценой?

    // %% en
    // ## There and back: the Fourier transform
    //
    // $$F(\nu) = \int f(x)\,e^{-i2\pi\nu x}dx, \qquad f(x) = \int F(\nu)\,e^{i2\pi\nu x}d\nu, \qquad
    // e^{i\varphi} = \cos\varphi + i\sin\varphi.$$
    // No factor stands in front in either direction: that is what ordinary frequency buys, and everything below keeps to
    // it. The transform asks how much of every helix $e^{i2\pi\nu x}$ is in the signal. At a jump the inverse returns the
    // mean of both sides.
    //
    // Below a signal is taken apart by quadrature and put together again from its closed form, at places where nothing was
    // sampled.
    // %% ru
    // ## Туда и обратно: преобразование Фурье
    //
    // $$F(\nu) = \int f(x)\,e^{-i2\pi\nu x}dx, \qquad f(x) = \int F(\nu)\,e^{i2\pi\nu x}d\nu, \qquad
    // e^{i\varphi} = \cos\varphi + i\sin\varphi.$$
    // Множителя перед интегралом нет ни в ту, ни в другую сторону: этим и удобна обычная частота, и дальше мы держимся этого
    // соглашения. Преобразование спрашивает, сколько в сигнале каждой винтовой линии $e^{i2\pi\nu x}$. В точке скачка обратное
    // преобразование возвращает среднее двух сторон.
    //
    // Ниже сигнал разложен численным интегрированием, а потом собран снова из замкнутой формы там, где отсчётов не было.
    // %%
    {
        let f = Shifted::new(0.3, Gaussian::new(1.2)?)?; // not even: the transform is complex
        let nu = 0.4;
        let breaks = even_breaks(-9.0, 9.0, 0.5); // beyond them f is below 10⁻⁷⁰
        let re = integrate_pieces(|x| f.at(x) * cos_pi(2.0 * nu * x), &breaks, 1e-15);
        let im = integrate_pieces(|x| -f.at(x) * sin_pi(2.0 * nu * x), &breaks, 1e-15);
        let closed = f.spectrum().density(nu);
        println!("F({nu}) = {:.6} {:+.6}i", closed.re, closed.im);
        prove([
            Residual::near("Re F", re.value, closed.re, re.error),
            Residual::near("Im F", im.value, closed.im, im.error),
        ])?;
        for x in [-0.5, 0.3, 1.7] {
            let back = f.spectrum().inverse_at(x)?;
            println!("x = {x:4.1}: f = {:.6}, F⁻¹F = {:.6}", f.at(x), back.re);
            // the quadrature sums about 64 pieces of 15 places; the spectrum is cut where it is below ε/2
            prove([Residual::near("f(x)", back.re, f.at(x), sum_rounding(64 * 15, 2.0))])?;
        }
    }
    law(lang, "round-trip")?;

    // %%
    show(lang, "f12-euler", &[])?;

    // %%
    show(lang, "f12-both-ways", &[("c", "2")])?;

    // %% en
    // **Exercise.** In the last figure only the frequencies below $c$ are kept. Which $c$ keeps both packets? Which energy is
    // lost at $c = 2$, and where in the figure can it be read off twice?
    // %% ru
    // **Упражнение.** На последнем рисунке оставлены только частоты ниже $c$. При каком $c$ сохранятся оба пакета? Какая
    // энергия теряется при $c = 2$ и в каких двух местах рисунка её можно увидеть?

    // %% en
    // ## The table of pairs: box and Gaussian
    //
    // $$\mathrm{box}(x) \leftrightarrow \mathrm{sinc}(\nu), \qquad e^{-\pi x^2} \leftrightarrow e^{-\pi\nu^2}.$$
    // The box ends in space and never in frequency: the side lobes of the sinc fall only like $1/\nu$, the first one stands
    // at $\nu = 1.430$ and only 13.26 dB below the peak. The Gaussian is its own transform. The printed table calls the
    // right-hand column $f(\omega)$; it is $F$ (E04). Every pair of the library can be held against the integral.
    // %% ru
    // ## Таблица пар: прямоугольник и гауссиан
    //
    // $$\mathrm{box}(x) \leftrightarrow \mathrm{sinc}(\nu), \qquad e^{-\pi x^2} \leftrightarrow e^{-\pi\nu^2}.$$
    // Прямоугольник кончается в пространстве, но не по частоте: боковые лепестки sinc убывают лишь как $1/\nu$, первый стоит
    // в $\nu = 1{,}430$ и всего на 13,26 дБ ниже пика. Гауссиан — сам себе преобразование. В печатной таблице правый столбец
    // назван $f(\omega)$, а должно быть $F$ (E04). Любую пару библиотеки можно сверить с интегралом.
    // %%
    {
        let (unit, bell) = (Boxcar::new(1.0)?, Gaussian::new(1.0)?);
        let lobe = maximum(|nu| unit.spectrum().density(nu).norm(), 1.0, 2.0, 16);
        println!(
            "F(½) = {:.4}; {:.2} dB, ν = {:.3}",
            unit.spectrum().density(0.5).re,
            20.0 * lobe.value.log10(),
            lobe.at
        );
        let frequencies = [0.0, 0.3, 0.5, 1.43, 2.0, 3.7];
        prove([
            pair_by_quadrature(&unit, &[-0.5, 0.5], &frequencies, 0.0),
            pair_by_quadrature(&bell, &even_breaks(-8.0, 8.0, 1.0), &frequencies, 0.0),
            Residual::near(
                "F(1) = F(2) = F(3) = 0",
                (1..=3).map(|k| unit.spectrum().density(f64::from(k)).norm()).sum(),
                0.0,
                0.0,
            ),
        ])?;
    }

    // %%
    show(lang, "f13-pairs", &[])?;

    // %% en
    // **Exercise.** `Decay::new(1.0)`, $e^{-x}$ for $x > 0$, has a complex spectrum. Check it by `pair_by_quadrature`. How
    // far must the breaks reach, and what does the last argument, the tail, have to be?
    // %% ru
    // **Упражнение.** У `Decay::new(1.0)`, то есть $e^{-x}$ при $x > 0$, спектр комплексный. Проверьте его с помощью
    // `pair_by_quadrature`. Как далеко должны тянуться узлы и каким должен быть последний аргумент, хвост?

    // %% en
    // ## Lines: weights, not heights
    //
    // A constant, a cosine and a comb never end, and their spectra are *impulses*, which have a place and a weight:
    // $$1 \leftrightarrow \delta(\nu), \qquad
    // \cos x \leftrightarrow \tfrac12\delta\bigl(\nu - \tfrac1{2\pi}\bigr) + \tfrac12\delta\bigl(\nu + \tfrac1{2\pi}\bigr),
    // \qquad Ш_T \leftrightarrow \sum_k \delta\bigl(\nu - \tfrac kT\bigr).$$
    // Two rows of the printed table are wrong in its own convention. It gives $\cos x$ two lines of weight $\pi$ at
    // $\pm\tfrac12$: transformed back, that is $2\pi\cos\pi x$ (E01). And it gives the comb lines of weight $1/T$, which is
    // right for $T = 1$ only (E02; notebook 4).
    //
    // Experiment: under the window $e^{-\pi(x/L)^2}$ the peak grows with $L$, and its area does not.
    // %% ru
    // ## Линии: вес, а не высота
    //
    // Константа, косинус и гребень не кончаются, и спектры их состоят из *импульсов*, у которых есть место и вес:
    // $$1 \leftrightarrow \delta(\nu), \qquad
    // \cos x \leftrightarrow \tfrac12\delta\bigl(\nu - \tfrac1{2\pi}\bigr) + \tfrac12\delta\bigl(\nu + \tfrac1{2\pi}\bigr),
    // \qquad Ш_T \leftrightarrow \sum_k \delta\bigl(\nu - \tfrac kT\bigr).$$
    // Две строки печатной таблицы неверны в её же соглашении. Косинусу $\cos x$ приписаны две линии веса $\pi$ в
    // $\pm\tfrac12$: обратное преобразование даёт $2\pi\cos\pi x$ (E01). А линиям гребня приписан вес $1/T$, верный лишь
    // при $T = 1$ (E02; тетрадь 4).
    //
    // Опыт: под окном $e^{-\pi(x/L)^2}$ пик растёт вместе с $L$, а его площадь — нет.
    // %%
    let cos_x = Cosine::new(1.0 / (2.0 * PI))?;
    for window in [10.0, 20.0, 40.0] {
        let seen = Product::new(cos_x, Gaussian::new(window)?)?.spectrum();
        let peak = maximum(|nu| seen.density(nu).re, 0.05, 0.3, 64);
        // one peak alone: the other one's tail reaches over zero with weight below e^{−π(L/2π)²}/2
        let area = integrate_pieces(|nu| seen.density(nu).re, &even_breaks(0.0, 1.0, 0.02), 1e-14);
        println!("L = {window}: F({1:.4}) = {0:.3}, ∫F = {2:.6}", peak.value, peak.at, area.value);
        let tail = 0.5 * (-PI * (window / (2.0 * PI)).powi(2)).exp();
        prove([Residual::near("∫F = ½", area.value, 0.5, area.error + tail)])?;
    }
    {
        let printed = Spectrum::of_lines([Impulse::new(-0.5, PI), Impulse::new(0.5, PI)])?;
        for x in [0.0, 1.0, 2.0] {
            let (ours, theirs) = (cos_x.spectrum().inverse_at(x)?.re, printed.inverse_at(x)?.re);
            println!("cos {x} = {:+.4}; ½δ(ν ± 1/2π): {ours:+.4}; πδ(ν ± ½): {theirs:+.4}", x.cos());
            prove([
                Residual::near("cos x", ours, x.cos(), sum_rounding(2, 1.0)),
                Residual::near("2π·cos πx", theirs, 2.0 * PI * cos_pi(x), sum_rounding(2, 2.0 * PI)),
            ])?;
        }
    }

    // %%
    show(lang, "f13-windows", &[("T", "2")])?;

    // %% en
    // **Exercise.** Which lines has $\sin x$? And $\cos^2 x$? Write them down with `Impulse::new`, and let `inverse_at` check
    // you.
    // %% ru
    // **Упражнение.** Какие линии у $\sin x$? А у $\cos^2 x$? Запишите их с помощью `Impulse::new` и проверьте себя через
    // `inverse_at`.

    Ok(())
}
