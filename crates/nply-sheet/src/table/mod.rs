//! Tables for a program, written chunk by chunk as CSV or (feature `parquet`) Parquet.
//!
//! ```
//! use nply_sheet::table::{Column, Kind, TableWriter};
//! let columns = vec![Column::new("force", Kind::Float).with_unit("N"), Column::new("states", Kind::Integer)];
//! let mut table = TableWriter::csv(columns, Vec::new())?;
//! table.write_chunk(&[vec![Some(0.1), None].into(), vec![1_i64, 2].into()])?;
//! assert_eq!(String::from_utf8(table.finish()?)?, "force,states\n0.1,1\n,2\n");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(feature = "parquet")]
pub mod arrow;
mod block;
mod column;
mod comma;
#[cfg(feature = "parquet")]
mod damaged;
mod error;
#[cfg(feature = "parquet")]
mod parquet;
mod reader;
mod writer;

pub use block::{Block, BlockFile, Encoder, Format, Mark};
pub use column::{Column, Kind, Values};
#[cfg(feature = "parquet")]
pub use damaged::panic_is_caught;
pub use error::TableError;
pub use reader::TableReader;
pub use writer::TableWriter;
