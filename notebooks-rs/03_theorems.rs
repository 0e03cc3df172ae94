//! Theorems of the Fourier transform: what is done to a function, and what that does to its spectrum.
#![allow(clippy::print_stdout, reason = "a notebook prints")]

use nyquist::course::{display, law, prove, show};
use nyquist::figure::{Figure, Layer, Legend, Meaning, Panel, Scale};
use nyquist::laws::poisson::sum_rounding;
use nyquist::laws::theorems::{convolution_theorem, pair_by_quadrature, parseval, uncertainty};
use nyquist::num::quadrature::even_breaks;
use nyquist::num::random::normal;
use nyquist::prelude::*;
use nyquist::text;
use std::f64::consts::PI;

fn main() -> Result<()> {
    // %% en
    // # 3. Theorems
    //
    // The slide on convolution states two theorems. With a few more they are the whole grammar of this course: whoever
    // knows what shifting, stretching, multiplying and convolving do to a spectrum can read off all that sampling and
    // reconstruction do.
    //
    // In the library every theorem is an adaptor: `Shifted`, `Stretched`, `Modulated`, `Product`, `Convolution`,
    // `Derivative`. It changes the signal *and* its closed-form spectrum, and an integral that knows nothing of the theorem
    // (`pair_by_quadrature`) checks that the two still belong together.
    // %% ru
    // # 3. Теоремы
    //
    // На слайде о свёртке две теоремы. Ещё несколько — и это вся грамматика курса: кто знает, что делают со спектром
    // сдвиг, растяжение, умножение и свёртка, тот прочтёт всё, что делают дискретизация и реконструкция.
    //
    // В библиотеке каждая теорема — адаптер: `Shifted`, `Stretched`, `Modulated`, `Product`, `Convolution`, `Derivative`. Он
    // изменяет сигнал *и* его спектр в замкнутой форме, а интеграл, ничего не знающий о теореме (`pair_by_quadrature`),
    // проверяет, что они по-прежнему составляют пару.
    // %%
    let lang = Lang::En;
    let bell = Gaussian::new(1.0)?;

    // %% en
    // ## Shift: the phases turn, the magnitudes stay
    //
    // **Theorem.** $f(x - x_0) \leftrightarrow e^{-i2\pi\nu x_0}F(\nu)$.
    //
    // How much of every frequency there is does not depend on where the signal stands. So the magnitude alone says nothing
    // about places: they are in the phases.
    // %% ru
    // ## Сдвиг: фазы поворачиваются, модули остаются
    //
    // **Теорема.** $f(x - x_0) \leftrightarrow e^{-i2\pi\nu x_0}F(\nu)$.
    //
    // Сколько в сигнале каждой частоты, не зависит от того, где он стоит. Поэтому модуль спектра ничего не говорит о
    // положении: оно скрыто в фазах.
    // %%
    let late = Shifted::new(0.25, bell)?;
    for nu in [0.0, 0.5, 1.0, 1.5] {
        let (before, after) = (bell.spectrum().density(nu), late.spectrum().density(nu));
        let turned = (after / before).arg() / PI;
        println!("ν = {nu}: |F| = {:.4}, arg = {turned:+.2}π", after.norm());
        prove([Residual::near("|F|", after.norm(), before.norm(), 4.0 * f64::EPSILON)])?;
    }
    prove([pair_by_quadrature(&late, &even_breaks(-8.0, 8.5, 1.0), &[0.0, 0.5, 1.3], 0.0)])?;
    law(lang, "shift")?;

    // %%
    {
        let (x, y) = (Scale::linear(text!("x", "x"), -1.5, 2.0), Scale::linear(Text::same("f"), -0.1, 1.1));
        let (nu, v) = (Scale::linear(text!("ν", "ν"), -2.0, 2.0), Scale::linear(Text::same("F"), -1.1, 1.1));
        let (f, spectrum) = (Shifted::new(0.5, bell)?, Shifted::new(0.5, bell)?.spectrum());
        let space = Panel::new("space", text!("in space: moved by ½", "в пространстве: сдвиг на ½"), x, y)
            .with(Layer::curve("before", Meaning::Guide, -1.5, 2.0, 200, |x| bell.at(x)).dashed())
            .with(Layer::curve("f", Meaning::Signal, -1.5, 2.0, 200, |x| f.at(x)));
        let of = |name, meaning, part: &dyn Fn(f64) -> f64| Layer::curve(name, meaning, -2.0, 2.0, 200, part);
        let frequency = Panel::new("frequency", text!("in frequency: turned", "по частоте: поворот фаз"), nu, v)
            .with(of("|F|", Meaning::Guide, &|nu| spectrum.density(nu).norm()).dashed().label(Text::same("|F|")))
            .with(of("Re", Meaning::Series(0), &|nu| spectrum.density(nu).re).label(Text::same("Re F")))
            .with(of("Im", Meaning::Series(1), &|nu| spectrum.density(nu).im).label(Text::same("Im F")));
        let title = text!("A shift turns the phases", "Сдвиг поворачивает фазы");
        display(lang, &title, &Figure::new(2).with(space).with(frequency))?;
    }

    // %% en
    // **Exercise.** By how much must a signal be shifted so that a tone of frequency 3 in it looks the same as before?
    // Give all answers.
    // %% ru
    // **Упражнение.** На сколько надо сдвинуть сигнал, чтобы тон с частотой 3 в нём выглядел как прежде? Укажите все
    // ответы.

    // %% en
    // ## Stretching: wide here is narrow there
    //
    // **Theorem** (similarity). $f(x/c) \leftrightarrow c\,F(c\nu)$ for $c > 0$.
    //
    // Twice as long in space, half as wide in frequency, and twice as high, for the area of a spectrum is $f(0)$, which does
    // not change. An impulse keeps its *weight*, because $c\,\delta(c\nu - \nu_0) = \delta(\nu - \nu_0/c)$: the factor that
    // the printed table forgets in the row of the sinusoid (E01).
    // %% ru
    // ## Растяжение: широко здесь — узко там
    //
    // **Теорема** (подобие). $f(x/c) \leftrightarrow c\,F(c\nu)$ при $c > 0$.
    //
    // Вдвое длиннее в пространстве — вдвое уже по частоте и вдвое выше, ведь площадь спектра равна $f(0)$ и не меняется.
    // Импульс сохраняет свой *вес*, поскольку $c\,\delta(c\nu - \nu_0) = \delta(\nu - \nu_0/c)$: этот множитель и забыт в
    // строке синусоиды печатной таблицы (E01).
    // %%
    {
        let (x, y) = (Scale::linear(text!("x", "x"), -3.0, 3.0), Scale::linear(Text::same("f(x/c)"), 0.0, 1.1));
        let (nu, v) = (Scale::linear(text!("ν", "ν"), -3.0, 3.0), Scale::linear(Text::same("c·F(cν)"), 0.0, 2.2));
        let mut space = Panel::new("space", text!("in space", "в пространстве"), x, y);
        let mut frequency = Panel::new("frequency", text!("in frequency", "по частоте"), nu, v);
        for (i, c) in [0.5, 1.0, 2.0].into_iter().enumerate() {
            let wide = Stretched::new(c, bell)?;
            let spectrum = wide.spectrum();
            let label = text!("c = {c}", "c = {c}");
            let meaning = Meaning::Series(i as u8);
            space = space.with(Layer::curve("f", meaning, -3.0, 3.0, 240, |x| wide.at(x)).label(label.clone()));
            let density = |nu: f64| spectrum.density(nu).re;
            frequency = frequency.with(Layer::curve("F", meaning, -3.0, 3.0, 240, density).label(label));
            let area = spectrum.inverse_at(0.0)?.re;
            println!("c = {c}: F(0) = {:.2}, ∫F = {area:.6}", spectrum.density(0.0).re);
            prove([
                pair_by_quadrature(&wide, &even_breaks(-8.0 * c, 8.0 * c, 0.5 * c), &[0.0, 0.5, 1.3], 0.0),
                Residual::near("∫F = f(0)", area, 1.0, sum_rounding(8 * 15, 1.0)), // eight pieces of 15 places
            ])?;
        }
        let title = text!("Wide here is narrow there", "Широко здесь — узко там");
        display(lang, &title, &Figure::new(2).with(space).with(frequency))?;
    }

    // %% en
    // **Exercise.** A record is played at double speed. What happens to its band, and what to the rate at which it has to be
    // sampled?
    // %% ru
    // **Упражнение.** Запись проиграли вдвое быстрее. Что стало с её полосой и с частотой, с которой её нужно
    // дискретизовать?

    // %% en
    // ## Convolution here is multiplication there
    //
    // **Theorem** (slide “Свертка и преобразование Фурье”).
    // $$(f \otimes g)(x) = \int f(x')\,g(x - x')\,dx' \;\leftrightarrow\; F(\nu)\,G(\nu).$$
    // A filter is a convolution; in frequency it is a mere factor, one number a frequency. The box convolved with itself is
    // the tent, so the tent's spectrum is $\mathrm{sinc}^2$.
    // %% ru
    // ## Свёртка здесь — умножение там
    //
    // **Теорема** (слайд «Свертка и преобразование Фурье»).
    // $$(f \otimes g)(x) = \int f(x')\,g(x - x')\,dx' \;\leftrightarrow\; F(\nu)\,G(\nu).$$
    // Фильтр — это свёртка; по частоте он всего лишь множитель, одно число на частоту. Свёртка прямоугольника с самим собой
    // — треугольник, значит, спектр треугольника $\mathrm{sinc}^2$.
    // %%
    {
        let (unit, edges) = (Boxcar::new(1.0)?, [-0.5, 0.5]);
        let twice = Convolution::new(unit, &edges, unit, &edges)?;
        let tent = Tent::new(1.0)?;
        for x in [0.0, 0.25, 0.8, 1.2] {
            println!("x = {x}: box ⊗ box = {:.4}, tent = {:.4}", twice.at(x), tent.at(x));
            // two pieces of 15 places
            prove([Residual::near("box ⊗ box = tent", twice.at(x), tent.at(x), sum_rounding(30, 1.0))])?;
        }
        // and on samples, where the transform is an FFT: any two records
        let noise = |seed: u64, n: usize| {
            let values = (0..n as u64).map(|i| normal(seed, i, 0)).collect();
            Samples::new(Axis::new(0.0, 0.1, n)?, values)
        };
        prove([convolution_theorem(&noise(1, 300)?, &noise(2, 200)?)?])?;
    }
    law(lang, "convolution")?;

    // %%
    show(lang, "f17-convolution", &[("nu0", "2"), ("w", "2")])?;

    // %% en
    // **Exercise.** Convolve the tent with the box once more, and again. What do the spectra become, how fast do they fall,
    // and which famous curve does the function approach?
    // %% ru
    // **Упражнение.** Сверните треугольник с прямоугольником ещё раз и ещё. Какими станут спектры, как быстро они убывают и к
    // какой знаменитой кривой приближается функция?

    // %% en
    // ## Multiplication here is convolution there
    //
    // **Theorem** (the dual). $f \cdot g \leftrightarrow F \otimes G$. In ordinary frequency no $1/2\pi$ is needed.
    //
    // Convolution with an impulse is a shift: $F \otimes w\,\delta(\nu - \nu_0) = w\,F(\nu - \nu_0)$; the slide's “convolution
    // with a delta function is the signal” holds for $\delta(\nu)$ alone (E19). A cosine has two impulses of weight ½, hence
    // **modulation**, $f\cos 2\pi\nu_0x \leftrightarrow \tfrac12F(\nu - \nu_0) + \tfrac12F(\nu + \nu_0)$, and hence the beat:
    // two tones multiplied are the tones of their sum and difference.
    // %% ru
    // ## Умножение здесь — свёртка там
    //
    // **Теорема** (двойственная). $f \cdot g \leftrightarrow F \otimes G$. Для обычной частоты множитель $1/2\pi$ не нужен.
    //
    // Свёртка с импульсом — это сдвиг: $F \otimes w\,\delta(\nu - \nu_0) = w\,F(\nu - \nu_0)$; слова слайда «свёртка сигнала
    // дельта-функцией есть сигнал» верны только для $\delta(\nu)$ (E19). У косинуса два импульса веса ½, отсюда
    // **модуляция**, $f\cos 2\pi\nu_0x \leftrightarrow \tfrac12F(\nu - \nu_0) + \tfrac12F(\nu + \nu_0)$, и отсюда же биения:
    // произведение двух тонов — тоны суммарной и разностной частоты.
    // %%
    let beat = Product::new(Cosine::new(3.0)?, Cosine::new(2.5)?)?;
    for line in beat.spectrum().lines() {
        println!("ν = {:+.1}: w = {}", line.at, line.weight.re);
    }
    let burst = Product::new(Cosine::new(2.0)?, bell)?;
    let modulated = Modulated::new(2.0, bell)?;
    for nu in [0.0, 1.5, 2.0, 2.4] {
        let (product, theorem) = (burst.spectrum().density(nu).re, modulated.spectrum().density(nu).re);
        prove([Residual::near("½F(ν − ν₀) + ½F(ν + ν₀)", product, theorem, sum_rounding(2, 1.0))])?;
    }
    law(lang, "product")?;
    law(lang, "modulation")?;

    // %% en
    // Sampling is this theorem with the Dirac comb for the second factor: notebook 4.
    //
    // **Exercise.** A window of length $L$ is a product with a box. What does it do to a line, and why can two tones closer
    // than about $1/L$ not be told apart?
    // %% ru
    // Дискретизация — эта же теорема, где второй множитель — гребень Дирака: тетрадь 4.
    //
    // **Упражнение.** Окно длины $L$ — это умножение на прямоугольник. Что оно делает с линией и почему два тона ближе
    // примерно $1/L$ не различить?

    // %% en
    // ## Differentiation, and how fast spectra fall
    //
    // **Theorem.** $f' \leftrightarrow i2\pi\nu\,F(\nu)$: differentiation amplifies every frequency in proportion.
    //
    // Read backwards: the smoother a function, the faster its spectrum falls. A jump gives $1/\nu$ (the box), a corner
    // $1/\nu^2$ (the tent), and a function all of whose derivatives are smooth beats every power (the Gaussian). So an edge in
    // an image does not have “infinite frequencies”: it has frequencies *without end*, falling like $1/\nu$ (E21). Multiplied
    // by $\pi\nu$ and $(\pi\nu)^2$ the first two no longer fall.
    // %% ru
    // ## Дифференцирование и скорость убывания спектра
    //
    // **Теорема.** $f' \leftrightarrow i2\pi\nu\,F(\nu)$: дифференцирование усиливает каждую частоту пропорционально ей самой.
    //
    // Прочтём наоборот: чем глаже функция, тем быстрее убывает её спектр. Скачок даёт $1/\nu$ (прямоугольник), излом
    // $1/\nu^2$ (треугольник), а функция, гладкая со всеми производными, обгоняет любую степень (гауссиан). Так что у границы
    // на изображении не «бесконечные частоты», а частоты *без конца*, убывающие как $1/\nu$ (E21). Умноженные на $\pi\nu$ и
    // $(\pi\nu)^2$, первые два спектра больше не убывают.
    // %%
    {
        let (unit, tent) = (Boxcar::new(1.0)?.spectrum(), Tent::new(1.0)?.spectrum());
        for nu in [1.5, 5.5, 20.5, 100.5] {
            let (edge, corner) = (unit.density(nu).norm(), tent.density(nu).norm());
            println!(
                "ν = {nu:5}: {edge:.1e} (Boxcar), {corner:.1e} (Tent), {:.0e} (Gaussian)",
                bell.spectrum().density(nu).norm()
            );
            // half-way between its zeros the sinc is 1/(πν), to the rounding of ν·π
            let rounding = 8.0 * f64::EPSILON;
            prove([
                Residual::near("πν·|F| = 1 (box)", PI * nu * edge, 1.0, rounding),
                Residual::near("(πν)²·|F| = 1 (tent)", (PI * nu).powi(2) * corner, 1.0, rounding),
            ])?;
        }
    }
    law(lang, "derivative")?;

    // %%
    {
        let (x, y) = (Scale::log(text!("ν", "ν"), 0.1, 100.0), Scale::log(Text::same("|F|"), 1e-6, 2.0));
        let (unit, tent, bell) = (Boxcar::new(1.0)?.spectrum(), Tent::new(1.0)?.spectrum(), bell.spectrum());
        // half-way between the zeros of the sinc stand its crests, and between them straight lines
        let crests = |spectrum: &Spectrum| {
            let at = [0.1, 0.2, 0.4].into_iter().chain((1..100).map(|k| f64::from(k) + 0.5));
            at.map(|nu| [nu, spectrum.density(nu).norm()]).collect::<Vec<_>>()
        };
        let below = |nu: f64| bell.density(nu).norm().max(1e-7);
        let panel = Panel::new("decay", Text::EMPTY, x, y)
            .legend(Legend::LowerLeft)
            .with(Layer::line("box", Meaning::Series(0), crests(&unit)).label(text!("box: 1/ν", "прямоугольник: 1/ν")))
            .with(
                Layer::line("tent", Meaning::Series(1), crests(&tent)).label(text!("tent: 1/ν²", "треугольник: 1/ν²")),
            )
            .with(
                Layer::line(
                    "bell",
                    Meaning::Series(2),
                    (0..200).map(|i| 0.1 * 1.015f64.powi(i)).map(|nu| [nu, below(nu)]),
                )
                .label(text!("Gaussian", "гауссиан")),
            );
        let title = text!("The smoother, the faster it falls", "Чем глаже, тем быстрее убывание");
        display(lang, &title, &Figure::new(1).with(panel))?;
    }

    // %% en
    // **Exercise.** An image is sharpened by adding its derivative. Why does noise grow most, and which part of the spectrum
    // must be kept out of it?
    // %% ru
    // **Упражнение.** Изображение делают резче, добавляя к нему производную. Почему сильнее всего растёт шум и какую часть
    // спектра не следует в неё пускать?

    // %% en
    // ## Parseval: the energy is the same in both
    //
    // **Theorem** (Parseval, Plancherel). $\int f^2\,dx = \int |F|^2\,d\nu$.
    //
    // So errors may be counted where it is easier. What an ideal low-pass takes away from a signal has, in the mean square,
    // exactly the energy of the frequencies taken away. RC(1), the raised cosine $F = \cos^2(\pi\nu/2)$ on
    // $|\nu| < 1$, has the energy $\tfrac34$.
    // %% ru
    // ## Парсеваль: энергия одна и та же
    //
    // **Теорема** (Парсеваль, Планшерель). $\int f^2\,dx = \int |F|^2\,d\nu$.
    //
    // Значит, ошибки можно считать там, где удобнее. У того, что идеальный фильтр отнимает у сигнала, в среднем
    // квадратичном ровно та энергия, что была у отнятых частот. У RC(1), приподнятого косинуса $F = \cos^2(\pi\nu/2)$ при
    // $|\nu| < 1$, энергия равна $\tfrac34$.
    // %%
    let rc = RaisedCosine::new(1.0)?;
    {
        let spectrum = rc.spectrum();
        let (inside, all) = (spectrum.energy(-0.5, 0.5), spectrum.energy(-1.0, 1.0));
        println!("∫|F|² = {all:.6}, |ν| < ½: {inside:.6}");
        // samples faster than 2B carry it too; beyond the record f² < 1/(63π²x⁶)
        let samples = Samples::of(&rc, Axis::centered(0.4, 501)?);
        let sum: f64 = samples.values().iter().map(|v| v * v).sum::<f64>() * 0.4;
        let tail = 2.0 / (5.0 * 63.0 * PI * PI * 99f64.powi(5));
        prove([
            Residual::near("∫|F|² = ¾", all, 0.75, sum_rounding(16 * 15, 0.75)),
            Residual::near("T·Σf² = ∫|F|²", sum, all, tail + sum_rounding(501, 0.75)),
            parseval(&bell, &even_breaks(-8.0, 8.0, 1.0), 0.0),
        ])?;
    }
    law(lang, "parseval")?;

    // %%
    show(lang, "f12-both-ways", &[("c", "1")])?; // what a low-pass at 1 takes away, in space and in frequency

    // %% en
    // **Exercise.** Which cut-off takes away one per cent of the energy of RC(1)? Find it with `spectrum.energy`. How large is
    // the error then beside the signal, in the root mean square?
    // %% ru
    // **Упражнение.** Какая частота среза отнимает у RC(1) один процент энергии? Найдите её с помощью `spectrum.energy`.
    // Какова тогда среднеквадратичная ошибка по сравнению с сигналом?

    // %% en
    // ## Uncertainty: no signal is short in both
    //
    // **Theorem** (Heisenberg, Weyl, Gabor). The deviations of the intensities $f^2$ and $|F|^2$ obey
    // $$\sigma_x\,\sigma_\nu \ge \frac1{4\pi},$$
    // and the Gaussian alone reaches it. (For the amplitudes of the Gaussian the product is $1/(2\pi)$; which of the two a
    // text means has to be asked.) So there is no filter that is both short in space and sharp in frequency: this is the
    // trade behind every kernel of notebook 5.
    // %% ru
    // ## Неопределённость: нельзя быть коротким и там и там
    //
    // **Теорема** (Гейзенберг, Вейль, Габор). Разбросы интенсивностей $f^2$ и $|F|^2$ связаны неравенством
    // $$\sigma_x\,\sigma_\nu \ge \frac1{4\pi},$$
    // и равенство достигает только гауссиан. (Для амплитуд гауссиана произведение равно $1/(2\pi)$; что именно имеет в виду
    // автор, всегда стоит уточнить.) Поэтому не бывает фильтра, короткого в пространстве и резкого по частоте сразу: таков
    // компромисс за каждым ядром тетради 5.
    // %%
    for width in [0.3, 1.0, 3.0] {
        let product = uncertainty(&Gaussian::new(width)?, 10.4 * width);
        println!("Gaussian({width}): 4π·σσ = {product:.9}");
    }
    println!("RC(1): 4π·σσ = {:.3}", uncertainty(&rc, 400.0));
    println!("sinc²: 4π·σσ = {:.3}", uncertainty(&SincSquared::new(1.0)?, 400.0));
    law(lang, "uncertainty")?;

    // %% en
    // **Exercise.** Why does the box not stand in this list? (Compute $\int \nu^2\,\mathrm{sinc}^2\nu\,d\nu$.)
    // %% ru
    // **Упражнение.** Почему в этом списке нет прямоугольника? (Вычислите $\int \nu^2\,\mathrm{sinc}^2\nu\,d\nu$.)

    Ok(())
}
