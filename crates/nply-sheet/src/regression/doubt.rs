//! What makes an answer doubtful: measurements that no ply can have, turns of the wrong sign, a row that stands alone, rows left out.

use super::answer::{round3, values};
use super::chi::chance_of_greater;
use super::descent::{Bottom, Ground};
use super::error::{limit_of, lines, of_signs as question};
use super::problem::Regression;
use super::row::{Row, Settled, reach};
use super::{Compared, FittedRow, Given, Observable, Regressed, RegressionError};
use crate::preferred::six_digits;

/// Chance makes greater sums of squares once in a thousand fits: then something is wrong.
const CHANCE: f64 = 1e-3;

/// Refuses a measurement further beyond what any ply of the estimated strands has, at whatever angle, than errors carry it.
pub(super) fn of_reach(
    regression: &Regression,
    ground: &Ground<'_>,
    best: &Bottom,
    answer: &Regressed,
) -> Result<(), RegressionError> {
    const ERRORS: f64 = 5.0;
    // where errors are not known
    const SHARE: f64 = 0.05;
    if ground.model.stretches() {
        return Ok(());
    }
    let mut ends: Vec<(Observable, Option<[f64; 2]>)> = Vec::new();
    for (row, fitted) in regression.rows.iter().zip(&answer.rows) {
        for compared in fitted.compared.iter().filter(|compared| !compared.observable.is_load()) {
            let Compared { observable, measured, .. } = *compared;
            let error = compared.error.filter(|_| answer.weighed);
            let tolerance = error.map_or(SHARE * measured.abs(), |error| ERRORS * error);
            if compared.residual().abs() <= tolerance {
                continue;
            }
            // shapes do not depend on the twist, and so not on the row
            let known = ends.iter().find(|(other, _)| *other == observable).map(|(_, ends)| *ends);
            let strand = ground.model.strand(&best.slots, row.twist);
            let of_all = known.unwrap_or_else(|| reach(ground.model, ground.charted, &strand, observable));
            if known.is_none() {
                ends.push((observable, of_all));
            }
            let Some([low, high]) = of_all else { continue };
            let least = measured < low;
            if measured < low - tolerance || measured > high + tolerance {
                let (line, name, limit) = (row.line, observable.name(), if least { low } else { high });
                return Err(RegressionError::OutOfReach { line, name, measured, limit, least });
            }
        }
    }
    Ok(())
}

/// Measurements beside a limit, within their errors.
pub(super) fn of_limits(answer: &Regressed) -> Vec<String> {
    let at = |wanted: bool| {
        let rows: Vec<usize> =
            answer.rows.iter().filter(|row| row.limit() == Some(wanted)).map(|row| row.line).collect();
        (!rows.is_empty()).then(|| {
            format!(
                "In {} what was measured is nearest to {}: a limit and no state, within the errors given.",
                lines(&rows),
                limit_of(wanted)
            )
        })
    };
    [false, true].into_iter().filter_map(at).collect()
}

/// Rows of straight strands.
pub(super) fn of_straight(answer: &Regressed) -> Option<String> {
    let rows: Vec<usize> = answer.rows.iter().filter(|row| row.is_straight()).map(|row| row.line).collect();
    (!rows.is_empty()).then(|| {
        format!(
            "In {} the strands lie straight, side by side: without twist and moment, or without turns, that is equilibrium under any force.",
            lines(&rows)
        )
    })
}

/// Rows that say nothing, and why.
pub(super) fn of_left_out(regression: &Regression) -> Option<String> {
    let left_out = &regression.left_out;
    let mut reasons: Vec<&str> = left_out.iter().map(|(_, reason)| reason.as_str()).collect();
    reasons.sort_unstable();
    reasons.dedup();
    let of = |reason: &&str| {
        let rows: Vec<usize> = left_out.iter().filter(|(_, other)| other == reason).map(|(line, _)| *line).collect();
        format!("{reason} in {}", lines(&rows))
    };
    let said: Vec<String> = reasons.iter().map(of).collect();
    let rows = if left_out.len() == 1 { "1 row is".to_owned() } else { format!("{} rows are", left_out.len()) };
    (!said.is_empty()).then(|| format!("{rows} left out: {}.", said.join("; ")))
}

/// A row that alone makes most of a sum of squares too great, with the estimates without it; and whether the others then fit.
pub(super) fn of_outlier(
    regression: &Regression,
    ground: &Ground<'_>,
    best: &Bottom,
    answer: &Regressed,
) -> Option<(String, bool)> {
    answer.probability.filter(|chance| *chance < CHANCE)?;
    let sums = best.settled.iter().map(Settled::chi_squared).enumerate();
    let (at, most) = sums.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let own = best.settled[at].residuals.len() - best.settled[at].spent;
    let freedom = answer.degrees_of_freedom.checked_sub(own).filter(|freedom| *freedom > 0)?;
    if most < 0.5 * best.chi_squared {
        return None;
    }
    let others: Vec<Row> = [&ground.rows[..at], &ground.rows[at + 1..]].concat();
    let fewer = Ground { rows: &others, ..*ground };
    let starts = [best.slots, *ground.model.slots()];
    let without = starts
        .into_iter()
        .filter_map(|slots| fewer.descend(slots).ok())
        .min_by(|a, b| a.chi_squared.total_cmp(&b.chi_squared))?;
    let said = format!(
        "{} alone makes {:.0} % of χ²: a slip there? Without it {}, with χ² = {} and {freedom} degree{} of freedom.",
        lines(&[ground.rows[at].line]).replace("line", "Line"),
        100.0 * most / best.chi_squared,
        values(regression, &without),
        six_digits(round3(without.chi_squared)),
        if freedom == 1 { "" } else { "s" }
    );
    Some((said, chance_of_greater(without.chi_squared, freedom).is_some_and(|chance| chance > CHANCE)))
}

/// Whether an answer is poor, or none, and turns counted the other way make a good one: the sign of S is easily forgotten.
pub(super) fn of_signs(
    regression: &Regression,
    answer: Result<Regressed, RegressionError>,
    may_go_on: &dyn Fn(usize) -> bool,
) -> Result<Regressed, RegressionError> {
    // signs explain a misfit where it falls to a hundredth
    const FALL: f64 = 1e-2;
    // where errors are not known, what leaves a tenth of the measured numbers unexplained is poor
    const SHARE: f64 = 0.1;
    let poor = match &answer {
        Ok(answer) if !answer.weighed => squares(answer) > SHARE * SHARE * measured(answer),
        Ok(answer) => answer.probability.map_or(answer.chi_squared > 9.0, |chance| chance < CHANCE),
        Err(RegressionError::NoState { .. } | RegressionError::OutOfReach { .. }) => true,
        Err(_) => false,
    };
    let mirrored = poor.then(|| regression.mirrored()).flatten().and_then(|other| other.estimated(may_go_on).ok());
    let Some(mirrored) = mirrored else { return answer };
    let signed = |given: Given| matches!(given, Given::State(observable) if observable.is_signed());
    let columns = regression.columns.iter().map(|column| column.given).filter(|given| signed(*given));
    let columns: Vec<&'static str> = columns.map(Given::name).collect();
    match answer {
        Ok(mut answer) if squares(&mirrored) < FALL * squares(&answer) => {
            answer.notes.insert(0, format!("{}.", question(&columns)));
            Ok(answer)
        }
        Err(error) => Err(RegressionError::Signs { columns, error: Box::new(error) }),
        answer => answer,
    }
}

/// The sum of squared residuals, each over its error where errors are known; one column alone has none.
fn squares(answer: &Regressed) -> f64 {
    let compared = answer.rows.iter().flat_map(|row: &FittedRow| &row.compared);
    let residual = |compared: &Compared| {
        if answer.weighed { compared.standardised().unwrap_or(f64::NAN) } else { compared.residual() }
    };
    compared.map(|compared| residual(compared) * residual(compared)).sum()
}

/// The same of the measured numbers themselves, where errors are not known.
fn measured(answer: &Regressed) -> f64 {
    let compared = answer.rows.iter().flat_map(|row| &row.compared);
    compared.map(|compared| compared.measured * compared.measured).sum()
}
