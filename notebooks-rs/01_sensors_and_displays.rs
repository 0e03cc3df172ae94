//! Sensors and displays: where sampling and reconstruction happen, and what goes wrong between them.
#![allow(clippy::print_stdout, reason = "a notebook prints")]

use nyquist::course::{law, prove, show};
use nyquist::laws::poisson::sum_rounding;
use nyquist::num::{cos_pi, sin_pi, sinc};
use nyquist::prelude::*;
use std::f64::consts::PI;

fn main() -> Result<()> {
    // %% en
    // # 1. Sensors and displays
    //
    // A sensor turns a continuous picture into numbers; a display turns numbers back into a continuous picture. This
    // notebook looks at both ends, at what goes wrong in images between them, and at the one cause behind it all.
    //
    // Run the cells from top to bottom. `show` draws a figure of the lecture, `prove` and `law` print what was *measured*
    // beside what theory *allows*: `✓ measured · allowed`. The names E01, E02, … are those of the list of corrections to
    // the lecture's slides. Everywhere $\nu$ is an ordinary frequency, in cycles per unit, and
    // $\mathrm{sinc}\,t = \sin(\pi t)/(\pi t)$.
    // %% ru
    // # 1. Сенсоры и дисплеи
    //
    // Сенсор превращает непрерывную картину в числа, дисплей превращает числа обратно в непрерывную картину. Эта тетрадь —
    // об обоих концах пути, о том, что портится в изображении между ними, и об общей причине всех этих бед.
    //
    // Выполняйте ячейки сверху вниз. `show` рисует иллюстрацию лекции, `prove` и `law` печатают, что *измерено* и сколько
    // *допускает* теория: `✓ измерено · допустимо`. Обозначения E01, E02, … взяты из списка поправок к слайдам лекции.
    // Всюду $\nu$ — обычная частота, в периодах на единицу длины, а $\mathrm{sinc}\,t = \sin(\pi t)/(\pi t)$.
    // %%
    let lang = Lang::En;

    // %% en
    // ## A pixel is a filter and then a sample
    //
    // **Theorem.** A pixel of width $a$ returns the mean of the light on it,
    // $$R_i = \frac1a\int_{iT-a/2}^{iT+a/2} E(x)\,dx = (E \otimes \mathrm{box}_a)(iT),$$
    // a point sample of a picture that has been blurred by a box. A tone of frequency $\nu$ keeps
    // $\mathrm{sinc}(a\nu)$ of its amplitude: at the Nyquist frequency, with pixels that leave no gap, $2/\pi = 0.6366$.
    //
    // So the lecture's two statements, “sensors integrate over an area” and “sampling reads the signal at points”, are
    // both true, one after the other (E18).
    // %% ru
    // ## Пиксель — сначала фильтр, потом отсчёт
    //
    // **Теорема.** Пиксель ширины $a$ возвращает среднее упавшего на него света,
    // $$R_i = \frac1a\int_{iT-a/2}^{iT+a/2} E(x)\,dx = (E \otimes \mathrm{box}_a)(iT),$$
    // то есть точечный отсчёт картины, размытой прямоугольным фильтром. От тона частоты $\nu$ остаётся доля
    // $\mathrm{sinc}(a\nu)$: на частоте Найквиста, если между пикселями нет зазоров, $2/\pi = 0{,}6366$.
    //
    // Значит, верны оба утверждения лекции — и «сенсоры интегрируют по площади», и «дискретизация читает сигнал в
    // точках»: сначала одно, потом другое (E18).
    // %%
    let tone = Grating::new([0.5, 0.0])?; // half a cycle a pixel: the Nyquist frequency
    for a in [0.25, 0.5, 1.0, 1.5] {
        let read = tone.mean([-0.5 * a, 0.5 * a], [0.0, 1.0]); // one pixel, its middle on a crest
        println!("a = {a:.2}: R = {read:.4}");
        prove([Residual::near("R = sinc(a/2)", read, sinc(0.5 * a), 4.0 * f64::EPSILON)])?;
    }

    // %%
    show(lang, "f01-pixels", &[("a", "1"), ("f", "0.9")])?;

    // %% en
    // On the left the fine grating, 0.9 cycles a pixel, comes back as a slow wave of 0.1 whichever way it is read; the
    // pixel's area only makes it weaker.
    //
    // **Exercise.** Which width of the pixel makes the tone of the cell above vanish completely, and why can no sensor
    // be built so? (`nyquist exercise start` has more of this kind, and checks the answers.)
    // %% ru
    // Слева мелкая решётка, 0,9 периода на пиксель, в любом случае возвращается медленной волной с частотой 0,1; площадь
    // пикселя лишь ослабляет её.
    //
    // **Упражнение.** При какой ширине пикселя тон из ячейки выше исчезнет совсем и почему такой сенсор не построить?
    // (В `nyquist exercise start` таких упражнений много, и ответы проверяются.)

    // %% en
    // ## Where the pixels stand: the chip and the eye
    //
    // A chip's pixels form a lattice. The cones of the eye keep their distance but no order (Yellott 1983). The power of
    // $N$ sampling points at the frequency $\mathbf u$ is
    // $$P(\mathbf u) = \frac1N\Bigl|\sum_{j=1}^N e^{-i2\pi\mathbf u\cdot\mathbf x_j}\Bigr|^2.$$
    // A lattice has $P = N$ at every multiple of its own frequency: each of these peaks will make a false copy of the
    // picture's spectrum. Points without order have $P \approx 1$ there: what is too fine becomes noise, not a false
    // pattern. We come back to this in notebook 8.
    // %% ru
    // ## Где стоят пиксели: матрица и глаз
    //
    // Пиксели матрицы стоят решёткой. Колбочки глаза держат расстояние, но не порядок (Йеллот, 1983). Мощность $N$ точек
    // дискретизации на частоте $\mathbf u$ равна
    // $$P(\mathbf u) = \frac1N\Bigl|\sum_{j=1}^N e^{-i2\pi\mathbf u\cdot\mathbf x_j}\Bigr|^2.$$
    // У решётки $P = N$ на каждой кратной её собственной частоты, и каждый такой пик создаст ложную копию спектра картины.
    // У точек без порядка там $P \approx 1$: слишком мелкое становится шумом, а не ложным узором. К этому мы вернёмся в
    // тетради 8.
    // %%
    {
        let power = |points: &[[f64; 2]], u: f64| {
            let turns = points.iter().map(|p| 2.0 * u * p[0]);
            let (c, s) = turns.fold((0.0, 0.0), |(c, s), t| (c + cos_pi(t), s + sin_pi(t)));
            (c * c + s * s) / points.len() as f64
        };
        let lattice = Regular::<2>::new([32, 32])?.points(1);
        let disks = PoissonDisk::with_about(1024)?;
        let cones = disks.points(1);
        // the lattice, then the cones
        println!("N = {}, P(32, 0) = {:.1}", lattice.len(), power(&lattice, 32.0));
        println!("N = {}, P(32, 0) = {:.1}", cones.len(), power(&cones, 32.0));
        let n = lattice.len();
        prove([
            Residual::near("P(32, 0) = N", power(&lattice, 32.0), n as f64, sum_rounding(n, 4.0 * n as f64)),
            Residual::at_least("|x_i − x_j| ≥ r", min_distance_torus(&cones)?, disks.radius()),
        ])?;
    }

    // %%
    show(lang, "f01-sensor", &[])?;

    // %% en
    // **Exercise.** Print `power(&cones, u)` for `u` from 1 to 64. Where is it far below 1, and where does it rise above?
    // Which of the two properties protects the eye from moiré, and which keeps slow shading free of noise?
    // %% ru
    // **Упражнение.** Напечатайте `power(&cones, u)` для `u` от 1 до 64. Где мощность гораздо меньше 1, а где поднимается
    // выше? Какое из этих двух свойств защищает глаз от муара, а какое — плавные переходы тона от шума?

    // %% en
    // ## A display is a reconstruction
    //
    // **Theorem.** A display puts a light of finite size $k$ in place of every sample, so the spectrum of what we see is
    // that of the samples, with all its copies, times the response $K$ of the light. A held sample (a box one step wide)
    // lets the first image of a tone at $f$ through with
    // $$\frac{K(1-f)}{K(f)} = \frac{\mathrm{sinc}(1-f)}{\mathrm{sinc}(f)} = \frac{f}{1-f}$$
    // of the tone's amplitude. A Gaussian spot lets almost nothing through.
    // %% ru
    // ## Дисплей — это реконструкция
    //
    // **Теорема.** Дисплей ставит на место каждого отсчёта источник света конечного размера $k$, поэтому спектр видимого —
    // это спектр отсчётов со всеми его копиями, умноженный на отклик $K$ источника. Удержание отсчёта (прямоугольник
    // шириной в шаг) пропускает первую копию тона $f$ с долей
    // $$\frac{K(1-f)}{K(f)} = \frac{\mathrm{sinc}(1-f)}{\mathrm{sinc}(f)} = \frac{f}{1-f}$$
    // его амплитуды. Гауссово пятно не пропускает почти ничего.
    // %%
    {
        let samples = Samples::of(&Cosine::new(0.1)?, Axis::nodes(0.0..100.0, 100)?);
        let (held, spots) = (
            reconstruct(&samples, BoxKernel),
            reconstruct(&samples, GaussianKernel::new(0.5, 4.0)?), // σ = half a step
        );
        let held = held.spectrum_at(0.9).norm() / held.spectrum_at(0.1).norm();
        let spots = spots.spectrum_at(0.9).norm() / spots.spectrum_at(0.1).norm();
        println!("K(0.9)/K(0.1) = {held:.4} (BoxKernel), {spots:.4} (GaussianKernel)");
        prove([Residual::near("f/(1 − f) = 1/9", held, 1.0 / 9.0, sum_rounding(100, 1.0))])?;
    }
    law(lang, "V28")?;

    // %%
    show(lang, "f02-display", &[("f", "0.1")])?;

    // %% en
    // **Exercise.** At which frequency is the first image half as strong as the tone? Check it with
    // `("f", "…")` in the last cell. Why does a digital audio player need an analogue filter behind its converter?
    // %% ru
    // **Упражнение.** При какой частоте первая копия вдвое слабее тона? Проверьте, изменив `("f", "…")` в последней
    // ячейке. Зачем цифровому плееру аналоговый фильтр после преобразователя?

    // %% en
    // ## What goes wrong: staircases and moiré
    //
    // One sample a pixel knows only inside or outside, so a straight edge becomes a staircase: at the angle $\theta$ its
    // treads are $\cot\theta$ pixels long on average, 28.6 at 2°. And where a texture is finer than the pixels, rings
    // appear around centres that do not exist: the zone plate
    // $$f(x, y) = \tfrac12 + \tfrac12\cos\frac{\pi(x^2 + y^2)}{M}$$
    // sampled at the integers is *exactly* periodic with the period $M$ if $M$ is even, because
    // $(x + M)^2 - x^2 = 2Mx + M^2$ turns the phase by whole periods.
    // %% ru
    // ## Что портится: «лестница» и муар
    //
    // Единственный отсчёт знает лишь «внутри» или «снаружи», поэтому прямая граница превращается в лестницу: при угле
    // $\theta$ длина ступени в среднем $\cot\theta$ пикселей, при 2° это 28,6. А там, где текстура мельче пикселей,
    // появляются кольца вокруг несуществующих центров: зонная пластинка
    // $$f(x, y) = \tfrac12 + \tfrac12\cos\frac{\pi(x^2 + y^2)}{M}$$
    // в целых точках *в точности* периодична с периодом $M$, если $M$ чётно, ведь
    // $(x + M)^2 - x^2 = 2Mx + M^2$ поворачивает фазу на целое число оборотов.
    // %%
    {
        let slope = 2f64.to_radians().tan();
        let edge = HalfPlane::through([0.0, 0.3], 2f64.to_radians())?;
        let (points, means) = {
            let grid = Grid::pixels(600, 24)?;
            (Image::of(&edge, grid), Image::averaged(&edge, grid))
        };
        // how high the dark part stands in a column
        let height = |image: &Image, i: usize| (0..24).map(|j| image.at(i, j)).sum::<f64>();
        let jumps = (1..600).filter(|&i| height(&points, i) != height(&points, i - 1)).count();
        println!("600/{jumps} = {:.1}, cot θ = {:.1}", 600.0 / jumps as f64, 1.0 / slope);
        let worst = (0..600).map(|i| (height(&means, i) - 0.3 - slope * (i as f64 + 0.5)).abs());
        prove([
            Residual::near("N·tan θ", jumps as f64, 600.0 * slope, 1.0), // a stair may begin on either side
            Residual::at_most("Σ R = y(x)", worst.fold(0.0, f64::max), sum_rounding(24, 24.0)),
        ])?;

        let plate = ZonePlate::new(64.0)?;
        let grid = Grid::centered(1.0, 192, 192)?; // its centre is pixel (96, 96)
        let (points, means) = (Image::of(&plate, grid), Image::averaged(&plate, grid));
        println!("f(0, 0) = {:.3}, f(M, 0) = {:.3}", points.at(96, 96), points.at(160, 96));
        println!("R(0, 0) = {:.3}, R(M, 0) = {:.3}", means.at(96, 96), means.at(160, 96));
        prove([Residual::near("f(M, 0) = f(0, 0)", points.at(160, 96), points.at(96, 96), 0.0)])?;
    }

    // %%
    show(lang, "f03-jaggies", &[("flat", "2")])?;

    // %%
    show(lang, "f03-moire", &[("M", "64")])?;

    // %% en
    // The mean over the pixel (right) puts the fractions back into the edge and dims the ghosts, but it does not remove
    // them all: its transfer is a sinc, not a low-pass (E13).
    //
    // **Exercise.** Where does the picture repeat for $M = 48$? And for $M = 63$, which is odd? Predict, then look.
    // %% ru
    // Среднее по пикселю (справа) возвращает границе дробные части и приглушает ложные центры, но убирает их не все: его
    // передаточная функция — sinc, а не идеальный фильтр (E13).
    //
    // **Упражнение.** Где повторится картинка при $M = 48$? А при нечётном $M = 63$? Сначала предскажите, потом проверьте.

    // %% en
    // ## What goes wrong: small objects and highlights flicker
    //
    // A disc of radius $r < \tfrac12$ is hit by the one sample of a pixel with the probability $\pi r^2$: it blinks when it
    // moves. Its mean over the pixels spreads the same light over all that it touches, so the sum over the pixels is
    // $\pi r^2$ in *every* frame. The same happens to highlights narrower than a pixel.
    // %% ru
    // ## Что портится: мелкие объекты и блики мерцают
    //
    // Единственный отсчёт пикселя попадает в диск радиуса $r < \tfrac12$ с вероятностью $\pi r^2$, и при движении диск
    // мигает. Среднее по площади распределяет тот же свет по всем задетым пикселям, и сумма по пикселям равна $\pi r^2$ в
    // *каждом* кадре. То же происходит с бликами уже пикселя.
    // %%
    {
        let (r, frames) = (0.3, 4096);
        let p = PI * r * r;
        let (mut hits, mut worst) = (0.0, 0.0f64);
        for [x, y] in Random::new(frames)?.points(1) {
            let disc = Disc::new([1.0 + x, 1.0 + y], r)?; // somewhere in the middle of 3×3 pixels
            let grid = Grid::pixels(3, 3)?;
            hits += Image::of(&disc, grid).values().iter().sum::<f64>();
            let light: f64 = Image::averaged(&disc, grid).values().iter().sum();
            worst = worst.max((light - p).abs());
        }
        println!("πr² = {p:.4}, P = {:.4}", hits / frames as f64);
        let deviation = (p * (1.0 - p) / frames as f64).sqrt();
        prove([
            Residual::near("P = πr²", hits / frames as f64, p, 4.0 * deviation),
            // 16ε(1 + r) for each of the nine areas
            Residual::at_most("Σ R = πr²", worst, 9.0 * 16.0 * f64::EPSILON * (1.0 + r)),
        ])?;
    }

    // %%
    show(lang, "f03-small-objects", &[("r", "0.3")])?;

    // %%
    show(lang, "f03-highlights", &[])?;

    // %% en
    // **Exercise.** A star is much smaller than a pixel. How many samples a pixel are needed for it to be hit in nine
    // frames of ten, if the samples are independent? What would its mean over the pixel cost?
    // %% ru
    // **Упражнение.** Звезда гораздо меньше пикселя. Сколько независимых отсчётов на пиксель нужно, чтобы попадать в неё в
    // девяти кадрах из десяти? А чего стоило бы среднее по пикселю?

    // %% en
    // ## What goes wrong: strobing
    //
    // Time is sampled too. A wheel of $m$ spokes at $n$ turns a second repeats $mn$ times a second, and a film at $f_s$
    // frames shows the frequency nearest to it in the band $(-f_s/2, f_s/2]$: the signed alias
    // $mn - f_s\,\mathrm{round}(mn/f_s)$. A negative one turns backwards. An open shutter is a box in time, a prefilter:
    // it damps, and does not remove.
    // %% ru
    // ## Что портится: стробирование
    //
    // Дискретизуется и время. Колесо с $m$ спицами при $n$ оборотах в секунду повторяется $mn$ раз в секунду, а фильм с
    // $f_s$ кадрами показывает ближайшую к этому частоту из полосы $(-f_s/2, f_s/2]$, то есть алиас со знаком
    // $mn - f_s\,\mathrm{round}(mn/f_s)$. Отрицательный вращается назад. Открытый затвор — прямоугольник во времени, то есть
    // предфильтр: он ослабляет, но не устраняет.
    // %%
    for turns in [1.4, 1.6, 2.9, 3.0, 3.1] {
        let seen = Alias::of(8.0 * turns, 24.0)?.signed() / 8.0;
        println!("n = {turns:.1}: n′ = {seen:+.1}");
    }
    // 23.2 = 2.9·8 is known to 1ε·23.2, and the rest is exact
    prove([Residual::near("n′ = −0.1", Alias::of(8.0 * 2.9, 24.0)?.signed() / 8.0, -0.1, 4.0 * f64::EPSILON)])?;
    law(lang, "V29")?;

    // %%
    show(lang, "f03-strobing", &[("turns", "2.9"), ("spokes", "8")])?;

    // %% en
    // **Exercise.** At which speeds does the wheel seem to stand still, and at which do the spokes seem twice as many?
    // %% ru
    // **Упражнение.** При каких скоростях колесо кажется неподвижным, а при каких спиц кажется вдвое больше?

    // %% en
    // ## Antialiasing: filter first, then sample
    //
    // All these are one fault. What is too fast for the rate does not vanish when it is sampled: it comes back as
    // something slow. So it must be taken away *before* sampling; afterwards nothing can tell it from the truth.
    //
    // Below a tone at 0.4 of the rate loses every second sample, once as it is and once behind an ideal low-pass at the
    // new Nyquist frequency $\tfrac14$.
    // %% ru
    // ## Антиалиасинг: сначала фильтр, потом отсчёты
    //
    // Всё это — одна беда. Слишком быстрое для выбранной частоты при дискретизации не исчезает, а возвращается чем-то
    // медленным. Значит, убирать его надо *до* дискретизации: потом его уже ничем не отличить от правды.
    //
    // Ниже тон с частотой 0,4 от частоты дискретизации теряет каждый второй отсчёт: один раз как есть, другой — после
    // идеального фильтра низких частот до новой частоты Найквиста $\tfrac14$.
    // %%
    {
        let fine = Samples::of(&Cosine::new(0.4)?, Axis::nodes(0.0..200.0, 200)?);
        let bare = fine.decimated(2)?;
        let filtered = inverse(&forward(&fine).low_passed(0.25)?).decimated(2)?;
        // the amplitude of a tone is twice its line's share of the record
        let seen = |samples: &Samples| 2.0 * forward(samples).near(0.1).norm() / samples.axis().span();
        println!("A(0.1) = {:.4}, Π: A(0.1) = {:.4}", seen(&bare), seen(&filtered));
        prove([
            Residual::near("0.4 → 0.1", fold(0.4, 0.5), 0.1, f64::EPSILON),
            Residual::near("A(0.1) = 1", seen(&bare), 1.0, sum_rounding(200, 1.0)),
            Residual::near("Π: A(0.1) = 0", seen(&filtered), 0.0, sum_rounding(200, 1.0)),
        ])?;
    }

    // %%
    show(lang, "f04-images", &[("filter", "ideal")])?;

    // %% en
    // Why image synthesis needs it: a renderer, unlike a sensor, asks for the light $L(x, y)$ at points, and what lies
    // between them is lost for good. The scene behind wavy glass below has the *same* samples to the last bit.
    // %% ru
    // Какое отношение это имеет к синтезу изображений: рендерер, в отличие от сенсора, спрашивает о свете $L(x, y)$ в
    // точках, и то, что лежит между ними, потеряно навсегда. У сцены за волнистым стеклом внизу отсчёты *те же* до
    // последнего бита.
    // %%
    show(lang, "f05-synthesis", &[("depth", "0.25")])?;

    // %% en
    // **Exercise.** Replace `Cosine::new(0.4)` by 0.2. What do the two lines say now, and why?
    // %% ru
    // **Упражнение.** Замените `Cosine::new(0.4)` на 0,2. Что напечатают обе строки теперь и почему?

    // %% en
    // ## The cause: frequencies fold
    //
    // Sampling reads $f(iT)$ and forgets the rest. For a smooth function little is lost: straight lines between the samples
    // err by at most $\tfrac{T^2}{8}\max|f''|$. For a fast one everything is.
    //
    // **Theorem.** At the rate $f_s$ the tones $\nu$ and $\nu + kf_s$ have the same samples for every whole $k$, since
    // $e^{i2\pi(\nu + kf_s)j/f_s} = e^{i2\pi\nu j/f_s}$. The frequency seen is the distance to the nearest multiple of the
    // rate,
    // $$f_a = \bigl|f - f_s\,\mathrm{round}(f/f_s)\bigr|,$$
    // a triangle wave: up to the Nyquist frequency $f_s/2$, down to zero, and up again. On the way down a cosine comes back
    // as a cosine and a sine with its sign turned over.
    // %% ru
    // ## Причина: частоты «заворачиваются»
    //
    // Дискретизация читает $f(iT)$ и забывает остальное. Для плавной функции потеря мала: отрезки прямых между отсчётами
    // ошибаются не более чем на $\tfrac{T^2}{8}\max|f''|$. Для быстрой теряется всё.
    //
    // **Теорема.** При частоте дискретизации $f_s$ тоны $\nu$ и $\nu + kf_s$ имеют одни и те же отсчёты при любом целом $k$,
    // потому что $e^{i2\pi(\nu + kf_s)j/f_s} = e^{i2\pi\nu j/f_s}$. Видимая частота — расстояние до ближайшего кратного
    // частоты дискретизации,
    // $$f_a = \bigl|f - f_s\,\mathrm{round}(f/f_s)\bigr|,$$
    // треугольная волна: вверх до частоты Найквиста $f_s/2$, вниз до нуля и снова вверх. На спуске косинус возвращается
    // косинусом, а синус меняет знак.
    // %%
    {
        let axis = Axis::new(0.0, 1.0, 64)?;
        let worst = |a: &Samples, b: &Samples, sign: f64| {
            let pairs = a.values().iter().zip(b.values());
            pairs.map(|(a, b)| (a - sign * b).abs()).fold(0.0, f64::max)
        };
        let cosine = |nu: f64| Ok::<_, Error>(Samples::of(&Cosine::new(nu)?, axis));
        let sine = |nu: f64| Ok::<_, Error>(Samples::of(&Sine::new(nu)?, axis));
        // the angle 2π·0.9·63 is known to its rounding
        let angle = 2.0 * PI * 63.0 * f64::EPSILON;
        prove([
            Residual::at_most("cos 2π0.9k = cos 2π0.1k", worst(&cosine(0.9)?, &cosine(0.1)?, 1.0), angle),
            Residual::at_most("sin 2π0.9k = −sin 2π0.1k", worst(&sine(0.9)?, &sine(0.1)?, -1.0), angle),
        ])?;

        // asked of the samples themselves: where is the peak of their spectrum?
        for f in [1.0, 3.0, 4.5, 7.0, 9.0, 15.0] {
            let bins = forward(&Samples::of(&Cosine::new(f)?, Axis::nodes(0.0..8.0, 64)?));
            let peak =
                bins.magnitudes().filter(|[nu, _]| *nu >= 0.0).fold([0.0; 2], |a, b| if b[1] > a[1] { b } else { a });
            println!("f_s = 8, f = {f:4.1}: f_a = {:.1}", peak[0]);
            prove([Residual::near("f_a", peak[0], fold(f, 8.0), 0.0)])?;
        }
    }

    // %%
    show(lang, "f06-sampling", &[("T", "0.5")])?;

    // %%
    show(lang, "f07-cause", &[("slow", "0.4"), ("fast", "0.9")])?;

    // %%
    show(lang, "f08-folding", &[])?;

    // %% en
    // **Exercise.** A tone of 17 kHz is recorded at 44.1 kHz, then every second sample is thrown away. What is heard? And
    // after throwing away every second sample once more?
    // %% ru
    // **Упражнение.** Тон 17 кГц записан с частотой 44,1 кГц, затем выброшен каждый второй отсчёт. Что слышно? А если
    // выбросить каждый второй ещё раз?

    Ok(())
}
