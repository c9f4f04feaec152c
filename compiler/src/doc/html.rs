//! HTML pages: self-contained files without external resources, for screens of any width.

use super::collect::{Entry, Field, Kind, Page, Type};
use pulldown_cmark::{CowStr, Event, Parser, html::push_html};
use std::collections::BTreeMap;

const STYLE: &str = include_str!("style.css");
const SCRIPT: &str = include_str!("search.js");

/// Sections of a page in order: kind, heading, true if entries have a table of fields.
const SECTIONS: [(Kind, &str); 9] = [
    (Kind::Param, "Params"),
    (Kind::Output, "Outputs"),
    (Kind::Function, "Functions"),
    (Kind::Component, "Components"),
    (Kind::Record, "Records"),
    (Kind::Constant, "Constants"),
    (Kind::Enumeration, "Enumerations"),
    (Kind::Dimension, "Dimensions"),
    (Kind::Unit, "Units"),
];

/// Renders the page of one module or model; links lead to the other pages.
pub fn page(page: &Page, all: &[Page]) -> String {
    let links = Links::new(page, all);
    let mut body = format!("<h1>{}</h1>\n", escape(&title(page)));
    body += &links.markdown(&page.doc);
    body += SEARCH_BOX;
    body += &contents(page);
    for (kind, heading) in SECTIONS {
        let entries: Vec<&Entry> = page.entries.iter().filter(|entry| entry.kind == kind).collect();
        if entries.is_empty() {
            continue;
        }
        body += &format!("<h2>{heading}</h2>\n");
        for entry in entries {
            body += &entry_html(entry, &links);
        }
    }
    body += &types(page, &links);
    let others = all.iter().filter(|other| other.name != page.name);
    let mut navigation: String =
        others.map(|other| format!("<a href=\"{0}.html\">{0}</a> ", escape(&other.name))).collect();
    if all.len() > 1 {
        navigation = format!("<a href=\"index.html\">Index</a> {navigation}");
    }
    document(&title(page), &navigation, &body)
}

/// Renders an index of all entries of all pages.
pub fn index(pages: &[Page]) -> String {
    let mut body = format!("<h1>Calyx reference</h1>\n{SEARCH_BOX}");
    // Entries link to their own pages; names in sentences would link to the index itself.
    let links = Links::default();
    for page in pages {
        body += &format!("<h2><a href=\"{0}.html\">{1}</a></h2>\n", escape(&page.name), escape(&title(page)));
        body += &links.markdown(first_sentence(&page.doc));
        body += "<dl class=\"list\">\n";
        for entry in &page.entries {
            body += &format!(
                "<div class=\"entry\" data-name=\"{name}\"><dt><a href=\"{page}.html#{name}\">{name}</a></dt><dd>{doc}</dd></div>\n",
                name = escape(&entry.name),
                page = escape(&page.name),
                doc = links.inline(first_sentence(&entry.doc)),
            );
        }
        body += "</dl>\n";
    }
    document("Calyx reference", "", &body)
}

const SEARCH_BOX: &str = "<p class=\"search\"><input id=\"search\" type=\"search\" placeholder=\"Search by name\" aria-label=\"Search by name\"></p>\n";

fn title(page: &Page) -> String {
    match page.name.as_str() {
        "std" => "Names available in every model".into(),
        name if page.library => format!("Module {name}"),
        name => name.to_owned(),
    }
}

/// Generator tag that identifies pages of this program.
pub(super) const GENERATOR: &str = "<meta name=\"generator\" content=\"calyx doc\">";

fn document(title: &str, navigation: &str, body: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         {GENERATOR}\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<nav>{navigation}</nav>\n<main>\n{body}</main>\n\
         <script>\n{SCRIPT}</script>\n</body>\n</html>\n",
        escape(title)
    )
}

/// Renders a table of contents: names with their first sentence.
fn contents(page: &Page) -> String {
    let mut out = String::from("<dl class=\"list contents\">\n");
    let links = Links::default();
    for entry in &page.entries {
        out += &format!(
            "<div class=\"entry\" data-name=\"{name}\"><dt><a href=\"#{name}\">{name}</a></dt><dd>{doc}</dd></div>\n",
            name = escape(&entry.name),
            doc = links.inline(first_sentence(&entry.doc)),
        );
    }
    out + "</dl>\n"
}

fn entry_html(entry: &Entry, links: &Links) -> String {
    let name = escape(&entry.name);
    let mut out = format!(
        "<section class=\"entry\" id=\"{name}\" data-name=\"{name}\">\n<h3><a href=\"#{name}\">{name}</a>"
    );
    if !entry.effect.is_empty() {
        out += &format!(" <span class=\"effect\">{}</span>", entry.effect);
    }
    out += "</h3>\n";
    if !entry.signature.is_empty() {
        let result = entry.result.as_ref().map(|ty| format!(" → {}", links.ty(ty))).unwrap_or_default();
        out += &format!("<pre><code>{}{result}</code></pre>\n", escape(&broken(&entry.signature)));
    }
    if let Some(former) = &entry.former {
        out += &format!("<p>formerly <code>{}</code></p>\n", escape(former));
    }
    out += &links.markdown(&entry.doc);
    if !entry.fields.is_empty() {
        out += "<dl class=\"fields\">\n";
        for field in &entry.fields {
            out += &field_html(entry, field, links);
        }
        out += "</dl>\n";
    }
    out + "</section>\n"
}

/// Returns `true` for a parameter or field that has no default and needs a value.
fn is_required(entry: &Entry, field: &Field) -> bool {
    let given = !matches!(entry.kind, Kind::Param | Kind::Enumeration) && field.mode != "output";
    given && field.default.is_none()
}

fn field_html(entry: &Entry, field: &Field, links: &Links) -> String {
    let mut facts = Vec::new();
    if let Some(ty) = &field.ty {
        let units = match ty.units.as_slice() {
            [] => String::new(),
            units => format!(" <span class=\"units\">{}</span>", escape(&units.join(", "))),
        };
        facts.push(format!("{}{units}", links.ty(ty)));
    }
    if !matches!(field.mode, "" | "in") {
        facts.push(format!("<em>{}</em>", field.mode));
    }
    if field.symbolic {
        facts.push("an expression, given with <code>:=</code>".into());
    }
    match &field.default {
        Some(default) => facts.push(format!("default <code>{}</code>", escape(default))),
        None if is_required(entry, field) => facts.push("required".into()),
        None => {}
    }
    if !field.domain.is_empty() {
        facts.push(format!("allowed <code>{}</code>", escape(&field.domain)));
    }
    if let Some(former) = &field.former {
        facts.push(format!("formerly <code>{}</code>", escape(former)));
    }
    let heading = if entry.kind == Kind::Param {
        "Value".to_owned()
    } else {
        format!("<code>{}</code>", escape(&field.name))
    };
    format!(
        "<dt>{heading} <span class=\"facts\">{}</span></dt><dd>{}</dd>\n",
        facts.join(" · "),
        links.markdown(&field.doc)
    )
}

/// Renders the handle types of a module with the functions that return and accept them.
fn types(page: &Page, links: &Links) -> String {
    let mut made: BTreeMap<&str, (Vec<&str>, Vec<&str>)> = BTreeMap::new();
    for entry in page.entries.iter().filter(|entry| entry.kind == Kind::Function) {
        for name in entry.result.iter().flat_map(|ty| &ty.names) {
            made.entry(name).or_default().0.push(&entry.name);
        }
        for name in entry.fields.iter().filter_map(|field| field.ty.as_ref()).flat_map(|ty| &ty.names) {
            made.entry(name).or_default().1.push(&entry.name);
        }
    }
    if made.is_empty() {
        return String::new();
    }
    let list = |names: &[&str]| {
        let mut names = names.to_vec();
        names.dedup();
        names.iter().map(|name| links.code(name)).collect::<Vec<_>>().join(", ")
    };
    let mut out = String::from("<h2>Types</h2>\n<dl class=\"fields\">\n");
    for (name, (makers, takers)) in made {
        let name = escape(name);
        out += &format!("<dt id=\"type-{name}\"><code>{name}</code></dt><dd><p>");
        if !makers.is_empty() {
            out += &format!("made by {}", list(&makers));
        }
        if !takers.is_empty() {
            out += if makers.is_empty() { "" } else { "; " };
            out += &format!("taken by {}", list(&takers));
        }
        out += "</p></dd>\n";
    }
    out + "</dl>\n"
}

/// Link targets of names.
#[derive(Default)]
struct Links {
    targets: BTreeMap<String, String>,
}

impl Links {
    fn new(page: &Page, all: &[Page]) -> Links {
        let mut targets = BTreeMap::new();
        for other in all {
            let file = if other.name == page.name { String::new() } else { format!("{}.html", other.name) };
            for entry in &other.entries {
                let target = format!("{file}#{}", entry.name);
                if other.library && other.name != "std" {
                    targets.insert(format!("{}.{}", other.name, entry.name), target.clone());
                }
                // Names of the page itself take precedence.
                if file.is_empty() || !targets.contains_key(&entry.name) {
                    targets.insert(entry.name.clone(), target);
                }
                for name in entry.result.iter().flat_map(|ty| &ty.names) {
                    targets.entry(name.clone()).or_insert(format!("{file}#type-{name}"));
                }
            }
        }
        Links { targets }
    }

    /// Renders code, with a link if it is a known name, alone or as a call.
    fn code(&self, text: &str) -> String {
        let name = text.split('(').next().unwrap_or(text);
        match self.targets.get(name) {
            Some(target) => format!("<a href=\"{}\"><code>{}</code></a>", escape(target), escape(text)),
            None => format!("<code>{}</code>", escape(text)),
        }
    }

    fn ty(&self, ty: &Type) -> String {
        let mut out = String::new();
        // Identifiers of the type, with the text between them.
        let mut rest = ty.text.as_str();
        while let Some(start) = rest.find(|c: char| c.is_alphanumeric() || c == '_') {
            let length = rest[start..]
                .find(|c: char| !(c.is_alphanumeric() || c == '_'))
                .unwrap_or(rest.len() - start);
            let (before, word) = (&rest[..start], &rest[start..start + length]);
            out += &escape(before);
            match self.targets.get(word).filter(|_| ty.names.iter().any(|name| name == word)) {
                Some(target) => out += &format!("<a href=\"{}\">{}</a>", escape(target), escape(word)),
                None => out += &escape(word),
            }
            rest = &rest[start + length..];
        }
        out + &escape(rest)
    }

    fn markdown(&self, text: &str) -> String {
        if text.is_empty() {
            return String::new();
        }
        let mut out = String::new();
        push_html(&mut out, self.events(text));
        out
    }

    /// Renders Markdown without the enclosing paragraph.
    fn inline(&self, text: &str) -> String {
        let html = self.markdown(text);
        let html = html.trim();
        html.strip_prefix("<p>").and_then(|html| html.strip_suffix("</p>")).unwrap_or(html).to_owned()
    }

    /// Parses Markdown: names in backticks become links, HTML becomes text.
    fn events<'t>(&'t self, text: &'t str) -> impl Iterator<Item = Event<'t>> {
        Parser::new(text).map(|event| match event {
            Event::Code(code) => Event::InlineHtml(CowStr::from(self.code(&code))),
            Event::Html(text) | Event::InlineHtml(text) => Event::Text(text),
            other => other,
        })
    }
}

/// Returns the text of a page without markup.
pub fn text(page: &Page) -> String {
    let mut out = format!("{}\n{}\n", title(page), page.doc);
    for (kind, heading) in SECTIONS {
        for (index, entry) in page.entries.iter().filter(|entry| entry.kind == kind).enumerate() {
            if index == 0 {
                out += &format!("\n{heading}\n");
            }
            let result = entry.result.as_ref().map(|ty| format!(" -> {}", ty.text)).unwrap_or_default();
            out += &format!("\n{}: {}{result}\n", entry.name, entry.signature);
            if let Some(former) = &entry.former {
                out += &format!("    formerly {former}\n");
            }
            for line in entry.doc.lines() {
                out += &format!("    {line}\n");
            }
            for field in &entry.fields {
                out += &format!("  {}\n", field_text(entry, field));
            }
        }
    }
    out
}

fn field_text(entry: &Entry, field: &Field) -> String {
    let mut parts = vec![field.name.clone()];
    if let Some(ty) = &field.ty {
        let units = if ty.units.is_empty() { String::new() } else { format!(" [{}]", ty.units.join(", ")) };
        parts.push(format!("{}{units}", ty.text));
    }
    match &field.default {
        Some(default) => parts.push(format!("default {default}")),
        None if is_required(entry, field) => parts.push("required".into()),
        None => {}
    }
    if !field.domain.is_empty() {
        parts.push(format!("allowed {}", field.domain));
    }
    if let Some(former) = &field.former {
        parts.push(format!("formerly {former}"));
    }
    if !field.doc.is_empty() {
        parts.push(field.doc.replace('\n', " "));
    }
    parts.join("; ")
}

/// Breaks a long signature into one argument per line.
fn broken(signature: &str) -> String {
    const WIDTH: usize = 60;
    let (Some(open), true) = (signature.find('('), signature.chars().count() > WIDTH) else {
        return signature.to_owned();
    };
    let Some(inner) = signature[open + 1..].strip_suffix(')') else { return signature.to_owned() };
    let mut lines = format!("{}(", &signature[..open]);
    let mut depth = 0i32;
    let mut line = String::new();
    for c in inner.chars() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            _ => {}
        }
        if c == ',' && depth == 0 {
            lines += &format!("\n    {},", line.trim());
            line.clear();
        } else {
            line.push(c);
        }
    }
    format!("{lines}\n    {})", line.trim())
}

/// Returns the text up to the first full stop that ends a sentence, or the first blank line.
fn first_sentence(doc: &str) -> &str {
    let paragraph = doc.split("\n\n").next().unwrap_or(doc);
    let end = paragraph.find(". ").or_else(|| paragraph.find(".\n")).map_or(paragraph.len(), |at| at + 1);
    &paragraph[..end]
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
