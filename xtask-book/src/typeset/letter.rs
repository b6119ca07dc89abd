//! Single signs: what each is in LaTeX.

/// A letter or sign that stands for something; none of what is no such sign.
pub(super) fn latex(letter: char) -> Option<&'static str> {
    Some(match letter {
        'α' => r"\alpha ",
        'β' => r"\beta ",
        'γ' => r"\gamma ",
        'δ' => r"\delta ",
        'ε' => r"\varepsilon ",
        'ζ' => r"\zeta ",
        'η' => r"\eta ",
        'θ' => r"\theta ",
        'κ' => r"\kappa ",
        'λ' => r"\lambda ",
        'μ' => r"\mu ",
        'ν' => r"\nu ",
        'π' => r"\pi ",
        'ρ' => r"\rho ",
        'σ' => r"\sigma ",
        'τ' => r"\tau ",
        'φ' => r"\varphi ",
        'χ' => r"\chi ",
        'ψ' => r"\psi ",
        'ω' => r"\omega ",
        'Γ' => r"\Gamma ",
        'Δ' => r"\Delta ",
        'Θ' => r"\Theta ",
        'Λ' => r"\Lambda ",
        'Φ' => r"\Phi ",
        'Ψ' => r"\Psi ",
        'Ω' => r"\Omega ",
        '𝓕' => r"\mathcal{F}",
        '𝓛' => r"\mathcal{L}",
        'ℒ' => r"\mathscr{L}",
        '𝓡' => r"\mathcal{R}",
        'Ĝ' => r"\hat{G}",
        '∂' => r"\partial ",
        '∞' => r"\infty ",
        '…' => r"\dots ",
        '½' => r"\tfrac12 ",
        '¼' => r"\tfrac14 ",
        '¾' => r"\tfrac34 ",
        _ => return None,
    })
}

/// What stands between terms.
pub(super) fn operator(letter: char) -> Option<&'static str> {
    Some(match letter {
        '+' => "+",
        '−' | '-' => "-",
        '±' => r"\pm ",
        '∓' => r"\mp ",
        '=' => "=",
        '<' => "<",
        '>' => ">",
        '≤' => r"\le ",
        '≥' => r"\ge ",
        '≪' => r"\ll ",
        '≈' => r"\approx ",
        '→' => r"\to ",
        ',' => ",",
        ':' => ":",
        ';' => ";",
        '.' => ".",
        _ => return None,
    })
}

/// An accent that stands behind its letter.
pub(super) fn accent(mark: char) -> Option<&'static str> {
    Some(match mark {
        '\u{304}' => r"\bar",
        '\u{302}' => r"\hat",
        '\u{303}' => r"\tilde",
        '\u{307}' => r"\dot",
        _ => return None,
    })
}

/// A raised sign as it is when not raised.
pub(super) fn raised(letter: char) -> Option<char> {
    pair("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿⁱ", "0123456789+-ni", letter)
}

/// A lowered sign as it is when not lowered.
pub(super) fn lowered(letter: char) -> Option<char> {
    pair("₀₁₂₃₄₅₆₇₈₉₊₋ₐₑᵢⱼₖₙᵣₛ", "0123456789+-aeijknrs", letter)
}

fn pair(signs: &str, plain: &str, letter: char) -> Option<char> {
    signs.chars().zip(plain.chars()).find_map(|(sign, plain)| (sign == letter).then_some(plain))
}

/// Functions that are written with their argument behind them.
pub(super) fn is_function(word: &str) -> bool {
    matches!(word, "sin" | "cos" | "tan" | "cot" | "arctan" | "exp" | "ln")
}
