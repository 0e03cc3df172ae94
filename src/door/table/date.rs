//! Dates of ISO 8601 as seconds.

use crate::door::table::decimal::Decimal;

/// How dates of a column are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Calendar {
    /// Between day and hour: `T` or a space.
    letter: char,
    /// `Z`, minutes east of Greenwich, or nothing.
    zone: Zone,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Zone {
    Unsaid,
    Utc,
    East(i32),
}

const DAY: i64 = 86_400;
/// Of a second: more are not read, and not written.
const MOST_DECIMALS: u32 = 18;

impl Calendar {
    /// The seconds since 1970 of a date such as `2026-01-31T12:00:00.25Z`, and how it was written. Seconds, and with them
    /// their fraction, may be left out, as may the zone; the time of the day may, too. Every day has 86,400 seconds, as in
    /// Unix: a leap second has no number.
    pub(crate) fn read(text: &str) -> Option<(Decimal, Self)> {
        let (day, rest) = (text.get(..10)?, text.get(10..)?);
        let bytes = day.as_bytes();
        if bytes[4] != b'-' || bytes[7] != b'-' {
            return None;
        }
        let days = days(number(&day[..4])?, number(&day[5..7])?, number(&day[8..])?)?;
        if rest.is_empty() {
            let calendar = Self { letter: 'T', zone: Zone::Unsaid };
            return Some((Decimal::new((days * DAY).into(), 0), calendar));
        }
        let letter = rest.chars().next().filter(|c| matches!(c, 'T' | 't' | ' '))?;
        let (time, zone) = zone(&rest[1..])?;
        let (hour, minute) = (number(time.get(..2)?)?, number(time.get(3..5)?)?);
        if hour > 23 || minute > 59 || time.as_bytes()[2] != b':' {
            return None;
        }
        let second: Decimal = match time.get(5..)? {
            "" => Decimal::ZERO,
            seconds => {
                let seconds = seconds.strip_prefix(':')?;
                let (whole, fraction) = seconds.split_once('.').unwrap_or((seconds, "0"));
                let digits = !fraction.is_empty() && fraction.bytes().all(|b| b.is_ascii_digit());
                if !digits || fraction.len() > MOST_DECIMALS as usize || whole.len() != 2 || number(whole)? > 59 {
                    return None;
                }
                seconds.parse().ok()?
            }
        };
        let east = if let Zone::East(minutes) = zone { i64::from(minutes) } else { 0 };
        let whole = days * DAY + 3600 * hour + 60 * (minute - east);
        Some((second.plus(Decimal::new(whole.into(), 0))?, Self { letter: letter.to_ascii_uppercase(), zone }))
    }

    /// The date of so many seconds since 1970, written in the same way.
    pub(crate) fn show(self, seconds: Decimal) -> String {
        let east = if let Zone::East(minutes) = self.zone { i64::from(minutes) } else { 0 };
        let decimals = seconds.decimals().min(MOST_DECIMALS);
        let (digits, exponent) = seconds.parts();
        let unit = 10i128.pow(decimals);
        let kept = digits / 10i128.pow((seconds.decimals() - decimals).min(MOST_DECIMALS));
        let ticks = kept * 10i128.pow(exponent.clamp(0, 18).unsigned_abs()) + i128::from(60 * east) * unit;
        let (whole, fraction) = (ticks.div_euclid(unit), ticks.rem_euclid(unit));
        let whole = whole as i64; // 10¹⁸ seconds are older than everything
        let (year, month, day) = civil(whole.div_euclid(DAY));
        let rest = whole.rem_euclid(DAY);
        let (hour, minute, second) = (rest / 3600, rest / 60 % 60, rest % 60);
        let letter = self.letter;
        let mut text = format!("{year:04}-{month:02}-{day:02}{letter}{hour:02}:{minute:02}:{second:02}");
        if unit > 1 {
            text += &format!(".{fraction:0width$}", width = decimals as usize);
        }
        match self.zone {
            Zone::Unsaid => {}
            Zone::Utc => text.push('Z'),
            Zone::East(minutes) => {
                let sign = if minutes < 0 { '-' } else { '+' };
                text += &format!("{sign}{:02}:{:02}", minutes.abs() / 60, minutes.abs() % 60);
            }
        }
        text
    }

    /// Whether both say how far they are from Greenwich, or neither does: otherwise they cannot be compared.
    pub(crate) fn comparable(self, other: Self) -> bool {
        (self.zone == Zone::Unsaid) == (other.zone == Zone::Unsaid)
    }
}

fn number(text: &str) -> Option<i64> {
    text.bytes().all(|b| b.is_ascii_digit()).then(|| text.parse().ok()).flatten()
}

/// The time of the day, and the zone behind it.
fn zone(text: &str) -> Option<(&str, Zone)> {
    if let Some(time) = text.strip_suffix(['Z', 'z']) {
        return Some((time, Zone::Utc));
    }
    let Some(at) = text.rfind(['+', '-']) else { return Some((text, Zone::Unsaid)) };
    let (time, behind) = text.split_at(at);
    let digits: String = behind[1..].chars().filter(|c| *c != ':').collect();
    if !digits.is_ascii() {
        return None;
    }
    let (hours, minutes) = match digits.len() {
        2 => (number(&digits)?, 0),
        4 => (number(&digits[..2])?, number(&digits[2..])?),
        _ => return None,
    };
    if hours > 23 || minutes > 59 {
        return None;
    }
    let east = (60 * hours + minutes) as i32;
    Some((time, Zone::East(if behind.starts_with('-') { -east } else { east })))
}

/// Days from 1970-01-01 on of the Gregorian calendar (Hinnant, *chrono-compatible low-level date algorithms*): years begin
/// in March, so that the leap day is their last.
fn days(year: i64, month: i64, day: i64) -> Option<i64> {
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let long = match month {
        2 => 28 + i64::from(leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return None,
    };
    if !(1..=long).contains(&day) {
        return None;
    }
    let year = if month <= 2 { year - 1 } else { year };
    let (era, of_era) = (year.div_euclid(400), year.rem_euclid(400));
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    Some(era * 146_097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719_468)
}

/// The inverse of [`days`]: year, month and day.
fn civil(days: i64) -> (i64, i64, i64) {
    let shifted = days + 719_468;
    let (era, of_era) = (shifted.div_euclid(146_097), shifted.rem_euclid(146_097));
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let march = (5 * of_year + 2) / 153;
    let (day, month) = (of_year - (153 * march + 2) / 5 + 1, if march < 10 { march + 3 } else { march - 9 });
    (year + era * 400 + i64::from(month <= 2), month, day)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seconds(text: &str) -> Option<String> {
        Calendar::read(text).map(|(seconds, _)| seconds.to_string())
    }

    #[test]
    fn dates_are_seconds_since_1970() {
        // known from `date -u +%s`
        for (text, known) in [
            ("1970-01-01T00:00:00Z", "0"),
            ("2026-01-31T12:00:00.25Z", "1769860800.25"),
            ("2026-01-31 12:00", "1769860800"),
            ("2000-02-29T23:59:59.999999999Z", "951868799.999999999"),
            ("2026-01-31T12:00:00+01:00", "1769857200"),
            ("2026-01-31T12:00:00-0530", "1769880600"),
            ("1969-12-31T23:59:59Z", "-1"),
            ("2026-01-31", "1769817600"),
        ] {
            assert_eq!(seconds(text).as_deref(), Some(known), "{text}");
        }
        for text in [
            "2026-02-29T00:00:00Z",
            "2026-13-01",
            "2026-01-31T24:00:00",
            "2026-01-31T12:60",
            "2026-01-31T12:00:60Z",
            "2026-01-31T12:00:00.Z",
            "2026-01-31X12:00",
            "31.01.2026 12:00",
            "2026-01-31T",
            "2026-01-31T12",
            "2026-01-31T12:00:00+1",
            "2026-01-31T12:00:00+1é2",
            "äöüäöü",
        ] {
            assert_eq!(seconds(text), None, "{text}");
        }
    }

    #[test]
    fn dates_are_written_as_they_were_read() {
        for text in ["2026-01-31T12:00:00.250Z", "1999-12-31 23:59:59", "2024-02-29T06:07:08.5-03:30"] {
            let (seconds, calendar) = Calendar::read(text).unwrap();
            assert_eq!(calendar.show(seconds), text);
        }
        for day in -200_000..200_000 {
            let (year, month, of_month) = civil(day);
            assert_eq!(days(year, month, of_month), Some(day));
        }
    }
}
