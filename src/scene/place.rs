//! Where in a file something stands.

use super::SceneFileError;

/// A file's text, in which errors are given their place.
#[derive(Clone, Copy, Debug)]
pub struct Places<'a>(pub &'a str);

impl Places<'_> {
    /// An error at a byte of the text.
    ///
    /// ```
    /// use bellfit::scene::Places;
    /// let error = Places("a = 1\nβ = x\n").error(11, "no number".to_owned());
    /// assert_eq!(error.to_string(), "line 2, column 5: no number");
    /// ```
    pub fn error(&self, at: usize, message: String) -> SceneFileError {
        let text = self.0;
        let end = (0..=at.min(text.len())).rev().find(|&i| text.is_char_boundary(i)).unwrap_or(0);
        let before = &text[..end];
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().map_or(0, |l| l.chars().count()) + 1;
        // What the file says is quoted: a control character in it is shown, not sent.
        let show = |c: char| if c.is_control() { c.escape_default().to_string() } else { c.to_string() };
        SceneFileError { line, column, message: message.chars().map(show).collect() }
    }

    /// What the parser says, in one line.
    pub fn of_toml(&self, error: &toml::de::Error) -> SceneFileError {
        let message = error.message().lines().collect::<Vec<_>>().join(", ");
        self.error(error.span().map_or(0, |span| span.start), message)
    }
}
