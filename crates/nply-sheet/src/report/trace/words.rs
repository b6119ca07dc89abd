//! States and events on a path in a few words.

use nply::Handedness;
use nply::mechanics::{End, Event, Mark, Support};

use super::stop::Stop;

/// A state in a few words.
pub(super) fn brief<S: Stop>(station: &S) -> String {
    // 0.000° in the words below
    if station.lay_angle().degrees() < 5e-4 {
        return "straight".to_owned();
    }
    let side = if station.hand() == Handedness::Right { "right" } else { "left" };
    let how = match station.carried() {
        Support::Neighbours if station.pulls() => ", p < 0",
        Support::Neighbours => "",
        Support::Core => " on the core",
        Support::Both => " touching on the core",
        Support::Free => " free",
    };
    format!("{side} {:.3}°{how}", station.lay_angle().degrees())
}

pub(super) fn carried_by<S: Stop>(station: &S) -> &'static str {
    match station.carried() {
        Support::Neighbours if station.pulls() => "pulling",
        Support::Neighbours => "neighbours",
        Support::Core => "core",
        Support::Both => "both",
        Support::Free => "none",
    }
}

/// An event in a few words.
pub(super) fn what<S: Stop>(event: &Event<S>) -> String {
    let words = word(event);
    if event.jump.is_some() { format!("{words}, jump") } else { words.to_owned() }
}

/// What ends the stable states, in a sentence.
pub(super) fn happened<S: Stop>(event: &Event<S>) -> &'static str {
    match event.mark {
        Mark::Fold => "there two states meet in a fold",
        Mark::ContactChange(Support::Free) => "there the ply opens",
        Mark::ContactChange(Support::Neighbours) => "there neighbours alone come to carry the strands",
        Mark::ContactChange(Support::Core) => "there the core alone comes to carry the strands",
        Mark::ContactChange(Support::Both) => "there neighbours and core come to carry the strands",
        _ => word(event),
    }
}

const fn word<S>(event: &Event<S>) -> &'static str {
    match event.mark {
        Mark::Arrival => "arrives",
        Mark::Fold => "fold",
        Mark::ContactChange(Support::Free) => "opens",
        Mark::ContactChange(Support::Neighbours) => "on neighbours alone",
        Mark::ContactChange(Support::Core) => "on the core alone",
        Mark::ContactChange(Support::Both) => "neighbours and core",
        Mark::Separation => "p = 0",
        Mark::Diagonal => "45°",
        Mark::MostTurns => "most turns",
        Mark::CurvatureLimit => "curvature limit",
        Mark::StrainLimit => "strain limit",
        Mark::Straight => "straight",
        Mark::Buckling => "buckles",
    }
}

pub(super) const fn ended(end: End) -> &'static str {
    match end {
        End::Arrival => "arrives",
        End::LeftWindow => "back to start",
        End::FlatRings => "flat rings",
        End::Apart => "apart",
        End::UnboundedLoad => "no end of load",
        End::Overstretched => "overstretched",
        End::Stalled => "stops",
    }
}

pub(super) const fn why(end: End) -> &'static str {
    match end {
        End::Arrival => "it arrives",
        End::LeftWindow => {
            "after a fold the branch leads back to where the leg began, and beyond; the far end cannot be reached along it"
        }
        End::FlatRings => "the strands come to lie as flat rings, 90° to the axis",
        End::Apart => "the strands lose each other and open without bound",
        End::UnboundedLoad => {
            "the load that holds the displacement grows without bound, as no more turns or no shorter ply can be had"
        }
        End::Overstretched => {
            "strands come to be stretched to less than half or more than double their length, where linear elasticity means nothing"
        }
        End::Stalled => "the branch could not be followed further",
    }
}
