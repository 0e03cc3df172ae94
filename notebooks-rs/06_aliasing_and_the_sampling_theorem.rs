//! Aliasing, and the theorem of Nyquist, Shannon and Kotelnikov to the letter.
#![allow(clippy::print_stdout, reason = "a notebook prints")]

use nyquist::course::{law, prove, show};
use nyquist::laws::alias::{alias_energy, leaked_spectrum};
use nyquist::laws::generalised::{band_pass, band_pass_tail};
use nyquist::laws::poisson::sum_rounding;
use nyquist::num::cos_pi;
use nyquist::prelude::*;
use std::f64::consts::PI;

fn main() -> Result<()> {
    // %% en
    // # 6. Aliasing and the theorem of Nyquist, Shannon and Kotelnikov
    //
    // The chain of notebook 5 returns the signal if the copies of its spectrum do not overlap. This notebook lets them
    // overlap, measures the damage, and then reads the theorem to the letter, for the slide leaves out a condition.
    // %% ru
    // # 6. Алиасинг и теорема Найквиста–Шеннона–Котельникова
    //
    // Цепочка из тетради 5 возвращает сигнал, если копии его спектра не накладываются. В этой тетради мы дадим им
    // наложиться, измерим ущерб, а затем прочтём теорему буквально: на слайде недостаёт одного условия.
    // %%
    let lang = Lang::En;
    let rc = RaisedCosine::new(1.0)?; // RC(1): B = 1

    // %% en
    // ## What if the copies overlap?
    //
    // Copies are $1/T$ apart and $2B$ wide. They overlap when $T$ is too *large*, $1/T < 2B$; the slide's “if $T$ is not large
    // enough” is the wrong way round (E07). A frequency $\nu$ beyond the Nyquist frequency lands on
    // $|\nu - k/T|$, and whole stretches of the band are folded over like paper.
    // %% ru
    // ## Что, если копии пересекаются?
    //
    // Копии отстоят на $1/T$, ширина каждой $2B$. Накладываются они тогда, когда $T$ слишком *велико*, $1/T < 2B$; слова
    // слайда «если $T$ недостаточно большой» — наоборот (E07). Частота $\nu$ за частотой Найквиста попадает в
    // $|\nu - k/T|$, и целые куски полосы складываются, как лист бумаги.
    // %%
    println!("1/T = 1.25: {:?}", Verdict::on(&rc.spectrum(), 1.25)?);
    for piece in landings(1.0, 1.25)? {
        println!("{:?} → {:?}", piece.from, piece.to);
        prove([Residual::near("f_a", piece.to[1], fold(piece.from[1], 1.25), 2.0 * f64::EPSILON)])?;
    }

    // %%
    show(lang, "f26-undersampled", &[("T", "0.8")])?;

    // %% en
    // **Exercise.** Where does the band $(0, 1)$ land at the rate 0.7? How many times is it folded?
    // %% ru
    // **Упражнение.** Куда попадёт полоса $(0, 1)$ при частоте дискретизации 0,7? Сколько раз она сложится?

    // %% en
    // ## High frequencies leak into low ones
    //
    // The ideal low-pass keeps everything inside $\pm\tfrac1{2T}$: the signal's own spectrum and the tails of its neighbours,
    // $$\tilde F(\nu) = \Pi_{1/T}(\nu)\sum_k F(\nu - k/T).$$
    // Alias means a mask: high frequencies wear that of low ones. The reconstruction still passes through every sample, so
    // nothing in the samples gives it away. (The book's drawing cuts off the central copy and leaves the leaked tails out,
    // that is, the alias itself: E30. The third column below, $F^{-1}\{\Pi F\}$, is that wrong curve.)
    // %% ru
    // ## Высокие частоты «протекают» в низкие
    //
    // Идеальный фильтр оставляет всё внутри $\pm\tfrac1{2T}$: собственный спектр сигнала и хвосты соседних копий,
    // $$\tilde F(\nu) = \Pi_{1/T}(\nu)\sum_k F(\nu - k/T).$$
    // Alias — это маска: высокие частоты выступают под маской низких. Реконструкция по-прежнему проходит через все отсчёты,
    // и по ним подмену не заметить. (В рисунке книги просто обрезана центральная копия, а протёкшие хвосты, то есть сам
    // алиас, не нарисованы: E30. Третий столбец ниже, $F^{-1}\{\Pi F\}$, — та неверная кривая.)
    // %%
    {
        let f = Gaussian::with_spectrum(8.0)?; // the lecture's: F = e^{−8ν²}, T = 1
        let (leaked, cut) = (leaked_spectrum(&f.spectrum(), 1.0)?, f.spectrum().low_passed(0.5)?);
        let samples = Samples::of(&f, Axis::centered(1.0, 41)?);
        let series = reconstruct(&samples, Ideal);
        for x in [0.0, 0.5, 1.0, 1.5] {
            let (from_spectrum, wrong) = (leaked.inverse_at(x)?.re, cut.inverse_at(x)?.re);
            println!("x = {x:.1}: f = {:.5}, f̃ = {:.5}, F⁻¹{{Π·F}} = {wrong:.5}", f.at(x), series.at(x));
            // two ways to the same curve: the low-passed sum of the copies, and the cardinal series
            prove([Residual::near("F⁻¹{F̃} = Σf(k)·sinc(x − k)", from_spectrum, series.at(x), sum_rounding(128, 1.0))])?;
        }
        println!("F(0.4) = {:.5}, F̃(0.4) = {:.5}", f.spectrum().density(0.4).re, leaked.density(0.4).re);
    }

    // %%
    show(lang, "f27-overlap", &[("T", "1")])?;

    // %%
    show(lang, "f28-leak", &[("T", "1")])?;

    // %% en
    // **Exercise.** Draw the last figure for `("T", "1.5")`. Where does the reconstruction agree with the signal, and why
    // exactly there?
    // %% ru
    // **Упражнение.** Постройте последний рисунок для `("T", "1.5")`. Где реконструкция совпадает с сигналом и почему именно
    // там?

    // %% en
    // ## How large is the error, and which step is needed?
    //
    // **Theorem.** As long as $1/T \ge B$, what folds into the band has exactly the energy of what was lost beyond it:
    // $$\|\tilde f - f\|^2 = 2\int_{|\nu| > 1/2T}|F|^2\,d\nu.$$
    // The pieces beyond the edge fold to separate places, so they keep their energy. And at every single point
    // $|\tilde f - f| \le 2\int_{|\nu| > 1/2T}|F|\,d\nu$. Both are zero as soon as $1/T \ge 2B$. The cell
    // prints what was lost + what folded.
    // %% ru
    // ## Какова ошибка и какой нужен шаг?
    //
    // **Теорема.** Пока $1/T \ge B$, у завернувшегося в полосу ровно та же энергия, что у потерянного за её краем:
    // $$\|\tilde f - f\|^2 = 2\int_{|\nu| > 1/2T}|F|^2\,d\nu.$$
    // Куски за краем попадают в разные места и потому сохраняют энергию. А в каждой отдельной точке
    // $|\tilde f - f| \le 2\int_{|\nu| > 1/2T}|F|\,d\nu$. Обе величины равны нулю, как только $1/T \ge 2B$. Ячейка печатает
    // потерянное + завернувшееся.
    // %%
    for step in [0.4, 0.5, 0.6, 0.8, 1.0, 1.25] {
        let energy = alias_energy(&rc.spectrum(), step)?;
        // without the sign that rounding leaves to nothing
        let [lost, folded, relative] = [energy.lost, energy.folded, energy.relative()].map(f64::abs);
        println!("T = {step:4}: {lost:.6} + {folded:.6}, ‖f̃ − f‖²/‖f‖² = {relative:.6}");
    }
    law(lang, "alias-energy")?;
    law(lang, "pointwise-alias")?;

    // %% en
    // The last line, $T = 1.25$, is beyond the theorem: $1/T < B$, the folded pieces meet each other, and the two halves differ.
    // %% ru
    // Последняя строка, $T = 1{,}25$, уже вне условий теоремы: $1/T < B$, завернувшиеся куски встречаются друг с другом, и
    // половины не равны.
    // %%
    show(lang, "f29-step", &[("B", "1")])?;

    // %% en
    // **Exercise.** At which rate is the error of RC(1) one per cent in the root mean square? (The table has energies.)
    // %% ru
    // **Упражнение.** При какой частоте дискретизации среднеквадратичная ошибка для RC(1) равна одному проценту? (В таблице —
    // энергии.)

    // %% en
    // ## The theorem to the letter
    //
    // **Theorem.** Let $F = 0$ for $|\nu| > B$.
    //
    // 1. A signal of finite energy is determined by its samples at any rate $f_s \ge 2B$, *equality included*.
    // 2. A signal with a line at $B$, a tone, needs $f_s > 2B$. At $f_s = 2B$ the samples of $\cos(2\pi Bx + \varphi)$ are
    //    $(-1)^k\cos\varphi$: amplitude and phase cannot be told apart, and of the sine nothing is left.
    //
    // The slide's “at least $2B$” is right in the first case and wrong in the second (E08), and so $f_s/2$ is a limit that no
    // tone attains, not “the highest frequency that can be reproduced”; its letter $B$ is a bandwidth in one line and a rate
    // in the next (E09). Two names are easily swapped: the Nyquist *rate* $2B$ belongs to a signal, the Nyquist *frequency*
    // $f_s/2$ to a rate (E36). And unsaid: infinitely many samples, exact values, and the sinc.
    // %% ru
    // ## Теорема — буквально
    //
    // **Теорема.** Пусть $F = 0$ при $|\nu| > B$.
    //
    // 1. Сигнал конечной энергии определяется отсчётами с любой частотой $f_s \ge 2B$, *включая равенство*.
    // 2. Сигналу с линией на $B$, то есть тону, нужно $f_s > 2B$. При $f_s = 2B$ отсчёты $\cos(2\pi Bx + \varphi)$ равны
    //    $(-1)^k\cos\varphi$: амплитуду и фазу не разделить, а от синуса не остаётся ничего.
    //
    // «Как минимум $2B$» на слайде верно в первом случае и неверно во втором (E08); поэтому $f_s/2$ — предел, которого ни один
    // тон не достигает, а не «максимальная частота, которую можно воспроизвести», причём буква $B$ в одной строке — полоса, а
    // в следующей — частота дискретизации (E09). Легко спутать два английских термина: Nyquist *rate*
    // — наименьшая частота дискретизации сигнала, $2B$, а Nyquist *frequency*, частота Найквиста, — половина частоты
    // дискретизации, $f_s/2$ (E36). И не сказано, что нужны бесконечно
    // много отсчётов, точные значения и sinc.
    // %%
    for degrees in [0.0, 30.0, 60.0, 90.0f64] {
        let phi = degrees.to_radians();
        let tone = Cosine::with_phase(0.5, phi)?; // B = ½, f_s = 1 = 2B
        let samples = Samples::of(&tone, Axis::new(0.0, 1.0, 64)?);
        let back = reconstruct(&samples, Ideal).edge(Edge::Wrap);
        println!("φ = {degrees:2}°: f̃ = {:.4}·cos πx", back.at(0.0).abs());
        // the phase in turns, and 64 terms of the sum
        let bound = sum_rounding(64, 1.0);
        prove([Residual::near("cos φ·cos πx", back.at(0.25), phi.cos() * cos_pi(0.25), bound)])?;
    }
    println!("cos πx, 1/T = 1:   {:?}", Verdict::on(&Cosine::new(0.5)?.spectrum(), 1.0)?);
    println!("RC(1), 1/T = 2:    {:?}", Verdict::on(&rc.spectrum(), 2.0)?);
    println!("RC(1), 1/T = 1.75: {:?}", Verdict::on(&rc.spectrum(), 1.75)?);

    // %%
    show(lang, "f30-theorem", &[("phi", "60"), ("rate", "2.05")])?;

    // %% en
    // **Exercise.** Hearing ends at 20 kHz. Why is the compact disc sampled at 44.1 kHz and not at 40?
    // %% ru
    // **Упражнение.** Слух кончается на 20 кГц. Почему у компакт-диска частота дискретизации 44,1 кГц, а не 40?

    // %% en
    // ## A rising tone comes back falling
    //
    // The lecture's $1 + \cos 4\pi x^2$ has the local frequency $4x$ and is sampled at 8. At $x = 1$ it reaches the Nyquist
    // frequency, and its samples turn round: $4\pi(k/8)^2 = \pi k^2/16$ depends on $k^2 \bmod 32$ alone, so they are the mirror
    // image about $x = 1$ and repeat with the period 2, *exactly*.
    // %% ru
    // ## Растущая частота возвращается убывающей
    //
    // У сигнала лекции $1 + \cos 4\pi x^2$ местная частота $4x$, частота дискретизации 8. При $x = 1$ достигается частота
    // Найквиста, и отсчёты поворачивают назад: $4\pi(k/8)^2 = \pi k^2/16$ зависит только от $k^2 \bmod 32$, поэтому они
    // зеркальны относительно $x = 1$ и повторяются с периодом 2 — *в точности*.
    // %%
    {
        let samples = Samples::of(&LectureChirp, Axis::new(0.0, 0.125, 33)?);
        let v = samples.values();
        let mirrored = (0..=8).map(|k| (v[8 + k] - v[8 - k]).abs()).fold(0.0, f64::max);
        let repeated = (0..=16).map(|k| (v[16 + k] - v[k]).abs()).fold(0.0, f64::max);
        prove([
            Residual::at_most("f(1 + t) = f(1 − t)", mirrored, 0.0),
            Residual::at_most("f(x + 2) = f(x)", repeated, 0.0),
        ])?;
        for x in [0.5, 1.5, 2.5] {
            println!("x = {x}: 4x = {} → {}", 4.0 * x, fold(4.0 * x, 8.0));
        }
    }

    // %%
    show(lang, "x-chirp", &[("rate", "8")])?;

    // %% en
    // **Exercise.** Predict the figure for the rates 4 and 16: where is the first mirror, and what is the period?
    // %% ru
    // **Упражнение.** Предскажите рисунок для частот 4 и 16: где первое зеркало и каков период?

    // %% en
    // ## An edge has no Nyquist rate
    //
    // An edge falls like $1/\nu$ and never ends. What a rate $1/T$ loses of the box,
    // $$2\int_{1/2T}^\infty \mathrm{sinc}^2\nu\,d\nu \approx \frac{2T}{\pi^2},$$
    // falls only like $T$: sampling twice as fast halves the energy of the error, and no rate is fast enough. So images with
    // edges always alias, and the question is only how much: that is where prefilters begin (notebook 7).
    // %% ru
    // ## У границы нет достаточной частоты
    //
    // Спектр границы убывает как $1/\nu$ и не кончается. То, что частота $1/T$ теряет у прямоугольника,
    // $$2\int_{1/2T}^\infty \mathrm{sinc}^2\nu\,d\nu \approx \frac{2T}{\pi^2},$$
    // убывает лишь как $T$: вдвое более частые отсчёты вдвое уменьшают энергию ошибки, и никакой частоты не хватит. Поэтому
    // изображения с границами искажены алиасингом всегда, и вопрос лишь в том, насколько: отсюда и предфильтры (тетрадь 7).
    // %%
    {
        let spectrum = Boxcar::new(1.0)?.spectrum();
        for step in [0.5, 0.25, 0.125, 0.0625] {
            let half = 0.5 / step;
            let lost = 1.0 - spectrum.energy(-half, half);
            println!("T = {step:6}: 1 − ∫|F|² = {lost:.5}, 2T/π² = {:.5}", 2.0 * step / (PI * PI));
            // what was left out, ∫cos 2πν/(πν)², is below 1/(π³h²) by the second mean value theorem
            prove([Residual::near("2T/π²", lost, 2.0 * step / (PI * PI), 1.0 / (PI.powi(3) * half * half))])?;
        }
    }

    // %% en
    // **Exercise.** The same for the tent, whose spectrum falls like $1/\nu^2$: which power of $T$ does its loss follow? Replace
    // `Boxcar` by `Tent` (whose energy is $\tfrac23$) and look.
    // %% ru
    // **Упражнение.** То же для треугольника, спектр которого убывает как $1/\nu^2$: какой степени $T$ пропорциональна потеря?
    // Замените `Boxcar` на `Tent` (его энергия $\tfrac23$) и посмотрите.

    // %% en
    // ## Below twice the highest frequency
    //
    // Only copies that overlap do harm. A signal whose band lies between $f_L$ and $f_H$ needs no rate above $2f_H$: its copies
    // miss each other exactly at
    // $$\frac{2f_H}{n} \le f_s \le \frac{2f_L}{n - 1}, \qquad 1 \le n \le \Bigl\lfloor\frac{f_H}{f_H - f_L}\Bigr\rfloor.$$
    // For the band from 21 to 24 the rate 8.2 will do, and 9, although faster, will not (Vaughan, Scott, White 1991).
    // %% ru
    // ## Реже удвоенной высшей частоты
    //
    // Вредят только наложенные копии. Сигналу с полосой между $f_L$ и $f_H$ не нужна частота выше $2f_H$: его копии не задевают
    // друг друга ровно при
    // $$\frac{2f_H}{n} \le f_s \le \frac{2f_L}{n - 1}, \qquad 1 \le n \le \Bigl\lfloor\frac{f_H}{f_H - f_L}\Bigr\rfloor.$$
    // Для полосы от 21 до 24 частоты 8,2 достаточно, а 9, хотя это и чаще, не годится (Vaughan, Scott, White, 1991).
    // %%
    for interval in bandpass_rates(21.0, 24.0)?.iter().rev().take(4) {
        println!("n = {}: {:.3} ≤ f_s ≤ {:.3}", interval.n, interval.low, interval.high);
    }
    {
        // RC(1.5) on a carrier at 22.5: nothing outside 21 … 24
        let f = Modulated::new(22.5, RaisedCosine::new(1.5)?)?;
        let places: Vec<f64> = (0..=100).map(|i| 0.02 * f64::from(i) - 1.0).collect();
        for rate in [8.2, 9.0, 10.0] {
            let band = BandPass::new(Samples::of(&f, Axis::centered(1.0 / rate, 8001)?), 21.0..24.0)?;
            println!("f_s = {rate}: f(0.12) = {:.6}, f̃(0.12) = {:.6}", f.at(0.12), band.at(0.12));
            let restored = band_pass(&f, 21.0..24.0, rate, 4000, &places, band_pass_tail(1.5, 1.0 / rate, 4000))?;
            assert_eq!(restored.holds(), band.recoverable());
            if restored.holds() {
                prove([restored])?;
            } else {
                println!("✗ max|f̃ − f| = {:.2}", restored.measured);
            }
        }
    }
    law(lang, "band-pass")?;

    // %%
    show(lang, "x-bandpass", &[("rate", "8.2")])?;

    // %% en
    // **Exercise.** Choose a rate for the band from 100 to 103 that leaves as much room as possible on both sides for a real
    // filter. How far may the clock be off?
    // %% ru
    // **Упражнение.** Выберите для полосы от 100 до 103 частоту дискретизации с наибольшим запасом по обе стороны, чтобы
    // хватило реальному фильтру. Насколько может ошибаться тактовый генератор?

    Ok(())
}
