//! Help for names that a module does not have, and for handles of the wrong kind.
//!
//! The documentation of a module may list concepts that the module lacks, and concepts that it has
//! under another name. Each item ends with the names that users look for:
//!
//! ```text
//! Not available yet:
//! - bevel and hypoid gears (`bevel`, `hypoid`)
//!
//! Under another name:
//! - `external` makes external gears (`pinion`, `spur_gear`)
//! ```

use super::symbols::with_article;
use super::unit::Maker;

/// Limit of the names offered.
const MOST_NAMES: usize = 6;

/// Returns the help for a name that a module does not have.
pub(super) fn help(module: &str, doc: &str, name: &str, declared: &[String]) -> String {
    let related = related(name, declared);
    let near = match related.as_slice() {
        [] => String::new(),
        all => {
            let all: Vec<String> = all.iter().map(|name| format!("`{name}`")).collect();
            format!("; names like it: {}", all.join(", "))
        }
    };
    match (listed(doc, name), declared.is_empty()) {
        (Some(DocumentedItem::Absent(concept)), _) => format!("Calyx does not have {concept} yet{near}"),
        (Some(DocumentedItem::Renamed(text)), _) => text,
        (None, true) => "the module exports no names".into(),
        (None, false) if !related.is_empty() => {
            near.trim_start_matches("; ").replacen("names", "it has names", 1)
        }
        (None, false) if declared.len() <= MOST_NAMES => {
            let all: Vec<String> = declared.iter().map(|name| format!("`{name}`")).collect();
            format!("it has {}", all.join(", "))
        }
        (None, false) => {
            format!(
                "the module has {} names and none like it; type `{module}.` in an editor, or run `calyx doc {module}`, to see them",
                declared.len()
            )
        }
    }
}

/// Returns `true` if the documentation lists a name.
pub(super) fn lists(doc: &str, name: &str) -> bool {
    listed(doc, name).is_some()
}

/// An item in the lists of the documentation.
enum DocumentedItem {
    Absent(String),
    Renamed(String),
}

/// Returns the item with the longest listed name that `name` contains, the first of several.
fn listed(doc: &str, name: &str) -> Option<DocumentedItem> {
    let mut make: Option<fn(String) -> DocumentedItem> = None;
    let (mut found, mut most_words) = (None, 0);
    let mut lines = doc.lines().map(str::trim).peekable();
    while let Some(line) = lines.next() {
        match line {
            "Not available yet:" => make = Some(DocumentedItem::Absent),
            "Under another name:" => make = Some(DocumentedItem::Renamed),
            "" => make = None,
            _ => {
                let Some((make, first)) = make.zip(line.strip_prefix("- ")) else { continue };
                let mut item = first.to_owned();
                while let Some(more) = lines.next_if(|line| !line.is_empty() && !line.starts_with("- ")) {
                    item.push(' ');
                    item.push_str(more);
                }
                let Some((text, names)) = item.rsplit_once(" (") else { continue };
                let contained = names.split('`').skip(1).step_by(2).filter(|listed| has_words(name, listed));
                let count = contained.map(|listed| words(listed).len()).max().unwrap_or(0);
                if count > most_words {
                    (found, most_words) = (Some(make(text.to_owned())), count);
                }
            }
        }
    }
    found
}

fn words(name: &str) -> Vec<String> {
    name.split('_').filter(|word| !word.is_empty()).map(str::to_lowercase).collect()
}

/// Returns `true` if the words of `part` are adjacent in `name`.
fn has_words(name: &str, part: &str) -> bool {
    let (name, part) = (words(name), words(part));
    !part.is_empty() && name.windows(part.len()).any(|window| window == part)
}

/// Returns the help for a value that is not the required handle. It names the functions that create
/// the handle from the given value, if any. If a function created the given value from a handle of
/// the required type, it names that argument. Otherwise it names all functions that create the
/// handle. `makers` are the functions that create the wanted handle, and those that create the
/// found one.
pub(super) fn handle(makers: [&[Maker]; 2], wanted: &str, found: &str) -> String {
    let quoted = |all: &[&str]| {
        let all: Vec<String> = all.iter().map(|name| format!("`{name}`")).collect();
        all.join(" or ")
    };
    let [of_wanted, of_found] = makers;
    let takes = |maker: &&Maker| maker.parameters.iter().any(|(_, kind)| kind == found);
    let direct: Vec<&str> = of_wanted.iter().filter(takes).map(|maker| maker.name.as_str()).collect();
    let all: Vec<&str> = of_wanted.iter().map(|maker| maker.name.as_str()).collect();
    let received = of_found.iter().find_map(|maker| {
        let (parameter, _) = maker.parameters.iter().find(|(_, kind)| kind == wanted)?;
        Some(format!("give the {wanted} that `{}` received as `{parameter}`", maker.name))
    });
    match (direct.as_slice(), received, all.as_slice()) {
        ([], Some(received), _) => received,
        ([], None, []) => format!("give {}", with_article(wanted)),
        ([], None, all) => format!("make {} with {}", with_article(wanted), quoted(all)),
        (direct, ..) => format!(
            "make {} of this {found} with {}, and give the result here",
            with_article(wanted),
            quoted(direct)
        ),
    }
}

/// Returns names that share words with a name, those with the most shared words first.
fn related(name: &str, declared: &[String]) -> Vec<String> {
    let wanted = words(name);
    // Words such as `of` and `at` are not significant.
    let shared =
        |other: &String| words(other).iter().filter(|word| word.len() > 3 && wanted.contains(word)).count();
    let mut found: Vec<(usize, &String)> =
        declared.iter().map(|other| (shared(other), other)).filter(|(count, _)| *count > 0).collect();
    found.sort_by(|a, b| b.0.cmp(&a.0).then(a.1.len().cmp(&b.1.len())).then(a.1.cmp(b.1)));
    found.into_iter().take(MOST_NAMES).map(|(_, name)| name.clone()).collect()
}

#[cfg(test)]
mod tests {
    const DOC: &str = "Gears.\n\nNot available yet:\n- bevel gears (`bevel`, `hypoid`)\n- scuffing (`flash_temperature`)\n\n\
                       Under another name:\n- `external` makes external gears (`pinion`,\n  `wheel`)\n- `internal` makes\n\
                         internal gears (`ring`)\n- `worm` makes worm wheels (`worm_wheel`)\n";

    #[test]
    fn concepts_that_the_documentation_lists_are_recognised() {
        let declared: Vec<String> =
            ["external", "max_root_stress", "gauge_stress", "mesh", "a", "b", "c", "d"]
                .map(String::from)
                .into();
        let help = |name: &str| super::help("gears", DOC, name, &declared);
        assert_eq!(help("spiral_bevel"), "Calyx does not have bevel gears yet");
        assert_eq!(help("flash_temperature"), "Calyx does not have scuffing yet");
        assert_eq!(help("pinion"), "`external` makes external gears");
        // Items may continue on the next line.
        assert_eq!(help("wheel"), "`external` makes external gears");
        // A longer name precedes a part of it.
        assert_eq!(help("worm_wheel"), "`worm` makes worm wheels");
        assert_eq!(help("ring"), "`internal` makes internal gears");
        assert_eq!(help("tooth_root_stress"), "it has names like it: `max_root_stress`, `gauge_stress`");
        assert!(help("zebra").contains("`calyx doc gears`"));
        // Parts of words do not match.
        assert!(!help("bevelled").contains("yet"));
    }
}
