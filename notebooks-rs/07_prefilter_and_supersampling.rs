//! Prefilter and supersampling: what can be done against aliasing before the samples, and between samples and pixels.

#![allow(clippy::print_stdout, reason = "a notebook prints")]

use nyquist::course::{display, law, prove, show};
use nyquist::figure::{Figure, Layer, Legend, Meaning, Panel, Scale};
use nyquist::laws::coverage::{coverage_adds_up, edges_of_checkerboard, mean_by_counting};
use nyquist::laws::hold::{taps_converge, uniform_transfer};
use nyquist::num::sinc;
use nyquist::prelude::*;
use nyquist::text;

fn main() -> Result<()> {
    // %% en
    // # 7. Prefilter and supersampling
    //
    // Aliasing cannot be repaired: once a tone has been folded, its samples are those of another tone, and no filter can
    // tell them apart. So whatever is done must be done **before** the last sample is taken. The lecture names three ways:
    // filter the continuous picture first; sample more finely and filter the samples; sample at random. This notebook is
    // about the first two, the next one about the third.
    //
    // Frequencies are in cycles per pixel: the sampling rate is 1, the Nyquist frequency ½.
    // %% ru
    // # 7. Префильтрация и суперсэмплинг
    //
    // Алиасинг нельзя исправить задним числом: если синусоида завернулась, её отсчёты неотличимы от отсчётов другой
    // синусоиды, и никакой фильтр их не разделит. Значит, всё, что можно сделать, надо сделать **до** последнего отсчёта.
    // В лекции названы три способа: сначала отфильтровать непрерывную картину; взять отсчёты чаще и отфильтровать уже их;
    // брать отсчёты случайно. Эта тетрадь — о первых двух, следующая — о третьем.
    //
    // Частоты всюду в периодах на пиксель: частота дискретизации равна 1, частота Найквиста — ½.
    // %%
    let lang = Lang::En;

    // %% en
    // ## 1. Three ways, and what each leaves
    //
    // Take two tones, $\nu = 0.9$ and $\nu = 3.9$. With one sample a pixel both fold to
    // $$|\nu - \mathrm{round}(\nu)| = 0.1,$$
    // a slow wave that the scene never had. An antialiasing method is a factor in front of that wave, and the question is
    // how small the factor is. Below: a Lanczos filter before sampling, the mean over the pixel's area, and the mean of
    // four regular samples.
    // %% ru
    // ## 1. Три способа и что остаётся после каждого
    //
    // Возьмём две синусоиды, $\nu = 0{,}9$ и $\nu = 3{,}9$. При одном отсчёте на пиксель обе заворачиваются в
    // $$|\nu - \mathrm{round}(\nu)| = 0{,}1$$
    // — медленную волну, которой в сцене не было. Любой способ антиалиасинга — это множитель перед этой волной, и вопрос
    // лишь в том, насколько он мал. Ниже — фильтр Ланцоша перед дискретизацией, среднее по площади пикселя и среднее
    // четырёх равномерных отсчётов.
    // %%
    let tones = [0.9, 3.9];
    prove(tones.map(|nu| Residual::near(format!("fold({nu}) = 0.1"), fold(nu, 1.0), 0.1, 4.0 * f64::EPSILON * nu)))?;
    for nu in tones {
        let (filter, area, four) = (Lanczos::new(3.0)?.response(nu), sinc(nu), uniform_transfer(4, nu));
        let line = text!(
            "tone {nu}: filter {filter:.4}, area {area:.4}, four samples {four:.4}",
            "тон {nu}: фильтр {filter:.4}, площадь {area:.4}, четыре отсчёта {four:.4}"
        );
        println!("{}", line.get(lang));
    }

    // %% en
    // The mean of four samples looks like the pixel's area at 0.9 and like nothing at all at 3.9. Keep an eye on that
    // number; it returns in section 4.
    // %% ru
    // При 0,9 четыре отсчёта почти неотличимы от площади пикселя, а при 3,9 они не ослабляют синусоиду совсем. Запомните
    // это число: к нему мы вернёмся в разделе 4.
    // %%
    show(lang, "f31-remedies", &[])?;

    // %% en
    // **Exercise.** Which tones between 1 and 4 cycles per pixel does the mean of four samples remove completely, and
    // which ones does the area remove? Guess, then put your guesses into `tones`. Which of them fold to 0.1?
    // %% ru
    // **Упражнение.** Какие частоты от 1 до 4 периодов на пиксель среднее четырёх отсчётов убирает полностью, а какие
    // убирает площадь? Предположите, потом подставьте свои числа в `tones`. Какие из них заворачиваются в 0,1?

    // %% en
    // ## 2. Filter first
    //
    // **Theorem.** Let $H(\nu) = 0$ for $|\nu| \ge \frac1{2T}$. Then the samples of $f \otimes h$ with the step $T$ restore
    // $f \otimes h$ exactly, whatever $f$ is: the copies of $F \cdot H$ do not touch.
    //
    // The filter that keeps all the rest is $h(x) = \frac1T\,\mathrm{sinc}\frac xT$ (a popular book prints
    // $\mathrm{sinc}(2\omega_s x)$, four times too narrow and without the factor; that is erratum E34 of the
    // sources). It is infinitely wide, so that in practice it is replaced by a finite one, and what that one leaks
    // is simply its response $K(\nu)$ beyond Nyquist. `prefiltered` convolves the scene's exact means with a kernel; let us
    // measure the gain at $\nu = 0.9$ and compare.
    // %% ru
    // ## 2. Сначала фильтр
    //
    // **Теорема.** Пусть $H(\nu) = 0$ при $|\nu| \ge \frac1{2T}$. Тогда отсчёты $f \otimes h$ с шагом $T$ точно
    // восстанавливают $f \otimes h$, какова бы ни была $f$: копии $F \cdot H$ не соприкасаются.
    //
    // Всё остальное сохраняет фильтр $h(x) = \frac1T\,\mathrm{sinc}\frac xT$ (в известной книге напечатано
    // $\mathrm{sinc}(2\omega_s x)$ — вчетверо у́же, чем нужно, и без множителя; это опечатка источника, E34). Он бесконечно
    // широк, поэтому на практике берут конечный, и его утечка — это просто его отклик $K(\nu)$ за частотой
    // Найквиста. `prefiltered` сворачивает точные средние сцены с ядром; измерим усиление при $\nu = 0{,}9$ и сравним.
    // %%
    let (fine, ten) = (Grating::new([0.9, 0.0])?, Grid::pixels(10, 1)?);
    // nine periods in ten pixels fold to one period: the amplitude of that wave
    fn amplitude(image: &Image) -> f64 {
        2.0 * image_forward(image).bin(1, 0).norm() / image.width() as f64
    }
    // the convolution is a sum over 16 cells a pixel: it errs by sinc(ν/16), and by what the kernel passes near 16, 32, …
    fn allowed(kernel: &dyn Kernel) -> f64 {
        let cells = 1.0 - sinc(0.9 / 16.0);
        let copies: f64 = (1..=4).map(|m| kernel.response(16.0 * f64::from(m) - 0.9).abs()).sum();
        cells * kernel.response(0.9).abs() + 4.0 * copies + 64.0 * f64::EPSILON
    }
    let kernels: [(&'static str, Box<dyn Kernel>); 4] = [
        ("tent", Box::new(TentKernel)),
        ("Mitchell", Box::new(Cubic::mitchell())),
        ("Lanczos-3", Box::new(Lanczos::new(3.0)?)),
        ("Lanczos-8", Box::new(Lanczos::new(8.0)?)),
    ];
    for (name, kernel) in &kernels {
        let left = amplitude(&prefiltered(&fine, ten, kernel, 16)?);
        println!("{name}: {left:.6}");
        prove([Residual::near(format!("{name}: K(0.9)"), left, kernel.response(0.9).abs(), allowed(kernel))])?;
    }

    // %% en
    // The lecture's example is a chirp, $1 + \cos 4\pi x^2$, whose frequency $4x$ grows without end. Without a filter the
    // samples show a mirror image beyond Nyquist; behind a good filter only the mean is left there, which is the truth.
    // %% ru
    // Пример лекции — ЛЧМ-сигнал $1 + \cos 4\pi x^2$: его частота $4x$ растёт неограниченно. Без фильтра в отсчётах за
    // частотой Найквиста видно зеркальное отражение; за хорошим фильтром там остаётся только среднее, и это правда.
    // %%
    show(lang, "f32-prefilter", &[("radius", "10")])?;

    // %% en
    // **Exercise.** With `("radius", "6")` the filter is short. Where does the filtered curve differ from the one above,
    // and why just there? What does a longer filter cost in a renderer?
    // %% ru
    // **Упражнение.** Поставьте `("radius", "6")`: фильтр станет коротким. Где кривая после фильтра изменилась и почему
    // именно там? Чем пришлось бы заплатить за более длинный фильтр в рендерере?

    // %% en
    // ## 3. Exact area is a filter, too: a box
    //
    // The slide's second example is the analytic coverage of a pixel by a polygon or a line. That is possible (so that
    // «prefiltering is impossible in our case», as a later slide has it, is too strong: E14), and it is exact: the pixels add
    // up to the area of the shape, wherever it lies. But it is exact *for the area*. The mean over a pixel is the
    // convolution with a box, and the transfer of a box,
    // $$\frac1T \int_{-T/2}^{T/2} \cos 2\pi\nu x\,dx = \mathrm{sinc}(\nu T),$$
    // is 0.64 at Nyquist, where an ideal filter stops everything above and nothing below, and still 0.11 at 0.9 of the rate.
    // Exact area dims aliases and does not remove them (E13).
    // %% ru
    // ## 3. Точная площадь — тоже фильтр: прямоугольный
    //
    // Второй пример на слайде — аналитический расчёт покрытия пикселя многоугольником или линией. Это возможно (так что
    // «префильтрация невозможна в нашем случае» на одном из следующих слайдов — слишком сильно: E14), и это точно: сумма
    // пикселей равна площади фигуры, где бы она ни лежала. Но точно это *для площади*. Среднее по пикселю — свёртка с
    // прямоугольником, а его передача
    // $$\frac1T \int_{-T/2}^{T/2} \cos 2\pi\nu x\,dx = \mathrm{sinc}(\nu T)$$
    // на частоте Найквиста равна 0,64 — а идеальный фильтр ниже неё не трогает ничего, выше не пропускает ничего, — и
    // даже на 0,9 частоты дискретизации ещё 0,11. Точная площадь ослабляет алиасы, но не убирает их (E13).
    // %%
    let triangle = ConvexPolygon::new(&[[1.3, 0.8], [14.2, 5.1], [6.4, 11.7]])?;
    prove([coverage_adds_up(&triangle, triangle.area(), Grid::pixels(16, 12)?)])?;
    law(lang, "area-is-a-box")?;

    // %% en
    // A zone plate puts every frequency somewhere in the picture, so that one sees the whole transfer at once. Its true
    // centre is on the left; the one on the right is a ghost.
    // %% ru
    // На зонной пластинке у каждой частоты есть своё место, так что всю передачу видно сразу. Настоящий центр — слева; тот,
    // что справа, — ложный.
    // %%
    show(lang, "x-area-ghosts", &[])?;

    // %% en
    // **Exercise.** At which distance from the true centre does the area filter turn black into white, that is, where is
    // its transfer negative? Find the place in the picture.
    // %% ru
    // **Упражнение.** На каком расстоянии от настоящего центра усреднение по площади меняет чёрное и белое местами, то есть
    // где его передача отрицательна? Найдите это место на картинке.

    // %% en
    // ## 4. Uniform supersampling
    //
    // $n$ samples a pixel move the copies of the spectrum $n$ times as far apart; then the samples are weighed,
    // $$\mathrm{Pixel} = \sum_s w_s \cdot \mathrm{Sample}_s, \qquad \sum_s w_s = 1.$$
    // The slide leaves the second equation out, yet without it every constant changes its brightness. With $n$ equal weights
    // this is a digital filter whose transfer is
    // $$D(\nu) = \frac{\sin \pi\nu}{n \sin(\pi\nu/n)}.$$
    // For low frequencies it is nearly the box. But it is *periodic*: $|D(\nu + n)| = |D(\nu)|$, so that everything near $n$
    // cycles per pixel passes whole, and folds. That is the 3.9 of section 1.
    // %% ru
    // ## 4. Равномерный суперсэмплинг
    //
    // $n$ отсчётов на пиксель раздвигают копии спектра в $n$ раз; затем отсчёты складываются с весами:
    // $$\mathrm{Pixel} = \sum_s w_s \cdot \mathrm{Sample}_s, \qquad \sum_s w_s = 1.$$
    // Второго равенства на слайде нет, а без него меняется яркость любой константы. При $n$ равных весах это
    // цифровой фильтр с передачей
    // $$D(\nu) = \frac{\sin \pi\nu}{n \sin(\pi\nu/n)}.$$
    // На низких частотах это почти усреднение по площади. Но она *периодична*: $|D(\nu + n)| = |D(\nu)|$, и всё, что лежит
    // вблизи $n$ периодов на пиксель, проходит целиком — и заворачивается. Вот откуда взялось 3,9 в разделе 1.
    // %%
    let taps = [0.125, 0.375, 0.625, 0.875].map(|x| Tap { at: [x, 0.5], weight: 0.25 });
    let nu: f64 = 3.9;
    let measured = amplitude(&weighted(&Grating::new([nu, 0.0])?, ten, &taps)?);
    let half_turns = std::f64::consts::PI * nu;
    let formula = half_turns.sin() / (4.0 * (half_turns / 4.0).sin());
    // ten pixels by transform, of cosines whose arguments reach 2πν·10
    let rounding = f64::EPSILON * (16.0 + 20.0 * half_turns);
    prove([
        Residual::near("n = 4: |D(3.9)| = 0.98464", measured, formula.abs(), rounding),
        Residual::near("|D(3.9)| = |D(0.1)|", measured, uniform_transfer(4, 0.1), rounding),
    ])?;
    let bright = taps.map(|tap| Tap { weight: 0.26, ..tap });
    match weighted(&fine, ten, &bright) {
        Err(error) => println!("{error}"),
        Ok(_) => panic!("weights that add up to 1.04 make the picture brighter"),
    }
    // and for a fixed frequency, as n grows, D tends to the box
    prove([4, 16, 64].map(|n| taps_converge(n, 0.9)))?;

    // %% en
    // The transfers for more and more samples, beside the box that they tend to. Between the peaks at the multiples of $n$
    // they follow it; on the peaks never.
    // %% ru
    // Передачи при всё большем числе отсчётов и прямоугольный фильтр, к которому они стремятся. Между пиками на кратных $n$
    // они следуют за ним, на пиках — никогда.
    // %%
    let gain = Scale::linear(text!("gain", "усиление"), 0.0, 1.15);
    let mut panel = Panel::new("transfer", Text::EMPTY, Scale::linear(Text::same("ν"), 0.0, 17.0), gain)
        .legend(Legend::Above)
        .with(
            Layer::curve("box", Meaning::Kernel, 0.0, 17.0, 1700, |nu| sinc(nu).abs())
                .thick()
                .label(text!("area", "площадь")),
        );
    for (i, n) in (0..).zip([2, 4, 16]) {
        let curve = Layer::curve("taps", Meaning::Series(i), 0.0, 17.0, 1700, |nu| uniform_transfer(n, nu).abs());
        panel = panel.with(curve.thin().label(text!("n = {n}", "n = {n}")));
    }
    display(
        lang,
        &text!("What n samples a pixel let through", "Что пропускают n отсчётов на пиксель"),
        &Figure::new(1).with(panel),
    )?;

    // %%
    show(lang, "f33-supersampling", &[("n", "6")])?;

    // %% en
    // **Exercise.** Change the weights of `taps` to those of a tent, $(1, 3, 3, 1)/8$. Is less left at 0.9? And at 3.9?
    // Explain the second answer without computing anything.
    // %% ru
    // **Упражнение.** Замените веса `taps` на треугольные, $(1, 3, 3, 1)/8$. Меньше ли осталось при 0,9? А при 3,9? Второй
    // ответ объясните без вычислений.

    // %% en
    // ## 5. Duff's checkerboard: the same, to be looked at
    //
    // An endless checkerboard runs to the horizon, and its frequency grows from row to row without bound: in the row $Y$ it
    // is $hf/(2Y^2)$ periods a pixel. So somewhere near the horizon every regular pattern meets its own rate. For $n$ samples
    // across the pixel that is the row
    // $$Y = f\sqrt{\frac{h}{2fn}},$$
    // 5.66, 2.83 and 2.00 for $n = 1, 4, 8$ (here $f = 64$, $h = 1$). There all samples of a pixel see the same colour, and
    // false squares appear. An edge by itself would gain a factor $n$ from $n \times n$ samples; this picture gains less.
    // %% ru
    // ## 5. Шахматная доска Даффа: то же самое глазами
    //
    // Бесконечная доска уходит к горизонту, и частота клеток растёт от строки к строке без предела: в строке $Y$ она равна
    // $hf/(2Y^2)$ периодов на пиксель. Значит, где-то у горизонта любая регулярная сетка встречает собственную частоту. Для
    // $n$ отсчётов на сторону пикселя это строка
    // $$Y = f\sqrt{\frac{h}{2fn}}:$$
    // 5,66, 2,83 и 2,00 при $n = 1, 4, 8$ (здесь $f = 64$, $h = 1$). Там все отсчёты пикселя видят один цвет, и появляются
    // ложные клетки. На одном крае $n \times n$ отсчётов дали бы выигрыш в $n$ раз; эта картина выигрывает меньше.
    // %%
    let board = Checkerboard::lecture(128)?;
    // all rows but the first, which touches the horizon
    let rows = Grid::cells(0.0..128.0, 128, 1.0..128.0, 127)?;
    let exact = Image::averaged(&board, rows);
    let mut errors = Vec::new();
    for n in [1, 2, 4, 8] {
        let error = supersample(&board, rows, &Regular::<2>::new([n, n])?, &BoxKernel, 1)?.rmse(&exact)?;
        let ghost = 64.0 * (1.0 / (128.0 * n as f64)).sqrt();
        let line = text!(
            "{n} × {n}: error {error:.4}, ghost expected in row {ghost:.2}",
            "{n} × {n}: ошибка {error:.4}, ложный узор ожидается в строке {ghost:.2}"
        );
        println!("{}", line.get(lang));
        errors.push(error);
    }
    prove([
        // the lecture's companion computed these two by a program of its own and gave four digits
        Residual::near("RMSE, 1 × 1", errors[0], 0.1284, 0.5e-4),
        Residual::near("RMSE, 4 × 4", errors[2], 0.0395, 0.5e-4),
        Residual::at_most("RMSE(1 × 1)/RMSE(4 × 4) < n = 4", errors[0] / errors[2], 4.0),
    ])?;

    // %%
    show(lang, "f35-checkerboard", &[])?;

    // %% en
    // **Exercise.** Before you change `n` to 8 in the figure, `("n", "8")`: where will the ghost be, and will the picture
    // look better or only different?
    // %% ru
    // **Упражнение.** Прежде чем поставить в рисунке `("n", "8")`: где окажется ложный узор, и станет ли картинка лучше или
    // просто другой?

    // %% en
    // ## 6. And with exact area
    //
    // Of this scene the exact pixel is known. With the square wave $q = \pm1$ of period 2 and its primitive $\Lambda$, a
    // triangle wave,
    // $$\text{mean} = \frac12 - \frac1{2A}\int_{Y_0}^{Y_1} q\!\left(\tfrac{hf}{Y}\right)\frac{Y}{h}
    // \left[\Lambda\!\left(\tfrac{hX_1}{Y}\right) - \Lambda\!\left(\tfrac{hX_0}{Y}\right)\right] dY,$$
    // and between the places where one of the arguments crosses an integer the integrand is *linear* in $Y$: the midpoint
    // rule is exact. Counting samples comes to the same, slowly: each straight edge through the pixel costs at most $1/n$.
    // %% ru
    // ## 6. И то же с точной площадью
    //
    // Для этой сцены точное значение пикселя известно. С меандром $q = \pm1$ периода 2 и его первообразной $\Lambda$,
    // треугольной волной,
    // $$\text{среднее} = \frac12 - \frac1{2A}\int_{Y_0}^{Y_1} q\!\left(\tfrac{hf}{Y}\right)\frac{Y}{h}
    // \left[\Lambda\!\left(\tfrac{hX_1}{Y}\right) - \Lambda\!\left(\tfrac{hX_0}{Y}\right)\right] dY,$$
    // а между точками, где один из аргументов проходит через целое число, подынтегральная функция *линейна* по $Y$: формула
    // средних прямоугольников точна. Подсчёт отсчётов даёт то же, но медленно: каждый край, идущий через пиксель, стоит не
    // больше $1/n$.
    // %%
    let pixel = [[30.0, 31.0], [7.0, 8.0]];
    let edges = edges_of_checkerboard(&board, pixel);
    prove(
        [10, 100, 1000]
            .into_iter()
            .map(|n| mean_by_counting(&board, pixel, n, edges, 0.0))
            .collect::<Result<Vec<_>>>()?,
    )?;

    // %%
    show(lang, "f36-exact-area", &[])?;

    // %% en
    // Far away the exact area is an even grey, without a ghost of any rate. It is still a box, and no more than a box: in
    // the first rows beyond Nyquist the squares are visible, dimmed and partly inverted.
    //
    // **Exercise.** In which row is the frequency of the squares exactly one period a pixel, so that a box removes their
    // fundamental completely? Compute it and look at that row of the chart.
    // %% ru
    // Вдали точная площадь — ровный серый, без ложных узоров какой бы то ни было частоты. Но это всё тот же прямоугольный
    // фильтр: в первых строках за Найквистом клетки видны, ослабленные и частью вывернутые.
    //
    // **Упражнение.** В какой строке на пиксель приходится ровно один период клеток, так что прямоугольный фильтр полностью
    // убирает первую гармонику? Вычислите и найдите эту строку на графике.

    Ok(())
}
