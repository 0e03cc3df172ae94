//! One scene, three formats: deterministic, well formed, cut at the frame, pixel-exact.

use crate::samples::{Pixels, all, bare, colors};
use ndarray::Array2;
use nyquist::figure::{Bar, Figure, Layer, Meaning, Panel, Scale, Tones};
use nyquist::plot::{Format, Style, Theme, animated, draw};
use nyquist::text::{Lang, Text};
use std::sync::OnceLock;

fn styles() -> Vec<Style> {
    let mut styles = Vec::new();
    for lang in Lang::ALL {
        for theme in Theme::ALL {
            styles.push(Style { lang, theme, ..Style::default() });
        }
    }
    styles.push(Style { size: (1200, 900), title: false, scale: 0.5, ..Style::default() });
    styles
}

type Written = Vec<(String, Format, Vec<u8>)>;

/// Every sample in every style and format, once for all tests.
fn written() -> &'static Written {
    static WRITTEN: OnceLock<Written> = OnceLock::new();
    WRITTEN.get_or_init(write)
}

fn write() -> Written {
    let mut written = Vec::new();
    for (name, title, figure) in all() {
        for (i, style) in styles().iter().enumerate() {
            let scene = draw(&title, &Text::fixed("What is seen <&>", "Что видно <&>"), &figure, style);
            for format in Format::ALL {
                written.push((format!("{name} in style {i}"), format, scene.write(format)));
            }
        }
    }
    written
}

#[test]
fn the_same_bytes_every_time_and_in_every_thread() {
    let threads: Vec<_> = (0..2).map(|_| std::thread::spawn(write)).collect();
    for thread in threads {
        let there = thread.join().expect("no thread panics");
        for ((name, format, a), (_, _, b)) in written().iter().zip(&there) {
            assert!(a == b, "{name} as {format:?} differs between threads");
        }
    }
}

#[test]
fn every_svg_is_well_formed_and_refers_only_to_what_it_defines() {
    for (name, _, bytes) in written().iter().filter(|w| w.1 == Format::Svg) {
        let text = String::from_utf8(bytes.clone()).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
        let root = document.root_element();
        assert_eq!(root.attribute("role"), Some("img"), "{name}");
        assert!(root.children().any(|n| n.has_tag_name(("http://www.w3.org/2000/svg", "title"))), "{name}");
        assert!(root.children().any(|n| n.has_tag_name(("http://www.w3.org/2000/svg", "desc"))), "{name}");
        let ids: std::collections::BTreeSet<&str> = document.descendants().filter_map(|n| n.attribute("id")).collect();
        for node in document.descendants() {
            let used = node.attribute(("http://www.w3.org/1999/xlink", "href")).and_then(|h| h.strip_prefix('#'));
            let clip = node.attribute("clip-path").and_then(|c| c.strip_prefix("url(#")?.strip_suffix(')'));
            for id in used.into_iter().chain(clip) {
                assert!(ids.contains(id), "{name}: nothing is called {id}");
            }
        }
        assert!(!text.contains("-0 ") && !text.contains("-0\"") && !text.contains("NaN"), "{name}");
    }
}

#[test]
fn pictures_of_curves_are_small() {
    for (name, format, bytes) in written().iter().filter(|w| !w.0.starts_with("raster")) {
        let most = if *format == Format::Png { 250_000 } else { 60_000 };
        assert!(bytes.len() < most, "{name} as {format:?} has {} bytes", bytes.len());
    }
}

#[test]
fn every_pdf_is_one_page_of_its_size_and_its_table_of_objects_is_right() {
    for (name, _, bytes) in written().iter().filter(|w| w.1 == Format::Pdf) {
        assert!(bytes.starts_with(b"%PDF-1.7") && bytes.ends_with(b"%%EOF"), "{name}");
        let text = String::from_utf8_lossy(bytes);
        let page = if name.ends_with("style 4") { "/MediaBox [0 0 720 540]" } else { "/MediaBox [0 0 960 540]" };
        assert!(text.contains(page), "{name}");
        let find = |what: &[u8], from: usize| from + bytes[from..].windows(what.len()).position(|w| w == what).unwrap();
        let start = String::from_utf8_lossy(&bytes[find(b"startxref", 0) + 9..]).into_owned();
        let table: usize = start.split_whitespace().next().unwrap().parse().unwrap();
        assert!(bytes[table..].starts_with(b"xref"), "{name}: startxref leads elsewhere");
        let rows = String::from_utf8_lossy(&bytes[table..]).into_owned();
        for (id, row) in rows.lines().skip(2).take_while(|r| *r != "trailer").enumerate() {
            if let Some(offset) = row.strip_suffix(" 00000 n").or_else(|| row.trim_end().strip_suffix(" 00000 n")) {
                let offset: usize = offset.parse().unwrap();
                assert!(bytes[offset..].starts_with(format!("{id} 0 obj").as_bytes()), "{name}: object {id}");
            }
        }
        // The page's content can be unpacked, and what it saves it restores.
        let content = find(b"\nstream\n", find(b"4 0 obj", 0)) + 8;
        let unpacked = miniz_oxide::inflate::decompress_to_vec_zlib(&bytes[content..find(b"\nendstream", content)]);
        let unpacked = String::from_utf8(unpacked.unwrap()).unwrap();
        let count = |op: &str| unpacked.lines().filter(|l| *l == op).count();
        assert_eq!(count("q"), count("Q"), "{name}");
    }
}

#[test]
fn nothing_touches_the_edge_of_the_picture() {
    for (name, title, figure) in all() {
        for style in styles() {
            let pixels = Pixels::of(&draw(&title, &Text::EMPTY, &figure, &style));
            let paper = pixels.at(0, 0);
            let (w, h) = pixels.size;
            let margin = (8.0 * style.scale) as usize;
            let outside = |x: usize, y: usize| x < margin || y < margin || x >= w - margin || y >= h - margin;
            for (x, y) in (0..h).flat_map(|y| (0..w).map(move |x| (x, y))).filter(|p| outside(p.0, p.1)) {
                assert_eq!(pixels.at(x, y), paper, "{name} in {style:?}: something at {x}, {y}");
            }
        }
    }
}

#[test]
fn a_curve_that_leaves_the_panel_is_cut_and_not_bent_along_the_frame() {
    let steep = Layer::curve("f", Meaning::Leaked, 0.0, 1.0, 50, |x| 40.0 * (x - 0.5));
    let axis = || Scale::linear(Text::EMPTY, 0.0, 1.0).bare();
    let y = Scale::linear(Text::EMPTY, -1.0, 1.0).bare();
    let figure = Figure::new(1).with(Panel::new("p", Text::EMPTY, axis(), y).with(steep));
    let pixels = Pixels::of(&draw(&Text::EMPTY, &Text::EMPTY, &figure, &Style::default()));
    let red = |y: usize| (0..pixels.size.0).filter(|x| pixels.is(*x, y, Theme::Light.colour(Meaning::Leaked))).count();
    let most = (0..pixels.size.1).map(red).max().unwrap();
    // The line is 3.5 units wide and rises by 20 panel heights: no row sees much more of it than its own width.
    assert!(most <= 12, "{most} pixels in a row");
    let rows = (0..pixels.size.1).filter(|y| red(*y) > 0).count();
    assert!(rows > 800, "it crosses the whole panel: {rows} rows");
}

#[test]
fn the_slope_of_a_cut_line_is_kept_however_far_it_leads() {
    // From (0, 0) to (1, 1e9): at the frame's top, y = 1, it is still at x = 1e-9, that is, vertical.
    for far in [1e3, 1e6, 1e9, 1e300] {
        let line = Layer::line("f", Meaning::Leaked, [[0.5, 0.0], [1.0, far]]);
        let axis = || Scale::linear(Text::EMPTY, 0.0, 1.0).bare();
        let figure = Figure::new(1).with(Panel::new("p", Text::EMPTY, axis(), axis()).with(line));
        let pixels = Pixels::of(&draw(&Text::EMPTY, &Text::EMPTY, &figure, &Style::default()));
        let colour = Theme::Light.colour(Meaning::Leaked);
        let columns: Vec<usize> =
            (0..pixels.size.0).filter(|x| (0..pixels.size.1).any(|y| pixels.is(*x, y, colour))).collect();
        let (first, last) = (columns[0], columns[columns.len() - 1]);
        assert!(first.abs_diff(800) <= 4 && last.abs_diff(800) <= 4, "{far}: columns {first} to {last}");
    }
}

#[test]
fn cells_of_a_raster_are_whole_pixels_of_one_tone() {
    let n = 96;
    let checks = Array2::from_shape_fn((n, n), |(y, x)| if (x + y) % 2 == 0 { 0.0 } else { 1.0 });
    let range = (0.0, n as f64);
    let axis = || Scale::linear(Text::EMPTY, range.0, range.1).bare();
    let raster = Layer::raster("r", range, range, checks, (0.0, 1.0), Tones::Grey);
    let figure = Figure::new(1).with(Panel::new("p", Text::EMPTY, axis(), axis()).square().with(raster));
    let pixels = Pixels::of(&draw(&Text::EMPTY, &Text::EMPTY, &figure, &Style::default()));
    // Along a row through the middle of the picture, inside the frame: runs of equal length, black and white by turns.
    let row: Vec<u8> = (0..pixels.size.0).map(|x| pixels.at(x, 420)[0]).collect();
    let inside: Vec<u8> = row[450..1150].to_vec();
    assert!(inside.iter().all(|v| *v == 0 || *v == 255), "only the two tones");
    let mut runs: Vec<usize> = inside.chunk_by(|a, b| a == b).map(<[u8]>::len).collect();
    runs.remove(0);
    runs.pop();
    assert!(runs.iter().all(|r| *r == runs[0]) && runs[0] == 8, "{runs:?}");
}

#[test]
fn a_raster_with_cells_below_a_pixel_keeps_its_mean_light() {
    // Black and white lines far finer than a pixel: half the light is sRGB 188, not 128.
    let stripes = Array2::from_shape_fn((8, 4000), |(_, x)| f64::from(u8::from(x % 2 == 0)));
    let axis = |n: f64| Scale::linear(Text::EMPTY, 0.0, n).bare();
    let raster = Layer::raster("r", (0.0, 4000.0), (0.0, 8.0), stripes, (0.0, 1.0), Tones::Grey);
    let figure = Figure::new(1).with(Panel::new("p", Text::EMPTY, axis(4000.0), axis(8.0)).with(raster));
    let pixels = Pixels::of(&draw(&Text::EMPTY, &Text::EMPTY, &figure, &Style::default()));
    let row = (100..1500).map(|x| f64::from(pixels.at(x, 450)[0]));
    let light = row.map(|v| ((v / 255.0 + 0.055) / 1.055).powf(2.4)).sum::<f64>() / 1400.0;
    assert!((light - 0.5).abs() < 0.01, "mean light {light}");
}

#[test]
fn anything_can_be_drawn() {
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -1.0, 1e300, 5e-324];
    for range in
        [(0.0, 1.0), (1.0, 0.0), (1.0, 1.0), (f64::NAN, 1.0), (0.0, f64::INFINITY), (-1e300, 1e300), (1e-9, 1.0)]
    {
        for log in [false, true] {
            let scale = || {
                let mut scale = Scale::linear(Text::same("x"), range.0, range.1);
                scale.log = log;
                scale
            };
            let points: Vec<[f64; 2]> = odd.iter().flat_map(|x| odd.iter().map(|y| [*x, *y])).collect();
            let mut panel = Panel::new("p", Text::same("_{^{x"), scale(), scale());
            for layer in [
                Layer::line("a", Meaning::Signal, points.clone()).label(Text::same("a")),
                Layer::dots("b", Meaning::Signal, points.clone()),
                Layer::stems("c", Meaning::Signal, points.clone()),
                Layer::arrows("d", Meaning::Signal, points.clone()),
                Layer::area("e", Meaning::Signal, points.clone()),
                Layer::bars("f", Meaning::Signal, 0.1, points.clone()),
                Layer::verticals("g", Meaning::Signal, odd),
                Layer::horizontals("h", Meaning::Signal, odd),
                Layer::spans("i", Meaning::Signal, points.clone()),
                Layer::pointers("j", Meaning::Signal, points.iter().map(|p| [*p, [0.5, 0.5]])),
                Layer::notes("k", Meaning::Signal, points.iter().map(|p| (*p, Text::same("}{")))),
                Layer::raster("l", range, range, Array2::from_elem((2, 3), f64::NAN), range, Tones::Data),
                Layer::raster("m", range, range, Array2::zeros((0, 0)), range, Tones::Grey),
                Layer::colors("n", range, range, &colors([[f64::MAX, -1.0, 0.5], [0.0, 0.0, 0.0]])),
            ] {
                panel = panel.with(layer);
            }
            panel = panel.bar(if log { Bar::powers_of_ten(Text::same("}")) } else { Bar::values(Text::EMPTY) });
            let scene = draw(
                &Text::EMPTY,
                &Text::EMPTY,
                &Figure::new(0).with(panel),
                &Style { scale: 0.2, ..Style::default() },
            );
            for format in Format::ALL {
                assert!(!scene.write(format).is_empty());
            }
        }
    }
    for figure in [Figure::new(3), bare()] {
        for size in [(0, 0), (320, 180), (180, 1600)] {
            let style = Style { size, scale: f64::NAN, ..Style::default() };
            let scene = draw(&Text::same("A title that has no room at all"), &Text::EMPTY, &figure, &style);
            assert!(!scene.png().is_empty());
        }
    }
}

#[test]
fn formats_are_read_by_name_and_the_nearest_is_named_first() {
    assert_eq!("SVG".parse::<Format>().unwrap(), Format::Svg);
    let error = "pmg".parse::<Format>().unwrap_err().to_string();
    assert_eq!(error, "no format is called \"pmg\"; known: png, svg, pdf");
    assert_eq!("dark".parse::<Theme>().unwrap(), Theme::Dark);
}

/// The frames of an animation as whole pictures, and how long one lasts.
fn frames(apng: &[u8]) -> (Vec<Vec<u8>>, [u16; 2]) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(apng)).read_info().expect("the file is a PNG");
    let count = reader.info().animation_control().expect("it is an animation").num_frames;
    let width = reader.info().width as usize;
    let mut shown = vec![0; 3 * width * reader.info().height as usize];
    let (mut pictures, mut delay) = (Vec::new(), [0, 0]);
    for _ in 0..count {
        let mut part = vec![0; shown.len()];
        let read = reader.next_frame(&mut part).expect("the frame can be read");
        let control = reader.info().frame_control().copied().expect("every frame has its place");
        delay = [control.delay_num, control.delay_den];
        let line = 3 * read.width as usize;
        for (j, row) in part.chunks_exact(line).take(read.height as usize).enumerate() {
            let at = 3 * ((control.y_offset as usize + j) * width + control.x_offset as usize);
            shown[at..at + line].copy_from_slice(row);
        }
        pictures.push(shown.clone());
    }
    (pictures, delay)
}

#[test]
fn an_animation_shows_its_frames() {
    let figure = nyquist::figure::catalog::by_name("f03-strobing").and_then(|entry| entry.figure());
    let motion = figure.expect("the wheel can be computed").motion.expect("it turns");
    let style = Style { size: (480, 270), ..Default::default() };
    let scenes: Vec<_> =
        motion.frames[..5].iter().map(|frame| draw(&Text::EMPTY, &Text::EMPTY, frame, &style)).collect();
    let apng = animated(&scenes, motion.rate);
    assert_eq!(apng, animated(&scenes, motion.rate));
    let (pictures, delay) = frames(&apng);
    assert_eq!((pictures.len(), delay), (5, [1, motion.rate]));
    for (scene, picture) in scenes.iter().zip(pictures) {
        let still = scene.png();
        let mut reader = png::Decoder::new(std::io::Cursor::new(&still)).read_info().expect("a PNG");
        let mut pixels = vec![0; picture.len()];
        reader.next_frame(&mut pixels).expect("it can be read");
        assert!(pixels == picture, "a frame differs from its still");
    }
}
