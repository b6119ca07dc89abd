//! One line of a formula: terms of factors, read with the blanks between them.
//!
//! A quotient needs no rule but one for its denominator, as (a b)/c and a (b/c) are the same number. The denominator is a bracket, a root, a function with its argument,
//! or all that stands behind the stroke without a blank: 1/2γ is 1/(2γ), (1/2γ) θ² is θ²/(2γ). Where a reader could take it otherwise, the line is refused.

use super::letter;

/// A formula in LaTeX.
pub(super) fn latex(text: &str, aligned: bool) -> Result<String, String> {
    let mut reader = Reader { letters: text.chars().collect(), at: 0, inline: false, align: aligned };
    let whole = reader.expression(None).map_err(|why| format!("`{text}`: {why}"))?;
    Ok(whole.latex)
}

/// A line's terms, put together.
struct Whole {
    latex: String,
    /// Whether it is one quotient and nothing else.
    is_quotient: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Letter,
    Number,
    Half,
    /// With an argument that stands without brackets: what follows must stand apart.
    Function,
    /// d or ∂.
    Differential,
    /// · or ×.
    Product,
    /// An integral or a limit: what follows is under it.
    Big,
    Word,
    Bracket,
    Quotient,
}

struct Factor {
    latex: String,
    kind: Kind,
    /// No blank before it.
    tight: bool,
    /// Of a bracket without power: what it holds.
    inner: Option<Whole>,
}

impl Factor {
    fn new(latex: impl Into<String>, kind: Kind) -> Self {
        Self { latex: latex.into(), kind, tight: false, inner: None }
    }
}

struct Reader {
    letters: Vec<char>,
    at: usize,
    /// Quotients stay in the line, with a stroke.
    inline: bool,
    /// The first = still to come is where lines are aligned.
    align: bool,
}

impl Reader {
    fn peek(&self) -> Option<char> {
        self.letters.get(self.at).copied()
    }

    fn take(&mut self, wanted: char) -> bool {
        let is_there = self.peek() == Some(wanted);
        self.at += usize::from(is_there);
        is_there
    }

    /// Passes blanks; whether there were any.
    fn blanks(&mut self) -> bool {
        let start = self.at;
        while self.peek() == Some(' ') {
            self.at += 1;
        }
        self.at > start
    }

    /// Terms up to a closing sign, or to the end.
    fn expression(&mut self, close: Option<char>) -> Result<Whole, String> {
        let mut latex = String::new();
        let mut term: Vec<Factor> = Vec::new();
        let mut operators = 0;
        let mut is_quotient = false;
        loop {
            let spaced = self.blanks();
            let Some(next) = self.peek() else {
                if let Some(close) = close {
                    return Err(format!("`{close}` is missing"));
                }
                break;
            };
            if Some(next) == close {
                self.at += 1;
                break;
            }
            if let Some(operator) = letter::operator(next) {
                self.at += 1;
                operators += 1;
                latex.push_str(&joined(&term));
                term.clear();
                let stands_here = next == '=' && close.is_none() && std::mem::take(&mut self.align);
                if stands_here {
                    latex.push('&');
                } else if next == '=' && close.is_none() {
                    self.align = false;
                }
                latex.push_str(operator);
                if next == ',' && close.is_none() {
                    latex.push_str(r"\; ");
                }
            } else if next == '/' {
                self.at += 1;
                self.quotient(&mut term, spaced)?;
                is_quotient = operators == 0 && term.len() == 1;
            } else {
                let mut factor = if matches!(next, '·' | '×') {
                    self.at += 1;
                    Factor::new(if next == '·' { r"\cdot " } else { r"\times " }, Kind::Product)
                } else {
                    self.factor()?
                };
                factor.tight = !spaced;
                is_quotient = false;
                unwrap_quotient(&mut factor, term.last());
                term.push(factor);
            }
        }
        is_quotient &= operators == 0 && term.len() == 1;
        latex.push_str(&joined(&term));
        Ok(Whole { latex, is_quotient })
    }

    /// A factor with all that hangs on it.
    fn factor(&mut self) -> Result<Factor, String> {
        let next = self.peek().ok_or("the line ends where something is missing")?;
        if next.is_ascii_digit() {
            return Ok(self.number());
        }
        if next.is_ascii_alphabetic() {
            let word: String = self.letters[self.at..].iter().take_while(|c| c.is_ascii_alphabetic()).collect();
            if word == "lim" {
                self.at += 3;
                let hung = self.hangings()?;
                return Ok(Factor::new(format!(r"\lim{hung}"), Kind::Big));
            }
            if letter::is_function(&word) {
                self.at += word.len();
                return self.function(&word);
            }
            let is_word = word.len() > 1 && word.bytes().all(|b| b.is_ascii_lowercase());
            if is_word && !(word.len() == 2 && word.starts_with('d')) {
                return Ok(self.word());
            }
        }
        match next {
            '(' | '[' => self.bracket(if next == '(' { ')' } else { ']' }, false),
            '|' => {
                self.at += 1;
                let inner = self.expression(Some('|'))?;
                let hung = self.hangings()?;
                Ok(Factor::new(format!(r"\left|{}\right|{hung}", inner.latex), Kind::Letter))
            }
            '√' => {
                self.at += 1;
                let root = self.factor()?;
                let inner = root.inner.map_or(root.latex, |inner| inner.latex);
                Ok(Factor::new(format!(r"\sqrt{{{inner}}}"), Kind::Letter))
            }
            '∫' => {
                self.at += 1;
                let hung = self.hangings()?;
                Ok(Factor::new(format!(r"\int{hung} "), Kind::Big))
            }
            _ => self.letter(next),
        }
    }

    fn number(&mut self) -> Factor {
        let mut digits = String::new();
        while let Some(next) = self.peek() {
            let is_point = next == '.' && self.letters.get(self.at + 1).is_some_and(char::is_ascii_digit);
            if !next.is_ascii_digit() && !is_point {
                break;
            }
            digits.push(next);
            self.at += 1;
        }
        if self.take('°') {
            digits.push_str(r"^\circ ");
        }
        Factor::new(digits, Kind::Number)
    }

    /// Words with what ties them together.
    fn word(&mut self) -> Factor {
        let mut word = String::new();
        while let Some(next) = self.peek() {
            let ties = matches!(next, '\'' | '’' | '-');
            let goes_on = self.letters.get(self.at + 1).is_some_and(char::is_ascii_lowercase);
            if !(next.is_ascii_lowercase() || (ties && goes_on)) {
                break;
            }
            word.push(next);
            self.at += 1;
        }
        if self.take(':') {
            word.push(':');
        }
        Factor::new(format!(r"\text{{{word}}}"), Kind::Word)
    }

    fn letter(&mut self, next: char) -> Result<Factor, String> {
        let plain =
            if next.is_ascii_alphabetic() { Some(next.to_string()) } else { letter::latex(next).map(str::to_owned) };
        let mut latex = plain.ok_or_else(|| format!("`{next}` is not known"))?;
        self.at += 1;
        while let Some(accent) = self.peek().and_then(letter::accent) {
            latex = format!("{accent}{{{}}}", latex.trim_end());
            self.at += 1;
        }
        let hung = self.hangings()?;
        let kind = match next {
            '½' | '¼' | '¾' => Kind::Half,
            '∂' => Kind::Differential,
            'd' if hung.is_empty() => Kind::Differential,
            _ => Kind::Letter,
        };
        Ok(Factor::new(if hung.is_empty() { latex } else { format!("{}{hung}", latex.trim_end()) }, kind))
    }

    /// A function, its power, and its argument: a bracket, or all that follows without a blank up to a stroke.
    fn function(&mut self, name: &str) -> Result<Factor, String> {
        let power = self.hangings()?;
        if self.peek() == Some('(') {
            let argument = self.bracket(')', true)?;
            return Ok(Factor::new(format!(r"\{name}{power}{}", argument.latex), Kind::Letter));
        }
        self.blanks();
        let mut argument = String::new();
        while self.peek().is_some_and(|next| next.is_alphanumeric() || letter::latex(next).is_some()) {
            argument.push_str(&self.factor()?.latex);
        }
        if argument.is_empty() {
            return Err(format!("{name} has no argument, or one in brackets behind a blank"));
        }
        if self.peek() == Some('(') {
            return Err(format!("where the argument of {name} ends is not certain"));
        }
        Ok(Factor::new(format!(r"\{name}{power} {argument}"), Kind::Function))
    }

    /// A bracket; of a function's argument quotients stay in the line.
    fn bracket(&mut self, close: char, is_argument: bool) -> Result<Factor, String> {
        let open = if close == ')' { '(' } else { '[' };
        self.at += 1;
        let outside = self.inline;
        self.inline |= is_argument;
        let inner = self.expression(Some(close))?;
        self.inline = outside;
        let hung = self.hangings()?;
        let is_tall = inner.latex.contains(r"\frac") || inner.latex.contains(r"\sqrt");
        let latex = if is_tall {
            format!(r"\left{open}{}\right{close}{hung}", inner.latex)
        } else {
            format!("{open}{}{close}{hung}", inner.latex)
        };
        let inner = hung.is_empty().then_some(inner);
        Ok(Factor { latex, kind: Kind::Bracket, tight: false, inner })
    }

    /// Primes, powers and indices behind a sign.
    fn hangings(&mut self) -> Result<String, String> {
        let (mut primes, mut above, mut below) = (String::new(), String::new(), String::new());
        while let Some(next) = self.peek() {
            if next == '′' || next == '″' {
                primes.push_str(if next == '′' { "'" } else { "''" });
                self.at += 1;
            } else if let Some(plain) = letter::raised(next) {
                above.push(plain);
                self.at += 1;
            } else if let Some(plain) = letter::lowered(next) {
                below.push(plain);
                self.at += 1;
                // u₃,ply
                let tail: String = self.letters[self.at..].iter().take(4).collect();
                if tail == ",ply" {
                    below.push_str(r",\text{ply}");
                    self.at += 4;
                }
            } else if next == '^' {
                self.at += 1;
                above.push_str(&self.hanging()?);
            } else if next == '_' {
                self.at += 1;
                below.push_str(&self.hanging()?);
            } else {
                break;
            }
        }
        let mut hung = String::new();
        if !below.is_empty() {
            hung.push_str(&format!("_{{{below}}}"));
        }
        hung.push_str(&primes);
        if !above.is_empty() {
            hung.push_str(&format!("^{{{above}}}"));
        }
        Ok(hung)
    }

    /// What stands behind ^ or _: braces, or letters up to the next other sign.
    fn hanging(&mut self) -> Result<String, String> {
        if self.take('{') {
            let outside = std::mem::replace(&mut self.inline, true);
            let inner = self.expression(Some('}'))?;
            self.inline = outside;
            return Ok(inner.latex);
        }
        let run: String = self.letters[self.at..].iter().take_while(|c| is_plain(**c)).collect();
        self.at += run.chars().count();
        if run.len() > 1 && run.bytes().all(|b| b.is_ascii_lowercase()) {
            return Ok(format!(r"\text{{{run}}}"));
        }
        let signs: Option<String> = run
            .chars()
            .map(|c| letter::latex(c).map_or_else(|| c.is_ascii().then(|| c.to_string()), |l| Some(l.into())))
            .collect();
        signs.filter(|signs| !signs.is_empty()).ok_or_else(|| "an index or power is missing".to_owned())
    }

    /// The quotient of what stands before a stroke and what stands behind it.
    fn quotient(&mut self, term: &mut Vec<Factor>, spaced: bool) -> Result<(), String> {
        self.blanks();
        let first = self.factor()?;
        let is_differential = first.kind == Kind::Differential;
        let (alone, bare) = (first.kind == Kind::Function, first.inner.is_none());
        let mut below = vec![first];
        if bare && !alone {
            while self.peek().is_some_and(|next| !matches!(next, ' ' | '/') && self.starts_factor()) {
                let next = self.factor()?;
                let is_call = next.kind == Kind::Bracket;
                if is_call && below.last().is_some_and(|last| last.kind == Kind::Number) {
                    return Err("where the denominator ends is not certain".to_owned());
                }
                below.push(Factor { tight: true, ..next });
            }
        }
        let was = self.at;
        let apart = self.blanks();
        if self.starts_factor() && (!apart || alone || (spaced && !self.starts_differential())) {
            return Err("where the denominator ends is not certain: put all that follows before it".to_owned());
        }
        self.at = was;
        // a quotient before it is a factor beside it, unless it is all there is to divide
        let ends_scope = |factor: &Factor| matches!(factor.kind, Kind::Big | Kind::Word | Kind::Quotient);
        let before = term.len().saturating_sub(1);
        let mut start = term[..before].iter().rposition(ends_scope).map_or(0, |at| at + 1);
        if is_differential {
            start = term.iter().rposition(|factor| factor.kind == Kind::Differential).unwrap_or(start).max(start);
        } else if term.len() > start + 1 && term[start].kind == Kind::Half {
            start += 1;
        }
        let above = term.split_off(start);
        if above.is_empty() {
            return Err("a quotient has no numerator".to_owned());
        }
        let latex = if self.inline {
            let below =
                if below.len() > 1 && !is_differential { format!("({})", joined(&below)) } else { joined(&below) };
            format!("{}/{below}", joined(&above))
        } else {
            format!(r"\frac{{{}}}{{{}}}", held(&above), held(&below))
        };
        term.push(Factor { latex, kind: Kind::Quotient, tight: false, inner: None });
        Ok(())
    }

    /// Whether what an integral runs over stands here.
    fn starts_differential(&self) -> bool {
        self.peek() == Some('d') && self.letters.get(self.at + 1).is_some_and(|next| next.is_alphabetic())
    }

    /// Whether a factor stands here.
    fn starts_factor(&self) -> bool {
        self.peek().is_some_and(|next| {
            !matches!(next, ')' | ']' | '}' | '/' | '·' | '×' | '|') && letter::operator(next).is_none()
        })
    }
}

/// The length of an index that stands without braces.
pub(super) fn plain_length(text: &str) -> usize {
    text.chars().take_while(|sign| is_plain(*sign)).map(char::len_utf8).sum()
}

/// Whether a sign may stand in an index without braces.
fn is_plain(sign: char) -> bool {
    sign.is_ascii_alphanumeric() || (letter::latex(sign).is_some() && sign.is_alphabetic()) || sign == '∞'
}

/// A bracket round a quotient that is a factor needs no bracket, but for a function's argument.
fn unwrap_quotient(factor: &mut Factor, before: Option<&Factor>) {
    let is_argument = factor.tight && before.is_some_and(|before| before.kind != Kind::Bracket);
    if let Some(inner) = factor.inner.take_if(|inner| inner.is_quotient && !is_argument) {
        *factor = Factor { latex: inner.latex, kind: Kind::Quotient, tight: factor.tight, inner: None };
    }
}

/// Factors above or below a bar: there one bracket round all is none.
fn held(factors: &[Factor]) -> String {
    match factors {
        [Factor { inner: Some(inner), .. }] => inner.latex.clone(),
        _ => joined(factors),
    }
}

/// Factors beside each other.
fn joined(factors: &[Factor]) -> String {
    let mut latex = String::new();
    for (at, factor) in factors.iter().enumerate() {
        let before = at.checked_sub(1).map(|at| factors[at].kind);
        let is_text = factor.kind == Kind::Word || before == Some(Kind::Word);
        if is_text && at > 0 {
            latex.push_str(r"\ ");
        } else if (before == Some(Kind::Function) && factor.kind != Kind::Function)
            || (before.is_some() && !factor.tight && matches!(factor.kind, Kind::Differential | Kind::Number))
            || (before == Some(Kind::Number) && !factor.tight && factor.kind == Kind::Bracket)
        {
            latex.push_str(r"\,");
        }
        latex.push_str(&factor.latex);
    }
    latex
}

#[cfg(test)]
mod tests {
    fn set(text: &str) -> String {
        super::latex(text, false).unwrap().replace(' ', "")
    }

    #[test]
    fn letters_carry_accents_primes_powers_and_indices() {
        assert_eq!(set("φ̄a"), r"\bar{\varphi}a");
        assert_eq!(set("p̂ r³/B"), r"\frac{\hat{p}r^{3}}{B}");
        assert_eq!(set("r₁″"), "r_{1}''");
        assert_eq!(set("rᵢ₊₁(s)"), "r_{i+1}(s)");
        assert_eq!(set("d_f′ Θ_m"), r"d_{f}'\Theta_{m}");
        assert_eq!(set("E_ΘY Y′²"), r"E_{\ThetaY}Y'^{2}");
        assert_eq!(set("W_r^{α+}"), r"W_{r}^{\alpha+}");
        assert_eq!(set("u₃,ply"), r"u_{3,\text{ply}}");
        assert_eq!(set("C_ply"), r"C_{\text{ply}}");
    }

    #[test]
    fn functions_end_where_their_argument_does() {
        assert_eq!(set("x² cos²θ"), r"x^{2}\cos^{2}\theta");
        assert_eq!(set("r sin α n"), r"r\sin\alpha\,n");
        assert_eq!(set("sin 2θ / (2R)"), r"\frac{\sin2\theta}{2R}");
        assert_eq!(set("cos²2θ"), r"\cos^{2}2\theta");
        assert_eq!(set("cos(2π/n)"), r"\cos(2\pi/n)");
        assert_eq!(set("sin x (sin x − x cos x)"), r"\sinx\,(\sinx-x\cosx)");
        assert!(super::latex("sin (x)", false).is_err());
        assert!(super::latex("cos ψ(s)", false).is_err());
    }

    #[test]
    fn a_denominator_is_a_bracket_or_what_stands_tight() {
        assert_eq!(set("(1/2γ) θ²"), r"\frac{1}{2\gamma}\theta^{2}");
        assert_eq!(set("(εL/2πR) sin θ"), r"\frac{\varepsilonL}{2\piR}\sin\theta");
        assert_eq!(set("sin θ cos θ/ρ"), r"\frac{\sin\theta\cos\theta}{\rho}");
        assert_eq!(set("cos θ/sin θ"), r"\frac{\cos\theta}{\sin\theta}");
        assert_eq!(set("a / (b) · (c + d)"), r"\frac{a}{b}\cdot(c+d)");
        assert_eq!(set("1/[(1 + q)(2 − q)]"), r"\frac{1}{(1+q)(2-q)}");
        assert_eq!(set("½ x/√(1 + μ²)"), r"\tfrac12\frac{x}{\sqrt{1+\mu^{2}}}");
        assert_eq!(set("(a + b)/(c)^{3/2}"), r"\frac{a+b}{(c)^{3/2}}");
        assert_eq!(set("(xρ/2)²"), r"\left(\frac{x\rho}{2}\right)^{2}");
        assert_eq!(set("(1/r) d_m/d_f"), r"\frac{1}{r}\frac{d_{m}}{d_{f}}");
        assert_eq!(set("a/b/c"), r"\frac{\frac{a}{b}}{c}");
        assert_eq!(set("R / (ρ(θ) r) − 1"), r"\frac{R}{\rho(\theta)r}-1");
    }

    #[test]
    fn what_can_be_taken_two_ways_is_refused() {
        for doubtful in ["a / b c", "a/(b)c", "a/2(b + c)", "a/sin θ b"] {
            assert!(super::latex(doubtful, false).is_err(), "{doubtful}");
        }
    }

    #[test]
    fn derivatives_keep_to_themselves() {
        assert_eq!(set("a ∂d_f/∂f"), r"a\frac{\partiald_{f}}{\partialf}");
        assert_eq!(set("d(sin θ/ρ)/dθ"), r"\frac{d\left(\frac{\sin\theta}{\rho}\right)}{d\theta}");
        assert_eq!(set("−d cos θ/dY"), r"-\frac{d\cos\theta}{dY}");
        assert_eq!(set("−(∂G/∂x)/(∂G/∂y)"), r"-\frac{\frac{\partialG}{\partialx}}{\frac{\partialG}{\partialy}}");
    }

    #[test]
    fn integrals_have_bounds_and_what_is_under_them() {
        assert_eq!(set("(1/2π) ∫₀^ℒ u₃ ds"), r"\frac{1}{2\pi}\int_{0}^{\mathscr{L}}u_{3}\,ds");
        assert_eq!(set("μ ∫∫ (a − b) / [c]^{3/2} dψ(s)"), r"\mu\int\int\frac{a-b}{[c]^{3/2}}\,d\psi(s)");
        assert_eq!(set("∫_{−ψ_L/2}^0 f dx"), r"\int_{-\psi_{L}/2}^{0}f\,dx");
        assert_eq!(set("lim_{x → ±0} x"), r"\lim_{x\to\pm0}x");
    }

    #[test]
    fn words_are_words() {
        assert_eq!(super::latex("σ = 1 for n odd", false).unwrap(), r"\sigma =1\ \text{for}\ n\ \text{odd}");
        assert_eq!(
            super::latex("greatest sin θ/ρ, the maker's lay", false).unwrap(),
            r"\text{greatest}\ \frac{\sin \theta }{\rho },\; \text{the}\ \text{maker's}\ \text{lay}"
        );
    }

    #[test]
    fn lines_are_aligned_at_their_first_equals_sign() {
        assert_eq!(super::latex("a = b = c", true).unwrap(), "a&=b=c");
        assert_eq!(super::latex("f(a = b) = c", true).unwrap(), "f(a=b)&=c");
    }
}
