//! A table, looked into.

use crate::door::table::{Column, Heading, Table};
use crate::error::{Error, Result, finite, positive};
use crate::inspect::table::{Findings, Look, Prediction, inspect};
use crate::record::Sampling;

/// A table with all that was found in it, and what another rate would make of it.
#[derive(Debug, Clone, PartialEq)]
pub struct TableCheck {
    /// The table.
    pub table: Table,
    /// How it was sampled.
    pub sampling: Sampling,
    /// Its columns of values.
    pub columns: Vec<ColumnCheck>,
    /// The rate asked about.
    pub rate: Option<f64>,
    /// How far below the signal aliases must stay, in dB.
    pub tolerance: f64,
}

/// A column, and what was found in it.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnCheck {
    /// What stands above it.
    pub heading: Heading,
    /// Its values at the positions of the sampling.
    pub values: Vec<f64>,
    /// At how many positions there were several values that differ.
    pub disagreements: usize,
    /// What was found.
    pub found: Findings,
}

/// How far below the signal aliases must stay if nothing is said: one per cent of its amplitude.
pub const TOLERANCE: f64 = 40.0;

impl TableCheck {
    /// Looks into every column of a table; `rate` is one to sample the same signals at.
    ///
    /// ```
    /// use nyquist::door::table::{Reading, read_table};
    /// use nyquist::inspect::table::{Look, TOLERANCE, TableCheck};
    /// let row = |k: i32| format!("{},{}\n", f64::from(k) / 100.0, nyquist::num::cos_pi(0.6 * f64::from(k)));
    /// let text: String = (0..200).map(row).collect();
    /// let table = read_table("tone.csv", text.as_bytes(), &Reading::default())?;
    /// // 30 Hz at the rate of 50 Hz: seen at 20
    /// let check = TableCheck::new(table, None, Look::default(), Some(50.0), TOLERANCE)?;
    /// assert!(!check.fine());
    /// let [prediction] = &check.predictions()[..] else { panic!() };
    /// assert!((prediction.landings[0].alias.frequency() - 20.0).abs() < 1e-9);
    /// # Ok::<(), nyquist::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// A table without columns of values, or without times where no `step` between rows, in seconds, is said; what
    /// [`Sampling::of`] and [`inspect`] refuse; a rate that is not positive, a tolerance that is not finite.
    pub fn new(table: Table, step: Option<f64>, look: Look, rate: Option<f64>, tolerance: f64) -> Result<Self> {
        if let Some(rate) = rate {
            positive("the new rate", rate)?;
        }
        finite("the tolerance", tolerance)?;
        if table.columns.is_empty() {
            return Err(Error::Unsupported("there is one column, and no values beside the times"));
        }
        let sampling = Sampling::of_table(&table, step)?;
        let check = |column: &Column| {
            let values = sampling.values(&column.values)?;
            Ok(ColumnCheck {
                heading: column.heading.clone(),
                disagreements: sampling.disagreements(&column.values),
                found: inspect(&sampling, &values, look)?,
                values,
            })
        };
        let columns = table.columns.iter().map(check).collect::<Result<Vec<_>>>()?;
        Ok(Self { table, sampling, columns, rate, tolerance })
    }

    /// What the new rate would make of each column; nothing if none was asked about.
    pub fn predictions(&self) -> Vec<Prediction<'_>> {
        let of = |rate: f64| self.columns.iter().filter_map(move |c| Prediction::new(&c.found, rate).ok());
        self.rate.into_iter().flat_map(of).collect()
    }

    /// Whether in every column aliases stay below the tolerance; yes, if no rate was asked about.
    pub fn fine(&self) -> bool {
        self.predictions().iter().all(|prediction| prediction.signal_to_alias() >= self.tolerance)
    }

    /// The unit of the positions: that of the column of times, seconds where the step was said.
    pub fn unit(&self) -> &str {
        self.table.clock.as_ref().map_or("s", |clock| clock.unit())
    }

    /// A position as the table writes it: that of the row that stood there.
    pub fn shown(&self, position: usize) -> String {
        let row = self.sampling.row(position);
        match &self.table.clock {
            Some(clock) => clock.show(clock.times[row]),
            None => self.sampling.positions()[position].to_string(),
        }
    }

    /// On which line of the file the row of a position stood.
    pub fn line(&self, position: usize) -> u64 {
        self.table.lines[self.sampling.row(position)]
    }
}
