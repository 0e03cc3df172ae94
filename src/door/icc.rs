//! The tone curves of a colour profile, which say what linear light is.
//!
//! An ICC profile of the matrix kind (`rTRC`, `gTRC`, `bTRC`, or `kTRC` of grey ones) decodes each channel by a curve, and
//! then turns the primaries; the curves are what linear light needs, and the primaries stay what they are. Profiles of
//! tables (printers, most scanners) have no such curves. Source: ICC.1:2022, §§7, 8.3, 10.6, 10.18.

use crate::door::transfer::{Curve, Transfer};

/// The curves of a profile; sRGB's, and a remark that says so, if it has none that rise.
pub(super) fn transfer_or_srgb(profile: &[u8], remarks: &mut Vec<String>) -> Transfer {
    transfer(profile).unwrap_or_else(|| {
        remarks.push("the colour profile has no tone curves: the curve of sRGB is assumed".into());
        Transfer::Srgb
    })
}

/// The curves of a profile, if it has ones that rise.
fn transfer(profile: &[u8]) -> Option<Transfer> {
    if profile.get(36..40)? != b"acsp" {
        return None;
    }
    let tag = |name: &[u8; 4]| -> Option<&[u8]> {
        let count = long(profile, 128)?.min(100);
        let entry = (0..count).map(|i| 132 + 12 * i).find(|&at| profile.get(at..at + 4) == Some(name))?;
        let (from, size) = (long(profile, entry + 4)?, long(profile, entry + 8)?);
        profile.get(from..from.checked_add(size)?)
    };
    let read = |name| curve(tag(name)?).filter(Curve::rises);
    let curves = match read(b"kTRC") {
        Some(grey) => [grey.clone(), grey.clone(), grey],
        None => [read(b"rTRC")?, read(b"gTRC")?, read(b"bTRC")?],
    };
    Some(Transfer::Curves(Box::new(curves)))
}

/// The curve in a tag: `curv`, a table, or `para`, a formula.
fn curve(tag: &[u8]) -> Option<Curve> {
    let short = |at: usize| Some(u16::from_be_bytes(tag.get(at..at + 2)?.try_into().ok()?));
    let fixed = |at: usize| Some(f64::from(i32::from_be_bytes(tag.get(at..at + 4)?.try_into().ok()?)) / 65_536.0);
    match tag.get(..4)? {
        b"curv" => match long(tag, 8)? {
            0 => Some(Curve::Power(1.0)),
            1 => Some(Curve::Power(f64::from(short(12)?) / 256.0)),
            n => {
                let bytes = tag.get(12..12usize.checked_add(n.checked_mul(2)?)?)?;
                Some(Curve::Table(bytes.chunks_exact(2).map(|b| u16::from_be_bytes([b[0], b[1]])).collect()))
            }
        },
        b"para" => {
            // how many parameters each kind has, and where they belong
            let places: &[usize] = match short(8)? {
                0 => return Some(Curve::Power(fixed(12)?)),
                1 => &[0, 1, 2],
                2 => &[0, 1, 2, 5],
                3 => &[0, 1, 2, 3, 4],
                4 => &[0, 1, 2, 3, 4, 5, 6],
                _ => return None,
            };
            let mut p = [0.0; 7];
            for (i, &place) in places.iter().enumerate() {
                p[place] = fixed(12 + 4 * i)?;
            }
            if places.len() < 5 {
                // below −b/a the value is the constant: nothing, or e, which is c here
                p[4] = -p[2] / p[1];
                p[6] = p[5];
            }
            Some(Curve::Parametric(p))
        }
        _ => None,
    }
}

fn long(bytes: &[u8], at: usize) -> Option<usize> {
    let four = bytes.get(at..at.checked_add(4)?)?.try_into().ok()?;
    usize::try_from(u32::from_be_bytes(four)).ok()
}
