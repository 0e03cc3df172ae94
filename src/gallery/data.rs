//! Every layer of a figure as numbers: CSV for spreadsheets, JSON for programs.

use crate::figure::{Entry, Figure, Layer, Mark};
use crate::gallery::File;
use crate::text::Lang;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::fmt::Write;
use std::path::Path;

/// `data/STEM.json` with all layers, and `data/STEM/PANEL.LAYER.csv` for each; layers that share a name are numbered.
pub fn files(stem: &str, entry: &Entry, figure: &Figure) -> Vec<File> {
    let folder = Path::new("data");
    let mut files = Vec::new();
    let mut panels = Vec::new();
    for panel in &figure.panels {
        let mut seen: HashMap<&str, usize> = HashMap::new();
        let mut layers = Vec::new();
        for layer in &panel.layers {
            let count = seen.entry(layer.name).or_default();
            *count += 1;
            let name = if *count == 1 { layer.name.to_owned() } else { format!("{}-{count}", layer.name) };
            let (columns, rows) = table(layer);
            let mut csv = columns.join(",") + "\n";
            for row in &rows {
                let cells: Vec<String> = row.iter().map(|cell| cell.csv()).collect();
                writeln!(csv, "{}", cells.join(",")).expect("writing to a string cannot fail");
            }
            let path = folder.join(stem).join(format!("{}.{name}.csv", panel.name));
            files.push(File { path, bytes: csv.into_bytes() });
            let rows: Vec<Vec<Value>> = rows.iter().map(|row| row.iter().map(Cell::json).collect()).collect();
            let meaning = format!("{:?}", layer.meaning);
            layers.push(json!({ "name": name, "meaning": meaning, "columns": columns, "rows": rows }));
        }
        let label = |text: &crate::text::Text| json!({ "en": text.get(Lang::En), "ru": text.get(Lang::Ru) });
        let scale = |s: &crate::figure::Scale| json!({ "label": label(&s.label), "range": s.range, "log": s.log });
        let (x, y) = (scale(&panel.x), scale(&panel.y));
        panels.push(json!({ "name": panel.name, "title": label(&panel.title), "x": x, "y": y, "layers": layers }));
    }
    let whole = json!({ "id": entry.id, "panels": panels });
    files.push(File { path: folder.join(format!("{stem}.json")), bytes: format!("{whole:#}\n").into_bytes() });
    files
}

enum Cell<'a> {
    Number(f64),
    Words(&'a str),
}

impl Cell<'_> {
    fn csv(&self) -> String {
        match self {
            Self::Number(v) => v.to_string(),
            Self::Words(w) => format!("\"{}\"", w.replace('"', "\"\"")),
        }
    }

    fn json(&self) -> Value {
        match self {
            Self::Number(v) => json!(v), // NaN, the lifted pen, becomes null
            Self::Words(w) => json!(w),
        }
    }
}

/// The middle of the cell `i` of `n`.
fn middle((low, high): (f64, f64), i: usize, n: usize) -> f64 {
    low + (high - low) * (i as f64 + 0.5) / n as f64
}

fn table(layer: &Layer) -> (Vec<&'static str>, Vec<Vec<Cell<'_>>>) {
    fn numbers<const N: usize>(rows: impl IntoIterator<Item = [f64; N]>) -> Vec<Vec<Cell<'static>>> {
        rows.into_iter().map(|row| row.map(Cell::Number).into()).collect()
    }
    match &layer.mark {
        Mark::Line(p) | Mark::Dots(p) | Mark::Stems(p) | Mark::Bars { points: p, .. } => {
            (vec!["x", "y"], numbers(p.iter().copied()))
        }
        Mark::Arrows(p) => (vec!["at", "weight"], numbers(p.iter().copied())),
        Mark::Area(p) => (vec!["x", "lower", "upper"], numbers(p.iter().copied())),
        Mark::Verticals(at) => (vec!["x"], numbers(at.iter().map(|&v| [v]))),
        Mark::Horizontals(at) => (vec!["y"], numbers(at.iter().map(|&v| [v]))),
        Mark::Spans(p) => (vec!["from", "to"], numbers(p.iter().copied())),
        Mark::Pointers(p) => {
            (vec!["from_x", "from_y", "to_x", "to_y"], numbers(p.iter().map(|[a, b]| [a[0], a[1], b[0], b[1]])))
        }
        Mark::Notes(notes) => {
            let rows = notes.iter().map(|([x, y], text)| {
                vec![
                    Cell::Number(*x),
                    Cell::Number(*y),
                    Cell::Words(text.get(Lang::En)),
                    Cell::Words(text.get(Lang::Ru)),
                ]
            });
            (vec!["x", "y", "en", "ru"], rows.collect())
        }
        Mark::Raster { x, y, values, .. } => {
            let (rows, columns) = values.dim();
            let cells = values.indexed_iter();
            let places = cells.map(|((iy, ix), &v)| [middle(*x, ix, columns), middle(*y, iy, rows), v]);
            (vec!["x", "y", "value"], numbers(places))
        }
        Mark::Colors { x, y, light } => {
            let (rows, columns) = light[0].dim();
            let cells = light[0].indexed_iter();
            let places = cells.map(|((iy, ix), &red)| {
                let [green, blue] = [&light[1], &light[2]].map(|plane| plane[[iy, ix]]);
                [middle(*x, ix, columns), middle(*y, iy, rows), red, green, blue]
            });
            (vec!["x", "y", "red", "green", "blue"], numbers(places))
        }
    }
}
