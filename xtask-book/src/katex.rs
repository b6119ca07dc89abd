//! KaTeX, which sets formulas when the book is built: one process of Node for all of them.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::math::Formula;

/// KaTeX as npm installs it into `book/node_modules`: renderer, stylesheet and fonts of one version.
#[derive(Debug, Clone)]
pub struct Katex {
    folder: PathBuf,
}

/// Reads formulas as one JSON list, writes their HTML as another. What KaTeX does not know, or finds doubtful, is an error.
const SCRIPT: &str = r"
const katex = require(process.argv[1]);
let input = '';
process.stdin.on('data', piece => input += piece).on('end', () => {
  const set = ([latex, displayMode]) => {
    try {
      return { html: katex.renderToString(latex, { displayMode, throwOnError: true, strict: 'error', output: 'htmlAndMathml' }) };
    } catch (error) {
      return { error: error.message };
    }
  };
  process.stdout.write(JSON.stringify(JSON.parse(input).map(set)));
});
";

impl Katex {
    /// KaTeX, where it is installed.
    #[must_use]
    pub fn installed(root: &Path) -> Option<Self> {
        let folder = root.join("book/node_modules/katex");
        folder.join("dist/katex.min.css").is_file().then_some(Self { folder })
    }

    /// Its folder of stylesheet and fonts.
    #[must_use]
    pub fn dist(&self) -> PathBuf {
        self.folder.join("dist")
    }

    /// The HTML of each formula.
    ///
    /// # Errors
    /// A sentence with the first formula that cannot be set, or why Node does not answer.
    pub fn set(&self, formulas: &BTreeSet<Formula>) -> Result<BTreeMap<Formula, String>, String> {
        let asked: Vec<&Formula> = formulas.iter().collect();
        let input = serde_json::to_vec(&asked).map_err(|error| error.to_string())?;
        let mut node = Command::new("node")
            .args(["-e", SCRIPT])
            .arg(self.dist().join("katex.js"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("cannot start node: {error}"))?;
        if let Some(mut pipe) = node.stdin.take() {
            pipe.write_all(&input).map_err(|error| format!("node does not listen: {error}"))?;
        }
        let output = node.wait_with_output().map_err(|error| format!("node does not answer: {error}"))?;
        let answers: Vec<serde_json::Value> =
            serde_json::from_slice(&output.stdout).map_err(|error| format!("node answers no JSON: {error}"))?;
        let mut html = BTreeMap::new();
        for (formula, answer) in asked.into_iter().zip(answers) {
            let set = answer["html"].as_str().ok_or_else(|| format!("`{}`: {}", formula.0, answer["error"]))?;
            html.insert(formula.clone(), set.to_owned());
        }
        Ok(html)
    }
}
