//! The same as Arrow tables.

use std::sync::Arc;

use arrow_array::{Array, ArrayRef, RecordBatch, UInt64Array};
use arrow_schema::{Field, Schema, SchemaRef};

use super::Study;
use crate::spec::sweep::refused;
use crate::table::arrow::{batch, field, schema, values};
use crate::table::{Column, Kind, TableError, Values};
use crate::{ErrorKind, SpecError};

impl Study {
    /// The schema of its table: `row`, what varies, `state`, what is asked, `reason`; a unit is the metadata `unit` of its field, and the study
    /// with its version and balance the metadata of the schema.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// use nply_sheet::sweep::{Study, SweepFlags};
    /// let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "0.75")])?;
    /// let flags = SweepFlags {
    ///     sweep: vec!["pretwist=-1:0:3".into()], outputs: vec!["helical_angle".into()], ..SweepFlags::default()
    /// };
    /// let study = Study::from_spec(&ply, &flags)?;
    /// let batch = study.solve(0, 1)?;
    /// assert_eq!(batch.schema(), study.schema());
    /// // after a left-handed pretwist φ̄a = −1 three strands coil right-handed, at 30.613°
    /// let angle = batch.column_by_name("helical_angle_deg").and_then(|c| c.as_any().downcast_ref::<arrow_array::Float64Array>()).unwrap();
    /// assert!((angle.value(0) - 30.6130).abs() < 5e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn schema(&self) -> SchemaRef {
        schema(self.columns(), &self.metadata())
    }

    /// A stretch of its table, as [`Study::chunk`]: all rows of answers to `count` sets of data from `first` on, in order.
    ///
    /// # Errors
    /// [`TableError`] where Arrow refuses the table, and where the rows come from outside.
    pub fn solve(&self, first: u64, count: usize) -> Result<RecordBatch, TableError> {
        if self.takes_rows() {
            return Err(TableError::Encode(
                "the rows of this study come from outside: hand them in by solve_rows".into(),
            ));
        }
        batch(&self.schema(), &self.chunk(first, count))
    }

    /// Answers to given rows, in the order given: the given columns as they are, then `state` (where states are looked for), what is asked,
    /// and `reason`. A row with several states is repeated; one without any, or that no ply can be, stands once, with its sentence in `reason`.
    ///
    /// Columns are data by name as in [`Study::solve_given`]; their unit may stand in their metadata `unit`. Any integers, floating-point
    /// numbers, truth values and texts are taken, and null for a datum that is not given. Each call stands for itself; threads may share
    /// a study.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use arrow_array::{Float64Array, RecordBatch};
    /// use nply_sheet::Spec;
    /// use nply_sheet::sweep::{Study, SweepFlags};
    /// let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "0.75")])?;
    /// let study = Study::from_spec(&ply, &SweepFlags { states: Some("stable".into()), ..SweepFlags::default() })?;
    /// let twist = Float64Array::from(vec![-1.0, f64::NAN]);
    /// let rows = RecordBatch::try_from_iter([("pretwist", Arc::new(twist) as _)])?;
    /// let answers = study.solve_rows(&rows)?;
    /// let reason = answers.column_by_name("reason").unwrap();
    /// assert_eq!((answers.num_rows(), reason.is_null(0), reason.is_null(1)), (2, true, false));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`SpecError`] where no column is a datum, or one is not understood.
    pub fn solve_rows(&self, rows: &RecordBatch) -> Result<RecordBatch, SpecError> {
        let (given, cells) = read(rows)?;
        let (own, answers) = {
            let columns = self.given_columns(&given)?;
            (columns, self.solve_given(&given, &cells)?)
        };
        let (places, columns) = answers;
        let rows = rows.project(&Self::carried(&given)).map_err(|error| {
            refused(ErrorKind::WrongType, "rows", format!("the rows cannot be carried over: {error}"))
        })?;
        let fields: Vec<Arc<Field>> =
            rows.schema().fields().iter().cloned().chain(own.iter().map(|column| Arc::new(field(column)))).collect();
        let metadata: std::collections::HashMap<String, String> =
            rows.schema().metadata().clone().into_iter().chain(self.metadata()).collect();
        let schema = Arc::new(Schema::new_with_metadata(fields, metadata));
        let same = places.len() == rows.num_rows() && places.iter().enumerate().all(|(at, place)| at == *place);
        let cannot = |error: &dyn core::fmt::Display| {
            refused(ErrorKind::WrongType, "rows", format!("the rows cannot be carried over: {error}"))
        };
        let mut arrays: Vec<ArrayRef> = Vec::with_capacity(schema.fields().len());
        if same {
            arrays.extend(rows.columns().iter().cloned());
        } else {
            let at: UInt64Array = places.iter().map(|place| *place as u64).collect();
            for column in rows.columns() {
                arrays.push(arrow_select::take::take(column, &at, None).map_err(|error| cannot(&error))?);
            }
        }
        arrays.extend(columns.iter().map(crate::table::arrow::array));
        RecordBatch::try_new(schema, arrays).map_err(|error| cannot(&error))
    }
}

/// Columns of an Arrow table as columns of ours; of kinds that no datum has, only the name.
pub(crate) fn read(rows: &RecordBatch) -> Result<(Vec<Column>, Vec<Values>), SpecError> {
    let schema = rows.schema();
    let mut columns = Vec::with_capacity(rows.num_columns());
    let mut cells = Vec::with_capacity(rows.num_columns());
    for (field, array) in schema.fields().iter().zip(rows.columns()) {
        let unit = field.metadata().get("unit").map(String::as_str).unwrap_or_default();
        let values = values(array);
        if values.is_none()
            && super::plan::GivenKey::of_column(&Column::new(field.name(), Kind::Float).with_unit(unit))?.is_some()
        {
            let message = format!(
                "column {} holds {}: what is wanted are numbers, truth values or texts",
                crate::quoted(field.name()),
                field.data_type()
            );
            return Err(refused(ErrorKind::WrongType, "rows", message));
        }
        let values = values.unwrap_or(Values::Nothing(Kind::Text, array.len()));
        columns.push(Column::new(field.name(), values.kind()).with_unit(unit));
        cells.push(values);
    }
    Ok((columns, cells))
}
