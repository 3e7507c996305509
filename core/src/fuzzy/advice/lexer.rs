//! Advice in words and signs.

use super::{AdviceError, MOST_CHARACTERS};

/// A word or sign.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Token {
    Word(String),
    Open,
    Close,
    And,
    Or,
    Not,
    Semicolon,
    End,
}

impl Token {
    /// For messages.
    pub(super) fn name(&self) -> String {
        match self {
            Self::Word(word) => format!("`{word}`"),
            Self::Open => "`(`".into(),
            Self::Close => "`)`".into(),
            Self::And => "`and`".into(),
            Self::Or => "`or`".into(),
            Self::Not => "`not`".into(),
            Self::Semicolon => "`;`".into(),
            Self::End => "the end".into(),
        }
    }
}

/// A token and the offset of its first character.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Placed {
    pub(super) token: Token,
    pub(super) offset: usize,
    /// Offset behind its last character.
    pub(super) end: usize,
}

/// An error at a character.
pub(super) fn error(text: &[char], offset: usize, problem: String) -> AdviceError {
    let before = &text[..offset.min(text.len())];
    let line = before.iter().filter(|character| **character == '\n').count() + 1;
    let column = before.iter().rev().take_while(|character| **character != '\n').count() + 1;
    AdviceError { line, column, offset, problem }
}

/// All tokens, the last of them the end.
pub(super) fn tokens(text: &[char]) -> Result<Vec<Placed>, AdviceError> {
    if text.len() > MOST_CHARACTERS {
        let problem = format!("at most {MOST_CHARACTERS} characters can be read");
        return Err(error(text, MOST_CHARACTERS, problem));
    }
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(&character) = text.get(at) {
        if character.is_whitespace() {
            at += 1;
        } else if character == '#' {
            at += text[at..].iter().take_while(|character| **character != '\n').count();
        } else {
            let (token, length) = token(text, at)?;
            tokens.push(Placed { token, offset: at, end: at + length });
            at += length;
        }
    }
    tokens.push(Placed { token: Token::End, offset: text.len(), end: text.len() });
    Ok(tokens)
}

fn token(text: &[char], at: usize) -> Result<(Token, usize), AdviceError> {
    let rest = &text[at..];
    let in_word = |character: &&char| character.is_alphanumeric() || "_-".contains(**character);
    let length = rest.iter().take_while(in_word).count();
    if length > 0 {
        let word: String = rest[..length].iter().collect();
        return Ok((keyword(word), length));
    }
    match rest {
        ['(', ..] => Ok((Token::Open, 1)),
        [')', ..] => Ok((Token::Close, 1)),
        [';', ..] => Ok((Token::Semicolon, 1)),
        ['&', '&', ..] => Ok((Token::And, 2)),
        ['|', '|', ..] => Ok((Token::Or, 2)),
        ['!', ..] => Ok((Token::Not, 1)),
        [other, ..] => Err(error(
            text,
            at,
            format!("`{other}` means nothing; use words, ( ), and, or, not, && || !"),
        )),
        [] => Ok((Token::End, 0)),
    }
}

fn keyword(word: String) -> Token {
    match word.to_lowercase().as_str() {
        "and" => Token::And,
        "or" => Token::Or,
        "not" => Token::Not,
        lower => Token::Word(lower.to_owned()),
    }
}
