//! The skeleton of a report page, and the pieces that both pages share.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::Picture;

/// The whole page: one file that needs nothing else, neither scripts nor addresses.
pub(super) fn page(title: &str, body: Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="generator" content="Sonarium";
                title { (title) }
                style { (PreEscaped(include_str!("page.css"))) }
            }
            body { main { (body) } }
        }
    };
    page.into_string()
}

/// Facts as pairs of a name and a value.
pub(super) fn facts(pairs: &[(&str, Markup)]) -> Markup {
    html! {
        dl class="facts" {
            @for (name, value) in pairs { div { dt { (name) } dd { (value) } } }
        }
    }
}

/// A number worth a large type: its name, the number, and what belongs to it.
pub(super) struct KeyNumber {
    pub(super) name: &'static str,
    pub(super) value: String,
    pub(super) note: String,
}

/// Key numbers side by side.
pub(super) fn key_numbers(numbers: &[KeyNumber]) -> Markup {
    html! {
        dl class="key-numbers" {
            @for number in numbers {
                div {
                    dt { (number.name) }
                    dd { b { (number.value) } " " span { (number.note) } }
                }
            }
        }
    }
}

/// A picture with its caption, inside the page.
pub(super) fn figure(picture: &Picture) -> Markup {
    let source = format!("data:image/png;base64,{}", STANDARD.encode(&picture.png));
    html! {
        figure class="picture" {
            img src=(source) alt=(picture.alt);
            figcaption { (picture.caption) }
        }
    }
}

/// A section of figures; nothing when there are none.
pub(super) fn pictures(title: &str, pictures: &[Picture]) -> Markup {
    html! {
        @if !pictures.is_empty() {
            section {
                h2 { (title) }
                div class="pictures" {
                    @for picture in pictures { (figure(picture)) }
                }
            }
        }
    }
}

/// A column's heading: what it is, its unit below it, and whether it holds numbers.
pub(super) struct Heading {
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    pub(super) is_number: bool,
}

/// The heading of a column of words.
pub(super) const fn words(name: &'static str) -> Heading {
    Heading { name, unit: "", is_number: false }
}

/// The heading of a column of numbers.
pub(super) const fn numbers(name: &'static str, unit: &'static str) -> Heading {
    Heading { name, unit, is_number: true }
}

/// A table that scrolls sideways on a narrow screen and repeats its header row on paper.
///
/// `rows` are whole `tr` elements.
pub(super) fn table(class: &str, caption: &str, headings: &[Heading], rows: Markup) -> Markup {
    html! {
        div class="scroll" role="region" tabindex="0" aria-label=(caption) {
            table class=(class) {
                caption { span { (caption) } }
                thead {
                    tr {
                        @for heading in headings {
                            th scope="col" class=[heading.is_number.then_some("n")] {
                                (heading.name)
                                @if !heading.unit.is_empty() { br; small { (heading.unit) } }
                            }
                        }
                    }
                }
                tbody { (rows) }
            }
        }
    }
}

/// A cell with a number.
pub(super) fn number(text: impl AsRef<str>) -> Markup {
    html! { td class="n" { (text.as_ref()) } }
}
