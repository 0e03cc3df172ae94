//! Which options a command was given, and for which kind of file they are.

use crate::cli::Failure;
use clap::parser::ValueSource;
use clap::{ArgMatches, Command};
use nyquist::door::kind::Kind;

/// The options that were given and stand under a heading of the help: it says for which kinds of file they are.
#[derive(Debug, Default)]
pub(super) struct Given(Vec<(String, String)>);

impl Given {
    /// What stands on the command line of this command.
    pub(super) fn of(command: &Command, matches: &ArgMatches) -> Self {
        let given = command
            .get_arguments()
            .filter(|option| matches.value_source(option.get_id().as_str()) == Some(ValueSource::CommandLine));
        let named = given.filter_map(|option| {
            let heading = option.get_help_heading()?.to_lowercase();
            Some((option.get_long()?.to_owned(), heading))
        });
        Self(named.collect())
    }

    /// Refuses an option that could do nothing for a file of this kind: what was asked for would not be what was done.
    pub(super) fn fit(&self, name: &str, kind: Kind) -> Result<(), Failure> {
        let (word, it) = match kind {
            Kind::Sound => ("sound", "a sound"),
            Kind::Picture => ("pictures", "a picture"),
            Kind::Table => ("tables", "a table"),
        };
        match self.0.iter().find(|(_, heading)| !heading.contains(word)) {
            Some((option, heading)) => {
                Err(Failure::trouble(name, format!("--{option} is for {heading}, and this is {it}")))
            }
            None => Ok(()),
        }
    }
}
