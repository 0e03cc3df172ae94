//! What stands in a file, and what is said of what does not belong there.

use nyquist::door::table::{Reading, Separator, Table, TimeColumn, ValueColumns, read_table};
use nyquist::error::{Error, Result};

fn read(text: &str) -> Result<Table> {
    read_table("file", text.as_bytes(), &Reading::default())
}

fn times(table: &Table) -> Vec<f64> {
    table.clock.as_ref().expect("there are times").since_first()
}

/// The error without the file's name.
fn refusal(result: Result<Table>) -> String {
    let error = result.expect_err("this is no table");
    let text = error.to_string();
    text.strip_prefix("file: ").unwrap_or(&text).to_owned()
}

#[test]
fn the_same_numbers_in_every_dialect() {
    let german = Reading { decimal_comma: true, ..Reading::default() };
    let point = Reading::default();
    for (text, reading) in [
        ("0,1.5\n0.25,-2\n", &point),
        ("t,v\n0,1.5\n0.25,-2\n", &point),
        ("t,v\r\n0,1.5\r\n0.25,-2\r\n", &point),
        ("t,v\r0,1.5\r0.25,-2\r", &point),
        ("\u{feff}t,v\n0,1.5\n0.25,-2", &point),
        ("# made by hand\n\nt ; v\n\n 0 ; 1.5 \n# between\n0.25;-2.0\n;;\n", &point),
        ("t\tv\n0\t1.5\n2.5e-1\t-2\n", &point),
        ("\"t\",\"v\"\n\"0\",\"1.5\"\n\"0.25\",\"-2\"\n", &point),
        ("t,v,\n0,1.5,\n0.25,-2,\n", &point),
        ("t;v\n0;1,5\n0,25;-2\n", &german),
        ("t\tv\n0\t1,5\n0,25\t-2\n", &german),
    ] {
        let table = read_table("file", text.as_bytes(), reading).unwrap_or_else(|e| panic!("{text:?}: {e}"));
        assert_eq!(times(&table), [0.0, 0.25], "{text:?}");
        assert_eq!(table.columns.len(), 1, "{text:?}");
        assert_eq!(table.columns[0].values, [1.5, -2.0], "{text:?}");
    }
}

#[test]
fn names_and_units_are_kept() {
    let table = read("time [ms],Pressure (kPa),state\n0,1,2\n").unwrap();
    assert_eq!(table.clock.as_ref().unwrap().unit(), "ms");
    let said: Vec<String> = table.columns.iter().map(|c| c.heading.to_string()).collect();
    assert_eq!(said, ["Pressure [kPa]", "state"]);
    // a line of units, as oscilloscopes write it
    let table = read("Time,Channel A\n(us),(mV)\n\n0.0,1\n").unwrap();
    assert_eq!((table.clock.as_ref().unwrap().unit(), table.columns[0].heading.unit.as_str()), ("us", "mV"));
    // without a header, numbers
    assert_eq!(read("0,1\n").unwrap().columns[0].heading.name, "column 2");
    // old spreadsheets write Latin-1
    let table = read_table("file", b"t;T [\xb0C]\n0;20\n", &Reading::default()).unwrap();
    assert!(table.latin && table.columns[0].heading.unit == "°C");
}

#[test]
fn columns_are_picked_by_name_or_number() {
    let text = "state,clock,v\nidle,0,7\nbusy,1,8\n";
    let pick = |times: TimeColumn, columns: &[&str]| {
        let names = columns.iter().map(|c| (*c).into()).collect();
        let values = if columns.is_empty() { ValueColumns::Others } else { ValueColumns::These(names) };
        let reading = Reading { times, values, ..Reading::default() };
        read_table("file", text.as_bytes(), &reading)
    };
    let table = pick(TimeColumn::Named("clock".into()), &["v"]).unwrap();
    assert_eq!((times(&table), &table.columns[0].values[..]), (vec![0.0, 1.0], &[7.0, 8.0][..]));
    let table = pick(TimeColumn::Named("2".into()), &["3"]).unwrap();
    assert_eq!((times(&table), &table.columns[0].values[..]), (vec![0.0, 1.0], &[7.0, 8.0][..]));
    let table = pick(TimeColumn::Nowhere, &["v", "clock"]).unwrap();
    assert!(table.clock.is_none());
    assert_eq!(table.columns.iter().map(|c| c.values[1]).collect::<Vec<_>>(), [8.0, 1.0]);
    assert_eq!(
        pick(TimeColumn::Named("clok".into()), &[]).unwrap_err().to_string(),
        "no column is called \"clok\"; known: clock, v, state"
    );
    // times alone, whatever stands beside them
    let reading =
        Reading { times: TimeColumn::Named("clock".into()), values: ValueColumns::Nothing, ..Reading::default() };
    let table = read_table("file", text.as_bytes(), &reading).unwrap();
    assert_eq!((times(&table), table.columns.len()), (vec![0.0, 1.0], 0));
    // all others are values, and a state is none
    assert_eq!(
        refusal(pick(TimeColumn::Named("clock".into()), &[])),
        "line 2, column 1 (state): \"idle\" is no number"
    );
}

#[test]
fn what_is_no_number_is_named_by_line_and_column() {
    for (text, said) in [
        ("t,v\n0,1\n1,oops\n2,3\n", "line 3, column 2 (v): \"oops\" is no number"),
        (
            "t,v\n0,1\nlunch,1\n",
            "line 3, column 1 (t): \"lunch\" is no number, and no date such as 2026-01-31T12:00:00.25Z",
        ),
        ("t,v\n0,1\n\n# c\n1,2;3\n", "line 5, column 2 (v): \"2;3\" is no number"),
        ("0,1\n1,x\n", "line 2, column 2 (column 2): \"x\" is no number"),
        ("t,v\n0,1\n1\n", "line 3: 1 cell, but 2 in the first line"),
        ("t,v\n0,1\n1,2,3\n", "line 3: 3 cells, but 2 in the first line"),
        ("t,v\n0,1e999\n", "line 2, column 2 (v): \"1e999\" is too large"),
        ("t,v\n1e999,1\n", "line 2, column 1 (t): \"1e999\" is too large"),
        ("t,v\n9.99e-311,1\n", "line 2, column 1 (t): \"9.99e-311\" is too large or too small for a time"),
        ("t,v\n0,\n", "line 2, column 2 (v): the cell is empty (--skip-missing leaves such rows out)"),
        ("t,v\n0,NaN\n", "line 2, column 2 (v): the cell is not a number (NaN) (--skip-missing leaves such rows out)"),
        ("t,v\n0,-inf\n", "line 2, column 2 (v): the cell is infinite (--skip-missing leaves such rows out)"),
        ("t,v\n0,n/a\n", "line 2, column 2 (v): the cell has no value (--skip-missing leaves such rows out)"),
        ("\u{fffd}", "there is a header and no row of numbers"),
        ("t,v\n,1\n", "line 2, column 1 (t): the cell is empty (--skip-missing leaves such rows out)"),
        ("t;v\n0;1,5\n", "line 2, column 2 (v): \"1,5\" is no number (with --decimal-comma it is 1.5)"),
        ("t,v\n0,\"1\n1,2\n", "line 2: a quote is not closed on its line"),
        ("t,v\n0,\"1\"2\n", "line 2: something stands between a closing quote and the next separator"),
        ("t,v\n2026-01-31T12:00:00Z,1\n5,2\n", "line 3: the time is written in another way than those before"),
        (
            "t,v\n2026-01-31T12:00:00Z,1\n2026-01-31T12:00:01,2\n",
            "line 3: the time is written in another way than those before",
        ),
        ("", "nothing but blank lines and comments"),
        ("# nothing\n\n", "nothing but blank lines and comments"),
        ("t,v\n", "there is a header and no row of numbers"),
    ] {
        assert_eq!(refusal(read(text)), said, "{text:?}");
    }
    let long = format!("t,v\n0,{}\u{1b}[31m\n", "x".repeat(100));
    let said = refusal(read(&long));
    assert!(said.len() < 100 && said.contains('…') && !said.contains('\u{1b}'), "{said}");
    let odd = refusal(read("t,v\n0,a\u{1b}b\n"));
    assert!(!odd.contains('\u{1b}'), "{odd}");
}

#[test]
fn missing_values_can_be_left_out_and_are_counted() {
    let reading = Reading { skip_missing: true, ..Reading::default() };
    let table = read_table("file", b"t,v\n0,1\n1,\n2,NaN\n,3\n4,5\n", &reading).unwrap();
    assert_eq!((times(&table), &table.columns[0].values[..]), (vec![0.0, 4.0], &[1.0, 5.0][..]));
    assert_eq!((table.skipped.rows, table.skipped.first_line, &table.lines[..]), (3, 3, &[2, 6][..]));
    assert_eq!(refusal(read_table("file", b"t,v\n0,\n", &reading)), "a value is missing in every row");
    // text is no missing value
    assert!(read_table("file", b"t,v\n0,oops\n", &reading).is_err());
}

#[test]
fn other_encodings_are_named() {
    for bytes in [&b"\xff\xfet\0,\0v\0"[..], b"\xfe\xff\0t\0,\0v", b"t\0,\0v\0\n\0"] {
        assert!(refusal(read_table("file", bytes, &Reading::default())).contains("UTF-16"));
    }
    let both = Reading { decimal_comma: true, separator: Some(Separator::Comma), ..Reading::default() };
    assert!(matches!(read_table("file", b"1,2\n", &both), Err(Error::Unsupported(_))));
}

#[test]
fn times_are_differences_of_what_was_printed() {
    // microseconds since 1970: in f64 neighbours are 2.4e-7 apart there
    let table = read("t,v\n1769860800.000001,0\n1769860800.000002,0\n1769860800.500003,0\n").unwrap();
    assert_eq!(times(&table), [0.0, 1e-6, 0.500002]);
    let clock = table.clock.as_ref().unwrap();
    assert_eq!(clock.printed(), (6, 16));
    assert!(clock.rounding().iter().all(|r| (r - 0.5e-6).abs() < 1e-20));
    // nanoseconds as whole numbers
    let table = read("t,v\n1769860800000000001,0\n1769860800000000004,0\n").unwrap();
    assert_eq!(times(&table), [0.0, 3.0]);
    // significant digits instead of decimals: six of them
    let table = read("t,v\n0.00123457,0\n1.23457,0\n1234.57,0\n").unwrap();
    let rounding = table.clock.as_ref().unwrap().rounding();
    for (r, known) in rounding.iter().zip([0.5e-8, 0.5e-5, 0.5e-2]) {
        assert!((r / known - 1.0).abs() < 1e-12, "{rounding:?}");
    }
    // dates, over the end of a leap February
    let table = read("t,v\n2024-02-28T23:59:59.75Z,0\n2024-02-29T00:00:00Z,0\n2024-03-01T00:00:00Z,0\n").unwrap();
    assert_eq!(times(&table), [0.0, 0.25, 86_400.25]);
    let clock = table.clock.as_ref().unwrap();
    assert_eq!((clock.unit(), clock.show(clock.times[1]).as_str()), ("s", "2024-02-29T00:00:00Z"));
}

#[test]
fn the_separator_can_be_forced() {
    let reading = Reading { separator: Some(Separator::Comma), ..Reading::default() };
    let table = read_table("file", b"t,v;w\n0,1\n", &reading).unwrap();
    assert_eq!(table.columns[0].heading.name, "v;w");
    assert_eq!("TAB".parse::<Separator>(), Ok(Separator::Tab));
    assert_eq!(";".parse::<Separator>(), Ok(Separator::Semicolon));
    assert!("pipe".parse::<Separator>().unwrap_err().to_string().contains("known:"));
}
