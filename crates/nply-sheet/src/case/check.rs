//! From what was written to one question: the ways in which a description is understood as a whole.

use super::{Case, Shape, Strings, strands};
use crate::SpecError;
use crate::spec::Spec;

impl Spec {
    /// Understands the description as a whole: dimensionless numbers and one question.
    ///
    /// # Errors
    /// [`SpecError`]: a datum is missing, data contradict each other or are too many, a unit stands where the input has no
    /// scale (or the reverse), or no ply can be like this.
    ///
    /// ```
    /// use nply_sheet::{ErrorKind, Spec};
    /// let spec = Spec::from_flags([("strands", "1"), ("stiffness-ratio", "1"), ("pretwist", "-1")])?;
    /// assert_eq!(spec.check().unwrap_err().kind(), ErrorKind::Domain);
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn check(&self) -> Result<Case, SpecError> {
        Case::of(self, false)
    }

    /// As [`Spec::check`], asking what carries the strands ([`Question::Supported`](crate::Question::Supported)) whether or not a
    /// core is given; without one, strands touch their neighbours or nothing.
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::check`], and where the shape is given, `separation` is asked, the balance is radial or an
    /// external pressure acts.
    ///
    /// ```
    /// use nply_sheet::{Report, Spec};
    /// let flags = [("strands", "2"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2"), ("force", "-0.3"), ("moment", "0.9")];
    /// let report = Report::of(Spec::from_flags(flags)?.check_supports()?)?;
    /// let json: serde_json::Value = serde_json::from_str(&report.json())?;
    /// let open = json["states"].as_array().and_then(|states| states.iter().find(|state| state["support"] == "none"));
    /// let angle = open.and_then(|state| state["helical_angle_deg"].as_f64()).unwrap_or(0.0);
    /// assert!((angle - 50.36).abs() < 0.01); // free helices
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn check_supports(&self) -> Result<Case, SpecError> {
        Case::of(self, true)
    }

    /// As [`Spec::check`], of a ply that is spun and let go: the twist of its singles, a wanted lay, or both.
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::check`], where a load is given, or a lay whose hand is not.
    ///
    /// ```
    /// use nply_sheet::{Question, Spec};
    /// let flags = [("strands", "2"), ("stiffness-ratio", "1"), ("helical-angle", "20 deg"), ("hand", "S")];
    /// let case = Spec::from_flags(flags)?.check_plying()?;
    /// assert!(matches!(case.question, Question::PretwistAt { .. }));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn check_plying(&self) -> Result<Case, SpecError> {
        Case::of_plying(self)
    }

    /// Strings that a motor twists together: number, size, length, pull, and turns if not all that go in are meant.
    ///
    /// # Errors
    /// [`SpecError`] where one of these is missing, more turns are asked for than go in, or what such strings have not is given.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// let flags = [("strands", "2"), ("diameter", "1 mm"), ("strand-length", "0.5 m"), ("force", "20 N")];
    /// assert_eq!(Spec::from_flags(flags)?.check_strings()?.rotation, None);
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn check_strings(&self) -> Result<Strings, SpecError> {
        Strings::of(self)
    }

    /// The number of strands alone, 1 to a million.
    ///
    /// # Errors
    /// [`SpecError`] if it is missing or no ply has it.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// assert_eq!(Spec::from_flags([("strands", "3")])?.check_strands()?, 3);
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn check_strands(&self) -> Result<u32, SpecError> {
        strands(self, 1)
    }

    /// Understands the shape alone: number of strands, lay, and the strand's radius if given.
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::check`]; one strand is accepted.
    ///
    /// ```
    /// use nply_sheet::{Lay, Spec};
    /// let shape = Spec::from_flags([("strands", "2"), ("helical-angle", "45 deg")])?.check_shape()?;
    /// assert_eq!(shape.lay, Some(Lay::HelicalAngle(core::f64::consts::FRAC_PI_4)));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn check_shape(&self) -> Result<Shape, SpecError> {
        Shape::of(self)
    }
}
