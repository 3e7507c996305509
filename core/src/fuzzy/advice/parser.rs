//! Advice read by recursive descent.

use super::lexer::{Placed, Token, error, tokens};
use super::{Advice, AdviceError, Conclusion, Condition, DEEPEST, MOST_RULES, Rule, Vocabulary};

/// Words that mean something and can be no name.
const RESERVED: [&str; 6] = ["if", "then", "is", "let", "end", "move"];
/// Words that may stand before an action.
const VERBS: [&str; 3] = ["move", "turn", "go"];

/// Reads a text of advice.
///
/// # Errors
/// At the first character that is wrong: a sign without meaning, a word in the wrong place, a feature,
/// term or action that the vocabulary does not have, too many rules or too deep a condition.
pub fn parse(text: &str, vocabulary: &Vocabulary) -> Result<Advice, AdviceError> {
    let text: Vec<char> = text.chars().collect();
    let tokens = tokens(&text)?;
    let mut parser =
        Parser { text: &text, tokens, at: 0, depth: 0, vocabulary, advice: Advice::default() };
    loop {
        while parser.take(&Token::Semicolon) {}
        if parser.peek() == &Token::End {
            return Ok(parser.advice);
        }
        if parser.advice.rules.len() == MOST_RULES {
            return Err(parser.error(format!("at most {MOST_RULES} rules can be kept")));
        }
        let rule = parser.rule()?;
        parser.advice.rules.push(rule);
    }
}

struct Parser<'a> {
    text: &'a [char],
    tokens: Vec<Placed>,
    at: usize,
    depth: usize,
    vocabulary: &'a Vocabulary,
    advice: Advice,
}

impl Parser<'_> {
    fn peek(&self) -> &Token {
        &self.tokens[self.at].token
    }

    fn next(&mut self) -> Token {
        let token = self.peek().clone();
        self.at = (self.at + 1).min(self.tokens.len() - 1);
        token
    }

    fn take(&mut self, token: &Token) -> bool {
        let found = self.peek() == token && *token != Token::End;
        self.at += usize::from(found);
        found
    }

    fn take_word(&mut self, word: &str) -> bool {
        self.take(&Token::Word(word.to_owned()))
    }

    /// An error at the next token.
    fn error(&self, problem: String) -> AdviceError {
        error(self.text, self.tokens[self.at].offset, problem)
    }

    fn expected(&self, what: &str) -> AdviceError {
        self.error(format!("expected {what}, not {}", self.peek().name()))
    }

    fn word(&mut self, word: &str) -> Result<(), AdviceError> {
        if self.take_word(word) { Ok(()) } else { Err(self.expected(&format!("`{word}`"))) }
    }

    fn rule(&mut self) -> Result<Rule, AdviceError> {
        let begin = self.tokens[self.at].offset;
        self.word("if")?;
        let condition = self.any()?;
        self.word("then")?;
        let conclusion = self.conclusion()?;
        let end = self.tokens[self.at - 1].end;
        self.take_word("end");
        let text = self.text[begin..end].iter().collect();
        Ok(Rule { text, condition, conclusion })
    }

    fn any(&mut self) -> Result<Condition, AdviceError> {
        let mut condition = self.all()?;
        while self.take(&Token::Or) {
            condition = Condition::Or(Box::new(condition), Box::new(self.all()?));
        }
        Ok(condition)
    }

    fn all(&mut self) -> Result<Condition, AdviceError> {
        let mut condition = self.one()?;
        while self.take(&Token::And) {
            condition = Condition::And(Box::new(condition), Box::new(self.one()?));
        }
        Ok(condition)
    }

    fn one(&mut self) -> Result<Condition, AdviceError> {
        self.deeper(|parser| {
            if parser.take(&Token::Not) {
                return Ok(Condition::Not(Box::new(parser.one()?)));
            }
            if parser.take(&Token::Open) {
                let condition = parser.any()?;
                parser.close()?;
                return Ok(condition);
            }
            parser.fact()
        })
    }

    fn deeper<T>(
        &mut self,
        read: impl FnOnce(&mut Self) -> Result<T, AdviceError>,
    ) -> Result<T, AdviceError> {
        if self.depth == DEEPEST {
            return Err(self.error(format!("a condition can be nested {DEEPEST} deep at most")));
        }
        self.depth += 1;
        let read = read(self);
        self.depth -= 1;
        read
    }

    fn close(&mut self) -> Result<(), AdviceError> {
        if self.take(&Token::Close) { Ok(()) } else { Err(self.expected("`)`, `and` or `or`")) }
    }

    /// `FEATURE is TERM`, `FEATURE ( terms )`, or a term made before.
    fn fact(&mut self) -> Result<Condition, AdviceError> {
        let Token::Word(name) = self.peek().clone() else {
            return Err(self.expected("a condition"));
        };
        if RESERVED.contains(&name.as_str()) {
            return Err(self.expected("a condition"));
        }
        if let Some(made) = self.advice.made.iter().position(|made| *made == name) {
            self.next();
            return Ok(Condition::Made(made));
        }
        let features = &self.vocabulary.features;
        let Some(feature) = features.iter().position(|(feature, _)| *feature == name) else {
            let known: Vec<&str> = features.iter().map(|(feature, _)| feature.as_str()).collect();
            return Err(self.error(format!("there is no feature `{name}`; {}", list(&known))));
        };
        self.next();
        if self.take(&Token::Open) {
            let condition = self.any_term(feature)?;
            self.close()?;
            return Ok(condition);
        }
        if self.take_word("is") {
            return self.one_term(feature);
        }
        Err(self.expected("`is` or `(`"))
    }

    fn any_term(&mut self, feature: usize) -> Result<Condition, AdviceError> {
        let mut condition = self.all_terms(feature)?;
        while self.take(&Token::Or) {
            condition = Condition::Or(Box::new(condition), Box::new(self.all_terms(feature)?));
        }
        Ok(condition)
    }

    fn all_terms(&mut self, feature: usize) -> Result<Condition, AdviceError> {
        let mut condition = self.one_term(feature)?;
        while self.take(&Token::And) {
            condition = Condition::And(Box::new(condition), Box::new(self.one_term(feature)?));
        }
        Ok(condition)
    }

    fn one_term(&mut self, feature: usize) -> Result<Condition, AdviceError> {
        self.deeper(|parser| {
            if parser.take(&Token::Not) {
                return Ok(Condition::Not(Box::new(parser.one_term(feature)?)));
            }
            if parser.take(&Token::Open) {
                let condition = parser.any_term(feature)?;
                parser.close()?;
                return Ok(condition);
            }
            let (name, terms) = &parser.vocabulary.features[feature];
            let Token::Word(word) = parser.peek() else {
                return Err(parser.expected(&format!("a term of `{name}`")));
            };
            let Some(term) = terms.iter().position(|term| term == word) else {
                let known: Vec<&str> = terms.iter().map(String::as_str).collect();
                return Err(
                    parser.error(format!("`{name}` has no term `{word}`; {}", list(&known)))
                );
            };
            parser.next();
            Ok(Condition::Term { feature, term })
        })
    }

    fn conclusion(&mut self) -> Result<Conclusion, AdviceError> {
        if self.take_word("let") {
            return Ok(Conclusion::Make(self.new_name()?));
        }
        let avoid = self.take(&Token::Not);
        let action = self.action()?;
        Ok(if avoid { Conclusion::Avoid(action) } else { Conclusion::Do(action) })
    }

    fn new_name(&mut self) -> Result<usize, AdviceError> {
        let Token::Word(name) = self.peek().clone() else {
            return Err(self.expected("a name for the new term"));
        };
        let feature = self.vocabulary.features.iter().any(|(feature, _)| *feature == name);
        if feature || RESERVED.contains(&name.as_str()) {
            return Err(self.error(format!("`{name}` means something already; take another name")));
        }
        self.next();
        let made = &mut self.advice.made;
        Ok(made.iter().position(|known| *known == name).unwrap_or_else(|| {
            made.push(name);
            made.len() - 1
        }))
    }

    fn action(&mut self) -> Result<usize, AdviceError> {
        let known = |word: &str| self.vocabulary.actions.iter().position(|action| action == word);
        let verb = |token: &Token| match token {
            Token::Word(word) => VERBS.contains(&word.as_str()) && known(word).is_none(),
            _ => false,
        };
        if verb(self.peek()) {
            self.next();
        }
        let Token::Word(word) = self.peek() else {
            return Err(self.expected("an action"));
        };
        let Some(action) = self.vocabulary.actions.iter().position(|action| action == word) else {
            let known: Vec<&str> = self.vocabulary.actions.iter().map(String::as_str).collect();
            return Err(self.error(format!("there is no action `{word}`; {}", list(&known))));
        };
        self.next();
        Ok(action)
    }
}

fn list(known: &[&str]) -> String {
    if known.is_empty() {
        "there is none".into()
    } else {
        format!("there are {}", known.join(", "))
    }
}
