//! The book's chapters, their directives expanded: what a reader sees of an equation, a command, a number, a figure or a program is made when the book is built.
//!
//! Nothing here needs mdBook; `main` hands it what [`Book::expand`] gives.

mod anchor;
mod book;
mod command;
mod console;
mod equation;
mod example;
mod failure;
mod fence;
mod figure;
mod include;
mod katex;
mod kept;
mod links;
mod made;
mod math;
mod picture;
mod program;
mod prose;
mod site;
mod summary;
mod typeset;
mod value;

pub use book::{Book, Chapter};
pub use equation::Equations;
pub use failure::Failure;
pub use katex::Katex;
pub use math::{formulas, set_formulas};
pub use site::Site;
pub use summary::Summary;
