//! Rows of numbers x y z, separated by commas, semicolons, tabs or blanks, with or without a header.

use std::collections::BTreeMap;

use super::text::{Line, Source, Word, words};
use super::{Draft, Found, ReadError};
use crate::{Dimension, Unit, quoted};

/// Which column holds what, counted from 0.
#[derive(Clone, Debug, PartialEq)]
struct Layout {
    axes: [usize; 3],
    name: Option<usize>,
    /// the column and the factor to a diameter
    diameter: Option<(usize, f64)>,
    columns: usize,
    unit: Option<String>,
}

/// What stands between two fields.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Separator {
    Char(char),
    Blanks,
}

/// Words that head a column with a curve's name, perhaps with `_id`, `_name`, `_number` or `_index` behind.
const NAMES: [&str; 14] = [
    "curve", "strand", "wire", "chain", "filament", "fibre", "fiber", "yarn", "rod", "rope", "polyline", "core", "ply",
    "molecule",
];

/// Curves are told apart by a column with their names; without one, blank lines and repeated headers stand between them.
pub(super) fn read(source: &Source<'_>) -> Result<Found, ReadError> {
    let mut reader = Reader { source, separator: None, layout: None, header: None, remark: None, apart: true };
    let mut found = Found::default();
    let mut named: BTreeMap<String, usize> = BTreeMap::new();
    let mut last = 0;
    let mut scattered = None;
    for line in source.lines() {
        let text = source.text(line)?;
        let content = text.trim();
        if content.is_empty() {
            reader.apart = true;
            continue;
        }
        if let Some(remark) = content.strip_prefix(['#', '%']) {
            reader.remark = Some(remark.trim().to_owned()).filter(|_| reader.layout.is_none());
            continue;
        }
        let separator = *reader.separator.get_or_insert_with(|| Separator::of(content));
        let fields = separator.split(text);
        if reader.layout.is_none() {
            reader.begin(line, &fields, &mut found)?;
        }
        if reader.header.as_deref().is_some_and(|header| header == content) {
            reader.apart = true;
            continue;
        }
        let Some(layout) = &reader.layout else { continue };
        let row = layout.row(source, line, &fields)?;
        let at = match &row.name {
            Some(name) => *named.entry(name.clone()).or_insert(found.drafts.len()),
            None if reader.apart => found.drafts.len(),
            None => found.drafts.len() - 1,
        };
        if row.name.is_some() && at != last && at < found.drafts.len() && scattered.is_none() {
            scattered = Some(line.number);
        }
        last = at;
        reader.apart = false;
        if at == found.drafts.len() {
            found.drafts.push(Draft {
                name: row.name,
                diameter: row.diameter,
                line: Some(line.number),
                ..Draft::default()
            });
        }
        let draft = &mut found.drafts[at];
        if draft.diameter != row.diameter {
            return Err(source.at_line(line.number, "the diameter changes along the curve; one a curve is wanted"));
        }
        draft.points.push(row.point);
    }
    if let Some(line) = scattered {
        found.notes.push(format!(
            "Rows of a curve do not stand together, first in line {line}: those of one name are joined in the file's order."
        ));
    }
    if found.drafts.is_empty() {
        return Err(source.whole("it has no row of numbers x y z"));
    }
    Ok(found)
}

struct Reader<'s, 'b> {
    source: &'s Source<'b>,
    separator: Option<Separator>,
    layout: Option<Layout>,
    /// the header's text
    header: Option<String>,
    /// the last remark before the first row, which may be a header
    remark: Option<String>,
    /// whether the next row begins a curve
    apart: bool,
}

struct Row {
    name: Option<String>,
    diameter: Option<f64>,
    point: [f64; 3],
}

impl Reader<'_, '_> {
    /// What the first line of content says of the columns.
    fn begin(&mut self, line: Line<'_>, fields: &[Word<'_>], found: &mut Found) -> Result<(), ReadError> {
        let source = self.source;
        let numbers = fields.iter().filter(|field| field.text.parse::<f64>().is_ok()).count();
        let named: Vec<&str> = fields.iter().map(|field| field.text).collect();
        let layout = if let Some(layout) = Layout::of_header(&named).map_err(|why| source.at_line(line.number, why))? {
            self.header = Some(source_text(line).trim().to_owned());
            layout
        } else if numbers == 0 {
            let message = format!(
                "{} names no columns x, y, z; a header such as `curve,x,y,z`, or three numbers, are wanted",
                quoted(source_text(line).trim())
            );
            return Err(source.at_line(line.number, message));
        } else if let Some(layout) =
            self.layout_of_remark(fields.len()).map_err(|why| source.at_line(line.number, why))?
        {
            layout
        } else {
            Layout::of_row(fields).map_err(|why| source.at_line(line.number, why))?
        };
        found.unit.clone_from(&layout.unit);
        self.layout = Some(layout);
        Ok(())
    }

    /// A header that stands behind a `#`, as NumPy writes it.
    fn layout_of_remark(&self, columns: usize) -> Result<Option<Layout>, String> {
        let Some(remark) = &self.remark else { return Ok(None) };
        let fields = Separator::of(remark).split(remark);
        if fields.len() != columns {
            return Ok(None);
        }
        Layout::of_header(&fields.iter().map(|field| field.text).collect::<Vec<_>>())
    }
}

fn source_text(line: Line<'_>) -> String {
    String::from_utf8_lossy(line.bytes).into_owned()
}

impl Separator {
    /// From the first line of content.
    fn of(line: &str) -> Self {
        if line.contains(';') {
            Self::Char(';')
        } else if line.contains(',') {
            Self::Char(',')
        } else if line.split('\t').count() > 2 && line.split('\t').all(|field| words(field).count() < 2) {
            Self::Char('\t')
        } else {
            Self::Blanks
        }
    }

    /// The fields of a line without blanks and quotation marks around them; a separator between quotation marks does not count, nor one
    /// at the end.
    fn split(self, line: &str) -> Vec<Word<'_>> {
        let Self::Char(separator) = self else { return words(line).map(unquote).collect() };
        let mut fields = Vec::new();
        let (mut start, mut quotes) = (0, false);
        for (at, c) in line.char_indices() {
            if c == '"' {
                quotes = !quotes;
            } else if c == separator && !quotes {
                fields.push(field(line, start, at));
                start = at + c.len_utf8();
            }
        }
        fields.push(field(line, start, line.len()));
        if fields.last().is_some_and(|last| last.text.is_empty()) && fields.len() > 3 {
            fields.pop();
        }
        fields
    }
}

fn field(line: &str, start: usize, end: usize) -> Word<'_> {
    let text = line.get(start..end).unwrap_or("");
    let blanks = text.len() - text.trim_start().len();
    unquote(Word { text: text.trim(), at: start + blanks })
}

fn unquote(word: Word<'_>) -> Word<'_> {
    match word.text.strip_prefix('"').and_then(|text| text.strip_suffix('"')) {
        Some(text) => Word { text: text.trim(), at: word.at + 1 },
        None => word,
    }
}

impl Layout {
    /// From names of columns; `None` where they name no x, y, z.
    fn of_header(names: &[&str]) -> Result<Option<Self>, String> {
        let heads: Vec<(String, Option<String>)> = names.iter().map(|name| head(name)).collect();
        let find = |wanted: &[&str]| -> Result<Option<usize>, String> {
            let mut at = heads.iter().enumerate().filter(|(_, (name, _))| wanted.contains(&name.as_str()));
            let first = at.next();
            match at.next() {
                Some((second, _)) => Err(format!("column {} is named {} once more", second + 1, quoted(names[second]))),
                None => Ok(first.map(|(i, _)| i)),
            }
        };
        let axes = [
            find(&["x", "points:0", "points_0", "coordinates:0", "coordinates_0"])?,
            find(&["y", "points:1", "points_1", "coordinates:1", "coordinates_1"])?,
            find(&["z", "points:2", "points_2", "coordinates:2", "coordinates_2"])?,
        ];
        let axes = match axes {
            [Some(x), Some(y), Some(z)] => [x, y, z],
            [None, None, None] => return Ok(None),
            [Some(_), Some(_), None] => {
                return Err("the header names x and y and no z; for a curve in a plane write a z of 0".to_owned());
            }
            _ => return Err("the header names not all of x, y, z".to_owned()),
        };
        let units = axes.map(|axis| heads[axis].1.clone());
        if units[0] != units[1] || units[1] != units[2] {
            return Err("x, y and z have different units; one unit for all is wanted".to_owned());
        }
        let [unit, ..] = units;
        let diameter = match (find(&["diameter"])?, find(&["radius"])?) {
            (Some(_), Some(_)) => {
                return Err("the header names a diameter and a radius; one of them is wanted".to_owned());
            }
            (Some(column), None) => Some((column, 1.0)),
            (None, Some(column)) => Some((column, 2.0)),
            (None, None) => None,
        };
        if let Some((column, _)) = diameter
            && heads[column].1 != unit
        {
            return Err(format!(
                "{} is in another unit than x, y and z; one unit for all is wanted",
                quoted(names[column])
            ));
        }
        let plain = |name: &str| {
            let stem =
                ["_id", "_name", "_number", "_index"].iter().find_map(|tail| name.strip_suffix(tail)).unwrap_or(name);
            NAMES.contains(&stem)
        };
        let mut columns = heads.iter().enumerate().filter(|(_, (name, _))| plain(name));
        let name = columns.next().map(|(i, _)| i);
        if let Some((second, _)) = columns.next() {
            let both = (name.map_or("", |first| names[first]), names[second]);
            return Err(format!(
                "the columns {} and {} both name a curve; one is wanted",
                quoted(both.0),
                quoted(both.1)
            ));
        }
        Ok(Some(Self { axes, name, diameter, columns: names.len(), unit }))
    }

    /// From the first row, where nothing names the columns.
    fn of_row(fields: &[Word<'_>]) -> Result<Self, String> {
        let number = |at: usize| fields.get(at).is_some_and(|field| super::text::number(field.text).is_ok());
        let plain = |axes, name| Self { axes, name, diameter: None, columns: fields.len(), unit: None };
        match fields.len() {
            3 => Ok(plain([0, 1, 2], None)),
            4 if !number(0) && number(1) && number(2) && number(3) => Ok(plain([1, 2, 3], Some(0))),
            4 if number(0) && number(1) && number(2) && !number(3) => Ok(plain([0, 1, 2], Some(3))),
            2 => Err("it has two columns; x, y and z are wanted (a z of 0 for a curve in a plane)".to_owned()),
            columns => Err(format!(
                "{} and no header to say what they are; a header such as `curve,x,y,z`, or three columns, are wanted",
                super::text::counted(columns, "column")
            )),
        }
    }

    fn row(&self, source: &Source<'_>, line: Line<'_>, fields: &[Word<'_>]) -> Result<Row, ReadError> {
        if fields.len() != self.columns {
            let (found, wanted) = (super::text::counted(fields.len(), "column"), self.columns);
            return Err(source.at_line(line.number, format!("it has {found}, the first line {wanted}")));
        }
        let mut point = [0.0; 3];
        for ((value, axis), name) in point.iter_mut().zip(self.axes).zip(["x", "y", "z"]) {
            *value = source.number(line, fields[axis], name)?;
        }
        let name = self.name.map(|column| fields[column]);
        if let Some(empty) = name.filter(|name| name.text.is_empty()) {
            return Err(source.at_column(line, empty.at, "nothing is written; the curve's name is wanted here"));
        }
        let diameter = self.diameter.map(|(column, factor)| {
            let diameter = factor * source.number(line, fields[column], "the diameter")?;
            let positive = diameter > 0.0 && diameter < f64::INFINITY;
            let message = || format!("a diameter of {diameter}; one greater than 0 is wanted");
            if positive { Ok(diameter) } else { Err(source.at_column(line, fields[column].at, message())) }
        });
        Ok(Row { name: name.map(|name| name.text.to_owned()), diameter: diameter.transpose()?, point })
    }
}

/// A column's name in small letters, and its unit of length: `x [mm]`, `x (mm)` and `x_mm` are x in mm.
fn head(name: &str) -> (String, Option<String>) {
    let length = |text: &str| {
        if text == "r" {
            return Some(text.to_owned()); // strand radii
        }
        let unit = Unit::parse(text).ok().filter(|unit| unit.dimension() == Dimension::LENGTH)?;
        Some(unit.to_string())
    };
    let name = name.trim();
    if let Some((plain, unit)) = name.split_once(['[', '(']) {
        let unit = unit.trim_end_matches([']', ')']).trim();
        return (plain.trim().to_ascii_lowercase(), length(unit).or_else(|| Some(unit.to_owned())));
    }
    if let Some((plain, unit)) = name.rsplit_once('_')
        && let Some(unit) = length(unit)
    {
        return (plain.to_ascii_lowercase(), Some(unit));
    }
    (name.to_ascii_lowercase(), None)
}
