//! Tools that know no physics: Kepler's equation, polynomials in Bernstein form, roots, numbers with their derivatives.

pub(crate) mod bernstein;
pub(crate) mod columns;
pub(crate) mod dual;
pub(crate) mod foot;
pub(crate) mod gauss;
pub(crate) mod halley;
pub(crate) mod isolate;
pub(crate) mod jet;
pub(crate) mod jet2;
pub(crate) mod kepler;
mod kepler_chart;
pub(crate) mod linear;
mod matrix;
pub(crate) mod quadrant;
pub(crate) mod quadratic;
pub(crate) mod root;
pub(crate) mod septic;
pub(crate) mod series;
pub(crate) mod taylor;
pub(crate) mod vector;
pub(crate) mod wide;
