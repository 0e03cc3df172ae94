//! Images and their spectra: waves, spots, turning, filtering, sampling on lattices, and what edges do.

#![allow(clippy::print_stdout, reason = "a notebook prints")]

use nyquist::course::{display, law, prove, show};
use nyquist::figure::{Figure, Layer, Legend, Meaning, Panel, Scale};
use nyquist::image::decimate::decimate;
use nyquist::laws::gibbs::SAMPLED_PEAK;
use nyquist::laws::plane::{parseval_of_image, spectrum_by_transform, transform_rounding};
use nyquist::prelude::*;
use nyquist::text;

fn main() -> Result<()> {
    // %% en
    // # 9. Images and their spectra
    //
    // An image is a function of two variables, and its transform
    // $$F(u, v) = \iint f(x, y)\,e^{-2\pi i(ux + vy)}\,dx\,dy$$
    // says how much of every plane wave is in it. The four slides «Spatial and Frequency Domain» and «More Examples» show
    // pairs of pictures; here each pair is computed, and what one sees in it is measured. After that: filters, sampling in
    // the plane, and the sources of aliasing in synthetic images.
    // %% ru
    // # 9. Изображения и их спектры
    //
    // Изображение — функция двух переменных, и её преобразование
    // $$F(u, v) = \iint f(x, y)\,e^{-2\pi i(ux + vy)}\,dx\,dy$$
    // говорит, сколько в ней каждой плоской волны. На четырёх слайдах «Spatial and Frequency Domain» и «More Examples» —
    // пары картинок; здесь каждая пара вычислена, а то, что в ней видно, измерено. Потом — фильтры, дискретизация на
    // плоскости и причины алиасинга в синтезе изображений.
    // %%
    let lang = Lang::En;

    // %% en
    // ## 1. A wave is two points
    //
    // **Theorem.** A sine with $k$ whole periods across a picture of $N \times N$ pixels has two bins of the size $N^2/2$, at
    // $(\pm k, 0)$, and nothing else. A constant $c$ has one, $cN^2$.
    //
    // Whole periods are essential: the transform takes the picture to be repeated. With 30 pixels a period, 128 pixels do not
    // close, and the two points grow tails.
    // %% ru
    // ## 1. Волна — это две точки
    //
    // **Теорема.** У синуса, который укладывается на картинке $N \times N$ целое число раз $k$, два отсчёта спектра величины
    // $N^2/2$, в $(\pm k, 0)$, и больше ничего. У константы $c$ — один, $cN^2$.
    //
    // Целое число периодов существенно: преобразование считает картинку периодически продолженной. При периоде 30 пикселей
    // 128 пикселей не замыкаются, и у двух точек вырастают хвосты.
    // %%
    let grid = Grid::centered(1.0, 128, 128)?;
    fn sine(period: f64) -> Result<Grating> {
        Grating::with_phase([1.0 / period, 0.0], -std::f64::consts::FRAC_PI_2)
    }
    let whole = Image::of(&sine(32.0)?, grid);
    let bins = image_forward(&whole);
    let size: f64 = whole.values().iter().map(|v| v.abs()).sum();
    let rounding = transform_rounding(grid.len()) * size;
    prove([
        Residual::near("|F(4, 0)| = N²/2", bins.bin(4, 0).norm(), 8192.0, rounding),
        Residual::near("|F(−4, 0)| = N²/2", bins.bin(-4, 0).norm(), 8192.0, rounding),
        spectrum_by_transform(&whole, &sine(32.0)?.spectrum(), 0.0), // all other bins
    ])?;
    let mut panel = Panel::new(
        "row",
        Text::EMPTY,
        Scale::linear(text!("periods across the picture", "периодов на картинку"), -12.0, 12.0),
        Scale::log(text!("|F(k, 0)|", "|F(k, 0)|"), 1.0, 20_000.0),
    )
    .legend(Legend::Above);
    for (i, period) in (0..).zip([32.0, 30.0]) {
        let bins = image_forward(&Image::of(&sine(period)?, grid));
        let row: Vec<[f64; 2]> = (-12..=12i64).map(|k| [k as f64, bins.bin(k, 0).norm().max(1.0)]).collect();
        let layer = Layer::dots("bins", Meaning::Series(i), row.clone());
        panel = panel
            .with(Layer::line("between", Meaning::Series(i), row).thin())
            .with(layer.label(text!("{period} pixels a period", "период {period} пикселей")));
    }
    let title = text!("Whole periods, and not quite", "Целое число периодов и не совсем");
    display(lang, &title, &Figure::new(1).with(panel))?;

    // %%
    show(lang, "f43-spatial-and-frequency", &[])?;

    // %% en
    // **Exercise.** Where are the two points of a sine with 100 periods across 128 pixels? Predict it, then set the period to
    // `1.28` in the code above and ask for the right bin.
    // %% ru
    // **Упражнение.** Где окажутся две точки синуса, у которого 100 периодов на 128 пикселей? Предскажите, потом поставьте в
    // коде выше период `1.28` и спросите нужный отсчёт.

    // %% en
    // ## 2. Direction, and products
    //
    // The points lie in the direction in which the wave runs, at the distance of its number of periods. A *sum* of waves is a
    // sum of points. A *product* is not:
    // $$\sin a \cdot \sin b = \tfrac12\cos(a - b) - \tfrac12\cos(a + b),$$
    // four points of half the size at the sums and differences of the frequencies, and none where the factors had theirs.
    // That is the convolution theorem, read from right to left.
    // %% ru
    // ## 2. Направление и произведения
    //
    // Точки лежат в том направлении, в котором бежит волна, на расстоянии, равном числу её периодов. *Сумма* волн — сумма
    // точек. А *произведение* — нет:
    // $$\sin a \cdot \sin b = \tfrac12\cos(a - b) - \tfrac12\cos(a + b),$$
    // то есть четыре точки вдвое меньшей величины на суммах и разностях частот, и ни одной там, где они были у сомножителей.
    // Это теорема о свёртке, прочитанная справа налево.
    // %%
    let across = Image::of(&Grating::new([4.0 / 128.0, 0.0])?, grid);
    let down = Image::of(&Grating::new([0.0, 8.0 / 128.0])?, grid);
    let product = image_forward(&across.with(&down, |a, b| a * b)?);
    let sum = image_forward(&across.with(&down, |a, b| a + b)?);
    let rounding = transform_rounding(grid.len()) * 2.0 * 128.0 * 128.0;
    prove([
        Residual::near("sum: F(4, 0) = N²/2", sum.bin(4, 0).norm(), 8192.0, rounding),
        Residual::near("sum: F(4, 8) = 0", sum.bin(4, 8).norm(), 0.0, rounding),
        Residual::near("product: F(4, 0) = 0", product.bin(4, 0).norm(), 0.0, rounding),
        Residual::near("product: F(4, 8) = N²/4", product.bin(4, 8).norm(), 4096.0, rounding),
        Residual::near("product: F(−4, 8) = N²/4", product.bin(-4, 8).norm(), 4096.0, rounding),
    ])?;

    // %%
    show(lang, "f44-waves", &[("k", "5"), ("m", "10")])?;

    // %% en
    // **Exercise.** A picture's spectrum has four points, at $(\pm3, \pm3)$. Is the picture a sum of two waves or a product of
    // two waves? Can one tell?
    // %% ru
    // **Упражнение.** В спектре картинки четыре точки, $(\pm3, \pm3)$. Что это — сумма двух волн или произведение двух волн?
    // Можно ли это различить?

    // %% en
    // ## 3. Spots: wide here, narrow there
    //
    // $$e^{-r^2/a^2} \;\leftrightarrow\; \pi a^2 e^{-\pi^2a^2\rho^2}, \qquad \sigma_x\,\sigma_u = \frac1{2\pi}.$$
    // A spot twice as wide has a spectrum half as wide and four times as high: its sum over all pixels, $F(0, 0)$, has grown
    // so much. Below the widths are measured on the two pictures as root mean squares, without the formula.
    // %% ru
    // ## 3. Пятна: где широко, там узко
    //
    // $$e^{-r^2/a^2} \;\leftrightarrow\; \pi a^2 e^{-\pi^2a^2\rho^2}, \qquad \sigma_x\,\sigma_u = \frac1{2\pi}.$$
    // У вдвое более широкого пятна спектр вдвое у́же и вчетверо выше: во столько раз выросла его сумма по всем пикселям,
    // $F(0, 0)$. Ниже ширины измерены по самим картинкам, как среднеквадратичные, без формулы.
    // %%
    // ∫∫ w·f over ∫∫ f for a grid of values
    fn moment(grid: Grid, values: &[f64], weight: impl Fn(f64, f64) -> f64) -> f64 {
        let sums = grid.iter().zip(values).map(|([x, y], f)| [f * weight(x, y), *f]);
        let [part, whole] = sums.fold([0.0; 2], |s, t| [s[0] + t[0], s[1] + t[1]]);
        part / whole
    }
    for a in [4.0, 8.0] {
        let spot = GaussianSpot::round(a)?;
        let picture = Image::of(&spot, grid);
        let bins = image_forward(&picture);
        // the picture is even about a pixel: its spectrum is real
        let real: Vec<f64> = bins.values().iter().map(|f| f.re).collect();
        let sigma_x = moment(grid, picture.values(), |x, _| x * x).sqrt();
        let sigma_u = moment(bins.grid(), &real, |u, _| u * u).sqrt();
        println!("a = {a}: σₓ = {sigma_x:.4}, σᵤ = {sigma_u:.5}, F(0, 0) = {:.2}", bins.bin(0, 0).re);
        // each of N² bins is rounded by transform_rounding·Σf; weighted by u² ≤ ½ they err by N² of that, over ΣF = N²·f(0),
        // relative to σᵤ²; the root halves it
        let sum = bins.bin(0, 0).re;
        let bound = 0.5 * transform_rounding(grid.len()) * sum * 0.5 / (sigma_u * sigma_u);
        let product = std::f64::consts::TAU * sigma_x * sigma_u;
        prove([
            Residual::near(format!("a = {a}: 2π·σₓσᵤ = 1"), product, 1.0, bound),
            spectrum_by_transform(&picture, &spot.spectrum(), 0.0),
        ])?;
    }

    // %%
    show(lang, "f45-gaussians", &[("a", "10")])?;

    // %% en
    // **Exercise.** For which $a$ does a spot look the same in both pictures, if the spectrum is drawn with one bin for each
    // pixel? (128 pixels; the answer is a formula.)
    // %% ru
    // **Упражнение.** При каком $a$ пятно выглядит на обеих картинках одинаково, если отсчёт спектра рисовать размером с
    // пиксель? (128 пикселей; ответ — формула.)

    // %% en
    // ## 4. Turn the picture, and the spectrum turns
    //
    // **Theorem.** $f(R^{-1}x) \leftrightarrow F(R^{-1}u)$ for every rotation $R$: by the same angle, in the same sense. A spot
    // that is long in one direction has a spectrum that is short in that direction, so that the long axes of picture and
    // spectrum stand at right angles, whatever the angle.
    // %% ru
    // ## 4. Поверните картинку — повернётся и спектр
    //
    // **Теорема.** $f(R^{-1}x) \leftrightarrow F(R^{-1}u)$ для любого поворота $R$: на тот же угол и в ту же сторону. У пятна,
    // вытянутого в одном направлении, спектр в этом направлении короткий, так что длинные оси картинки и спектра
    // перпендикулярны при любом угле.
    // %%
    // the direction of the longer axis, in degrees, by second moments
    fn direction(grid: Grid, values: &[f64]) -> f64 {
        let xx = moment(grid, values, |x, _| x * x);
        let xy = moment(grid, values, |x, y| x * y);
        let yy = moment(grid, values, |_, y| y * y);
        (0.5 * (2.0 * xy).atan2(xx - yy)).to_degrees()
    }
    let degrees = 25.0f64;
    let picture = Image::of(&GaussianSpot::turned([8.0, 4.0], degrees.to_radians())?, grid);
    let bins = image_forward(&picture);
    let real: Vec<f64> = bins.values().iter().map(|f| f.re).collect();
    let [long, short] = [direction(grid, picture.values()), direction(bins.grid(), &real)];
    // moments of the spectrum are rounded as in section 3; the difference of the two widths is at least 1/(2π²)·(1/4² − 1/8²)
    let widths = (4f64.powi(-2) - 8f64.powi(-2)) / (2.0 * std::f64::consts::PI.powi(2));
    let bound = (transform_rounding(grid.len()) * bins.bin(0, 0).re / widths).to_degrees();
    prove([
        Residual::near("picture: 25°", long, degrees, bound),
        Residual::near("spectrum: 25° − 90°", short, degrees - 90.0, bound),
    ])?;
    law(lang, "rotation")?;

    // %%
    show(lang, "f46-turned", &[("angle", "30")])?;

    // %% en
    // **Exercise.** A thin line runs through a picture at 10° from the horizontal. What does its spectrum look like, and where
    // does it point?
    // %% ru
    // **Упражнение.** Через картинку под углом 10° к горизонтали идёт тонкая линия. Как выглядит её спектр и куда он
    // направлен?

    // %% en
    // ## 5. Filters: a picture in three parts
    //
    // A filter multiplies the spectrum. Low-pass, band-pass and high-pass with common cut-offs add up to the picture. If they
    // are ideal, their spectra have nothing in common, the parts are orthogonal, and by Parseval's theorem
    // $$\sum f^2 = \sum f_{\text{low}}^2 + \sum f_{\text{band}}^2 + \sum f_{\text{high}}^2.$$
    // Soft filters still add up to the picture; their energies do not add up.
    // %% ru
    // ## 5. Фильтры: картинка из трёх частей
    //
    // Фильтр умножает спектр. Низкие, средние и высокие частоты с общими границами складываются в картинку. Если фильтры
    // идеальны, их спектры не имеют общих точек, части ортогональны, и по теореме Парсеваля
    // $$\sum f^2 = \sum f_{\text{low}}^2 + \sum f_{\text{band}}^2 + \sum f_{\text{high}}^2.$$
    // Плавные фильтры по-прежнему дают в сумме картинку, но энергии уже не складываются.
    // %%
    let wall = Image::averaged(&BrickWall::new([24.0, 10.0], 1.5, [0.2, 0.8])?, Grid::centered(1.0, 96, 96)?);
    fn energy(image: &Image) -> f64 {
        image.values().iter().map(|v| v * v).sum()
    }
    let rounding = transform_rounding(wall.grid().len());
    for (name, shape) in [("ideal", Shape::Ideal), ("Gaussian", Shape::Gaussian)] {
        let low = Filter::low_pass(0.06, shape)?.apply(&wall);
        let band = Filter::band_pass(0.06, 0.2, shape)?.apply(&wall);
        let high = Filter::high_pass(0.2, shape)?.apply(&wall);
        let parts = energy(&low) + energy(&band) + energy(&high);
        println!("{name}: Σ‖f_i‖²/‖f‖² = {:.4}", parts / energy(&wall));
        let again = low.with(&band, |a, b| a + b)?.with(&high, |a, b| a + b)?;
        // three filters, two transforms each
        let bound = 6.0 * rounding * energy(&wall).sqrt();
        prove([Residual::at_most(format!("{name}: f_low + f_band + f_high = f"), 96.0 * again.rmse(&wall)?, bound)])?;
        if shape == Shape::Ideal {
            prove([Residual::near("Σ‖f_i‖² = ‖f‖²", parts / energy(&wall), 1.0, 12.0 * rounding)])?;
        }
    }
    prove([parseval_of_image(&wall)])?;

    // %%
    show(lang, "x-frequency-filters", &[("shape", "gaussian")])?;

    // %% en
    // **Exercise.** Change the shape in the figure to `ideal`. What appears around the edges, and which function of two
    // variables do you see there? (In one dimension it would be the sinc.)
    // %% ru
    // **Упражнение.** Поставьте в рисунке форму `ideal`. Что появилось у краёв и какую функцию двух переменных вы там видите?
    // (В одномерном случае это был бы sinc.)

    // %% en
    // ## 6. Sampling in the plane
    //
    // **Theorem.** Samples on a lattice repeat the spectrum on the *dual* lattice. Keeping every $T$-th pixel in both
    // directions makes copies $1/T$ apart, each as strong as the first:
    // $$F_T(u, v) = \sum_{m,n} F\!\left(u - \tfrac mT, v - \tfrac nT\right).$$
    // On pictures the theorem is exact, bin by bin; nothing is approximated.
    // %% ru
    // ## 6. Дискретизация на плоскости
    //
    // **Теорема.** Отсчёты на решётке повторяют спектр на *двойственной* решётке. Если оставить каждый $T$-й пиксель по обоим
    // направлениям, копии встанут через $1/T$, каждая не слабее первой:
    // $$F_T(u, v) = \sum_{m,n} F\!\left(u - \tfrac mT, v - \tfrac nT\right).$$
    // Для картинок теорема точна, отсчёт к отсчёту: приближений здесь нет.
    // %%
    let fine = image_forward(&wall);
    let coarse = image_forward(&decimate(&wall, [4, 4])?); // 24 × 24 bins
    let mut worst: f64 = 0.0;
    for (k, l) in (-12..12i64).flat_map(|l| (-12..12i64).map(move |k| (k, l))) {
        let copies = (0..16).map(|i| fine.bin(k + 24 * (i % 4), l + 24 * (i / 4)));
        // what is left of the coarse bin when all sixteen copies are taken away
        worst = worst.max(copies.fold(coarse.bin(k, l), |rest, copy| rest - copy).norm());
    }
    let size: f64 = wall.values().iter().sum();
    prove([Residual::at_most("F₄ = Σ F(· − m/4, · − n/4)", worst, 17.0 * rounding * size)])?;

    let (square, hexagonal) = (Lattice::square_for(0.5)?, Lattice::hexagonal_for(0.5)?);
    let ratio = hexagonal.density() / square.density();
    prove([Residual::near("hexagonal/square = √3/2", ratio, 0.75f64.sqrt(), 8.0 * f64::EPSILON)])?;

    // %%
    show(lang, "x-plane-copies", &[])?;

    // %% en
    // For a band that is round, a hexagonal lattice needs 13.4 % fewer samples: round copies pack more densely on it.
    //
    // The zone plate has every frequency somewhere. Its samples repeat with its own period, and the false centres are as sharp
    // as the true one: that is *pre*aliasing, and no reconstruction can undo it. What a poor kernel adds is *post*aliasing.
    // %% ru
    // Для круглой полосы гексагональной решётке хватает на 13,4 % меньше отсчётов: круглые копии упаковываются на ней плотнее.
    //
    // На зонной пластинке есть все частоты. Её отсчёты повторяются с её собственным периодом, и ложные центры столь же резки,
    // как настоящий: это *пре*алиасинг, никакая реконструкция его не исправит. То, что добавляет плохое ядро, — *пост*алиасинг.
    // %%
    let plate = ZonePlate::new(64.0)?;
    let mut differs: f64 = 0.0;
    for (x, y) in (0..64).flat_map(|y| (0..64).map(move |x| (f64::from(x), f64::from(y)))) {
        differs = differs.max((plate.at(x + 64.0, y) - plate.at(x, y)).abs());
    }
    prove([Residual::at_most("f(x + M, y) = f(x, y), x, y ∈ ℤ", differs, 64.0 * f64::EPSILON)])?;
    show(lang, "x-zone-plate", &[])?;

    // %% en
    // **Exercise.** Take an odd period, 63. Do the samples still repeat? With which period, and why? (Try it: the proof above
    // then fails.)
    // %% ru
    // **Упражнение.** Возьмите нечётный период, 63. Повторяются ли отсчёты? С каким периодом и почему? (Попробуйте:
    // доказательство выше тогда не пройдёт.)

    // %% en
    // ## 7. Where aliasing in synthetic images comes from
    //
    // Edges first. The slide says that borders of objects create «infinite frequencies». An edge has no frequency that is
    // infinite; its spectrum has no *end* (E21): it falls as $1/\nu$, a corner's as $1/(\nu_x\nu_y)$. Slowly enough that twice
    // as many samples make the error only $\sqrt2$ times smaller.
    //
    // And the rings: reconstruction by the sinc does *not* ring on correctly sampled data. What rings are samples of something
    // that has no band limit, and the overshoot is not Gibbs' 8.95 % (E15). The sinc through samples of a step gives
    // $$\tilde f\left(\tfrac12\right) = \tfrac12 + \tfrac2\pi = 1.1366,$$
    // and at most 14.11 % wherever between two samples the jump is. The 8.95 % belong to the step itself behind an ideal
    // low-pass.
    // %% ru
    // ## 7. Откуда берётся алиасинг в синтезе изображений
    //
    // Сначала границы. На слайде сказано, что границы объектов создают «бесконечные частоты». Бесконечной частоты у края нет;
    // у его спектра нет *конца* (E21): он убывает как $1/\nu$, а у угла — как $1/(\nu_x\nu_y)$. Настолько медленно, что от
    // удвоения числа отсчётов ошибка уменьшается лишь в $\sqrt2$ раз.
    //
    // Теперь кольца: на верно взятых отсчётах sinc *не* звенит. Звенят отсчёты того, у чего нет верхней частоты, и выброс — не
    // 8,95 % Гиббса (E15). Sinc по отсчётам ступеньки даёт
    // $$\tilde f\left(\tfrac12\right) = \tfrac12 + \tfrac2\pi = 1{,}1366,$$
    // а самое большее 14,11 %, где бы между двумя отсчётами ни был скачок. 8,95 % — это сама ступенька за идеальным
    // фильтром низких частот.
    // %%
    let edges = Boxcar::new(1.0)?.spectrum();
    let mut worst: f64 = 0.0;
    for nu in (1..=1000).map(|k| f64::from(k) + 0.5) {
        // here the sine is ±1
        worst = worst.max((edges.density(nu).norm() * std::f64::consts::PI * nu - 1.0).abs());
    }
    let peak = Ideal.step_response(SAMPLED_PEAK.at);
    println!("f̃({:.4}) = {peak:.5}", SAMPLED_PEAK.at);
    prove([
        Residual::at_most("πν·|F(ν)| = 1", worst, 8.0 * f64::EPSILON),
        Residual::near(
            "f̃(½) = ½ + 2/π",
            Ideal.step_response(0.5),
            0.5 + 2.0 / std::f64::consts::PI,
            8.0 * f64::EPSILON,
        ),
    ])?;
    law(lang, "low-passed-step")?;

    // %%
    show(lang, "f48-gibbs", &[("place", "0.2")])?;

    // %%
    show(lang, "f48-sources", &[])?;

    // %% en
    // Small objects fall between the samples; textures become finer than pixels towards the horizon; highlights and shadow
    // edges are created by the shading itself, so that no one can filter them in advance.
    //
    // **Exercise.** A fence has posts 0.3 pixels wide, one every 3.1 pixels. What does one sample a pixel make of it? With
    // which period does the picture repeat?
    // %% ru
    // Мелкие предметы попадают между отсчётами; текстуры к горизонту становятся мельче пикселя; блики и края теней рождаются
    // уже при закраске, и заранее их никто не отфильтрует.
    //
    // **Упражнение.** У забора столбики шириной 0,3 пикселя, по одному на каждые 3,1 пикселя. Что увидит один отсчёт на
    // пиксель? С каким периодом повторяется картинка?

    Ok(())
}
