//! All kernels by name, and families of them by name and parameters.

use crate::error::{Error, Result, unknown};
use crate::kernel::Kernel;
use crate::kernel::box_kernel::BoxKernel;
use crate::kernel::cubic::Cubic;
use crate::kernel::gaussian::GaussianKernel;
use crate::kernel::hamming::HammingKernel;
use crate::kernel::ideal::Ideal;
use crate::kernel::kaiser::Kaiser;
use crate::kernel::lanczos::Lanczos;
use crate::kernel::pbrt_sinc::PbrtSinc;
use crate::kernel::regularised::Regularised;
use crate::kernel::tent::TentKernel;

type Make = fn() -> Result<Box<dyn Kernel>>;

/// The named kernels, from the simplest to the ideal one.
const NAMED: &[(&str, Make)] = &[
    ("box", || Ok(Box::new(BoxKernel))),
    ("tent", || Ok(Box::new(TentKernel))),
    ("hamming", || Ok(Box::new(HammingKernel))),
    ("gaussian", || Ok(Box::new(GaussianKernel::pbrt4()))),
    ("gaussian-pbrt2", || Ok(Box::new(GaussianKernel::pbrt2()))),
    ("b-spline", || Ok(Box::new(Cubic::b_spline()))),
    ("mitchell", || Ok(Box::new(Cubic::mitchell()))),
    ("catmull-rom", || Ok(Box::new(Cubic::catmull_rom()))),
    ("lanczos-2", || Ok(Box::new(Lanczos::new(2.0)?))),
    ("lanczos-3", || Ok(Box::new(Lanczos::new(3.0)?))),
    ("lanczos-4", || Ok(Box::new(Lanczos::new(4.0)?))),
    ("kaiser", || Ok(Box::new(Kaiser::standard()))),
    ("regularised", || Ok(Box::new(Regularised::standard()))),
    ("sinc-pbrt2", || Ok(Box::new(PbrtSinc::new(4.0, 3.0)?))),
    ("ideal", || Ok(Box::new(Ideal))),
];

/// The families that take parameters, and what these are.
pub const FAMILIES: &[&str] = &[
    "cubic:B,C",
    "gaussian:SIGMA,RADIUS",
    "kaiser:RADIUS,BETA",
    "lanczos-LOBES",
    "regularised:RADIUS,WIDTH",
    "sinc-pbrt2:WIDTH,TAU",
];

/// The names of the named kernels, in order.
pub fn names() -> impl ExactSizeIterator<Item = &'static str> {
    NAMED.iter().map(|entry| entry.0)
}

/// The named kernels, in order.
///
/// ```
/// use nyquist::kernel::catalog;
/// assert!(catalog::all().iter().map(|kernel| kernel.name()).eq(catalog::names()));
/// ```
pub fn all() -> Vec<Box<dyn Kernel>> {
    NAMED
        .iter()
        .map(|entry| (entry.1)().expect("the parameters of the named kernels are within their ranges"))
        .collect()
}

/// The kernel of that name: a named one, or a member of one of the [`FAMILIES`].
///
/// ```
/// use nyquist::prelude::*;
/// use nyquist::kernel::catalog::by_name;
/// assert_eq!(by_name("mitchell")?.radius(), 2.0);
/// assert_eq!(by_name("cubic:0.3,0.35")?.name(), "cubic:0.3,0.35");
/// let Err(error) = by_name("lanczos3") else { panic!() };
/// assert!(error.to_string().starts_with("no kernel is called \"lanczos3\"; known: lanczos-"));
/// # Ok::<(), Error>(())
/// ```
///
/// # Errors
/// [`Error::Unknown`] with the nearest names first; [`Error::Unreadable`] where parameters are no numbers or too few; what
/// the kernel's constructor refuses.
pub fn by_name(name: &str) -> Result<Box<dyn Kernel>> {
    if let Some(entry) = NAMED.iter().find(|entry| entry.0 == name) {
        return (entry.1)();
    }
    let (family, given) = match (name.strip_prefix("lanczos-"), name.split_once(':')) {
        (Some(lobes), _) if lobes.parse::<f64>().is_ok() => ("lanczos", lobes),
        (_, Some(parts)) => parts,
        _ => (name, ""),
    };
    match family {
        "cubic" => two(name, given).and_then(|[b, c]| Ok(Box::new(Cubic::new(b, c)?) as _)),
        "gaussian" => two(name, given).and_then(|[sigma, r]| Ok(Box::new(GaussianKernel::new(sigma, r)?) as _)),
        "kaiser" => two(name, given).and_then(|[r, beta]| Ok(Box::new(Kaiser::new(r, beta)?) as _)),
        "regularised" => two(name, given).and_then(|[r, width]| Ok(Box::new(Regularised::new(r, width)?) as _)),
        "sinc-pbrt2" => two(name, given).and_then(|[width, tau]| Ok(Box::new(PbrtSinc::new(width, tau)?) as _)),
        "lanczos" if !given.is_empty() => {
            let lobes = given.parse().map_err(|_| unreadable(name, "a number of lobes"))?;
            Ok(Box::new(Lanczos::new(lobes)?))
        }
        _ => Err(unknown("kernel", name, names().chain(FAMILIES.iter().copied()))),
    }
}

fn unreadable(name: &str, wanted: &'static str) -> Error {
    let (family, given) = name.split_once(':').unwrap_or((name, ""));
    Error::Unreadable { what: format!("kernel {family}"), given: given.to_owned(), wanted }
}

/// The two numbers after the colon.
fn two(name: &str, given: &str) -> Result<[f64; 2]> {
    let wanted = "two numbers with a comma between";
    let numbers: Option<Vec<f64>> = given.split(',').map(|part| part.trim().parse().ok()).collect();
    numbers.and_then(|numbers| numbers.try_into().ok()).ok_or_else(|| unreadable(name, wanted))
}
