//! Estimates, how sure they are, and what they leave of the data.

use nalgebra::{DMatrix, DVectorView};
use nply::Handedness;

use super::chi::chance_of_greater;
use super::descent::{Bottom, Ground};
use super::error::lines;
use super::problem::Regression;
use super::row::{Row, Settled, is_limit};
use super::{Observable, Parameter, RegressionError, doubt};
use crate::preferred::six_digits;

/// A parameter as the data have it: SI, or the theory's units where the strand has no size; twists in rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Which.
    pub parameter: Parameter,
    /// Its most likely value.
    pub value: f64,
    /// One standard error; `None` where the data do not determine it, or leave nothing to tell errors from.
    pub standard_error: Option<f64>,
    /// Where the search began; with [`known_to`](Self::known_to), what it is known to be.
    pub start: f64,
    /// Whether the data determine it, alone and not only together with another; if not, its value is one of many.
    pub determined: bool,
    /// One standard error to which the start is known beforehand, where it counts as a measurement.
    pub known_to: Option<f64>,
}

/// A measured number beside what the fitted state has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compared {
    /// What was measured.
    pub observable: Observable,
    /// What was measured, SI.
    pub measured: f64,
    /// What the state has.
    pub fitted: f64,
    /// One standard error of the measured number: as given, or from the residuals of all; `None` where nothing tells.
    pub error: Option<f64>,
}

impl FittedRow {
    /// Whether the strands are straight, side by side: in equilibrium where there is neither twist nor moment, or where there are no turns.
    #[must_use]
    pub fn is_straight(&self) -> bool {
        self.helical_angle <= 0.0
    }

    /// Whether what was measured is nearest to straight strands or to flat rings: limits, and no states. `true`: flat rings.
    #[must_use]
    pub fn limit(&self) -> Option<bool> {
        (self.moved && !self.is_straight() && is_limit(self.helical_angle)).then_some(self.helical_angle > 1.0)
    }
}

impl Compared {
    /// Measured less fitted.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.measured - self.fitted
    }

    /// The same in errors.
    #[must_use]
    pub fn standardised(&self) -> Option<f64> {
        self.error.filter(|error| *error > 0.0).map(|error| self.residual() / error)
    }
}

/// The state that a row belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedRow {
    /// Line of the file, or number of the row.
    pub line: usize,
    /// Which way the ply winds.
    pub handedness: Handedness,
    /// θ, rad.
    pub helical_angle: f64,
    /// End force, SI.
    pub force: f64,
    /// End moment, SI.
    pub moment: f64,
    /// p₁ r³/B; negative where touching neighbours would have to pull.
    pub interstrand_pressure: f64,
    /// Whether measured numbers moved the state; else what is held fixes it.
    pub moved: bool,
    /// States in equilibrium that were looked at.
    pub states: usize,
    /// By how much the sum of squared residuals would be greater at the second nearest state.
    pub next_state: Option<f64>,
    /// Every measured number.
    pub compared: Vec<Compared>,
}

/// What a regression answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Regressed {
    /// In the order in which they were asked for.
    pub estimates: Vec<Estimate>,
    /// Correlations of the estimates' errors, of logarithms where a parameter is positive; `None` where one is not determined.
    pub correlation: Vec<Vec<Option<f64>>>,
    /// The sum of squared residuals, each over its error; where errors are not given, that is the degrees of freedom.
    pub chi_squared: f64,
    /// Measured numbers less those used up by the rows' states and by the estimates.
    pub degrees_of_freedom: usize,
    /// How often chance alone gives a greater χ²; `None` where errors are not given or nothing is left.
    pub probability: Option<f64>,
    /// Whether errors were given; else they are the residuals' own.
    pub weighed: bool,
    /// Row by row.
    pub rows: Vec<FittedRow>,
    /// What the data do not say, and what else one must know, a sentence each.
    pub notes: Vec<String>,
}

/// Below this share of the best determined direction nothing is determined.
const UNDETERMINED: f64 = 1e-8;

/// Which steps change no residual by more than rounding does: by a ten millionth of its error at a whole step, or of what another step does
/// to it. Residual by residual, so that a number known to many digits takes nothing from what the others say.
fn without_effect(slopes: &DMatrix<f64>) -> Vec<bool> {
    let most: Vec<f64> =
        slopes.row_iter().map(|row| row.iter().fold(1.0, |most: f64, slope| most.max(slope.abs()))).collect();
    let none =
        |column: DVectorView<'_, f64>| column.iter().zip(&most).all(|(slope, most)| slope.abs() <= UNDETERMINED * most);
    slopes.column_iter().map(none).collect()
}

/// How the data determine the parameters: covariance as far as there is one, and directions that change nothing.
struct Spread {
    /// of the steps x
    covariance: DMatrix<f64>,
    /// directions in x
    idle: Vec<Vec<f64>>,
}

impl Spread {
    fn of(slopes: &DMatrix<f64>) -> Self {
        let count = slopes.ncols();
        let idle = without_effect(slopes);
        let norms: Vec<f64> = slopes.column_iter().map(|column| column.norm()).collect();
        let norm = |k: usize| if idle[k] { 1.0 } else { norms[k] };
        let scaled = DMatrix::from_fn(slopes.nrows().max(count), count, |i, k| {
            if i < slopes.nrows() && !idle[k] { slopes[(i, k)] / norm(k) } else { 0.0 }
        });
        let parts = scaled.svd(false, true);
        let across = parts.v_t.unwrap_or_else(|| DMatrix::identity(count, count));
        let largest = parts.singular_values.max();
        let mut covariance = DMatrix::zeros(count, count);
        let mut idle = Vec::new();
        for (at, singular) in parts.singular_values.iter().enumerate() {
            let direction: Vec<f64> = (0..count).map(|k| across[(at, k)] / norm(k)).collect();
            if *singular > UNDETERMINED * largest {
                for i in 0..count {
                    for k in 0..count {
                        covariance[(i, k)] += direction[i] * direction[k] / (singular * singular);
                    }
                }
            } else {
                idle.push(direction);
            }
        }
        Self { covariance, idle }
    }

    /// Whether a parameter has no part in what changes nothing.
    fn determines(&self, k: usize) -> bool {
        self.idle.iter().all(|direction| {
            let length = direction.iter().map(|x| x * x).sum::<f64>();
            direction[k] * direction[k] <= 1e-8 * length
        })
    }
}

pub(super) fn of(
    regression: &Regression,
    ground: &Ground<'_>,
    mut best: Bottom,
    others: &[Bottom],
) -> Result<Regressed, RegressionError> {
    let slopes = ground.slopes(&best.slots, &best.settled);
    let spread = Spread::of(&slopes);
    // what changes no residual has wandered freely: it stays where it was
    for (idle, slot) in without_effect(&slopes).into_iter().zip(ground.free) {
        if idle {
            best.slots[*slot] = regression.model.slots()[*slot];
        }
    }
    let spent: usize = best.settled.iter().map(|row| row.spent).sum();
    let known = slopes.nrows() - spent;
    let asked = &regression.asked;
    if known < asked.len() {
        return Err(RegressionError::TooFew { unknown: asked.len(), known });
    }
    let freedom = known - (asked.len() - spread.idle.len());
    // where errors are not given, those of the residuals themselves
    let scale = match (regression.weighed, freedom) {
        (true, _) => Some(1.0),
        (false, 0) => None,
        (false, freedom) => Some(best.chi_squared / freedom as f64),
    };
    // a number that may as well be a hundred e-folds greater or less is none
    const MOST: f64 = 100.0;
    let spread_of = |k: usize, scale: f64| libm::sqrt(spread.covariance[(k, k)] * scale);
    // where no freedom is left a fit is exact; one that is not ran off, and what it missed by says how far
    let missed = scale.unwrap_or(best.chi_squared);
    let determined = |k: usize| spread.determines(k) && spread_of(k, missed) < MOST;
    let deviation = |k: usize| scale.map(|scale| spread_of(k, scale)).filter(|_| determined(k));
    let model = &regression.model;
    let value = |k: usize| model.value_at(&best.slots, asked[k]).unwrap_or(f64::NAN);
    // an error of a logarithm is a share of the value; one of the twist, in steps of the size of its slot
    let error = |k: usize| Some(deviation(k)? * if asked[k].is_positive() { value(k) } else { ground.sizes[k] });
    let estimates: Vec<Estimate> = (0..asked.len())
        .map(|k| Estimate {
            parameter: asked[k],
            value: value(k),
            standard_error: error(k),
            start: model.value(asked[k]).unwrap_or(f64::NAN),
            determined: determined(k),
            known_to: regression.known.iter().find(|known| known.parameter == asked[k]).map(|known| known.error),
        })
        .collect();
    let correlation = (0..asked.len())
        .map(|i| {
            let with = |k: usize| {
                let (own, other) = (spread.covariance[(i, i)], spread.covariance[(k, k)]);
                let both = spread.determines(i) && spread.determines(k);
                both.then(|| {
                    if i == k { 1.0 } else { (spread.covariance[(i, k)] / libm::sqrt(own * other)).clamp(-1.0, 1.0) }
                })
            };
            (0..asked.len()).map(with).collect()
        })
        .collect();
    let rows: Vec<FittedRow> = regression
        .rows
        .iter()
        .zip(&best.settled)
        .take_while(|_| (ground.may_go_on)())
        .map(|(row, settled)| fitted(ground, &best, row, settled, scale))
        .collect();
    let mut answer = Regressed {
        estimates,
        correlation,
        chi_squared: scale.map_or(0.0, |scale| if scale > 0.0 { best.chi_squared / scale } else { 0.0 }),
        degrees_of_freedom: freedom,
        probability: regression.weighed.then(|| chance_of_greater(best.chi_squared, freedom)).flatten(),
        weighed: regression.weighed,
        rows,
        notes: Vec::new(),
    };
    doubt::of_reach(regression, ground, &best, &answer)?;
    answer.notes = notes(regression, ground, &best, others, &spread, &answer);
    Ok(answer)
}

fn fitted(ground: &Ground<'_>, best: &Bottom, row: &Row, settled: &Settled, scale: Option<f64>) -> FittedRow {
    let strand = ground.model.strand(&best.slots, row.twist);
    let candidates = row.candidates(ground.model, ground.charted, &strand);
    let compared = row.measured.iter().zip(&settled.fitted).map(|(datum, fitted)| Compared {
        observable: datum.observable,
        measured: datum.value,
        fitted: *fitted,
        error: scale.map(|scale| libm::sqrt(scale) * datum.error),
    });
    let readings = &settled.readings;
    FittedRow {
        line: row.line,
        handedness: settled.spot.hand,
        helical_angle: readings.angle.value,
        force: Observable::Force.of(readings).value,
        moment: Observable::Moment.of(readings).value,
        interstrand_pressure: readings.pressure,
        moved: row.held.len() < 2,
        states: candidates.len().max(1),
        next_state: candidates.get(1).map(|next| {
            let more = next.chi_squared() - settled.chi_squared();
            more / scale.filter(|scale| *scale > 0.0).unwrap_or(1.0)
        }),
        compared: compared.collect(),
    }
}

fn notes(
    regression: &Regression,
    ground: &Ground<'_>,
    best: &Bottom,
    others: &[Bottom],
    spread: &Spread,
    answer: &Regressed,
) -> Vec<String> {
    let mut notes = Vec::from_iter(doubt::of_left_out(regression));
    if !best.converged {
        notes.push("The search did not come to an end within its steps: the estimates are the best it found. Start nearer to them.".to_owned());
    }
    notes.extend(spread.idle.iter().map(|direction| undetermined(regression, ground, best, direction, spread)));
    if spread.idle.is_empty() {
        notes.extend(alike(answer));
        notes.extend(elsewhere(regression, ground, best, others, spread));
    }
    for estimate in &answer.estimates {
        if !estimate.determined && spread.idle.is_empty() {
            notes.push(format!(
                "{} is not determined: values many times as great or as small fit as well.",
                estimate.parameter.name()
            ));
        }
        if let Some(error) = estimate.standard_error
            && estimate.parameter.is_positive()
            && error > 0.5 * estimate.value
        {
            notes.push(format!(
                "{} is hardly determined: its standard error is {} of it, so large that the estimate says little more than its order.",
                estimate.parameter.name(),
                super::report::percent(error / estimate.value)
            ));
        }
    }
    match doubt::of_outlier(regression, ground, best, answer) {
        Some((said, rest_fits)) => {
            notes.push(said);
            notes.extend(of_chi(answer).filter(|_| !rest_fits));
        }
        None => notes.extend(of_chi(answer)),
    }
    notes.extend(doubt::of_limits(answer));
    notes.extend(doubt::of_straight(answer));
    notes.extend(of_states(answer));
    notes
}

/// What changes no residual.
fn undetermined(
    regression: &Regression,
    ground: &Ground<'_>,
    best: &Bottom,
    direction: &[f64],
    spread: &Spread,
) -> String {
    // relative changes
    let model = &regression.model;
    let relative = |k: usize| {
        let step = direction[k] * ground.sizes[k];
        let parameter = regression.asked[k];
        if parameter.is_positive() {
            step
        } else {
            let slot = best.slots[parameter.slot() as usize];
            if slot == 0.0 { step } else { step / slot }
        }
    };
    let all: Vec<f64> = (0..direction.len()).map(relative).collect();
    let most = all.iter().fold(0.0_f64, |most, change| most.max(change.abs()));
    let part: Vec<(usize, f64)> = all
        .iter()
        .enumerate()
        .map(|(k, change)| (k, change / most))
        .filter(|(_, change)| change.abs() > 1e-4)
        .collect();
    let name = |k: usize| regression.asked[k].name();
    if let [(k, _)] = part[..] {
        return format!(
            "These measurements say nothing of {}: it changes no residual. Hold it, or measure what depends on it.",
            name(k)
        );
    }
    let sign = if part.first().is_some_and(|(_, change)| *change < 0.0) { -1.0 } else { 1.0 };
    let changes: Vec<String> =
        part.iter().map(|(k, change)| format!("{} by {} %", name(*k), six_digits(round3(sign * change)))).collect();
    let mut said = format!(
        "These measurements do not tell {} apart: changing {} together changes no residual.",
        listed(part.iter().map(|(k, _)| name(*k).to_owned()).collect()),
        listed(changes)
    );
    if let [(i, first), (k, second)] = part[..] {
        // a power of the one times the other is left as it is
        let (i, k, power) = if first.abs() > second.abs() { (k, i, -second / first) } else { (i, k, -first / second) };
        // name(i)·name(k)^power does not change; the power is at most 1: turn it round where that gives a whole one
        let (i, k, power) = if (1.0 / power - libm::round(1.0 / power)).abs() < 1e-3 {
            (k, i, libm::round(1.0 / power))
        } else {
            (i, k, power)
        };
        let rounded = round3(power);
        let raised =
            |power: f64| if (power - 1.0).abs() < 1e-9 { String::new() } else { format!("^{}", six_digits(power)) };
        let product = if rounded < 0.0 {
            format!("{}/{}{}", name(i), name(k), raised(-rounded))
        } else {
            format!("{}·{}{}", name(i), name(k), raised(rounded))
        };
        let share = |at: usize| {
            if regression.asked[at].is_positive() {
                1.0
            } else {
                let slot = best.slots[regression.asked[at].slot() as usize];
                if slot == 0.0 { 0.0 } else { ground.sizes[at] / slot }
            }
        };
        let weights = [(i, share(i)), (k, power * share(k))];
        let variance: f64 = weights
            .iter()
            .flat_map(|a| weights.iter().map(move |b| (a, b)))
            .map(|((a, wa), (b, wb))| wa * wb * spread.covariance[(*a, *b)])
            .sum();
        let of = |at: usize| model.value_at(&best.slots, regression.asked[at]).unwrap_or(f64::NAN);
        let size = libm::pow(of(k).abs(), power) * of(i).abs();
        if size.is_finite() && variance >= 0.0 {
            said += &format!(" Near here only {product} is determined; hold one of the two.");
        }
    } else {
        said += " Hold one of them, or measure something else too.";
    }
    said
}

pub(super) fn round3(value: f64) -> f64 {
    libm::round(value * 1e3) / 1e3
}

fn listed(mut words: Vec<String>) -> String {
    match words.pop() {
        None => String::new(),
        Some(last) if words.is_empty() => last,
        Some(last) => format!("{} and {last}", words.join(", ")),
    }
}

/// Estimates that go up and down together.
fn alike(answer: &Regressed) -> Vec<String> {
    let mut notes = Vec::new();
    for (i, row) in answer.correlation.iter().enumerate() {
        for (k, correlation) in row.iter().enumerate().take(i) {
            if let Some(correlation) = correlation.filter(|correlation| correlation.abs() > 0.98) {
                let (a, b) = (answer.estimates[k].parameter.name(), answer.estimates[i].parameter.name());
                notes.push(format!(
                    "{a} and {b} are hardly told apart (correlation {correlation:.4}): each is sure only as far as the other is."
                ));
            }
        }
    }
    notes
}

/// Other places of nearly the same χ².
fn elsewhere(
    regression: &Regression,
    ground: &Ground<'_>,
    best: &Bottom,
    others: &[Bottom],
    spread: &Spread,
) -> Option<String> {
    let lowest = others.first()?;
    // a sum of squares that is nothing but rounding has no neighbours
    let freedom = lowest.settled.iter().map(|row| row.residuals.len()).sum::<usize>() as f64;
    let near = if regression.weighed { 9.0 } else { 9.0 * lowest.chi_squared / freedom.max(1.0) };
    let apart = |other: &&Bottom| {
        ground.free.iter().zip(ground.sizes).enumerate().any(|(at, (k, size))| {
            let away = (other.slots[*k] - best.slots[*k]).abs() / size;
            let scale = if regression.weighed { 1.0 } else { lowest.chi_squared / freedom.max(1.0) };
            away > 1e-3 && away > 4.0 * libm::sqrt(spread.covariance[(at, at)] * scale)
        })
    };
    let other =
        others.iter().filter(|other| other.converged && other.chi_squared < lowest.chi_squared + near).find(apart)?;
    Some(format!(
        "Another minimum is not excluded by these measurements: {}, with χ² greater by {} only. A start nearer to what you know decides.",
        values(regression, other),
        six_digits(other.chi_squared - lowest.chi_squared)
    ))
}

/// What is asked for, as it is at a place.
pub(super) fn values(regression: &Regression, at: &Bottom) -> String {
    let value = |parameter: &Parameter| {
        Some(format!("{} = {}", parameter.name(), six_digits(regression.model.value_at(&at.slots, *parameter)?)))
    };
    let values: Vec<String> = regression.asked.iter().filter_map(value).collect();
    let bare = regression.asked.iter().all(|parameter| parameter.dimension() == crate::Dimension::NUMBER);
    values.join(", ") + if bare { "" } else { " (SI, twists in rad)" }
}

fn of_chi(answer: &Regressed) -> Option<String> {
    let freedom = answer.degrees_of_freedom;
    if !answer.weighed {
        return Some(if freedom == 0 {
            "No errors are given and no measurement is left over: nothing tells how sure the estimates are.".to_owned()
        } else {
            "No errors are given: those of the measurements are taken to be all alike and as large as the residuals, so that χ² tests nothing."
                .to_owned()
        });
    }
    let times = libm::sqrt(answer.chi_squared / freedom.max(1) as f64);
    match answer.probability {
        None => Some("No measurement is left over: the fit is exact and χ² tests nothing.".to_owned()),
        Some(chance) if chance < 1e-3 => Some(format!(
            "χ² is greater than chance makes it once in a thousand fits: measurements are less exact than said, or the theory lacks something \
             (friction, stretch, ends). Errors {} times as large would explain it, and the standard errors would be so much larger.",
            six_digits(round3(times))
        )),
        Some(chance) if chance > 0.999 => Some(format!(
            "χ² is less than chance makes it once in a thousand fits: the errors given are too large, about {} times.",
            six_digits(round3(1.0 / times))
        )),
        Some(_) => None,
    }
}

fn of_states(answer: &Regressed) -> Vec<String> {
    let mut notes = Vec::new();
    let several: Vec<&FittedRow> = answer.rows.iter().filter(|row| row.states > 1).collect();
    if !several.is_empty() {
        let close: Vec<usize> =
            several.iter().filter(|row| row.next_state.is_some_and(|more| more < 9.0)).map(|row| row.line).collect();
        let mut said = format!(
            "In {} of {} rows several states are in equilibrium; each row belongs to the one nearest to what was measured.",
            several.len(),
            answer.rows.len()
        );
        if !close.is_empty() {
            said += &format!(
                " In {} another is within three errors: the choice there is not certain, and the hand (--hand) or a shape may decide.",
                lines(&close)
            );
        }
        notes.push(said);
    }
    let parted: Vec<usize> =
        answer.rows.iter().filter(|row| row.interstrand_pressure < 0.0).map(|row| row.line).collect();
    if !parted.is_empty() {
        notes.push(format!(
            "In {} touching neighbours would have to pull on each other (p₁ < 0): strands that only push part there, and what was measured is \
             another state; leave the rows out, or see `nply support`.",
            lines(&parted)
        ));
    }
    notes
}
