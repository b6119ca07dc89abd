//! Parameters of a ply from measurements: stiffnesses, size and twist of the strands by weighted least squares.
//!
//! Rows of numbers go in, some held and some measured with errors; estimates with standard errors come out. No files: columns of
//! numbers, as a table or an array has them.
//!
//! ```
//! use nply::mechanics::Balance;
//! use nply_sheet::regression::{DataColumn, Model, Observable, Parameter, Regression, Role};
//! // balanced angles of three strands by the twist put into them, θ(φ̄a) for C/B = 0.75, read to 0.1°
//! let model = Model::new(3, Balance::Contact)?.with(Parameter::StiffnessRatio, 1.0)?;
//! let twist = DataColumn::held(Parameter::Pretwist, vec![-0.2, -0.5, -1.0, -2.0]);
//! let degrees = [12.1369_f64, 23.2305, 30.6130, 34.5859];
//! let angle = degrees.map(f64::to_radians).to_vec();
//! let angle = DataColumn::new(Observable::HelicalAngle, angle, Role::Measured(vec![0.1_f64.to_radians(); 4]));
//! let fit = Regression::new(model, &[Parameter::StiffnessRatio], vec![twist, angle])?.run()?;
//! let ratio = &fit.estimates[0];
//! assert!((ratio.value - 0.75).abs() < 1e-4 && ratio.standard_error.is_some_and(|error| error < 0.02));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod answer;
mod chi;
mod columns;
mod descent;
mod doubt;
mod error;
mod heading;
mod limp;
mod observable;
mod parameter;
mod picture;
mod problem;
mod reader;
mod report;
mod row;
mod rows;
mod sensed;
mod state;
mod straight;
mod written;

pub use answer::{Compared, Estimate, FittedRow, Regressed};
pub use columns::Measurements;
pub use error::RegressionError;
pub use observable::Observable;
pub use parameter::Parameter;
pub use problem::{DataColumn, Given, Regression, Role};
pub use report::{RegressionQuestion, RegressionReport};
pub use state::Model;
