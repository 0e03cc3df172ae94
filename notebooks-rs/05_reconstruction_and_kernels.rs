//! Reconstruction and kernels: from samples back to a function.
#![allow(clippy::print_stdout, reason = "a notebook prints")]

use nyquist::course::{law, prove, show};
use nyquist::kernel::catalog::by_name;
use nyquist::kernel::metrics::Metrics;
use nyquist::laws::gibbs::{HALF_PEAK, SAMPLED_PEAK};
use nyquist::laws::kernels::{reproduces_constants, reproduces_lines};
use nyquist::laws::poisson::{raised_cosine_tail, sum_rounding};
use nyquist::laws::truncation::sinc_energy_beyond;
use nyquist::num::extremum::maximum;
use nyquist::num::random::normal;
use nyquist::prelude::*;
use nyquist::signal::lecture::SPIKES;

fn main() -> Result<()> {
    // %% en
    // # 5. Reconstruction and kernels
    //
    // Sampling has copied the spectrum. To come back, one copy must be cut out, which in space means: put a kernel in place
    // of every sample, and add. This notebook does it exactly, sees why exactly is impractical, and compares the kernels
    // that are used instead.
    // %% ru
    // # 5. Реконструкция и ядра
    //
    // Дискретизация размножила спектр. Чтобы вернуться, надо вырезать одну копию, а в пространстве это значит: поставить на
    // место каждого отсчёта ядро и всё сложить. В этой тетради мы сделаем это точно, увидим, почему точно — непрактично, и
    // сравним ядра, которыми пользуются вместо этого.
    // %%
    let lang = Lang::En;
    let rc = RaisedCosine::new(1.0)?;

    // %% en
    // ## A convolution with the samples
    //
    // $$\tilde f(x) = \bigl((Ш_T f) \otimes r\bigr)(x) = T\sum_i f(iT)\,r(x - iT).$$
    // Every sample is replaced by the filter $r$, scaled by it. The library writes $r(x) = k(x/T)/T$ with a kernel $k$ in units
    // of the step; then the two factors $T$ cancel: $\tilde f(x) = \sum_i f(iT)\,k(x/T - i)$.
    // %% ru
    // ## Свёртка с отсчётами
    //
    // $$\tilde f(x) = \bigl((Ш_T f) \otimes r\bigr)(x) = T\sum_i f(iT)\,r(x - iT).$$
    // Каждый отсчёт заменяется фильтром $r$, умноженным на этот отсчёт. Библиотека записывает $r(x) = k(x/T)/T$, где ядро $k$
    // задано в единицах шага; тогда оба множителя $T$ сокращаются: $\tilde f(x) = \sum_i f(iT)\,k(x/T - i)$.
    // %%
    let spikes = Samples::new(Axis::new(0.0, 0.5, 9)?, SPIKES.to_vec())?; // the lecture's nine samples, T = ½
    {
        let mitchell = Cubic::mitchell();
        let back = reconstruct(&spikes, mitchell);
        for x in [1.0, 1.3, 2.2] {
            let by_hand: f64 = spikes.points().map(|[at, f]| f * mitchell.at((x - at) / 0.5)).sum();
            println!("x = {x}: {:.5}", back.at(x));
            prove([Residual::near("f̃ = Σf(iT)·k(x/T − i)", back.at(x), by_hand, sum_rounding(9, 4.0))])?;
        }
    }

    // %%
    show(lang, "f15-convolution", &[("r", "mitchell"), ("T", "1")])?;

    // %% en
    // **Exercise.** Try `("r", "box")`, `("r", "b-spline")`. Which of the curves pass through the samples? What must be true of
    // $k$ at the integers for that?
    // %% ru
    // **Упражнение.** Попробуйте `("r", "box")`, `("r", "b-spline")`. Какие кривые проходят через отсчёты? Какие значения
    // должно для этого принимать $k$ в целых точках?

    // %% en
    // ## The filter must scale with the step
    //
    // The book's example is the tent $r(x) = \max(0, 1 - |x|)$. It interpolates linearly *for $T = 1$ only*. At another step it
    // must be scaled, $r(x) = \tfrac1T\mathrm{tent}(x/T)$, so that $\int r = 1$; unscaled it blurs and misses the samples
    // (E06). The same holds for “the transform of the box is the sinc”: it is $\tfrac1T\mathrm{sinc}(x/T)$.
    // %% ru
    // ## Фильтр сжимается вместе с шагом
    //
    // Пример из книги — треугольник $r(x) = \max(0, 1 - |x|)$. Линейной интерполяцией он будет *только при $T = 1$*. При
    // другом шаге его надо сжать, $r(x) = \tfrac1T\mathrm{tent}(x/T)$, чтобы было $\int r = 1$; иначе он размывает и не
    // проходит через отсчёты (E06). То же относится к словам «преобразование Фурье от box-функции — sinc»: это
    // $\tfrac1T\mathrm{sinc}(x/T)$.
    // %%
    {
        let (tent, book) = (reconstruct(&spikes, TentKernel), Tent::new(1.0)?);
        let unscaled = |x: f64| spikes.points().map(|[at, f]| 0.5 * f * book.at(x - at)).sum::<f64>();
        for [x, f] in spikes.points().skip(2).take(4) {
            println!("f({x}) = {f:.3}; tent(x/T)/T: {:.3}; tent(x): {:.3}", tent.at(x), unscaled(x));
            prove([Residual::near("f̃(iT) = f(iT)", tent.at(x), f, 0.0)])?;
        }
        let middle = 0.5 * (SPIKES[4] + SPIKES[5]);
        prove([Residual::near("f̃(2¼) = ½f(2) + ½f(2½)", tent.at(2.25), middle, sum_rounding(2, 1.0))])?;
    }

    // %%
    show(lang, "f16-tents", &[("T", "0.5")])?;

    // %% en
    // **Exercise.** Which filter is the unscaled tent at $T = \tfrac12$, in units of the step? What are its values at the
    // integers, and which average of the samples does it therefore return?
    // %% ru
    // **Упражнение.** Какой это фильтр в единицах шага — несжатый треугольник при $T = \tfrac12$? Каковы его значения в целых
    // точках и какое среднее отсчётов он поэтому возвращает?

    // %% en
    // ## In frequency: cut out one copy
    //
    // $$\Bigl(\sum_k F(\nu - k/T)\Bigr)\,\Pi_{1/T}(\nu) = F(\nu) \quad\text{if the copies do not overlap},$$
    // and the condition belongs next to the statement (E20). $\Pi_{1/T}$ is a function of the frequency $\nu$, not of $x$
    // (E04); it is 1 inside, 0 outside and ½ exactly at $\pm\tfrac1{2T}$, the value the inverse transform gives (E05).
    //
    // Taken literally, the printed table (lines of weight $1/T$) and the slide (a box of height 1) make a chain of the gain
    // $1/T$, twice the signal at $T = \tfrac12$ (E03). With lines of weight 1 the gain is 1.
    // %% ru
    // ## По частоте: вырезать одну копию
    //
    // $$\Bigl(\sum_k F(\nu - k/T)\Bigr)\,\Pi_{1/T}(\nu) = F(\nu), \quad\text{если копии не накладываются},$$
    // и это условие должно стоять рядом с утверждением (E20). $\Pi_{1/T}$ — функция частоты $\nu$, а не $x$ (E04); внутри она
    // равна 1, снаружи 0, а ровно в $\pm\tfrac1{2T}$ — ½: такое значение даёт обратное преобразование (E05).
    //
    // Если понимать буквально таблицу (линии веса $1/T$) и слайд (прямоугольник высоты 1), получится цепочка с усилением
    // $1/T$: при $T = \tfrac12$ вдвое больше сигнала (E03). С линиями веса 1 усиление равно 1.
    // %%
    {
        let (slow, step) = (RaisedCosine::new(0.5)?, 0.5);
        let copies = slow.spectrum().replicated(1.0 / step, 3)?;
        let back = copies.low_passed(0.5 / step)?;
        let literal = copies.scaled(1.0 / step).low_passed(0.5 / step)?;
        for x in [0.0, 0.7] {
            let (f, ours, theirs) = (slow.at(x), back.inverse_at(x)?.re, literal.inverse_at(x)?.re);
            println!("x = {x}: f = {f:.5}, f̃ = {ours:.5}; w = 1/T: {theirs:.5}");
            prove([
                Residual::near("f̃ = f", ours, f, sum_rounding(8 * 15, 1.0)), // eight pieces of 15 places
                Residual::near("w = 1/T: f/T", theirs, f / step, sum_rounding(8 * 15, 2.0)),
            ])?;
        }
    }

    // %%
    show(lang, "f21-low-pass", &[("T", "1"), ("signal", "gaussian")])?;

    // %% en
    // **Exercise.** The Gaussian is not band-limited. How large is the trace of its neighbours at $\nu = \tfrac12$, and at which
    // step is it below $10^{-9}$?
    // %% ru
    // **Упражнение.** У гауссиана нет границы полосы. Насколько велик след соседних копий в $\nu = \tfrac12$ и при каком шаге
    // он меньше $10^{-9}$?

    // %% en
    // ## In space: the cardinal series
    //
    // **Theorem** (Whittaker, Kotelnikov, Shannon). If $F = 0$ for $|\nu| > B$ and $1/T \ge 2B$, then
    // $$f(x) = \sum_k f(kT)\,\mathrm{sinc}(x/T - k).$$
    // The sinc is 1 at its own sample and 0 at all others, so the sum passes through *any* data; for a band-limited signal it
    // is the signal in between as well. All that is in error is what a finite record leaves out.
    // %% ru
    // ## В пространстве: ряд Котельникова
    //
    // **Теорема** (Уиттекер, Котельников, Шеннон). Если $F = 0$ при $|\nu| > B$ и $1/T \ge 2B$, то
    // $$f(x) = \sum_k f(kT)\,\mathrm{sinc}(x/T - k).$$
    // Функция sinc равна 1 в своём отсчёте и 0 во всех остальных, поэтому сумма проходит через *любые* данные, а для сигнала
    // с ограниченной полосой она совпадает с ним и между отсчётами. Ошибка — только от того, что не попало в запись.
    // %%
    for step in [0.25, 0.4, 0.5] {
        let samples = Samples::of(&rc, Axis::centered(step, 8001)?);
        let back = reconstruct(&samples, Ideal);
        let places = (0..=64).map(|i| f64::from(i) / 16.0);
        let worst = places.map(|x| (back.at(x) - rc.at(x)).abs()).fold(0.0, f64::max);
        let size: f64 = samples.values().iter().map(|v| v.abs()).sum();
        let bound = raised_cosine_tail(1.0, step, 4000) / step + sum_rounding(4, size);
        println!("T = {step}, |k| ≤ 4000:");
        prove([Residual::at_most("|f̃ − f|", worst, bound)])?;
    }
    {
        let noise = Samples::new(Axis::new(0.0, 1.0, 32)?, (0..32).map(|i| normal(1, i, 0)).collect())?;
        let back = reconstruct(&noise, Ideal);
        let worst = noise.points().map(|[x, v]| (back.at(x) - v).abs()).fold(0.0, f64::max);
        prove([Residual::at_most("f̃(k) = f(k)", worst, 0.0)])?;
    }

    // %%
    show(lang, "f23-cardinal", &[("T", "0.4")])?;

    // %% en
    // **Exercise.** Only one sample is not zero: $f(0) = 1$. What is the reconstruction, and what is its spectrum? What does
    // that say about the samples of a band-limited signal that is not zero?
    // %% ru
    // **Упражнение.** Не равен нулю единственный отсчёт: $f(0) = 1$. Что даст реконструкция и каков её спектр? Может ли
    // ненулевой сигнал с ограниченной полосой кончаться?

    // %% en
    // ## Why the ideal filter is impractical
    //
    // **It never ends.** The energy of the sinc outside $|x| \le N$ is $\approx \tfrac1{\pi^2N}$: ten per cent at $N = 1$, one
    // at $N = 10$. Cut off after $N$ terms the series of a tone errs like $1/N$, the more the nearer it is to Nyquist.
    //
    // **It rings at jumps.** A sampled step overshoots by 14.114 %, or by 3.289 % where a sample with the value ½ sits on the
    // jump. Neither is Gibbs's 8.949 %, which belongs to the low-passed *continuous* step. But the sinc is not to blame: a
    // correctly sampled band-limited signal does not ring at all, as the cell above has measured (E15).
    // %% ru
    // ## Почему идеальный фильтр непрактичен
    //
    // **Он не кончается.** Энергия sinc вне $|x| \le N$ примерно $\tfrac1{\pi^2N}$: десять процентов при $N = 1$, один при
    // $N = 10$. Ошибка ряда, обрезанного на $N$ членах, для тона убывает как $1/N$ и тем больше, чем он ближе к частоте
    // Найквиста.
    //
    // **Он звенит на скачках.** Выброс дискретизованной ступеньки 14,114 %, а если на скачке стоит отсчёт со значением ½ —
    // 3,289 %. Ни то ни другое не 8,949 % по Гиббсу: это число относится к *непрерывной* ступеньке после фильтра. Но sinc ни
    // при чём: правильно дискретизованный сигнал с ограниченной полосой не звенит вовсе, что и измерено выше (E15).
    // %%
    let between = maximum(|x| Ideal.step_response(x), 0.0, 1.0, 16);
    let on_jump = maximum(|x| 0.5 * (Ideal.step_response(x) + Ideal.step_response(x - 1.0)), 1.0, 2.0, 16);
    println!("max f̃ − 1 = {:.3} %; f(0) = ½: {:.3} %", 100.0 * (between.value - 1.0), 100.0 * (on_jump.value - 1.0));
    prove([
        Residual::near("1.14114…", between.value, SAMPLED_PEAK.value, sum_rounding(8, 1.0)),
        Residual::near("1.03289…", on_jump.value, HALF_PEAK.value, sum_rounding(16, 1.0)),
    ])?;
    prove([1, 2, 8].into_iter().flat_map(sinc_energy_beyond))?;
    law(lang, "truncation-tone")?;
    law(lang, "sampled-step")?;

    // %%
    show(lang, "f24-problems", &[("f", "0.45")])?;

    // %% en
    // The way out is to leave room below Nyquist: under a Gaussian of the right width the series of an oversampled signal gains
    // the same share of a digit with every further sample.
    // %% ru
    // Выход — оставить запас до частоты Найквиста: с гауссовым множителем нужной ширины ряд передискретизованного сигнала с
    // каждым новым отсчётом прибавляет одну и ту же долю цифры.
    // %%
    law(lang, "regularised-series")?;
    show(lang, "x-truncation", &[("r", "0.5")])?;

    // %% en
    // **Exercise.** How many terms of the bare series are needed for three digits of a tone at 0.45 of the rate, and how many
    // with the Gaussian and twofold oversampling?
    // %% ru
    // **Упражнение.** Сколько членов простого ряда нужно, чтобы получить три цифры тона на 0,45 частоты дискретизации? А
    // сколько — с гауссианом и двукратной передискретизацией?

    // %% en
    // ## Kernels between the box and the sinc
    //
    // A kernel is judged by what it does below and above the Nyquist frequency: the smoothing
    // $S = 1 - \int_{|\nu|<1/2} K^2$ that it costs, the postaliasing $P = \int_{|\nu|>1/2} K^2$ that it lets through, and the
    // overshoot at a sampled step. No kernel of finite width has all three small (notebook 3, uncertainty).
    //
    // **Theorem** (Mitchell, Netravali 1988). The cubics $k_{B,C}$ reproduce constants, $\sum_i k(x - i) = 1$, for all $B, C$,
    // and straight lines exactly where $B + 2C = 1$.
    // %% ru
    // ## Ядра между прямоугольником и sinc
    //
    // О ядре судят по тому, что оно делает ниже и выше частоты Найквиста: какого сглаживания
    // $S = 1 - \int_{|\nu|<1/2} K^2$ оно стоит, сколько копий $P = \int_{|\nu|>1/2} K^2$ пропускает и каков выброс на
    // дискретизованной ступеньке. У ядра конечной ширины все три величины не бывают малы сразу (тетрадь 3, неопределённость).
    //
    // **Теорема** (Митчелл, Нетравали, 1988). Кубические ядра $k_{B,C}$ воспроизводят константы, $\sum_i k(x - i) = 1$, при всех
    // $B, C$, а прямые — только при $B + 2C = 1$.
    // %%
    println!("{:12} {:>6} {:>7} {:>10}", "", "S", "P", "max f̃ − 1");
    for name in ["box", "tent", "gaussian", "b-spline", "mitchell", "catmull-rom", "lanczos-3", "ideal"] {
        let m = Metrics::of(&*by_name(name)?);
        println!("{name:12} {:6.4} {:7.4} {:8.2} %", m.smoothing.abs(), m.postaliasing.abs(), 100.0 * m.overshoot);
    }
    prove([
        reproduces_constants(&Cubic::new(0.2, 0.9)?), // any B and C
        reproduces_lines(&Cubic::mitchell()),
        reproduces_lines(&Cubic::catmull_rom()),
    ])?;
    assert!(!reproduces_lines(&Cubic::new(0.0, 0.0)?).holds()); // B + 2C = 0
    law(lang, "cubic-order")?;

    // %%
    show(lang, "x-filters", &[("gaussian", "gaussian"), ("sinc", "lanczos-3")])?;

    // %%
    show(lang, "x-filters-pulse-chirp", &[("last", "lanczos-3")])?;

    // %%
    show(lang, "x-bc-plane", &[])?;

    // %% en
    // **Exercise.** Add `cubic:0.2,0.4` to the table. It keeps straight lines too; would you prefer it to Mitchell's for a
    // photograph, for a drawing?
    // %% ru
    // **Упражнение.** Добавьте в таблицу `cubic:0.2,0.4`. Это ядро тоже воспроизводит прямые; предпочли бы вы его ядру Митчелла
    // для фотографии, для чертежа?

    // %% en
    // ## All in one: the square closes
    //
    // Above is space, below is frequency; what is a product in one row is a convolution in the other. Going round one way or
    // the other must give the same: the spectrum of the reconstruction, computed from nothing but samples and the kernel's
    // response, is the signal's.
    // %% ru
    // ## Всё вместе: квадрат замкнулся
    //
    // Сверху — пространство, снизу — частота; что в одной строке произведение, то в другой свёртка. Каким путём ни иди,
    // результат один: спектр реконструкции, вычисленный только по отсчётам и отклику ядра, равен спектру сигнала.
    // %%
    {
        let samples = Samples::of(&rc, Axis::centered(0.4, 8001)?);
        let back = reconstruct(&samples, Ideal);
        let bound = raised_cosine_tail(1.0, 0.4, 4000) + sum_rounding(8001, 1.0);
        for nu in [0.0, 0.3, 0.9, 1.2, 2.5] {
            let (there, here) = (back.spectrum_at(nu), rc.spectrum().density(nu));
            println!("ν = {nu}: F̃ = {:.6}, F = {:.6}", there.re.abs(), here.re);
            prove([Residual::at_most("F̃ = F", (there - here).norm(), bound)])?;
        }
    }

    // %%
    show(lang, "f25-overview", &[("T", "0.4")])?;

    // %% en
    // **Exercise.** Repeat the cell with `TentKernel` instead of `Ideal`. At which of the frequencies does $\tilde F$ differ from
    // $F$ because the kernel smooths, and at which because it lets a copy through?
    // %% ru
    // **Упражнение.** Повторите ячейку с `TentKernel` вместо `Ideal`. На каких частотах $\tilde F$ отличается от $F$ из-за
    // сглаживания, а на каких — из-за пропущенной копии?

    Ok(())
}
