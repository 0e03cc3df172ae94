//! The six numbers of a kernel, against the table (V06).

use crate::kernel::Kernel;
use crate::kernel::catalog::by_name;
use crate::kernel::metrics::Metrics;
use crate::laws::Law;
use crate::residual::Residual;
use crate::text::Text;

/// A row of the table, as printed: the kernel's name, then `S`, `P`, `K(½)`, `K(1)`, the ripple of a constant and the
/// overshoot of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Row {
    /// The kernel's name in the catalogue.
    pub name: &'static str,
    /// The six numbers, with as many digits as are known.
    pub printed: [&'static str; 6],
}

/// The table of the lecture's companion, computed independently by sums and integrals in Python; the definitions are those
/// of [`Metrics`].
pub const TABLE: [Row; 9] = [
    Row { name: "box", printed: ["0.2263", "0.2263", "0.6366", "0.0000", "0.0000", "0.0000"] },
    Row { name: "tent", printed: ["0.3668", "0.0335", "0.4053", "0.0000", "0.0000", "0.0000"] },
    Row { name: "gaussian-pbrt2", printed: ["0.4499", "0.0149", "0.2915", "0.00716", "0.0143", "0.0000"] },
    Row { name: "gaussian", printed: ["0.4356", "0.0159", "0.3048", "0.00893", "0.0212", "0.0000"] },
    Row { name: "mitchell", printed: ["0.3404", "0.0219", "0.3833", "0.0000", "0.0000", "0.0363"] },
    Row { name: "catmull-rom", printed: ["0.2240", "0.0382", "0.4928", "0.0000", "0.0000", "0.0741"] },
    Row { name: "b-spline", printed: ["0.5235", "0.0029", "0.1643", "0.0000", "0.0000", "0.0000"] },
    Row { name: "lanczos-3", printed: ["0.1320", "0.0257", "0.5017", "0.0014", "0.0030", "0.118"] },
    Row { name: "sinc-pbrt2", printed: ["0.3298", "0.00007", "0.0486", "0.0003", "0.0006", "0.0964"] },
];

/// The six numbers of `kernel` against a printed row; allowed is half a unit of the last printed digit.
///
/// ```
/// use nyquist::laws::metrics::{TABLE, agrees};
/// use nyquist::prelude::*;
/// assert!(agrees(&BoxKernel, &TABLE[0]).iter().all(|number| number.holds()));
/// ```
pub fn agrees(kernel: &(impl Kernel + ?Sized), row: &Row) -> [Residual; 6] {
    let m = Metrics::of(kernel);
    let numbers = [m.smoothing, m.postaliasing, m.at_nyquist, m.at_rate, m.dc_ripple, m.overshoot];
    const NAMES: [&str; 6] = ["S", "P", "K(½)", "K(1)", "ripple", "overshoot"];
    std::array::from_fn(|i| {
        let printed = row.printed[i];
        let digits = printed.split_once('.').map_or(0, |(_, fraction)| fraction.len() as i32);
        let law = format!("{}: {} = {printed}", kernel.name(), NAMES[i]);
        let expected: f64 = printed.parse().expect("the table consists of numbers");
        Residual::near(law, numbers[i], expected, 0.5 * 10f64.powi(-digits))
    })
}

/// The laws of this theme.
pub static LAWS: &[Law] = &[Law {
    name: "kernel-metrics",
    inventory: &["V06"],
    says: &Text::fixed(
        "Smoothing, postaliasing, ripple and overshoot of nine kernels are those of the table",
        "Сглаживание, постэлиасинг, пульсации и выбросы девяти ядер — как в таблице",
    ),
    holds: || {
        let kernel = |row: &Row| by_name(row.name).expect("the table names kernels of the catalogue");
        TABLE.iter().flat_map(|row| agrees(&*kernel(row), row)).collect()
    },
    breaks: || {
        // the `sinc` of pbrt-2 taken for the textbook's Lanczos-3, which it is not
        let pbrt = by_name("sinc-pbrt2").expect("a kernel of the catalogue");
        agrees(&*pbrt, &TABLE[7]).into()
    },
}];
