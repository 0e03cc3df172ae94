//! Film, filters and the five-dimensional scene: lens, shutter, strata in groups, and how samples become pixels.

#![allow(clippy::print_stdout, reason = "a notebook prints")]

use nyquist::course::{law, prove, show};
use nyquist::kernel::metrics::Metrics;
use nyquist::laws::film::{Moments, constant_kept, ratio_bias};
use nyquist::num::random::uniform;
use nyquist::pattern::measure::elementary::occupancy;
use nyquist::prelude::*;
use nyquist::scene::catalog::by_name;
use nyquist::text;

fn main() -> Result<()> {
    // %% en
    // # 10. Film, filters and the five-dimensional scene
    //
    // So far an image was a function of two variables. A camera has more: its lens is open over an area, its shutter for a
    // time. This notebook goes the last part of the way: from the scene function $L(x, y, u, v, t)$ to samples in five
    // dimensions, and from the samples to pixels, where the question of the first notebook returns: which filter?
    // %% ru
    // # 10. Плёнка, фильтры и пятимерная сцена
    //
    // До сих пор изображение было функцией двух переменных. У камеры их больше: объектив открыт по площади, затвор — по
    // времени. Эта тетрадь проходит последний отрезок пути: от функции сцены $L(x, y, u, v, t)$ к отсчётам в пяти измерениях,
    // а от отсчётов — к пикселям, где возвращается вопрос первой тетради: какой фильтр?
    // %%
    let lang = Lang::En;

    // %% en
    // ## 1. The generalised scene function
    //
    // Light reaches the place $(x, y)$ of the film through every point $(u, v)$ of the lens and as long as the shutter is open,
    // $t$. All rays of a point in focus meet on the film. Those of a point at another distance $z$ fill a circle of
    // confusion: with the film $d'$ behind the lens, the focus at $z_f$ and the aperture $A$,
    // $$c = A\,d'\left|\frac1{z_f} - \frac1z\right|.$$
    // In the slice $(x, u)$ a point is therefore a straight line, and its slope times $A$ is $c$. Motion does the same in
    // $(x, t)$: both are *shears*, and what a shear does to a spectrum we know.
    // %% ru
    // ## 1. Обобщённая функция сцены
    //
    // В точку плёнки $(x, y)$ свет приходит через каждую точку линзы $(u, v)$ и всё время $t$, пока открыт затвор. Все лучи
    // точки в фокусе сходятся на плёнке. Лучи точки на другом расстоянии $z$ заполняют кружок нерезкости: если плёнка стоит
    // в $d'$ за линзой, в фокусе расстояние $z_f$, а диаметр линзы $A$, то
    // $$c = A\,d'\left|\frac1{z_f} - \frac1z\right|.$$
    // Поэтому в сечении $(x, u)$ точка — это прямая, и её наклон, умноженный на $A$, равен $c$. Движение делает то же самое в
    // $(x, t)$: и то и другое — *сдвиг*, а что он делает со спектром, мы знаем.
    // %%
    let (film, focus, aperture) = (1.0, 5.0, 0.8);
    let lens = ThinLens::new(film, focus, aperture)?;
    for z in [5.0, 2.75, 10.0, 1000.0] {
        let point = [0.3, -0.1, z];
        let [x, y] = lens.to_film(point, [0.0, 0.0]);
        // rays through the rim of the lens: the edge of the square is mapped to it
        let rim = (0..64).map(|i| lens.point([1.0, f64::from(i) / 63.0])).map(|place| lens.to_film(point, place));
        let radius = rim.map(|[a, b]| (a - x).hypot(b - y)).fold(0.0, f64::max);
        let formula = aperture * film * (1.0 / focus - 1.0 / z).abs();
        let rounding = 32.0 * f64::EPSILON;
        prove([
            Residual::near(format!("z = {z}: 2·max|x(u) − x(0)| = c"), 2.0 * radius, formula, rounding),
            Residual::near(format!("z = {z}: slope·A = c"), (lens.shear(z) * aperture).abs(), formula, rounding),
        ])?;
    }

    // %%
    show(lang, "f47-scene-function", &[("focus", "4"), ("A", "1.2")])?;

    // %%
    show(lang, "x-shear", &[])?;

    // %% en
    // **Exercise.** The farther behind the focus, the more is a point blurred; but there is a limit. What is it? Which distance
    // before the focus has the same circle of confusion?
    // %% ru
    // **Упражнение.** Чем дальше точка за фокусом, тем сильнее она размыта, но у размытия есть предел. Какой? На каком
    // расстоянии перед фокусом кружок нерезкости такой же?

    // %% en
    // ## 2. Strata in groups
    //
    // Four strata in *each* of five dimensions would take $4^5 = 1024$ samples. The slide's way out, «strata for each
    // dimension separately, then joined at random», is looser than what its picture shows (E17): what is stratified are
    // *groups*, the place in the pixel $(x, y)$, the time $t$, the place on the lens $(u, v)$, four strata each, joined by
    // random permutations. Four samples are enough, and each group by itself is as good as jitter. Strata of every
    // single coordinate, read literally, would be a Latin hypercube: it helps only where the function is a sum of functions
    // of one variable.
    // %% ru
    // ## 2. Страты по группам
    //
    // Четыре страты в *каждом* из пяти измерений потребовали бы $4^5 = 1024$ отсчёта. Выход на слайде — «генерировать страты
    // по каждой размерности отдельно, затем случайным образом соединять» — сказан шире, чем нарисовано (E17): страты строят по
    // *группам* — место в пикселе $(x, y)$, время $t$, место на линзе $(u, v)$, — по четыре в каждой, и соединяют случайными
    // перестановками. Хватает четырёх отсчётов, и каждая группа сама по себе не хуже джиттера. Страты по каждой
    // отдельной координате, если понимать слайд буквально, — это латинский гиперкуб: он помогает, лишь когда функция есть
    // сумма функций одной переменной.
    // %%
    let four = Padded::new(2)?.points(1);
    for [x, y, t, u, v] in &four {
        println!("(x, y) = ({x:.2}, {y:.2}), t = {t:.2}, (u, v) = ({u:.2}, {v:.2})");
    }
    let quarters = Cells::new([2, 2])?;
    // over many draws: the strata of each group that are missed
    fn missed(pattern: &dyn Pattern<5>, first: usize, quarters: Cells<2>) -> Result<f64> {
        let mut empty = 0;
        for seed in 0..1000 {
            let plane: Vec<[f64; 2]> = pattern.points(seed).iter().map(|s| [s[first], s[first + 1]]).collect();
            empty += occupancy(&plane, quarters)?.into_iter().filter(|points| *points == 0).count();
        }
        Ok(empty as f64 / 1000.0)
    }
    let (groups, hypercube) = (Padded::new(2)?, NRooks::new(4)?);
    let [by_groups, by_coordinates] = [missed(&groups, 3, quarters)?, missed(&hypercube, 3, quarters)?];
    let line = text!(
        "quarters of the lens without a ray: {by_groups} by groups, {by_coordinates} by coordinates",
        "четвертей линзы без луча: {by_groups} по группам, {by_coordinates} по координатам"
    );
    println!("{}", line.get(lang));
    let all = Pattern::<5>::count(&Jittered::new([4; 5])?).unwrap_or(0);
    prove([
        Residual::near("4⁵", all as f64, 1024.0, 0.0),
        Residual::near("(x, y): 4/4", missed(&groups, 0, quarters)?, 0.0, 0.0),
        Residual::near("(u, v): 4/4", by_groups, 0.0, 0.0),
        Residual::at_least("(u, v), NRooks: < 4/4", by_coordinates, f64::MIN_POSITIVE),
    ])?;

    // %%
    show(lang, "f52-groups", &[("seed", "7")])?;

    // %% en
    // **Exercise.** With four points on the lens in a Latin hypercube, how many of its quarters can be empty, and with which
    // probability? (There are 24 ways to place four rooks.)
    // %% ru
    // **Упражнение.** Четыре точки на линзе образуют латинский гиперкуб. Сколько её четвертей может остаться пустыми и с какой
    // вероятностью? (Расставить четыре ладьи можно 24 способами.)

    // %% en
    // ## 3. A sphere out of focus, and things that move
    //
    // What varies within one pixel of a blurred sphere is almost only the place on the lens. So it is the strata *of the lens*
    // that gain, and the more, the more rays there are: the random error falls as $1/N$, the stratified one faster. Strata of
    // the image alone gain nothing.
    // %% ru
    // ## 3. Расфокусированная сфера и то, что движется
    //
    // Внутри одного пикселя размытой сферы меняется почти одно лишь место на линзе. Поэтому выигрыш дают именно страты *линзы*,
    // и тем больший, чем больше лучей: случайная ошибка падает как $1/N$, стратифицированная — быстрее. Страты одного
    // изображения не дают ничего.
    // %%
    let sphere = by_name("defocus")?.scene();
    let reference = render(&*sphere, 36, 24, &Padded::with_count(4096)?, &BoxKernel, 9)?.luminance();
    let mut gains = Vec::new();
    for rays in [4, 16, 64] {
        let error = |pattern: &dyn Pattern<5>| -> Result<f64> {
            render(&*sphere, 36, 24, pattern, &BoxKernel, 1)?.luminance().rmse(&reference)
        };
        let random = error(&Random::new(rays)?)?.powi(2);
        let all = error(&Padded::with_count(rays)?)?.powi(2);
        let image_only = error(&Padded::with_count(rays)?.stratified(true, false, false))?.powi(2);
        let line = text!(
            "{rays} rays: MSE random/strata {:.1}, random/strata of the image only {:.2}",
            "лучей {rays}: MSE случайные/страты {:.1}, случайные/страты только изображения {:.2}",
            random / all,
            random / image_only
        );
        println!("{}", line.get(lang));
        gains.push(random / all);
    }
    prove([
        Residual::at_least("MSE(random) ≥ MSE(strata), N = 4", gains[0], 1.0),
        Residual::at_least("gain(16) > gain(4)", gains[1], gains[0]),
        Residual::at_least("gain(64) > gain(16)", gains[2], gains[1]),
    ])?;

    // %%
    show(lang, "f53-defocus", &[])?;

    // %% en
    // Time is no different. With $n$ equal moments a moving object becomes $n$ pale copies of itself: that is uniform
    // supersampling, whose transfer $D_n$ is one again at $n$ periods on the way. Strata of time make noise of it, as the open
    // shutter would: $\mathrm{sinc}$. And the shutter weakens strobing, it does not remove it.
    // %% ru
    // Со временем то же самое. При $n$ равных моментах движущийся предмет превращается в $n$ бледных копий: это равномерный
    // суперсэмплинг, передача которого $D_n$ при $n$ периодах на пути снова единица. Страты времени делают из этого шум вокруг
    // того, что увидел бы открытый затвор, $\mathrm{sinc}$. А затвор стробирование ослабляет, но не убирает.
    // %%
    show(lang, "x-motion", &[("moments", "3")])?;

    // %%
    law(lang, "shutter")?;

    // %% en
    // **Exercise.** How many rays a pixel does the random picture need to be as good as the stratified one with 64? Use the
    // printed gain, then try it.
    // %% ru
    // **Упражнение.** Сколько лучей на пиксель нужно случайной картинке, чтобы сравняться со стратифицированной при 64? Оцените
    // по напечатанному выигрышу, потом проверьте.

    // %% en
    // ## 4. From samples to pixels: three stages, one filter
    //
    // Reconstruct a function from the samples ($\otimes\, r$), remove what pixels cannot show ($\otimes\, p$), take its values
    // at the centres. Only the centres are asked for, and convolution is associative:
    // $$(S \otimes r) \otimes p = S \otimes (r \otimes p).$$
    // So one filter does it, and the function in the middle is never built. An example to be checked by hand: joining samples
    // by straight lines ($r$ a tent) and averaging over the pixel ($p$ a box) *is* the trapezoid rule.
    // %% ru
    // ## 4. От отсчётов к пикселям: три этапа, один фильтр
    //
    // Построить по отсчётам функцию ($\otimes\, r$), убрать то, чего не покажут пиксели ($\otimes\, p$), взять значения в
    // центрах. Нужны только центры, а свёртка ассоциативна:
    // $$(S \otimes r) \otimes p = S \otimes (r \otimes p).$$
    // Значит, хватает одного фильтра, а функцию в середине строить незачем. Пример, который можно проверить вручную: соединить
    // отсчёты отрезками ($r$ — треугольник) и усреднить по пикселю ($p$ — прямоугольник) — это и *есть* формула трапеций.
    // %%
    // four samples a pixel, eight pixels
    let samples = Samples::of(&RaisedCosine::new(0.8)?, Axis::nodes(-4.0..4.25, 33)?);
    let mut apart: f64 = 0.0;
    {
        let lines = reconstruct(&samples, TentKernel);
        for pixel in 0..8u32 {
            let start = f64::from(pixel) - 4.0;
            // all three stages: a straight piece has its mean in its middle
            let stages = (0..4).map(|k| lines.at(start + (f64::from(k) + 0.5) / 4.0)).sum::<f64>() / 4.0;
            // one filter: half the outer samples, all of the inner ones
            let s = &samples.values()[4 * pixel as usize..];
            let trapezoid = (0.5 * s[0] + s[1] + s[2] + s[3] + 0.5 * s[4]) / 4.0;
            apart = apart.max((stages - trapezoid).abs());
        }
    }
    prove([Residual::at_most("(S ⊗ tent) ⊗ box = trapezoid", apart, 16.0 * f64::EPSILON)])?;

    // %%
    show(lang, "f55-stages", &[("n", "4"), ("p", "mitchell")])?;

    // %%
    show(lang, "f55-plane", &[])?;

    // %% en
    // **Exercise.** Which weights do you get if the samples are joined by steps instead of straight lines, with a sample in the
    // middle of each step?
    // %% ru
    // **Упражнение.** Какие получатся веса, если соединять отсчёты не отрезками, а ступеньками с отсчётом в середине каждой?

    // %% en
    // ## 5. A pixel from scattered samples
    //
    // $$I(x, y) = \frac{\sum_i f(x - x_i, y - y_i)\,L_i}{\sum_i f(x - x_i, y - y_i)}.$$
    // The denominator differs from pixel to pixel; only the division keeps a constant. It has a price that the slide does not
    // mention: the mean of a quotient is not the quotient of the means. With $K$ independent samples the pixel is biased by
    // $$\frac1K\cdot\frac{I\,\mathsf E[w^2] - \mathsf E[w^2L]}{(\mathsf E\,w)^2}.$$
    // For the tent and $L = x^2$ that is $\frac4{45K}$: small beside the noise, which falls as $K^{-1/2}$, and yet not zero.
    // %% ru
    // ## 5. Пиксель по разбросанным отсчётам
    //
    // $$I(x, y) = \frac{\sum_i f(x - x_i, y - y_i)\,L_i}{\sum_i f(x - x_i, y - y_i)}.$$
    // Знаменатель от пикселя к пикселю разный, и константу сохраняет только деление. У него есть цена, о которой слайд молчит:
    // среднее отношения не равно отношению средних. При $K$ независимых отсчётах пиксель смещён на
    // $$\frac1K\cdot\frac{I\,\mathsf E[w^2] - \mathsf E[w^2L]}{(\mathsf E\,w)^2}.$$
    // Для треугольника и $L = x^2$ это $\frac4{45K}$: мало рядом с шумом, который падает как $K^{-1/2}$, но не нуль.
    // %%
    let scattered: Vec<Sample<1>> = (0..4000)
        .map(|i| [uniform(1, i, 0), uniform(1, i, 1)].map(|place| 16.0 * place - 4.0))
        .map(|at| Sample { at, light: [0.25] })
        .collect();
    let exposed = Film::new(Grid::pixels(8, 8)?, Cubic::mitchell())?.develop(&scattered)?;
    let weights = exposed.weights().values().to_vec();
    let (least, most) = weights.iter().fold((f64::INFINITY, 0.0f64), |(a, b), w| (a.min(*w), b.max(*w)));
    println!("Σf: {least:.1} … {most:.1}");
    let moments = Moments::of(&TentKernel, |x| x * x);
    prove([
        // Mitchell's filter reaches two pixels, so that a pixel weighs at most some 500 samples; amounts are at most twice
        // the sum
        constant_kept(exposed.image(), 0.25, 500, 2.0),
        Residual::near("K·bias = 4/45", moments.bias(1), 4.0 / 45.0, 1e-13 / (moments.weight * moments.weight)),
        ratio_bias(&TentKernel, |x| x * x, 8, 4000, true)?,
        ratio_bias(&TentKernel, |x| x * x, 32, 4000, true)?,
    ])?;

    // %%
    show(lang, "f56-weights", &[("kernel", "gaussian-pbrt2")])?;

    // %% en
    // **Exercise.** Divide by the *expected* sum of the weights instead, `4000/256`. Is the bias gone? And what happens to
    // the constant?
    // %% ru
    // **Упражнение.** Разделите вместо этого на *ожидаемую* сумму весов, `4000/256`. Исчезло ли смещение? А что стало с
    // константой?

    // %% en
    // ## 6. Which filter?
    //
    // Three vices, three numbers: blur $S = 1 - \int_{|\nu|<\frac12}K^2$, copies that come through $P = \int_{|\nu|>\frac12}K^2$,
    // and the overshoot at an edge. No filter is the best in all three; the slide calls the choice an art for good reason. But
    // one thing is exact. Among the cubics of Mitchell and Netravali all keep constants,
    // $\sum_i k(x - i) = 1$, and just those with
    // $$B + 2C = 1$$
    // keep straight lines, $\sum_i i\,k(x - i) = x$.
    // %% ru
    // ## 6. Какой фильтр?
    //
    // Три порока — три числа: размытие $S = 1 - \int_{|\nu|<\frac12}K^2$, прошедшие копии $P = \int_{|\nu|>\frac12}K^2$ и выброс
    // у края. Лучшего сразу по трём нет; не зря слайд называет выбор искусством. Но кое-что здесь точно. Все кубические ядра
    // Митчелла — Нетравали сохраняют константы, $\sum_i k(x - i) = 1$, а прямые, $\sum_i i\,k(x - i) = x$, сохраняют те и
    // только те, у которых
    // $$B + 2C = 1.$$
    // %%
    let kernels: [(&'static str, Box<dyn Kernel>); 6] = [
        ("box        ", Box::new(BoxKernel)),
        ("tent       ", Box::new(TentKernel)),
        ("Gauss      ", Box::new(GaussianKernel::pbrt2())),
        ("Mitchell   ", Box::new(Cubic::mitchell())),
        ("Catmull–Rom", Box::new(Cubic::catmull_rom())),
        ("Lanczos-3  ", Box::new(Lanczos::new(3.0)?)),
    ];
    for (name, kernel) in &kernels {
        let Metrics { smoothing, postaliasing, overshoot, .. } = Metrics::of(kernel);
        println!("{name}  S = {smoothing:.4}  P = {postaliasing:.4}  +{:.2} %", 100.0 * overshoot);
    }
    // the largest error of Σ k(x − i) − 1 and of Σ i·k(x − i) − x
    fn order(b: f64, c: f64) -> Result<[f64; 2]> {
        let kernel = Cubic::new(b, c)?;
        let at = |x: f64| {
            let weights = (-2..=3).map(f64::from).map(|i| [kernel.at(x - i), i * kernel.at(x - i)]);
            weights.fold([-1.0, -x], |s, w| [s[0] + w[0], s[1] + w[1]]).map(f64::abs)
        };
        Ok((0..100).map(|i| at(f64::from(i) / 100.0)).fold([0.0; 2], |w, e| [w[0].max(e[0]), w[1].max(e[1])]))
    }
    let rounding = 64.0 * f64::EPSILON;
    for [b, c] in [[1.0 / 3.0, 1.0 / 3.0], [0.0, 0.5], [1.0, 0.0], [0.6, 0.2]] {
        let [constant, straight] = order(b, c)?;
        prove([
            Residual::at_most(format!("({b:.2}, {c:.2}): Σk = 1"), constant, rounding),
            Residual::at_most(format!("({b:.2}, {c:.2}): Σi·k = x"), straight, rounding),
        ])?;
    }
    let [constant, straight] = order(0.0, 0.0)?;
    prove([
        Residual::at_most("(0, 0): Σk = 1", constant, rounding),
        // looked for at steps of 0.01, where the curvature is at most 6
        Residual::near("(0, 0): max|Σi·k − x| = √3/18", straight, 3f64.sqrt() / 18.0, 0.5 * 6.0 * 0.005 * 0.005),
    ])?;

    // %%
    show(lang, "f57-choice", &[("B", "0.2"), ("C", "0.8")])?;

    // %%
    show(lang, "f58-filters", &[("n", "1")])?;

    // %% en
    // With one sample a pixel, as here, the box shows it all: every pixel is its own sample. With more samples the three come
    // closer to each other.
    //
    // **Exercise.** Look for the cubic with the least overshoot on the line $B + 2C = 1$ for which $S$ is below 0.3. Is it near
    // Mitchell's?
    // %% ru
    // При одном отсчёте на пиксель, как здесь, box не скрывает ничего: пиксель и есть его отсчёт. Чем больше отсчётов, тем
    // ближе три картинки друг к другу.
    //
    // **Упражнение.** Найдите на прямой $B + 2C = 1$ кубическое ядро с наименьшим выбросом, у которого $S$ меньше 0,3. Далеко ли
    // оно от ядра Митчелла?

    // %% en
    // ## 7. The whole chain
    //
    // Sensors «integrate over an area», sampling «reads the signal at points»: two slides at the beginning of the lecture seem
    // to contradict each other (E18). Now the whole chain stands there, and both are right. The lens takes a mean over
    // $(u, v)$, the shutter over $t$, the sensor over the area of the pixel, and *then* there is a sample. Each mean is a
    // prefilter. A renderer with one ray a pixel has none of them; everything in these notebooks was about putting them back.
    // %% ru
    // ## 7. Вся цепочка
    //
    // Сенсоры «интегрируют по площади», дискретизация «читает сигнал в точках»: два слайда в начале лекции как будто
    // противоречат друг другу (E18). Теперь перед нами вся цепочка, и правы оба. Линза усредняет по $(u, v)$, затвор — по $t$,
    // сенсор — по площади пикселя, и *потом* берётся отсчёт. Каждое усреднение — префильтр. У рендерера с одним лучом на пиксель
    // нет ни одного; всё, о чём шла речь в этих тетрадях, — как их вернуть.
    // %%
    show(lang, "x-camera", &[])?;

    // %%
    show(lang, "f59-references", &[])?;

    // %% en
    // **Exercise.** The lens blurs what is out of focus, the shutter what moves. Which parts of a picture are protected from
    // aliasing by neither, so that the sensor's area must do it alone?
    // %% ru
    // **Упражнение.** Линза размывает то, что не в фокусе, затвор — то, что движется. Какие части картинки не защищены от
    // алиасинга ни тем, ни другим, так что всё ложится на площадь пикселя?

    Ok(())
}
